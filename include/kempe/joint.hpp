#pragma once
// The joints of the copying linkage.

namespace kempe {

/// The six named points of the drawing: the parallelogram V A C B, and the plates' ends X and Y. V, X and Y are the homologous
/// points, corners of a triangle that stays similar to itself.
enum class Joint { V, A, B, C, X, Y };

}  // namespace kempe
