#pragma once
// The copy ratio k: how much larger the copy is than the original, and how far it is turned.

#include <cstddef>
#include <optional>

#include "kempe/export.hpp"
#include "kempe/point.hpp"

namespace kempe {

/// How well pairs of points fit a similarity (complex least squares).
struct PairFit {
  std::size_t pairs = 0;              ///< that were fitted
  double residual_rms = 0;            ///< mm, at the pen
  double residual_largest = 0;        ///< mm, at the pen
  Point translation = Point::Zero();  ///< the similarity's value at the tracer's origin, mm
};

/// A copy ratio: pen - pole = k (tracer - pole).
///
/// Invariant: scale(), rotation() and k() are the same ratio; only the functions below make one. Nothing is refused here:
/// validate() says what no linkage can copy by.
class KEMPE_EXPORT Copy {
 public:
  /// Scale 1 without rotation: a translation, which has no pole, until a ratio is given.
  Copy() = default;

  /// From a scale (> 0) and a rotation, rad, counter-clockwise. Both are kept as they are, 0, negative numbers and NaN too:
  /// validate() and design() refuse them, under copy.scale or copy.rotation_deg. k is exact at whole quarter turns, where sine
  /// and cosine round.
  static Copy of(double scale, double rotation);
  /// From the ratio itself: scale |k|, rotation arg k in (-pi, pi]. k is kept as it is, 0 and NaN too: validate() and design()
  /// refuse them.
  static Copy of(Complex k);
  /// The same, of a ratio that pairs of points determined; `fit` is kept for the report, its translation in the table's frame.
  static Copy fitted(Complex k, const PairFit& fit);

  double scale() const { return scale_; }                     ///< |k|
  double rotation() const { return rotation_; }               ///< rad
  Complex k() const { return k_; }                            ///< the ratio itself
  const std::optional<PairFit>& fit() const { return fit_; }  ///< present if pairs gave the ratio

 private:
  Copy(double scale, double rotation, Complex k) : scale_(scale), rotation_(rotation), k_(k) {}

  double scale_ = 1, rotation_ = 0;
  Complex k_{1, 0};
  std::optional<PairFit> fit_;
};

}  // namespace kempe
