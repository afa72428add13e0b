// Interval arithmetic for the proven bound. Every double that leaves is rounded to the safe side.

#include <algorithm>
#include <cmath>

#include "synthesis/bound/box.hpp"
#include "synthesis/bound/reach_intervals.hpp"
#include "synthesis/bound/slack.hpp"

namespace kempe::bounding {
namespace {

void keep(Range& range, const Interval& values) {
  range.lower = std::max(range.lower, values.inf());
  range.upper = std::min(range.upper, values.sup());
}
void keep_at_least(Range& range, double lower) { range.lower = std::max(range.lower, lower); }
void keep_at_most(Range& range, double upper) { range.upper = std::min(range.upper, upper); }

struct Cosines {
  double far_at_most, near_at_least;
};
/// Largest cosine that the far end may have and smallest of the near end.
Cosines cosines(const ModeFacts& mode, double transmission) {
  const Range psi = mode.usable(transmission);
  return {cosine(Interval(psi.lower)).sup(), cosine(Interval(psi.upper)).inf()};
}

Interval ratio_squared(const PoleDistances& distances) {
  const Interval plain = Interval(distances.farthest_at_least) / Interval(distances.nearest_at_most);
  return CGAL::square(Interval(std::max(plain.inf(), distances.ratio_at_least)));
}

/// H(t) may not exceed (cos far - q^2 cos near) / (q^2 - 1), q = farthest / nearest: eliminates w from the
/// reach.
double H_limit(const PoleDistances& distances, const Cosines& limit) {
  if (!(distances.nearest_at_most > 0)) return (-Interval(limit.near_at_least)).sup();
  const Interval q2 = ratio_squared(distances);
  if (!(q2.inf() > 1)) return infinity;
  const Interval spread = Interval(limit.far_at_most) - q2 * Interval(limit.near_at_least);
  return (spread / (q2 - 1.0)).sup();
}

void keep_t_with_H_at_most(Range& t, double limit) {
  if (!(limit < 1e150)) return;
  const Interval H(limit);
  const Interval root = CGAL::sqrt(
      Interval(std::max(0.0, (CGAL::square(H) - 1.0).inf()), std::max(0.0, (CGAL::square(H) - 1.0).sup())));
  const Interval largest = H + root;
  keep_at_most(t, largest.sup());
  keep_at_least(t, (1.0 / Interval(largest.sup())).inf());
}

void keep_lengths_in_limits(const ModeFacts& mode, LengthBox& lengths) {
  const Interval a2 = CGAL::square(whole(mode.a)), b2 = CGAL::square(whole(mode.b));
  keep(lengths.w, 2.0 * whole(lengths.t) * a2);
  if (lengths.w.empty()) return;
  keep(lengths.w, 2.0 * b2 / whole(lengths.t));
  if (lengths.w.empty()) return;
  keep(lengths.t, whole(lengths.w) / (2.0 * a2));
  if (lengths.t.empty()) return;
  keep(lengths.t, 2.0 * b2 / whole(lengths.w));
}

void keep_reach(const ModeFacts& mode, const PoleDistances& distances, const Cosines& limit,
                LengthBox& lengths) {
  const Interval H = H_over(lengths.t);
  const Interval far = Interval(H.sup()) + Interval(limit.far_at_most);
  if (far.sup() > 0)
    keep_at_least(lengths.w,
                  (chain_squared(mode, Interval(distances.farthest_at_least)) / Interval(far.sup())).inf());
  const Interval between = Interval(limit.far_at_most) - Interval(limit.near_at_least);
  if (between.sup() > 0 && distances.squares_at_least > 0)
    keep_at_least(lengths.w, (CGAL::square(widened(mode.chain)) * Interval(distances.squares_at_least) /
                              Interval(between.sup()))
                                 .inf());
  const Interval near = Interval(H.inf()) + Interval(limit.near_at_least);
  if (near.inf() > 0)
    keep_at_most(lengths.w,
                 (chain_squared(mode, Interval(distances.nearest_at_most)) / Interval(near.inf())).sup());
}

/// Size of the smallest linkage with this t that reaches the farthest place:
/// c r (A + B t) / sqrt(t^2 + 2 t cos far + 1). Along t it has no minimum but at the ends of a range.
double size_on_far_limit(const ModeFacts& mode, const PoleDistances& distances, const Cosines& limit,
                         double t) {
  const Interval T(t);
  const Interval under = CGAL::square(T) + 2.0 * T * Interval(limit.far_at_most) + 1.0;
  if (!(under.sup() > 0)) return infinity;
  const Interval reach = widened(mode.chain) * Interval(distances.farthest_at_least);
  const Interval weight = widened(mode.size_per_a) + widened(mode.size_per_b) * T;
  return (reach * weight / CGAL::sqrt(Interval(under.sup()))).inf();
}

/// (A / sqrt t + B sqrt t) / sqrt 2, least over the range: size = sqrt(w) times this.
double size_per_root_w(const ModeFacts& mode, const Range& t) {
  const Interval A = widened(mode.size_per_a), B = widened(mode.size_per_b);
  const auto at = [&](const Interval& T) { return ((A + B * T) / CGAL::sqrt(2.0 * T)).inf(); };
  const Interval best = A / B;  // where the sum is least: sqrt(2 A B)
  if (best.sup() >= t.lower && best.inf() <= t.upper) return CGAL::sqrt(2.0 * A * B).inf();
  return std::min(at(Interval(t.lower)), at(Interval(t.upper)));
}

/// No opening of the assembly mode has a larger transmission angle, rad.
double widest_transmission(const ModeFacts& mode) {
  return ((Interval(mode.near_end) - mode.far_end) / 2.0).sup();
}

/// About the angle mu at which cos(far_end + mu) - weight cos(near_end - mu) falls to `needed`, rad; nothing proven.
double transmission_near(const ModeFacts& mode, double weight, double needed) {
  const NearestRounding nearest;
  const double along = std::cos(mode.far_end) - weight * std::cos(mode.near_end);
  const double across = std::sin(mode.far_end) + weight * std::sin(mode.near_end);
  const double size = std::hypot(along, across);
  if (!(size > 0)) return infinity;
  return std::acos(std::clamp(needed / size, -1.0, 1.0)) - std::atan2(across, along);
}

/// Largest transmission angle at which cos(far_end + mu) - weight cos(near_end - mu) >= needed: the left side
/// falls.
double transmission_with(const ModeFacts& mode, double weight, double needed) {
  const double widest = widest_transmission(mode);
  const double guess = transmission_near(mode, weight, needed);
  const auto impossible = [&](double mu) {
    const Interval far = Interval(mode.far_end) + mu, near = Interval(mode.near_end) - mu;
    return (cosine(far) - Interval(weight) * cosine(near)).sup() < needed;
  };
  if (impossible(0)) return -1;
  for (double above = slack::first_above_guess; above < 1; above *= 10) {
    const double mu = std::max(0.0, guess) + above;
    if (!(mu < widest)) break;
    if (impossible(mu)) return mu;
  }
  return widest;
}

double arc_at_most(double cosine_at_least) { return arc_cosine(Interval(cosine_at_least)).sup(); }
double arc_at_least(double cosine_at_most) { return arc_cosine(Interval(cosine_at_most)).inf(); }

/// Five corners whose hull holds every (a, b) of a box: its four corners, and where the tangents meet that
/// touch the lower hyperbola ab = w/2 at its ends (the upper hyperbola lies within its chord already).
std::array<Lengths, 5> hull_of(const LengthBox& lengths) {
  const Lengths left = lengths_of(lengths.t.upper, lengths.w.lower),
                right = lengths_of(lengths.t.lower, lengths.w.lower);
  const Interval sum = left.a + right.a;
  const Lengths tangents{2.0 * left.a * right.a / sum, Interval(lengths.w.lower) / sum};
  return {left, right, tangents, lengths_of(lengths.t.lower, lengths.w.upper),
          lengths_of(lengths.t.upper, lengths.w.upper)};
}

}  // namespace

Interval H_over(const Range& t) {
  const Interval at_lower = H_at(t.lower), at_upper = H_at(t.upper);
  const bool has_one = t.lower <= 1 && 1 <= t.upper;
  const double least = has_one ? 1 : std::max(1.0, std::min(at_lower.inf(), at_upper.inf()));
  return Interval(least, std::max(at_lower.sup(), at_upper.sup()));
}

Range ModeFacts::usable(double transmission) const {
  const OutwardRounding rounding;
  return {std::max((Interval(far_end) + transmission).inf(), allowed.lower),
          std::min((Interval(near_end) - transmission).sup(), allowed.upper)};
}

bool contract(const ModeFacts& mode, const PoleDistances& distances, double transmission,
              LengthBox& lengths) {
  const OutwardRounding rounding;
  if (mode.usable(transmission).empty()) return false;
  const Cosines limit = cosines(mode, transmission);
  const double H_most = H_limit(distances, limit);
  if (H_most < 1) return false;
  keep_t_with_H_at_most(lengths.t, H_most);
  for (int round = 0; round < 2; ++round) {
    if (lengths.t.empty() || lengths.w.empty()) return false;
    keep_lengths_in_limits(mode, lengths);
    if (lengths.t.empty() || lengths.w.empty()) return false;
    keep_reach(mode, distances, limit, lengths);
  }
  return !lengths.t.empty() && !lengths.w.empty();
}

double size_at_least(const ModeFacts& mode, const PoleDistances& distances, double transmission,
                     const LengthBox& lengths) {
  const OutwardRounding rounding;
  const Cosines limit = cosines(mode, transmission);
  const double by_reach = std::min(size_on_far_limit(mode, distances, limit, lengths.t.lower),
                                   size_on_far_limit(mode, distances, limit, lengths.t.upper));
  const Interval by_lengths =
      CGAL::sqrt(Interval(lengths.w.lower)) * Interval(size_per_root_w(mode, lengths.t));
  return std::max(by_reach, by_lengths.inf());
}

bool contract_by_size(const ModeFacts& mode, double size, LengthBox& lengths) {
  const OutwardRounding rounding;
  if (size < infinity)
    keep_at_most(lengths.w, CGAL::square(Interval(size) / Interval(size_per_root_w(mode, lengths.t))).sup());
  return !lengths.w.empty();
}

double transmission_at_most(const ModeFacts& mode, const PoleDistances& distances, const LengthBox& lengths) {
  const OutwardRounding rounding;
  const Interval H = H_over(lengths.t);
  double most = widest_transmission(mode);
  if (distances.nearest_at_most > 0) {  // w eliminated
    const double q2 = ratio_squared(distances).inf();
    if (q2 > 1)
      most = std::min(most, transmission_with(mode, q2, ((Interval(q2) - 1.0) * Interval(H.inf())).inf()));
  }
  if (distances.squares_at_least > 0)  // H eliminated
    most = std::min(most, transmission_with(mode, 1,
                                            (CGAL::square(widened(mode.chain)) *
                                             Interval(distances.squares_at_least) / Interval(lengths.w.upper))
                                                .inf()));
  const Interval far =
      chain_squared(mode, Interval(distances.farthest_at_least)) / Interval(lengths.w.upper) -
      Interval(H.sup());
  const Interval near = chain_squared(mode, Interval(distances.nearest_at_most)) / Interval(lengths.w.lower) -
                        Interval(H.inf());
  most = std::min(most, (Interval(arc_at_most(far.inf())) - mode.far_end).sup());
  most = std::min(most, (Interval(mode.near_end) - arc_at_least(near.sup())).sup());
  return most;
}

Range passed_by_all(const ModeFacts& mode, const PoleDistances& distances, const LengthBox& lengths) {
  const OutwardRounding rounding;
  const Interval H = H_over(lengths.t);
  const Interval near = chain_squared(mode, Interval(distances.nearest_at_most)) / Interval(lengths.w.lower) -
                        Interval(H.inf());
  const Interval far =
      chain_squared(mode, Interval(distances.farthest_at_least)) / Interval(lengths.w.upper) -
      Interval(H.sup());
  if (!(near.sup() < far.inf()) || far.inf() < -1 || near.sup() > 1) return {};
  return {arc_at_most(far.inf()), arc_at_least(near.sup())};
}

bool always_nearer(const ModeFacts& mode, const LengthBox& lengths, double psi, const MaterialPoint& first,
                   const MaterialPoint& second, double needed) {
  const OutwardRounding rounding;
  const IntervalComplex by_a = widened(first.of_a) - widened(second.of_a);
  const IntervalComplex by_b =
      (widened(first.of_b) - widened(second.of_b)) * direction_at(Interval(mode.bend * psi));
  const Interval limit = CGAL::square(Interval(needed));
  // The distance is a convex function of (a, b): its largest value over a hull is at a corner.
  for (const Lengths& corner : hull_of(lengths)) {
    const Interval x = by_a.re * corner.a + by_b.re * corner.b, y = by_a.im * corner.a + by_b.im * corner.b;
    if (!((CGAL::square(x) + CGAL::square(y)).sup() < limit.inf())) return false;
  }
  return true;
}

PoleDisc disc_around(const Range& x, const Range& y) {
  const Point centre(0.5 * (x.lower + x.upper), 0.5 * (y.lower + y.upper));
  const OutwardRounding rounding;
  const auto half = [](const Range& range, double middle) {
    return Interval(std::max((Interval(range.upper) - middle).sup(), (Interval(middle) - range.lower).sup()));
  };
  return {centre, CGAL::sqrt(CGAL::square(half(x, centre.x())) + CGAL::square(half(y, centre.y()))).sup()};
}

Spread spread_over(const Point& far, const Point& near, double rounding, const Range& x, const Range& y) {
  const OutwardRounding guard;
  Spread least{infinity, infinity};
  for (const double px : {x.lower, x.upper})
    for (const double py : {y.lower, y.upper}) {
      const auto from = [&](const Point& place) {
        return CGAL::sqrt(CGAL::square(Interval(px) - place.x()) + CGAL::square(Interval(py) - place.y()));
      };
      const Interval nearest = from(near) + rounding, farthest = from(far) - rounding;
      least.ratio = std::min(least.ratio, nearest.inf() > 0 ? (farthest / nearest).inf() : 0.0);
      least.squares = std::min(least.squares, (CGAL::square(farthest) - CGAL::square(nearest)).inf());
    }
  return {std::max(1.0, least.ratio), least.squares};
}

Range distance_from_box(const Point& corner, double rounding, const Range& x, const Range& y) {
  const OutwardRounding guard;
  const auto apart = [](const Range& range, double at) {
    return std::max({0.0, (Interval(range.lower) - at).inf(), (Interval(at) - range.upper).inf()});
  };
  const auto across = [](const Range& range, double at) {
    return std::max((Interval(range.upper) - at).sup(), (Interval(at) - range.lower).sup());
  };
  const Interval nearest =
      CGAL::sqrt(CGAL::square(Interval(apart(x, corner.x()))) + CGAL::square(Interval(apart(y, corner.y()))));
  const Interval farthest = CGAL::sqrt(CGAL::square(Interval(across(x, corner.x()))) +
                                       CGAL::square(Interval(across(y, corner.y()))));
  return {std::max(0.0, (nearest - rounding).inf()), (farthest + rounding).sup()};
}

}  // namespace kempe::bounding
