// A stored design against what the spec allowed its links, its pole and its grounding.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "geometry/fixed_text.hpp"
#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"
#include "specs/hardware.hpp"

namespace kempe {
namespace {

using namespace audit_slack;

/// Measured between holes on one line; CX and CY follow from them and the plates' angle.
constexpr std::array<std::size_t, 6> measured{0, 1, 2, 3, 4, 6};

void check_layers(const StoredDesign& design, AuditRecord& record) {
  record.checked("mechanism.links");
  const LayerAssignment& layers = design.layers;
  constexpr std::array<std::array<Link, 2>, 4> joined{
      {{Link::VA, Link::VB}, {Link::VA, Link::ACX}, {Link::VB, Link::BCY}, {Link::ACX, Link::BCY}}};
  for (const auto& [one, other] : joined)
    if (layers[one] == layers[other])
      record.broken({.limit = "mechanism.links",
                     .attained = layers[one],
                     .sentence = fmt::format("links {} and {} share a joint and lie both in layer {}",
                                             name(one), name(other), layers[one])});
}

void check_pins(const StoredDesign& design, AuditRecord& record) {
  record.checked("mechanism.pin_diameter_mm");
  if (const double thickest = thickest_pin(design.hardware); thickest > design.style.pin_diameter)
    record.broken(
        {.limit = "mechanism.pin_diameter_mm",
         .attained = thickest,
         .allowed = design.style.pin_diameter,
         .sentence = fmt::format("a pin of {:.6g} mm ({}) where contact is stated for pins of {:.6g} mm",
                                 thickest, words(design.hardware), design.style.pin_diameter)});
  if (design.style.pin_diameter <= design.style.width * (1 + same_length)) return;
  record.broken({.limit = "mechanism.pin_diameter_mm",
                 .attained = design.style.pin_diameter,
                 .allowed = design.style.width,
                 .sentence = fmt::format("a pin of {:.6g} mm in a link {:.6g} mm wide",
                                         design.style.pin_diameter, design.style.width)});
}

/// One requirement of single lengths: the first that misses it is told.
void check_each(const LinkLengths& lengths, std::span<const std::size_t> which, const std::string& key,
                const std::string& rule, const std::function<double(double)>& nearest_allowed,
                AuditRecord& record) {
  record.checked(key);
  const auto values = lengths.values();
  for (const std::size_t i : which) {
    const double allowed = nearest_allowed(values[i]);
    if (std::abs(values[i] - allowed) <= same_length * std::max(values[i], allowed)) continue;
    record.broken({.limit = key,
                   .attained = values[i],
                   .allowed = allowed,
                   .sentence = fmt::format("{} is {:.9g} mm: {}", LinkLengths::names[i], values[i], rule)});
  }
}

double nearest_of(const std::vector<double>& stock, double length) {
  return *std::min_element(stock.begin(), stock.end(),
                           [&](double a, double b) { return std::abs(a - length) < std::abs(b - length); });
}

void check_lengths(const LinkLengths& lengths, const Allowed& allowed, AuditRecord& record) {
  constexpr std::array<std::size_t, 8> all{0, 1, 2, 3, 4, 5, 6, 7};
  check_each(
      lengths, all, "links.shortest_mm", fmt::format("at least {:.9g} mm is allowed", allowed.shortest),
      [&](double length) { return std::max(length, allowed.shortest); }, record);
  check_each(
      lengths, all, "links.longest_mm", fmt::format("at most {:.9g} mm is allowed", allowed.longest),
      [&](double length) { return std::min(length, allowed.longest); }, record);
  if (const auto& grid = allowed.stock_lengths.grid)
    check_each(
        lengths, measured, "links.grid_mm", fmt::format("not a multiple of {:.9g} mm", *grid),
        [&](double length) { return std::max(1.0, std::round(length / *grid)) * *grid; }, record);
  if (const auto& stock = allowed.stock_lengths.stock; !stock.empty())
    check_each(
        lengths, measured, "links.stock_mm", "not a length of the stock",
        [&](double length) { return nearest_of(stock, length); }, record);
}

/// A link is as long over its ends as its farthest joints and half its width beyond each.
void check_strip(const StoredDesign& design, const LinkLengths& lengths, AuditRecord& record) {
  const std::string key = "limits.longest_strip_mm";
  if (!design.limits || !design.limits->longest_strip) return;
  record.checked(key);
  const auto values = lengths.values();
  const auto longest = std::max_element(values.begin(), values.end());
  const double strip = *design.limits->longest_strip, over_ends = *longest + design.style.width;
  if (over_ends <= strip * (1 + same_length)) return;
  record.broken(
      {.limit = key,
       .attained = over_ends,
       .allowed = strip,
       .sentence = fmt::format(
           "the link with {} is {:.9g} mm long over its ends: at most {:.9g} mm is allowed",
           LinkLengths::names[static_cast<std::size_t>(longest - values.begin())], over_ends, strip)});
}

void check_locks(const LinkLengths& lengths, const StockLengths& stock_lengths, AuditRecord& record) {
  const auto values = lengths.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!stock_lengths.locked[i]) continue;
    const std::string key = fmt::format("links.{}_mm", LinkLengths::names[i]);
    record.checked(key);
    if (std::abs(values[i] - *stock_lengths.locked[i]) > locked_length * values[i])
      record.broken({.limit = key,
                     .attained = values[i],
                     .allowed = stock_lengths.locked[i],
                     .sentence = fmt::format("{} is {:.9g} mm and locked to {:.9g} mm", LinkLengths::names[i],
                                             values[i], *stock_lengths.locked[i])});
  }
}

