#include "synthesis/design/copy_overlap.hpp"

#include "geometry/regions/region_algebra.hpp"

namespace kempe {

bool copy_overlaps_original(const Design& design) {
  if (design.region.empty()) return false;
  const CopyingLinkage& linkage = design.linkage;
  return !are_apart(design.region, similar_image(design.region, linkage.k(), linkage.pole()), 0);
}

std::string overlap_note(const Design& design) {
  if (design.limits.sheets_gap || !copy_overlaps_original(design)) return "";
  return "the copy overlaps the original; limits.sheets_gap_mm keeps them apart";
}

}  // namespace kempe
