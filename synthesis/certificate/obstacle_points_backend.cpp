// With z = T - P, w = g z, r = |w|^2, h = +-sqrt(4 a^2 b^2 - (r - a^2 - b^2)^2) and zeta = (1 + (a^2 - b^2 - i h)/r)/2:
//     p = w zeta,   q/s = w - p,   J = P + A p + B q/s = P + w ((A - B) zeta + B)
// for the constants A, B of a material point seen from the pole's joint. Seen from another joint it is J = w ((A - B) zeta + B), with
// the constants seen from there. V, X and Y have A = B. J's derivatives over the cell bound its way from the
// middle design (mean value theorem).

#include <algorithm>
#include <cmath>

#include "geometry/interval.hpp"
#include "synthesis/certificate/obstacle_points.hpp"
#include "synthesis/certificate/slack.hpp"

namespace kempe::certificate {
namespace {

struct Figures {
  Interval a, b, x, y;
};

Figures figures_of(const DesignCell& cell, bool middle) {
  const auto of = [&](Variable variable) {
    return middle ? Interval(cell.middle(variable)) : Interval(cell[variable].lower, cell[variable].upper);
  };
  return {of(Variable::a), of(Variable::b), of(Variable::x), of(Variable::y)};
}

/// The parts of the formula above.
struct Terms {
  IntervalComplex z, w;
  Interval r, difference, rest, h;  // a^2 - b^2, r - a^2 - b^2
  IntervalComplex zeta;
};

std::optional<Terms> terms_of(const Root& root, const Figures& at, const Point& place) {
  Terms t;
  t.z = {Interval(place.x()) - at.x, Interval(place.y()) - at.y};
  t.w = widened(root.g) * t.z;
  t.r = squared_length(t.w);
  const Interval a2 = CGAL::square(at.a), b2 = CGAL::square(at.b);
  t.difference = a2 - b2;
  t.rest = t.r - a2 - b2;
  const Interval h2 = 4.0 * a2 * b2 - CGAL::square(t.rest);
  if (!(h2.inf() > 0) || !(t.r.inf() > 0)) return std::nullopt;
  t.h = root.mode.bend * CGAL::sqrt(h2);
  const Interval half(0.5);
  t.zeta = {half * (1.0 + t.difference / t.r), -(half * t.h / t.r)};
  return t;
}

IntervalComplex times_i(const IntervalComplex& z) { return {-z.im, z.re}; }

/// J = P + w B whatever the lengths are, which need not reach the place.
PointRange copied_point_over(const Root& root, const DesignCell& cell, const Point& place,
                             const bounding::MaterialPoint& from, bool seen_from_a_joint) {
  const OutwardRounding rounding;
  const IntervalComplex map = widened(root.g) * widened(from.of_b);
  const IntervalComplex pole = exactly(as_complex(cell.pole())),
                        of_pole = exactly(seen_from_a_joint ? 0.0 : 1.0);
  const IntervalComplex at = of_pole * pole + map * (exactly(as_complex(place)) - pole);
  const Point J(0.5 * (at.re.inf() + at.re.sup()), 0.5 * (at.im.inf() + at.im.sup()));
  const Interval moves =
      (Interval(cell.half(Variable::x)) + Interval(cell.half(Variable::y))) * slack::whole_half;
  const Interval rounded = Interval(at.re.sup() - at.re.inf()) + Interval(at.im.sup() - at.im.inf());
  return PointRange{J, (length(of_pole - map) * moves + rounded).sup()};
}

}  // namespace

std::optional<PointRange> point_over(const Root& root, const DesignCell& cell, const Point& place,
                                     const bounding::MaterialPoint& from, bool copied,
                                     bool seen_from_a_joint) {
  if (copied) return copied_point_over(root, cell, place, from, seen_from_a_joint);
  const OutwardRounding rounding;
  const IntervalComplex B = widened(from.of_b), A_less_B = widened(from.of_a - from.of_b);
  const double of_pole = seen_from_a_joint ? 0 : 1;
  const auto middle = terms_of(root, figures_of(cell, true), place);
  const Figures whole = figures_of(cell, false);
  const auto over = terms_of(root, whole, place);
  if (!middle || !over) return std::nullopt;
  const auto turned = [&](const Terms& t) { return A_less_B * t.zeta + B; };
  const IntervalComplex at = middle->w * turned(*middle);
  const Point J(of_pole * cell.middle(Variable::x) + 0.5 * (at.re.inf() + at.re.sup()),
                of_pole * cell.middle(Variable::y) + 0.5 * (at.im.inf() + at.im.sup()));

  const Terms& t = *over;
  const Interval per_r = Interval(0.5) / t.r;
  const IntervalComplex base = t.w * A_less_B;
  const auto by_length = [&](const Interval& own, const Interval& other, double sign) {
    const Interval h_slope = 2.0 * own * (2.0 * CGAL::square(other) + t.rest) / t.h;
    return base * IntervalComplex{2.0 * sign * own * per_r, -(h_slope * per_r)};
  };
  const Interval h_by_r = -(t.rest / t.h);
  const IntervalComplex zeta_by_r{-(t.difference * per_r / t.r), (t.h / t.r - h_by_r) * per_r};
  const Interval g2 = CGAL::square(widened(std::abs(root.g)));
  const IntervalComplex by_r = base * zeta_by_r, direct = widened(root.g) * turned(t);
  const IntervalComplex by_x = exactly(of_pole) - direct + (-2.0 * g2 * t.z.re) * by_r;
  const IntervalComplex by_y = exactly(Complex(0, of_pole)) - times_i(direct) + (-2.0 * g2 * t.z.im) * by_r;

  Interval away = Interval((at.re.sup() - at.re.inf()) + (at.im.sup() - at.im.inf()));
  const auto add = [&](Variable variable, const IntervalComplex& slope) {
    if (cell.half(variable) > 0) away += length(slope) * (Interval(cell.half(variable)) * slack::whole_half);
  };
  add(Variable::a, by_length(whole.a, whole.b, 1));
  add(Variable::b, by_length(whole.b, whole.a, -1));
  add(Variable::x, by_x);
  add(Variable::y, by_y);
  return PointRange{J, away.sup()};
}

}  // namespace kempe::certificate
