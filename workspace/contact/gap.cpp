#include "workspace/contact/gap.hpp"

#include <algorithm>
#include <limits>

#include "geometry/segment_distance.hpp"

namespace kempe {
namespace {

bool have_common_joint(const Part& a, const Part& b) {
  if (a.kind != Part::Kind::link && b.kind != Part::Kind::link) return a.joint == b.joint;
  if (a.kind != Part::Kind::link) return has_joint(b.link, a.joint);
  if (b.kind != Part::Kind::link) return has_joint(a.link, b.joint);
  const LinkJoints joints = joints_of(a.link);
  return std::any_of(joints.joints.begin(), joints.joints.begin() + joints.count,
                     [&](Joint joint) { return has_joint(b.link, joint); });
}

Hull hull_in(const JointHull& piece, const Pose& pose) {
  return {{pose[piece.joints[0]], pose[piece.joints[1]], pose[piece.joints[2]]}, piece.count};
}

}  // namespace

std::string name(const ContactPair& pair) { return name(pair.first) + " and " + name(pair.second); }

std::vector<ContactPair> contact_pairs(const CopyingLinkage& linkage, const LayerAssignment& layers) {
  const std::vector<Part> parts = parts_of(linkage, layers);
  std::vector<ContactPair> pairs;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      const Part &a = parts[i], &b = parts[j];
      const bool share_layer =
          std::max(a.lowest_layer, b.lowest_layer) <= std::min(a.highest_layer, b.highest_layer);
      if ((share_layer || (a.is_post() && b.is_post())) && !have_common_joint(a, b)) pairs.push_back({a, b});
    }
  return pairs;
}

double gap(const ContactPair& pair, const Pose& pose, Complex shape, const LinkStyle& style) {
  double least = std::numeric_limits<double>::infinity();
  const auto others = axis_of(pair.second, shape, style.plate);
  for (const JointHull& one : axis_of(pair.first, shape, style.plate))
    for (const JointHull& other : others)
      least = std::min(least, distance(hull_in(one, pose), hull_in(other, pose)));
  return least - half_width(pair.first, style) - half_width(pair.second, style);
}

Tightest tightest_gap(const CopyingLinkage& linkage, const Pose& pose, const LinkStyle& style,
                      const LayerAssignment& layers) {
  Tightest tightest{std::numeric_limits<double>::infinity(), std::nullopt};
  for (const ContactPair& pair : contact_pairs(linkage, layers))
    if (const double here = gap(pair, pose, linkage.shape(), style); here < tightest.gap)
      tightest = {here, pair};
  return tightest;
}

}  // namespace kempe
