// Do the figures of a mechanism agree with each other?

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/fixed_text.hpp"
#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"

namespace kempe {
namespace {

using audit_slack::agreeing;

/// The second smallest of four: one of them alone may be wrong.
double agreed(std::array<double, 4> values) {
  std::sort(values.begin(), values.end());
  return values[1];
}

/// VA and VB as most of the eight lengths tell them; the stored ones where they agree with the others.
struct Bars {
  double VA, VB;
};
Bars bars_of(const LinkLengths& stored, const LinkLengths& unit) {
  const double VA = agreed({stored.VA, stored.BC, stored.BY / unit.BY, stored.CY / unit.CY});
  const double VB = agreed({stored.VB, stored.AC, stored.AX / unit.AX, stored.CX / unit.CX});
  const auto kept = [](double stored_one, double found) {
    return std::abs(stored_one - found) <= agreeing * found ? stored_one : found;
  };
  return {kept(stored.VA, VA), kept(stored.VB, VB)};
}

bool shape_agrees(const StoredDesign& design, AuditRecord& record) {
  const Complex shape = shape_of(design.k, design.grounding);
  const double off = std::abs(shape - design.shape), allowed = agreeing * (1 + std::abs(shape));
  record.checked("mechanism.shape");
  if (off <= allowed) return true;
  record.broken(
      {.limit = "mechanism.shape",
       .attained = off,
       .allowed = allowed,
       .sentence = fmt::format("the shape is ({}, {}); this ratio and vertex give ({}, {})",
                               design.shape.real(), design.shape.imag(), shape.real(), shape.imag())});
  return false;
}

bool opening_fits(const OpeningInterval& interval, const OpeningInterval& opening) {
  return OpeningInterval{interval.lower - agreeing, interval.upper + agreeing}.contains(opening);
}

/// The number of the assembly mode that orientation and opening name; nothing if no assembly mode has both.
std::optional<int> assembly_mode_of(const StoredDesign& design, AuditRecord& record) {
  record.checked("mechanism.assembly");
  record.checked("mechanism.orientation");
  const auto modes = assembly_modes(shape_of(design.k, design.grounding));
  const DrawnMechanism& drawn = design.mechanism;
  const auto mode = [&](int number) -> const AssemblyMode& {
    return modes[static_cast<std::size_t>(number)];
  };
  const auto fits = [&](int number) {
    return mode(number).sides == drawn.sides && opening_fits(mode(number).openings, drawn.opening);
  };
  const int count = static_cast<int>(modes.size());
  const int stated = design.assembly_mode.value_or(count);
  if (stated < count && fits(stated)) return stated;
  for (int other = 0; other < count; ++other) {
    if (!fits(other)) continue;
    if (design.assembly_mode)
      record.broken({.limit = "mechanism.assembly",
                     .attained = stated,
                     .allowed = other,
                     .sentence = fmt::format("opening and orientation belong to assembly mode {}, not {}",
                                             other, stated)});
    return other;
  }
  const bool known = stated < count;
  if (!known || mode(stated).sides != drawn.sides)
    record.broken(
        {.limit = "mechanism.orientation",
         .sentence = "no assembly mode has this orientation of plates and parallelogram at this opening"});
  if (!known || !opening_fits(mode(stated).openings, drawn.opening))
    record.broken({.limit = "mechanism.opening_deg",
                   .attained = degrees(drawn.opening.lower),
                   .allowed = known ? std::optional(degrees(mode(stated).openings.lower)) : std::nullopt,
                   .sentence = fmt::format("the opening {} .. {} degrees goes beyond the assembly mode",
                                           fixed_text(degrees(drawn.opening.lower), 6),
                                           fixed_text(degrees(drawn.opening.upper), 6))});
  return std::nullopt;
}

bool lengths_agree(const CopyingLinkage& linkage, const LinkLengths& stored, AuditRecord& record) {
  const auto exact = linkage.lengths().values(), found = stored.values();
  bool all = true;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const std::string key = fmt::format("mechanism.lengths_mm.{}", LinkLengths::names[i]);
    record.checked(key);
    if (std::abs(found[i] - exact[i]) <= agreeing * linkage.size()) continue;
    all = false;
    record.broken({.limit = key,
                   .attained = found[i],
                   .allowed = exact[i],
                   .sentence = fmt::format("{} is {:.9g} mm; with the other lengths {:.9g} mm close and copy",
                                           LinkLengths::names[i], found[i], exact[i])});
  }
  return all;
}

}  // namespace

std::optional<CopyingLinkage> audit_mechanism(const StoredDesign& design, AuditRecord& record) {
  const bool shape = shape_agrees(design, record);
  const auto assembly_mode = assembly_mode_of(design, record);
  const LinkLengths& stored = design.mechanism.lengths;
  const auto unit = CopyingLinkage::make(design.k, design.grounding, 1, 1, 0);
  if (!unit) {
    record.broken({.limit = "copy", .sentence = std::string(name(unit.error()))});
    return std::nullopt;
  }
  const Bars bars = bars_of(stored, unit->lengths());
  const auto linkage = CopyingLinkage::make(design.k, design.grounding, bars.VA, bars.VB,
                                            assembly_mode.value_or(0), design.mechanism.pole_position);
  const bool lengths = linkage && lengths_agree(*linkage, stored, record);
  if (!shape || !assembly_mode || !lengths) return std::nullopt;
  return *linkage;
}

}  // namespace kempe
