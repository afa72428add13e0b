#pragma once
// A place of the tracer as the designs of a box reach it, to first order about the box's middle: for the proven bound's backends.

#include <optional>

#include "synthesis/bound/first_order.hpp"
#include "synthesis/bound/load_trade.hpp"
#include "synthesis/bound/reach_intervals.hpp"

namespace kempe::bounding {

/// A box of designs, its middle, and what is asked of the designs.
class BoxMiddle {
 public:
  BoxMiddle(const ModeFacts& mode, const DesignRange& box, double place_rounding, double transmission);

  /// The logarithms of t and w, and where the pole stands (mm), less the middle's.
  FirstOrder log_t() const { return step(0); }
  FirstOrder log_w() const { return step(1); }
  FirstOrder pole_x() const { return step(2); }
  FirstOrder pole_y() const { return step(3); }
  /// t itself, and H(t).
  FirstOrder t_itself() const;
  FirstOrder H() const;
  /// Of coordinates in whose direction the box has no width nothing changes.
  bool has_width(std::size_t coordinate) const { return half_[coordinate] > 0; }

  const ModeFacts& mode;
  const DesignRange& box;
  const double t, w;
  const Point pole;
  const double place_rounding;  ///< mm
  const Range psi;              ///< |psi| that designs may have

 private:
  FirstOrder step(std::size_t coordinate) const;
  std::array<double, FirstOrder::coordinates> half_;
};

/// What a place is to all designs of a box, wherever psi is there.
struct ReachedPlace {
  Interval square, squares;  ///< (c r)^2 / w in the middle and over the box
  FirstOrder log_square;     ///< its logarithm
  FirstOrder cosine;         ///< of psi; over 1 in size for a design that does not reach the place
};
/// Nothing where the pole may stand at the place.
std::optional<ReachedPlace> reached(const BoxMiddle& middle, const Point& place);

/// psi at a place: those |psi| that designs may have, and the one from which figures are told, about the middle's.
struct PsiThere {
  Range range;
  double start;
  Interval cosine_at_start, sine_at_start, cosines, sines;

  static PsiThere about(const Range& range, double start);
};
/// Nothing where no design may have it, or the start is a change point.
std::optional<PsiThere> psi_at(const BoxMiddle& middle, const ReachedPlace& place);

/// The sine of psi, as a function of the cosine. The sines must be above 0.
FirstOrder sine_of(const FirstOrder& cosine, const PsiThere& psi);

}  // namespace kempe::bounding