void check_pole(const StoredDesign& design, const PoleSpec& pole, double slack, AuditRecord& record) {
  const std::string key = pole.is_fixed() ? "pole.at_mm" : "pole.within_mm";
  const Point& at = design.mechanism.pole_position;
  const double off = pole.is_fixed() ? (at - std::get<Point>(pole.place)).norm()
                                     : distance(std::get<Region>(pole.place), at);
  record.checked(key);
  if (off <= slack) return;
  record.broken({.limit = key,
                 .attained = off,
                 .allowed = 0,
                 .where = at,
                 .sentence = fmt::format("the pole stands at ({}, {}), {:.6g} mm off where it may",
                                         fixed_text(at.x(), 6), fixed_text(at.y(), 6), off)});
}

void check_grounding(Grounding grounding, const std::vector<Grounding>& groundings, AuditRecord& record) {
  record.checked("objective.groundings");
  if (std::find(groundings.begin(), groundings.end(), grounding) == groundings.end())
    record.broken(
        {.limit = "objective.groundings",
         .sentence = fmt::format("the {} stands at the vertex, which is not permitted", name(grounding))});
}

void check_layer_count(const LayerAssignment& layers, int most, AuditRecord& record) {
  record.checked("links.layers");
  if (layers.highest() > most)
    record.broken(
        {.limit = "links.layers",
         .attained = layers.highest(),
         .allowed = most,
         .sentence = fmt::format("a link lies in layer {}; {} layers are allowed", layers.highest(), most)});
}

/// The links have one of the sections that there was to choose from.
void check_section(const LinkStyle& style, const std::vector<LinkSection>& sections, AuditRecord& record) {
  if (sections.empty()) return;
  record.checked("links.sections_mm");
  const auto is_own = [&](const LinkSection& one) {
    return std::abs(one.width - style.width) <= same_length * style.width &&
           std::abs(one.thickness - style.thickness) <= same_length * style.thickness;
  };
  if (std::none_of(sections.begin(), sections.end(), is_own))
    record.broken(
        {.limit = "links.sections_mm",
         .attained = style.width,
         .allowed = sections.front().width,
         .sentence = fmt::format("links of {:.6g} x {:.6g} mm are none of the {} that were to choose from",
                                 style.width, style.thickness, sections.size())});
}

Joint joint_named(char name) {
  return *std::find_if(all_joints.begin(), all_joints.end(),
                       [&](Joint joint) { return letter(joint) == name; });
}

/// Of the eight lengths that which leaves least between what its two joints take, mm, half of each.
struct LeastLeft {
  std::size_t which;
  double length, taken;
};
LeastLeft least_left(const StoredDesign& design, const std::function<double(Joint)>& taken_at) {
  const auto values = design.mechanism.lengths.values();
  LeastLeft least{0, 0, 0};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto name = LinkLengths::names[i];
    const double taken = 0.5 * (taken_at(joint_named(name[0])) + taken_at(joint_named(name[1])));
    if (i == 0 || values[i] - taken < least.length - least.taken) least = {i, values[i], taken};
  }
  return least;
}

/// Holes as they are drawn, of each link, must not run into each other.
void check_holes(const StoredDesign& design, const CuttingSpec& cutting, AuditRecord& record) {
  const auto [which, length, diameter] = least_left(design, [&](Joint joint) {
    return hole_diameter(design.style, design.hardware, joint, cutting) - cutting.kerf;
  });
  record.checked("cutting.hole_fit_mm");
  if (length >= diameter * (1 - same_length)) return;
  record.broken({.limit = "cutting.hole_fit_mm",
                 .attained = length,
                 .allowed = diameter,
                 .sentence = fmt::format("two holes of {:.6g} mm run into each other: {} is {:.6g} mm",
                                         diameter, LinkLengths::names[which], length)});
}

/// Two joints of a link, as far apart as pin or hole is wide, and the wall between.
void check_walls(const StoredDesign& design, const CuttingSpec& cutting, const std::optional<double>& wall,
                 AuditRecord& record) {
  if (!wall) return record.not_checked("links.wall_mm", "the file does not state it");
  const auto [which, length, taken] = least_left(design, [&](Joint joint) {
    return std::max(pin_at(design.style, design.hardware, joint),
                    hole_diameter(design.style, design.hardware, joint, cutting));
  });
  record.checked("links.wall_mm");
  if (length >= (taken + *wall) * (1 - same_length)) return;
  record.broken(
      {.limit = "links.wall_mm",
       .attained = length - taken,
       .allowed = wall,
       .sentence = fmt::format("{} is {:.6g} mm, which leaves a wall of {:.6g} mm between holes of {:.6g} mm",
                               LinkLengths::names[which], length, length - taken, taken)});
}

}  // namespace

void audit_allowed(const StoredDesign& design, const CopyingLinkage& linkage, double slack,
                   AuditRecord& record) {
  check_layers(design, record);
  check_pins(design, record);
  check_strip(design, linkage.lengths(), record);
  const auto states = [&](const char* table) {
    return std::find(design.tables.begin(), design.tables.end(), table) != design.tables.end();
  };
  if (!design.allowed) {
    for (const char* table : {"links", "pole", "objective"})
      if (!states(table)) record.not_checked(table, "the file does not state what was allowed");
    return;
  }
  const Allowed& allowed = *design.allowed;
  check_lengths(linkage.lengths(), allowed, record);
  check_locks(linkage.lengths(), allowed.stock_lengths, record);
  check_layer_count(design.layers, allowed.layers, record);
  check_section(design.style, allowed.sections, record);
  check_pole(design, allowed.pole, slack, record);
  check_grounding(linkage.grounding(), allowed.groundings, record);
  if (design.cutting) {
    check_holes(design, *design.cutting, record);
    check_walls(design, *design.cutting, allowed.wall, record);
  } else {
    record.not_checked("cutting", "the file does not state how wide the holes are");
  }
}

}  // namespace kempe
