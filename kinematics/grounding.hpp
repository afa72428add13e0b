#pragma once
// What follows from a grounding: the roles of its joints, the plates' shape, the chain.

#include <array>
#include <optional>
#include <string_view>

#include "geometry/point.hpp"
#include "kempe/mechanism.hpp"

namespace kempe {

inline constexpr std::array<Joint, 6> all_joints{Joint::V, Joint::A, Joint::B, Joint::C, Joint::X, Joint::Y};
/// 'V', 'A', 'B', 'C', 'X' or 'Y'.
char letter(Joint joint);

/// The grounding of that name; nothing for any other word.
std::optional<Grounding> grounding_named(std::string_view word);

/// Which joint is the pole, which carries the tracer and which the pen.
struct JointRoles {
  Joint pole, tracer, pen;
  bool operator==(const JointRoles&) const = default;
};
JointRoles roles_of(Grounding grounding);

/// The grounding in which these joints have these roles; nothing if none has.
std::optional<Grounding> grounding_with(const JointRoles& roles);

/// True if the pole's pin is the one that joins VA and VB: else the two are pins of their own.
bool pole_is_at_V(Grounding grounding);

/// True if the pen sits there: then pole and tracer hold the plates' ends, and the loops close from both.
bool pen_is_at_V(Grounding grounding);

/// The shape s of the plates for a copy ratio k (finite, not 0; not 1 with the pen at V).
Complex shape_of(Complex k, Grounding grounding);

/// The copy ratio k whose plates have the shape s: the inverse of shape_of().
Complex ratio_of(Complex shape, Grounding grounding);

/// The chain X - V as a factor of tracer - pole: 1, -1 or -k.
Complex chain_per_tracer(Complex k, Grounding grounding);

/// Its magnitude, 1 or |k|.
double chain_length_per_tracer(Complex k, Grounding grounding);

}  // namespace kempe
