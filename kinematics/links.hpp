#pragma once
// Which joints a link has, and the axes of what is fixed to a link at its end.

#include <array>
#include <string_view>

#include "kempe/mechanism.hpp"
#include "kempe/point.hpp"

namespace kempe {

/// "VA", "VB", "ACX" or "BCY".
std::string_view name(Link link);

/// The link's joints: two for a bar (the third entry of `joints` unused), three for a plate, in the order of
/// the name.
struct LinkJoints {
  std::array<Joint, 3> joints;
  int count;
};
LinkJoints joints_of(Link link);

/// True if the joint is one of the link's.
bool has_joint(Link link, Joint joint);

/// The one of V, X and Y that is the link's: only these can be tracer or pen.
Joint end_of(Link link);

/// True if the link's joints differ by multiples of p (VA, BCY), false if by multiples of q (VB, ACX): the link turns with that
/// side of the parallelogram.
bool is_along_p(Link link);

/// The joint of the link that is nearest to its end, on plates of shape s: of a plate's two, the one that comes first in the link's
/// name if they are equally near, but for rounding.
Joint nearest_to_end(Link link, Complex s);

/// The direction from the link's end to that joint as a multiple of the direction of p or q: a number of size 1. What is fixed to the
/// link at its end has this for its x axis.
Complex axis_at_end(Link link, Complex s);

}  // namespace kempe
