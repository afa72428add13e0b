#pragma once
// The similarity that best carries points of the original to points of the copy.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/point.hpp"

namespace kempe {

/// A point under the tracer and the point that the pen should be at, mm.
struct PointPair {
  Point tracer, pen;
};

/// pen = k tracer + translation, with the least sum of squared distances at the pen.
struct SimilarityFit {
  Complex k;
  Point translation;            ///< mm
  double residual_rms = 0;      ///< mm, at the pen
  double residual_largest = 0;  ///< mm, at the pen

  /// The point that the similarity leaves where it is, translation / (1 - k): the pole. Nothing for k = 1.
  std::optional<Point> fixed_point() const;
};

/// Why pairs determine no copy ratio.
enum class PairFault {
  too_few,        ///< fewer than two different tracer points
  one_pen_point,  ///< all pen points in one place: k = 0
  mirrored,       ///< a reflection fits clearly better than a rotation
  no_similarity   ///< more than half of the pen points' spread remains unexplained
};

/// Complex linear least squares: with means x' and y', k = sum conj(x - x') (y - y') / sum |x - x'|^2. Values
/// of k within rounding of a quarter turn are put on it. Expects finite points. A mirrored set is one whose
/// best reflection leaves less than half the residual.
tl::expected<SimilarityFit, PairFault> fit_similarity(const std::vector<PointPair>& pairs);

}  // namespace kempe
