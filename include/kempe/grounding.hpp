#pragma once
// The three groundings of the one mechanism: which of the homologous points V, X, Y is the pole, the tracer, the pen.

#include <array>
#include <string_view>

#include "kempe/export.hpp"
#include "kempe/joint.hpp"

namespace kempe {

/// A grounding, named after what stands at the parallelogram's vertex V.
enum class Grounding {
  pole,    ///< pole V, tracer X, pen Y; s = k        (plagiograph)
  tracer,  ///< pole X, tracer V, pen Y; s = 1 - k    (drawing pantograph)
  pen      ///< pole X, tracer Y, pen V; s = 1 - 1/k  (variable ratio pantograph)
};
/// The three, in the order in which they are looked at and listed.
inline constexpr std::array<Grounding, 3> all_groundings{Grounding::pole, Grounding::tracer, Grounding::pen};

/// "pole", "tracer" or "pen".
KEMPE_EXPORT std::string_view name(Grounding grounding);

}  // namespace kempe
