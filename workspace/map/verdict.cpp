// Why the tracer can or cannot stand at one point: each limit in turn, in closed form.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workspace/contact/contact_scene.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/map/workspace_map.hpp"
#include "workspace/reach.hpp"

namespace kempe {

namespace {

/// Gaps within this share of the mechanism's size of the clearance are not decided.
constexpr double undecided = 1e-12;
/// A transmission angle that misses its limit by less, rad, keeps it: the opening is computed from the place.
constexpr double transmission_rounding = 1e-9;

Verdict lost(Cause cause, std::string sentence, std::vector<std::string> parts = {}) {
  return {false, false, cause, std::move(parts), std::move(sentence)};
}

Verdict unreachable(const CopyingLinkage& linkage, Unreachable why, double distance) {
  if (why == Unreachable::beyond_change_point) {
    const Annulus reach = reachable_annulus(linkage);
    return lost(Cause::beyond_change_point,
                fmt::format("beyond the change point: {:.2f} mm from the pole, where the parallelogram would "
                            "have to pass its flat position; this assembly mode reaches {:.2f} to {:.2f} mm",
                            distance, reach.inner, reach.outer));
  }
  const Annulus chain = chain_annulus(linkage);
  return lost(Cause::out_of_reach,
              fmt::format("out of reach: {:.2f} mm from the pole, the linkage reaches {:.2f} to "
                          "{:.2f} mm",
                          distance, chain.inner, chain.outer));
}

/// "touch" or how far apart two things are.
std::string nearness(double gap) {
  return gap > 0 ? fmt::format("are {:.3f} mm apart", gap) : std::string("overlap");
}

Verdict contact(Cause cause, const std::string& one, const std::string& other, double gap, double clearance) {
  return lost(
      cause,
      fmt::format("contact: {} and {} {}; the clearance is {:.3f} mm", one, other, nearness(gap), clearance),
      {one, other});
}

struct SmallestGap {
  double gap;
  Cause cause;
  std::string one, other;
};

SmallestGap smallest_gap(const MapTask& task, const std::vector<PoleGap>& at_pole, double opening,
                         double bearing) {
  const Pose pose = task.linkage.pose_at(opening, bearing);
  const Tightest own = tightest_gap(task.linkage, pose, task.style, task.layers);
  SmallestGap smallest{own.gap, Cause::self_contact, name(own.pair->first), name(own.pair->second)};
  const ContactScene scene(task, own.gap);
  const ObstacleGap obstacle = tightest_obstacle(scene, opening, bearing);
  if (obstacle.gap < smallest.gap)
    smallest = {obstacle.gap, Cause::obstacle_contact, scene.piece_name(obstacle.between),
                scene.obstacle_name(obstacle.between)};
  if (const auto post = tightest(at_pole); post && post->gap < smallest.gap)
    smallest = {post->gap, Cause::obstacle_contact, post->post, post->obstacle};
  return smallest;
}

}  // namespace

Verdict verdict_at(const MapTask& task, const Point& tracer) {
  const CopyingLinkage& linkage = task.linkage;
  const double distance = (tracer - linkage.pole()).norm();
  const auto opening = linkage.opening_at(distance);
  if (!opening) return unreachable(linkage, opening.error(), distance);
  const double transmission = linkage.transmission_angle(*opening);
  const double limit = std::max(task.limits.transmission, least_usable_angle);
  if (transmission < limit - transmission_rounding)
    return lost(Cause::transmission_below_limit,
                fmt::format("transmission below the limit: {:.4g} degrees here, the limit is {:.4g}",
                            degrees(transmission), degrees(limit)));
  const std::vector<PoleGap> at_pole = gaps_at_pole(task);
  if (const auto obstacle = obstacle_within(task.limits.clearance, at_pole))
    return lost(Cause::obstacle_contact,
                fmt::format("contact: {} stands within the clearance of the pole post, whatever the position",
                            *obstacle),
                {std::string("pole post ") + letter(linkage.pole_joint()), *obstacle});
  const Point reach = tracer - linkage.pole();
  const SmallestGap smallest = smallest_gap(task, at_pole, *opening, std::atan2(reach.y(), reach.x()));
  const double slack = undecided * (linkage.size() + task.limits.clearance);
  if (smallest.gap < task.limits.clearance - slack)
    return contact(smallest.cause, smallest.one, smallest.other, smallest.gap, task.limits.clearance);
  if (smallest.gap < task.limits.clearance + slack)
    return {false,
            true,
            std::nullopt,
            {smallest.one, smallest.other},
            fmt::format("uncertain: {} and {} are {:.6f} mm apart, as much as the clearance up to rounding",
                        smallest.one, smallest.other, smallest.gap)};
  return {true,
          false,
          std::nullopt,
          {},
          fmt::format("free: transmission angle {:.2f} degrees, smallest gap {:.3f} mm between {} and {}",
                      degrees(transmission), smallest.gap, smallest.one, smallest.other)};
}

}  // namespace kempe
