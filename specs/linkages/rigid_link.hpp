#pragma once
// A rigid link from its lengths and angles: the joints' places in the link's own frame.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/side.hpp"

namespace kempe {

struct JointDistance {
  std::size_t a, b;  ///< numbers of joints
  double length;     ///< mm, > 0
};

/// The angle at `at` from the arm to `from` to the arm to `to`, counter-clockwise.
struct JointAngle {
  std::size_t from, at, to;
  double angle;  ///< rad
};

struct RigidLinkTask {
  std::vector<std::string> joints;  ///< names, at least two
  std::vector<JointDistance> lengths;
  std::vector<JointAngle> angles;
  std::optional<Side> side;  ///< of joints that two lengths place, against first -> second joint
};

/// What a person has to say or change, the joints named.
struct NotRigid {
  std::string found, allowed;
};

/// The joints' places: the first at the origin, the second on the positive x axis. Each further joint is
/// placed from joints already placed, by a length and an angle or by two lengths and the side. Superfluous
/// lengths and angles must agree within 1e-6. Nothing is guessed: what does not follow is an error.
tl::expected<std::vector<Point>, NotRigid> place_joints(const RigidLinkTask& task);

}  // namespace kempe
