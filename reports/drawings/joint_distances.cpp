#include "reports/drawings/joint_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "specs/spec_keys.hpp"
#include "synthesis/verification/stations.hpp"
#include "workspace/contact/gap.hpp"

namespace kempe {

OpeningInterval openings_over_region(const Design& design) {
  const OpeningInterval shown = openings_to_show(design);
  if (design.region.empty()) return shown;
  const DistanceRange distances = distance_range(design.region, design.linkage.pole());
  const auto nearest = design.linkage.opening_at(distances.nearest),
             farthest = design.linkage.opening_at(distances.farthest);
  OpeningInterval needed = shown;
  if (nearest && farthest) needed = {std::min(*nearest, *farthest), std::max(*nearest, *farthest)};
  needed = {std::max(needed.lower, shown.lower), std::min(needed.upper, shown.upper)};
  return needed.empty() ? shown : needed;
}

double least_distance(const Design& design, Joint one, Joint other, const OpeningInterval& openings) {
  const Complex s = design.linkage.shape();
  const auto from = linkage_point(one, s), to = linkage_point(other, s);
  const Complex along_p = design.linkage.VA() * (to.of_p - from.of_p),
                along_q = design.linkage.VB() * (to.of_q - from.of_q);
  const auto at = [&](double opening) { return std::abs(along_p + along_q * std::polar(1.0, opening)); };
  // |u + v e^id| falls until v e^id points against u and grows from there.
  const double opposite = std::arg(-along_p * std::conj(along_q));
  double least = std::min(at(openings.lower), at(openings.upper));
  for (const double turn : {opposite - 2 * pi, opposite, opposite + 2 * pi})
    if (openings.lower < turn && turn < openings.upper) least = std::min(least, at(turn));
  return least;
}

double distance_from_link(const Design& design, Joint joint, Link link, const OpeningInterval& openings) {
  LinkStyle style = design.style;
  style.pin_diameter = 0;
  const ContactPair pair{Part{.kind = Part::Kind::pin, .joint = joint}, Part{.link = link}};
  return smallest_gap_over(design.linkage, style, std::vector{pair}, openings).gap;
}

std::vector<Pose> poses_over_region(const Design& design) {
  std::vector<Pose> poses;
  if (design.region.empty()) return poses;
  for (const Point& tracer : stations_over(design.region, design.linkage.pole(), {}))
    if (const auto opening = design.linkage.opening_at(tracer.norm()))
      poses.push_back(design.linkage.pose_at(*opening, std::atan2(tracer.y(), tracer.x())));
  return poses;
}

bool overlap(const Heights& one, const Heights& other) { return one.from < other.to && other.from < one.to; }

Heights heights_of(int layer, double thickness) { return {(layer - 1) * thickness, layer * thickness}; }

Heights heights_of(int lowest, int highest, double thickness) {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {lowest == 1 ? -far : (lowest - 1) * thickness, highest == most_layers ? far : highest * thickness};
}

}  // namespace kempe
