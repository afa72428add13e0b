#include "reports/drawings/blank.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reports/drawings/drawing.hpp"
#include "synthesis/problem/local_frame.hpp"

namespace kempe {
namespace {

/// Share of an area: of rectangles that differ by less the first is taken, so that rounding does not choose.
constexpr double same_area = 1e-9;

Point turned(const Point& point, Complex turn) { return as_point(as_complex(point) * turn); }

/// The pose with `origin` at the origin, turned by the unit number `turn`.
Pose local_pose(const Pose& pose, Joint origin, Complex turn) {
  Pose local;
  for (const Joint joint : all_joints) local[joint] = turned(pose[joint] - pose[origin], turn);
  return local;
}

/// Width and height of the upright rectangle round a link.
Point extent(Link link, const Pose& pose, const LinkStyle& style) {
  const Box box = bounding_box(link_outline(link, pose, style).outer);
  return box.upper - box.lower;
}

}  // namespace

Pose lying_pose(const Design& design, Link link) {
  const LinkStyle& style = design.style;
  const CopyingLinkage about_origin = shifted(design.linkage, -design.linkage.pole());
  const Pose pose = about_origin.pose_at(openings_to_show(design).middle(), 0);
  const LinkJoints of_link = joints_of(link);
  const auto count = static_cast<std::size_t>(of_link.count);
  const Joint origin = of_link.joints[0];
  std::optional<Pose> best;
  double smallest = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      const Complex along = as_complex(pose[of_link.joints[j]] - pose[of_link.joints[i]]);
      const Pose candidate = local_pose(pose, origin, std::conj(along) / std::abs(along));
      const Point size = extent(link, candidate, style);
      const double area_of_box = size.x() * size.y();
      if (best && area_of_box >= smallest * (1 - same_area)) continue;
      smallest = area_of_box;
      best = size.x() >= size.y() ? candidate : local_pose(candidate, origin, Complex(0, 1));
    }
  return *best;
}

Blank blank_of(const Design& design, Link link) {
  const Point size = extent(link, lying_pose(design, link), design.style);
  return {.length = size.x(), .width = size.y()};
}

double longest_over_ends(const Design& design) {
  const auto lengths = design.linkage.lengths().values();
  return *std::max_element(lengths.begin(), lengths.end()) + design.style.width;
}

bool is_straight_link(const Design& design, Link link) {
  return joints_of(link).count == 2 || is_straight(design.linkage.shape());
}

std::string_view form_of(const Design& design, Link link) {
  if (joints_of(link).count == 2) return "bar";
  if (is_straight_link(design, link)) return "straight bar, three holes";
  return design.style.plate == PlateStyle::bent ? "bent plate" : "triangular plate";
}

Strip strip_of(const Design& design) {
  Strip strip{.width = design.style.width, .thickness = design.style.thickness, .pieces = {}, .length = 0};
  for (const Link link : all_links)
    if (is_straight_link(design, link)) strip.pieces.push_back({link, blank_of(design, link).length});
  std::stable_sort(strip.pieces.begin(), strip.pieces.end(),
                   [](const Strip::Piece& a, const Strip::Piece& b) { return a.length > b.length; });
  for (const Strip::Piece& piece : strip.pieces) strip.length += piece.length + design.cutting.kerf;
  return strip;
}

}  // namespace kempe
