#include "reports/drawings/tolerance_words.hpp"

#include <fmt/format.h>

#include "synthesis/tolerance/corner_error.hpp"

namespace kempe {
namespace {

/// mm
double limit_with_rounding(const Design& design) { return *design.limits.copy_error * (1 + 1e-9); }

std::string understated_words(const Design& design) {
  const double worst = *design.quality.copy_error_worst, at_corner = *design.quality.copy_error_at_corner;
  std::string text = fmt::format(
      "the worst case is computed to the first order, which is too small here: an instrument within the "
      "tolerances has an error of {:.4g} mm, {:.0f} % more",
      at_corner, 100 * (at_corner / worst - 1));
  if (breaks_copy_error_limit(design))
    text += fmt::format(
        ", and more than the {:.6g} mm that limits.copy_error_mm allows{}", *design.limits.copy_error,
        worst <= limit_with_rounding(design) ? ", which are kept to the first order alone" : "");
  return text;
}

std::string plate_words(const PlateAtRisk& plate) {
  if (plate.height_may_lose >= 1)
    return fmt::format(
        "plate {} can be impossible to make: lengths off by {:.3g} mm or more can fail to form a triangle, "
        "and no "
        "figure of the copy error holds then",
        plate.plate, plate.flat_from);
  return fmt::format(
      "plate {} can lose {:.0f} % of its height, and lengths off by {:.3g} mm or more can fail to form a "
      "triangle: "
      "figures of the copy error are rough",
      plate.plate, 100 * plate.height_may_lose, plate.flat_from);
}

}  // namespace

std::vector<std::string> tolerance_words(const Design& design) {
  std::vector<std::string> words;
  const Quality& q = design.quality;
  if (!design.tolerance || !q.copy_error_worst) return words;
  const CopyTolerance tolerance = CopyTolerance::uniform(*design.tolerance);
  if (q.copy_error_at_corner)
    words.push_back(understated_words(design));
  else if (breaks_copy_error_limit(design))
    words.push_back(fmt::format("the worst case is more than the {:.6g} mm that limits.copy_error_mm allows",
                                *design.limits.copy_error));
  bool all_plates_exist = true;
  for (const PlateAtRisk& plate : plates_at_risk(design.linkage, tolerance)) {
    words.push_back(plate_words(plate));
    all_plates_exist = all_plates_exist && plate.height_may_lose < 1;
  }
  const auto corner = corner_error_over(design.linkage, tolerance, RegionReach(design.region));
  if (all_plates_exist && corner && !corner->closes)
    words.push_back(
        "an instrument within the tolerances was found that does not close everywhere in the region");
  return words;
}

bool breaks_copy_error_limit(const Design& design) {
  const Quality& q = design.quality;
  return design.limits.copy_error && q.copy_error_worst &&
         q.copy_error_at_corner.value_or(*q.copy_error_worst) > limit_with_rounding(design);
}

}  // namespace kempe
