#include "reports/drawings/overload_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/fixed_text.hpp"
#include "synthesis/design/error_budget.hpp"
#include "synthesis/design/other_sections.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/loads/strength.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// Share of a limit on the load error by which it may be missed: rounding.
constexpr double load_limit_rounding = 1e-9;

/// Share of the longest bar or arm: beams that bend by more no longer do so in proportion to their load.
constexpr double small_bending = 0.1;

double longest_length(const CopyingLinkage& linkage) {
  double longest = 0;
  for (const double length : linkage.lengths().values()) longest = std::max(longest, length);
  return longest;
}

/// mm, of tracer or pen; 0 where it is not stated.
double sunk_by_weight(const Design& design) {
  const auto openings = openings_over(design.linkage, design.region);
  if (!openings || !design.quality.sag) return 0;
  const SagAt sag =
      largest_sag(design.linkage, sag_conditions(spec_of(design), design.layers), *openings).sag;
  return std::max(sag.tracer.by_weight, sag.pen.by_weight);
}

}  // namespace

double largest_stress(const Design& design) {
  const auto& layered = design.quality.layered;
  const double in_plane = design.quality.loads->stress_max;
  return layered && layered->stress_max ? std::max(in_plane, *layered->stress_max) : in_plane;
}

double largest_push_in_bars(const Design& design) { return largest_push_in_bars(design, design.style); }

double buckling_load_of_bars(const Design& design) {
  return buckling_load(design.style, *design.material, std::max(design.linkage.VA(), design.linkage.VB()));
}

std::vector<std::string> overload_words(const Design& design) {
  std::vector<std::string> words;
  if (!design.load || !design.material || !design.quality.loads) return words;
  const Material& material = *design.material;
  const double stress = largest_stress(design);
  if (!std::isfinite(stress))
    words.push_back("the links yield or break: a hole leaves nothing of a link");
  else if (stress > material.strength)
    words.push_back(fmt::format("the links yield or break: they are stressed to {} MPa, and {} bears {} MPa",
                                three_digits(stress), material.name, three_digits(material.strength)));
  const double push = largest_push_in_bars(design), buckling = buckling_load_of_bars(design);
  if (push > buckling)
    words.push_back(
        fmt::format("the bars buckle: they are pushed with {} N, and {} N are enough to buckle them",
                    three_digits(push), three_digits(buckling)));
  if (words.empty()) return words;
  if (const auto style = section_that_bears(design))
    words.push_back(
        fmt::format("links of {} would bear it{}", section_words(*style),
                    keeps_the_rest(design, *style, design.hardware) ? "" : ", with other lengths"));
  return words;
}

std::optional<std::string> large_bending_words(const Design& design) {
  if (!design.load || !design.material || !design.quality.loads) return std::nullopt;
  const auto& layered = design.quality.layered;
  const double bent = std::max({design.quality.loads->error_max, sunk_by_weight(design),
                                layered ? std::max(layered->error_max, layered->rise_max) : 0,
                                design.quality.loads->weight_error_max.value_or(0)});
  if (bent <= small_bending * longest_length(design.linkage)) return std::nullopt;
  return fmt::format(
      "the links bend by {} mm, more than a tenth of their length: load error and sag are computed for small "
      "bending, and the true ones are other figures",
      three_digits(bent));
}

std::string beside_the_links(const Design& design) {
  const auto& layered = design.quality.layered;
  return layered && layered->weight_error_max.value_or(0) > no_drop ? "pins, layers and the links' own weight"
                                                                    : "pins and layers";
}

bool gives_too_far_in_all(const Design& design) {
  const auto whole = give_in_all(design.quality);
  if (!design.limits.load_error || design.limits.load_error_in_all || !whole) return false;
  const double kept = *design.limits.load_error * (1 + load_limit_rounding);
  return design.quality.loads->error_max <= kept && *whole > kept;
}

}  // namespace kempe
