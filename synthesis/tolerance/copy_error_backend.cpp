// The copy error from below, with directed rounding. Notation: copy_error.cpp; all sensitivities here are times sin d, which
// leaves cos d and sin d alone and no quotient.

#include <algorithm>
#include <array>

#include "geometry/interval.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {
namespace {

const IntervalComplex one_exactly = exactly(1.0), i_exactly = exactly(i_unit);

/// Displacement of a plate's third hole by its three lengths (copy_error.cpp), for all holes of a rectangle.
std::array<IntervalComplex, 3> displacements_of(const IntervalComplex& hole, bool flat) {
  const auto unit = [](const IntervalComplex& z) { return z / IntervalComplex{length(z), Interval(0)}; };
  const IntervalComplex from_corner = unit(hole);
  if (flat) return {exactly(0.0), from_corner, i_exactly * from_corner};
  const IntervalComplex from_C = unit(hole - one_exactly);
  const Interval sine = from_corner.re * from_C.im - from_corner.im * from_C.re;
  const IntervalComplex across{sine, Interval(0)};
  const IntervalComplex by_C = i_exactly * from_corner / across;
  return {from_C.re * by_C, exactly(0.0) - i_exactly * from_C / across, by_C};
}

Interval part_along(const Complex& direction, const IntervalComplex& z) {
  return Interval(direction.real()) * z.re + Interval(direction.imag()) * z.im;
}

}  // namespace

bool CopyErrorProfile::surely_exceeds(double limit, const OpeningInterval& openings) const {
  // Whatever the direction, the longest deviation is at least what all sources do along it. A good one is that of the middle,
  // turned back from the pen's deviation to the loops'.
  const Complex direction =
      std::conj(output_) * longest_deviation(sensitivities(openings.middle()), tolerance_).direction;
  const OutwardRounding guard;
  const IntervalComplex k = widened(k_), s = pole_is_at_V_  ? k
                                             : pen_is_at_V_ ? one_exactly - one_exactly / k
                                                            : one_exactly - k;
  const auto xi = displacements_of(one_exactly / s, flat_), eta = displacements_of(s, flat_);
  const IntervalComplex e = direction_at({openings.lower, openings.upper});
  const IntervalComplex t = one_exactly - s, it = i_exactly * t;
  const auto times_sine = [&](const IntervalComplex& z) { return e.im * z; };
  const IntervalComplex by_VA = t * IntervalComplex{e.im, -e.re};
  const std::array<IntervalComplex, 8> by_length{
      by_VA,
      it,
      e * times_sine(one_exactly - s * xi[0]) - it,
      times_sine(eta[0] - one_exactly) + e.re * it,
      e * times_sine(s * xi[1]),
      e * times_sine(s * xi[2]),
      times_sine(eta[1]),
      times_sine(eta[2]),
  };
  using Pair = std::array<IntervalComplex, 2>;
  const Pair by_VA_bar{by_VA, exactly(0.0)}, by_VB_bar{e.re * it, times_sine(it)};
  const Pair by_pole = pole_is_at_V_ ? by_VA_bar : Pair{times_sine(s), times_sine(i_exactly * s)};
  const Pair by_C{times_sine(one_exactly) - e.re * it, times_sine(i_exactly - it)};
  const std::array<Pair, 5> by_play{by_pole, by_VB_bar, by_VA_bar, by_VB_bar, by_C};
  Interval sum(0);
  for (std::size_t j = 0; j < 8; ++j)
    sum += Interval(tolerance_.length[j]) * CGAL::abs(part_along(direction, by_length[j]));
  for (std::size_t j = 0; j < 5; ++j) {
    const Interval x = part_along(direction, by_play[j][0]), y = part_along(direction, by_play[j][1]);
    sum += Interval(tolerance_.play[j]) / 2.0 * CGAL::sqrt(CGAL::square(x) + CGAL::square(y));
  }
  if (pen_is_at_V_) sum *= length(k);
  const Interval allowed = Interval(limit) * CGAL::abs(e.im) * length(exactly(direction));
  return sum.inf() > allowed.sup();
}

}  // namespace kempe
