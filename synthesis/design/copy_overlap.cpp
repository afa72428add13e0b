#include "synthesis/design/copy_overlap.hpp"

#include "geometry/regions/region_algebra.hpp"

namespace kempe {
namespace {

bool are_apart(const Box& one, const Box& other) {
  return (one.upper.array() < other.lower.array()).any() || (other.upper.array() < one.lower.array()).any();
}

}  // namespace

bool copy_overlaps_original(const Design& design) {
  if (design.region.empty()) return false;
  const Region copy = similar_image(design.region, design.linkage.k(), design.linkage.pole());
  if (are_apart(bounding_box(design.region), bounding_box(copy))) return false;
  return !are_apart(design.region, copy, 0);
}

std::string overlap_note(const Design& design) {
  if (design.limits.copy_gap || !copy_overlaps_original(design)) return "";
  return "the copy overlaps the original; limits.sheets_gap_mm keeps them apart";
}

}  // namespace kempe
