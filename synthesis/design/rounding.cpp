#include "synthesis/design/rounding.hpp"

#include <algorithm>
#include <cmath>

#include "specs/spec.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {
namespace {

constexpr double share_of_tolerance = 0.2;  ///< of the tolerance, at most: the step
constexpr double usual_tolerance = 0.05;    ///< mm, where the spec states none: what a vernier calliper reads
constexpr int most_decimals = 6;            ///< of a length in mm
constexpr double rounded_length = 1e-9;     ///< share of a length that rounding of doubles may change

/// Decimals of the largest power of ten that is at most `length` (mm).
int decimals_within(double length) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(length))), 0, most_decimals);
}

LinkLengths at_step(const LinkLengths& exact, double step) {
  LinkLengths rounded{};
  for (double LinkLengths::*length : {&LinkLengths::VA, &LinkLengths::VB, &LinkLengths::AC, &LinkLengths::BC,
                                      &LinkLengths::AX, &LinkLengths::CX, &LinkLengths::BY, &LinkLengths::CY})
    rounded.*length = std::round(exact.*length / step) * step;
  return rounded;
}

/// How far each length is off; of a plate toleranced as a bar its third hole is off the line by half a step at most.
CopyTolerance errors_of(const CopyingLinkage& linkage, const LinkLengths& rounded, double step) {
  CopyTolerance errors;
  const auto exact = linkage.lengths().values(), made = rounded.values();
  for (std::size_t i = 0; i < exact.size(); ++i) errors.length[i] = std::abs(made[i] - exact[i]);
  if (is_flat(linkage.shape()))
    for (const std::size_t offset : {5U, 7U})
      errors.length[offset] = is_straight(linkage.shape()) ? 0 : step / 2;
  return errors;
}

std::optional<double> worst_over(const Design& design, const CopyTolerance& errors) {
  if (design.region.empty()) return std::nullopt;
  const auto error = copy_error_over(design.linkage, errors, design.region);
  return error ? std::optional(error->worst) : std::nullopt;
}

RoundedLengths rounded_to(const Design& design, int decimals) {
  RoundedLengths rounded;
  rounded.step = std::pow(10, -decimals);
  rounded.lengths = at_step(design.linkage.lengths(), rounded.step);
  const CopyTolerance errors = errors_of(design.linkage, rounded.lengths, rounded.step);
  rounded.copy_error = worst_over(design, errors);
  if (!design.tolerance) return rounded;
  CopyTolerance both = CopyTolerance::uniform(*design.tolerance);
  for (std::size_t i = 0; i < both.length.size(); ++i) both.length[i] += errors.length[i];
  rounded.with_tolerance = worst_over(design, both);
  return rounded;
}

/// A rounded length beyond a limit that the exact one keeps.
bool exceeds(double rounded, double exact, double most) {
  const double rounding = rounded_length * std::abs(most);
  return rounded > most + rounding && exact <= most + rounding;
}
bool falls_below(double rounded, double exact, double least) { return exceeds(-rounded, -exact, -least); }

bool keeps_limits(const Design& design, const RoundedLengths& rounded) {
  const auto exact = design.linkage.lengths().values(), made = rounded.lengths.values();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (design.limits.longest_strip &&
        exceeds(made[i], exact[i], *design.limits.longest_strip - design.style.width))
      return false;
    if (!design.allowed) continue;
    const double holes =
        design.allowed->seat.value_or(design.style.pin_diameter) + design.allowed->wall.value_or(0);
    if (falls_below(made[i], exact[i], std::max(design.allowed->shortest, holes))) return false;
    if (exceeds(made[i], exact[i], design.allowed->longest)) return false;
  }
  const auto& limit = design.limits.copy_error;
  return !limit || !rounded.with_tolerance || *rounded.with_tolerance <= *limit ||
         (design.quality.copy_error_worst && *design.quality.copy_error_worst > *limit);
}

}  // namespace

RoundedLengths rounded_lengths(const Design& design) {
  const bool stated = design.tolerance && design.tolerance->length > 0;
  const double tolerance = stated ? design.tolerance->length : usual_tolerance;
  int decimals = decimals_within(share_of_tolerance * tolerance);
  RoundedLengths rounded = rounded_to(design, decimals);
  while (decimals < most_decimals && !keeps_limits(design, rounded)) rounded = rounded_to(design, ++decimals);
  return rounded;
}

int decimals_of(const RoundedLengths& rounded) {
  return std::max(0, static_cast<int>(std::lround(-std::log10(rounded.step))));
}

}  // namespace kempe
