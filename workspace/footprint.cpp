#include "workspace/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "workspace/footprint_outline.hpp"
#include "workspace/linkage_motion.hpp"
#include "workspace/parts.hpp"
#include "workspace/reach.hpp"
#include "workspace/sweep/grown_piece.hpp"
#include "workspace/sweep/region_bearings.hpp"

namespace kempe {
namespace {

using sweep::Bearings;
using sweep::GrownPiece;
using sweep::PolarBins;
using sweep::RegionBearings;

/// What one sweep needs beside the bins.
struct Sweep {
  const CopyingLinkage& linkage;
  const LinkStyle& style;
  OpeningInterval openings;
  bool outward;  ///< grow, so that nothing is missed
};

std::vector<GrownPiece> pieces_at(const Sweep& sweep, const LinkageMotion& motion, double opening,
                                  double half_slab, double half_ring) {
  const MovingJoints joints = motion.over(opening, sweep.outward ? half_slab : 0, 0, 0);
  std::vector<GrownPiece> pieces;
  for (const Link link : all_links)
    for (const JointHull& hull :
         axis_of({.kind = Part::Kind::link, .link = link}, sweep.linkage.shape(), sweep.style.plate)) {
      std::array<Point, 3> corners;
      double half_width = 0.5 * sweep.style.width, strays = 0;
      for (int i = 0; i < hull.count; ++i) {
        const Joint name = hull.joints[static_cast<std::size_t>(i)];
        const MovingJoint& joint = joints[static_cast<std::size_t>(name)];
        corners[static_cast<std::size_t>(i)] = joint.at;
        // Next to a dead point rates have no limit, places have.
        strays = std::max(strays, std::min(joint.reach, joint.at.norm() + motion.farthest(name)));
      }
      if (hull.count == 3 && cross(corners[1] - corners[0], corners[2] - corners[0]) < 0)
        std::swap(corners[1], corners[2]);
      if (sweep.outward) half_width += strays + half_ring;
      pieces.emplace_back(corners, hull.count, half_width);
    }
  return pieces;
}

/// Calls `visit(ring, angles, turned)` for the angles of every ring's middle circle in a piece, and all bearings by which the
/// pieces turn.
template <typename Visit>
void sweep_rings(const std::vector<GrownPiece>& pieces, const std::vector<Bearings>& bearings, int rings,
                 double step, Visit visit) {
  std::vector<Bearings> found;
  for (const GrownPiece& piece : pieces) {
    // Next to a dead point a piece may be larger than any int counts.
    const int first = static_cast<int>(std::clamp(piece.nearest() / step - 1, 0.0, 1.0 * rings));
    const int last = static_cast<int>(std::min(piece.farthest() / step + 1, rings - 1.0));
    for (int ring = first; ring <= last; ++ring) {
      piece.angles_in((ring + 0.5) * step, found);
      for (const Bearings& angles : found)
        for (const Bearings& turned : bearings) visit(ring, angles, turned);
    }
  }
}

/// The farthest place from the pole that any part comes to, mm.
double farthest_place(const Sweep& sweep, const LinkageMotion& motion) {
  double farthest = 0;
  for (const Joint joint : all_joints) farthest = std::max(farthest, motion.farthest(joint));
  return farthest + sweep.style.width;
}

std::optional<PolarBins> swept_bins(const CopyingLinkage& linkage, const LinkStyle& style,
                                    const Region& region, const FootprintGrid& grid, const StopFlag& stop) {
  const OpeningInterval openings = openings_met(linkage, region);
  if (openings.empty()) return std::nullopt;
  const Sweep sweep{linkage, style, openings, true};
  const LinkageMotion motion(linkage);
  PolarBins bins(grid.rings, grid.bins, 1.05 * farthest_place(sweep, motion));
  const RegionBearings region_bearings(region, linkage.pole());
  const double half_slab = openings.width() / grid.slabs / 2;
  const double one_bin = 2 * pi / grid.bins;  // what lies between is swept to within the grid anyway
  for (int slab = 0; slab < grid.slabs && !stop(); ++slab) {
    const double opening = openings.lower + (2 * slab + 1) * half_slab;
    const double a = linkage.radius_at(opening - half_slab), b = linkage.radius_at(opening + half_slab);
    const auto bearings = region_bearings.between(std::min(a, b), std::max(a, b), one_bin, stop);
    sweep_rings(pieces_at(sweep, motion, opening, half_slab, bins.step() / 2), bearings, bins.rings(),
                bins.step(), [&](int ring, const Bearings& angles, const Bearings& turned) {
                  bins.fill(ring, {angles.from + turned.from, angles.to + turned.to});
                });
  }
  return bins;
}

}  // namespace

Footprint footprint(const CopyingLinkage& linkage, const LinkStyle& style, const Region& region,
                    const FootprintGrid& grid) {
  return footprint_unless({}, linkage, style, region, grid).value_or(Footprint{});
}

std::optional<Footprint> footprint_unless(const StopFlag& stop, const CopyingLinkage& linkage,
                                          const LinkStyle& style, const Region& region,
                                          const FootprintGrid& grid) {
  const auto bins = stop() ? std::nullopt : swept_bins(linkage, style, region, grid, stop);
  if (stop()) return std::nullopt;
  if (!bins) return Footprint{};
  return Footprint{bins->area(), outline_in_the_plane(*bins, linkage.pole())};
}

double footprint_estimate(const CopyingLinkage& linkage, const LinkStyle& style, const Region& region,
                          const FootprintGrid& grid) {
  const OpeningInterval openings = openings_met(linkage, region);
  if (openings.empty()) return 0;
  const Sweep sweep{linkage, style, openings, false};
  const LinkageMotion motion(linkage);
  const double step = farthest_place(sweep, motion) / grid.rings;
  const RegionBearings region_bearings(region, linkage.pole());
  std::vector<std::vector<Bearings>> swept(static_cast<std::size_t>(grid.rings));
  for (int slab = 0; slab < grid.slabs; ++slab) {
    const double opening = openings.lower + slab * openings.width() / std::max(1, grid.slabs - 1);
    const double radius = linkage.radius_at(opening);
    sweep_rings(pieces_at(sweep, motion, opening, 0, 0), region_bearings.between(radius, radius), grid.rings,
                step, [&](int ring, const Bearings& angles, const Bearings& turned) {
                  add_turned(angles, turned, swept[static_cast<std::size_t>(ring)]);
                });
  }
  double area = 0;
  for (int ring = 0; ring < grid.rings; ++ring)
    for (const Bearings& angles : merged(std::move(swept[static_cast<std::size_t>(ring)])))
      area += std::min(2 * pi, angles.to - angles.from) * (ring + 0.5) * step * step;
  return area;
}

}  // namespace kempe
