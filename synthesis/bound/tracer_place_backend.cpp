#include <algorithm>
#include <cmath>

#include "synthesis/bound/tracer_place.hpp"

namespace kempe::bounding {
namespace {

/// Logarithm of a ratio of at least 1, or a little more.
double log_at_most(double upper, double lower) { return (Interval(upper) / Interval(lower) - 1.0).sup(); }

double log_from_middle_of(const Range& range, double middle) {
  return std::max(log_at_most(range.upper, middle), log_at_most(middle, range.lower));
}

double from_middle_of(const Range& range, double middle) {
  return std::max((Interval(range.upper) - middle).sup(), (Interval(middle) - range.lower).sup());
}

double geometric_middle(const Range& range) {
  const NearestRounding nearest;
  return std::sqrt(range.lower * range.upper);
}

Point middle_of(const Range& x, const Range& y) {
  const NearestRounding nearest;
  return {0.5 * (x.lower + x.upper), 0.5 * (y.lower + y.upper)};
}

}  // namespace

BoxMiddle::BoxMiddle(const ModeFacts& of_mode, const DesignRange& all, double rounding_of_places,
                     double transmission)
    : mode(of_mode), box(all), t(geometric_middle(all.lengths.t)), w(geometric_middle(all.lengths.w)),
      pole(middle_of(all.x, all.y)), place_rounding(rounding_of_places),
      psi(of_mode.usable(transmission)), half_{log_from_middle_of(all.lengths.t, t),
                                               log_from_middle_of(all.lengths.w, w),
                                               from_middle_of(all.x, pole.x()),
                                               from_middle_of(all.y, pole.y())} {}

FirstOrder BoxMiddle::step(std::size_t coordinate) const {
  FirstOrder f;
  f.along[coordinate] = Interval(half_[coordinate]);
  return f;
}

FirstOrder BoxMiddle::t_itself() const {
  return function_of(log_t(), Interval(t), Interval(t), whole(box.lengths.t));
}

/// The hyperbolic cosine of t's logarithm.
FirstOrder BoxMiddle::H() const {
  return function_of(log_t(), H_at(t), H_slope(Interval(t)), H_over(box.lengths.t));
}

std::optional<ReachedPlace> reached(const BoxMiddle& middle, const Point& place) {
  const Interval about(-middle.place_rounding, middle.place_rounding);
  const auto squared = [](const Interval& x, const Interval& y) { return CGAL::square(x) + CGAL::square(y); };
  const FirstOrder pole_x = middle.pole_x(), pole_y = middle.pole_y();
  const Interval x = Interval(middle.pole.x()) - place.x() + about,
                 y = Interval(middle.pole.y()) - place.y() + about;
  const Interval there = squared(x, y), all = squared(x + pole_x.spread(), y + pole_y.spread());
  if (all.inf() <= 0) return std::nullopt;
  // The logarithm of r^2 is harmonic: along any direction its second derivative is 2 / r^2 at most.
  const double off = (squared(pole_x.spread(), pole_y.spread()) / all.inf()).sup();
  const Interval chain = CGAL::square(widened(middle.mode.chain));
  ReachedPlace reached;
  reached.square = chain * there / Interval(middle.w);
  reached.squares = chain * all / whole(middle.box.lengths.w);
  reached.log_square = constant(logarithm(reached.square)) - middle.log_w() + (2.0 * x / there) * pole_x +
                       (2.0 * y / there) * pole_y;
  reached.log_square.off = Interval(-off, off);
  reached.cosine =
      function_of(reached.log_square, reached.square, reached.square, reached.squares) - middle.H();
  return reached;
}

PsiThere PsiThere::about(const Range& range, double start) {
  return {
      range, start, cosine(Interval(start)), sine(Interval(start)), cosine(whole(range)), sine(whole(range))};
}

std::optional<PsiThere> psi_at(const BoxMiddle& middle, const ReachedPlace& place) {
  const Interval reachable = arc_cosine(place.squares - H_over(middle.box.lengths.t));
  const Range psi{std::max(reachable.inf(), middle.psi.lower), std::min(reachable.sup(), middle.psi.upper)};
  if (psi.empty()) return std::nullopt;
  const double start = std::clamp(middle_of(arc_cosine(place.cosine.middle)), psi.lower, psi.upper);
  const PsiThere there = PsiThere::about(psi, start);
  return there.sine_at_start.inf() > 0 ? std::optional(there) : std::nullopt;
}

FirstOrder sine_of(const FirstOrder& cosine, const PsiThere& psi) {
  const FirstOrder from_start = cosine - constant(psi.cosine_at_start);
  FirstOrder sine = constant(psi.sine_at_start) - (psi.cosine_at_start / psi.sine_at_start) * from_start;
  sine.off -= CGAL::square(psi.cosines - psi.cosine_at_start) / (2.0 * psi.sines * CGAL::square(psi.sines));
  return sine;
}

}  // namespace kempe::bounding
