#pragma once
// The area that all links sweep while the tracer covers the region.
//
// At one opening d the linkage is rigid and the tracer stands at one distance r(d) from the pole; while the
// tracer passes the region at that distance, the linkage turns about the pole by the bearings of the region
// there. So, in polar coordinates about the pole,
//     swept = union over d of  (outline of the links at d, bearing 0)  shifted by the region's bearings at
//     r(d).
// The openings are cut into slabs, the plane into rings about the pole and bins of the angle. A slab's
// outline is grown by what any joint moves within the slab and by half a ring, bearings and angles are
// rounded outwards: the result contains all that is swept. Without the growing the area is an estimate,
// smooth enough to be searched with.

#include <optional>

#include "kinematics/copying_linkage.hpp"
#include "kinematics/stop_flag.hpp"
#include "specs/spec.hpp"

namespace kempe {

struct FootprintGrid {
  int slabs = 192;  ///< of openings
  int rings = 384;  ///< about the pole
  int bins = 4096;  ///< of a whole turn
};

struct Footprint {
  double area = 0;   ///< mm^2, never less than what is swept
  Region outline{};  ///< contains all that is swept
};

/// An outer bound of what the links sweep. Where the linkage does not reach a part of the region, that part
/// is left out; an empty result if it reaches none.
Footprint footprint(const CopyingLinkage& linkage, const LinkStyle& style, const Region& region,
                    const FootprintGrid& grid = {});
/// The same; nothing if it was stopped before all was swept.
std::optional<Footprint> footprint_unless(const StopFlag& stop, const CopyingLinkage& linkage,
                                          const LinkStyle& style, const Region& region,
                                          const FootprintGrid& grid = {});

/// The area alone, estimated without growing: exact in the limit of a fine grid, mm^2.
double footprint_estimate(const CopyingLinkage& linkage, const LinkStyle& style, const Region& region,
                          const FootprintGrid& grid);

}  // namespace kempe
