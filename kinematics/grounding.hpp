#pragma once
// The three groundings of the one mechanism: which of the homologous points V, X, Y is the pole, the tracer, the pen.

#include <array>
#include <optional>
#include <string_view>

#include "geometry/point.hpp"

namespace kempe {

/// The six named points of the drawing.
enum class Joint { V, A, B, C, X, Y };
inline constexpr std::array<Joint, 6> all_joints{Joint::V, Joint::A, Joint::B, Joint::C, Joint::X, Joint::Y};
/// 'V', 'A', 'B', 'C', 'X' or 'Y'.
char letter(Joint joint);

/// A grounding, named after what stands at the parallelogram's vertex V.
enum class Grounding {
  pole,    ///< pole V, tracer X, pen Y; s = k        (plagiograph)
  tracer,  ///< pole X, tracer V, pen Y; s = 1 - k    (drawing pantograph)
  pen      ///< pole X, tracer Y, pen V; s = 1 - 1/k  (variable ratio pantograph)
};
inline constexpr std::array<Grounding, 3> all_groundings{Grounding::pole, Grounding::tracer, Grounding::pen};

/// "pole", "tracer" or "pen".
std::string_view name(Grounding grounding);

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

/// The shape s of the plates for a copy ratio k (finite, not 0; not 1 with the pen at V).
Complex shape_of(Complex k, Grounding grounding);

/// The copy ratio k whose plates have the shape s: the inverse of shape_of().
Complex ratio_of(Complex shape, Grounding grounding);

/// The chain X - V as a factor of tracer - pole: 1, -1 or -k.
Complex chain_per_tracer(Complex k, Grounding grounding);

/// Its magnitude, 1 or |k|.
double chain_length_per_tracer(Complex k, Grounding grounding);

}  // namespace kempe
