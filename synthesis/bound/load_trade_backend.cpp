#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/interval.hpp"
#include "synthesis/bound/load_trade.hpp"
#include "synthesis/bound/slack.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/load_error.hpp"

namespace kempe::bounding {
namespace {

constexpr Complex left_turn{0, 1};

/// A figure of the lengths with its slopes along the logarithms of t and w.
struct Figure {
  Interval value, along_t, along_w;
};

/// A number, and a vector, that depend on psi, with their slopes.
struct TurningNumber {
  Interval value, slope;
};
struct TurningVector {
  IntervalComplex value, slope;
};

TurningVector operator*(const IntervalComplex& factor, const TurningVector& v) {
  return {factor * v.value, factor * v.slope};
}
TurningVector operator*(const TurningNumber& factor, const TurningVector& v) {
  return {factor.value * v.value, factor.slope * v.value + factor.value * v.slope};
}
TurningVector operator*(const TurningNumber& factor, const IntervalComplex& v) {
  return {factor.value * v, factor.slope * v};
}
TurningVector operator-(const TurningVector& u, const TurningVector& v) {
  return {u.value - v.value, u.slope - v.slope};
}
TurningVector fixed(const IntervalComplex& v) { return {v, exactly({0, 0})}; }

/// One term of the compliance: coefficient * length^power * (force . direction)^2, for 1 N at Y (synthesis/loads/link_forces.hpp).
struct Term {
  Interval coefficient;
  TurningVector force;
  bool is_of_VA;
  int power;
};

struct Bar {
  Interval VA, VB;  ///< mm
};

/// What holds for all terms of a linkage.
struct Section {
  Complex s;
  double bend;
  Interval across, along;  ///< per mm^3 and per mm, of 1 N
};

struct TurningArm {
  TurningVector along, across;
};

using TurningPlate = std::array<TurningArm, 3>;  // at its corner, C and tip

void add_plate_terms(const Section& section, const std::array<PlateArm, 2>& arms, const TurningPlate& forces,
                     bool is_of_VA, std::vector<Term>& terms) {
  for (const PlateArm& arm : arms) {
    const Interval length = widened(arm.length);
    const TurningArm& at_end = forces[static_cast<std::size_t>(arm.end)];
    terms.push_back({section.across * length * length * length, at_end.across, is_of_VA, 3});
    terms.push_back({section.along * length, at_end.along, is_of_VA, 1});
  }
}

/// Nothing near a change point, where the forces have no bound.
std::vector<Term> terms_at(const Interval& psi, const Section& section) {
  const IntervalComplex s = widened(section.s), one = exactly(1.0), left = exactly(left_turn);
  const Interval plate = length(s);
  const IntervalComplex s_direction{s.re / plate, s.im / plate};
  const IntervalComplex turned = s_direction * direction_at(section.bend * psi);
  const TurningVector e{turned, section.bend * (left * turned)};
  if (e.value.im.inf() <= 0 && e.value.im.sup() >= 0) return {};
  const IntervalComplex side = left * (one - s);
  const TurningNumber cosecant{1.0 / e.value.im, -e.slope.im / CGAL::square(e.value.im)};
  const TurningNumber minus_cosecant{-cosecant.value, -cosecant.slope}, cosine{e.value.re, e.slope.re};
  const TurningVector side_turned = side * e;
  const TurningVector bar_VA = cosecant * side_turned, bar_VB = minus_cosecant * side;
  const IntervalComplex minus = exactly(-1.0), whole{plate, Interval(0)};
  const TurningPlate ACX{{{cosine * bar_VA, minus * side_turned},
                          {s * e - cosine * bar_VA, left * e},
                          {whole * e, whole * (left * e)}}};
  const TurningPlate BCY{{{cosine * bar_VB, fixed(minus * side)},
                          {bar_VA - fixed(s), fixed(minus * (left * s))},
                          {fixed(s_direction), fixed(left * s_direction)}}};
  const bool straight = is_straight(section.s);
  std::vector<Term> terms;
  add_plate_terms(section, plate_arms(1.0 / section.s, straight), ACX, false, terms);
  add_plate_terms(section, plate_arms(section.s, straight), BCY, true, terms);
  terms.push_back({section.along, bar_VA, true, 1});
  terms.push_back({section.along, bar_VB, false, 1});
  return terms;
}

double middle_of(const Interval& x) { return 0.5 * (x.inf() + x.sup()); }

Interval scale_of(const Term& term, const Bar& bar) {
  const Interval& length = term.is_of_VA ? bar.VA : bar.VB;
  return term.coefficient * (term.power == 3 ? length * length * length : length);
}

/// The direction in which the pen gives way most, about.
Complex softest_direction(const std::vector<Term>& terms, const Bar& bar) {
  Complex sum = 0;
  for (const Term& term : terms) {
    const Complex force(middle_of(term.force.value.re), middle_of(term.force.value.im));
    sum += middle_of(scale_of(term, bar)) * force * force;
  }
  return std::polar(1.0, 0.5 * std::arg(sum));
}

/// Psi at one distance of the tracer, with its slopes; nothing where some design does not reach it between its change points.
std::optional<Figure> psi_at(const ModeFacts& mode, double distance, const Interval& t, const Interval& w) {
  const Interval reached = CGAL::square(widened(mode.chain) * Interval(distance)) / w;
  const Interval cosine = reached - (t + 1.0 / t) / 2.0;
  if (cosine.inf() <= -1 || cosine.sup() >= 1) return std::nullopt;
  const Interval sine = CGAL::sqrt(1.0 - CGAL::square(cosine));
  if (sine.inf() <= 0) return std::nullopt;
  return Figure{arc_cosine(cosine), (t - 1.0 / t) / 2.0 / sine, reached / sine};
}

/// Load error in a direction, over the limit, less 1.
Figure load_figure(const std::vector<Term>& terms, const Bar& bar, const Figure& psi, Complex direction,
                   const Interval& per_limit) {
  Figure sum{Interval(-1), Interval(0), Interval(0)};
  for (const Term& term : terms) {
    const Interval scale = per_limit * scale_of(term, bar);
    const auto along = [&](const IntervalComplex& v) {
      return v.re * Interval(direction.real()) + v.im * Interval(direction.imag());
    };
    const Interval force = along(term.force.value);
    const Interval by_psi = scale * (2.0 * force * along(term.force.slope));
    const Interval square = scale * CGAL::square(force), half_power(0.5 * term.power);
    sum.value += square;
    sum.along_t += by_psi * psi.along_t + (term.is_of_VA ? -half_power : half_power) * square;
    sum.along_w += by_psi * psi.along_w + half_power * square;
  }
  return sum;
}

/// Of two figures in a sum.
struct Weights {
  double first, second;
  Interval sum(const Interval& x, const Interval& y) const {
    return Interval(first) * x + Interval(second) * y;
  }
};

/// Half the widths of a box about its middle, in logarithms of t and w.
struct HalfWidths {
  double t, w;
};

/// Lower bound of a weighted sum over the box: from the value in the middle and the slopes over the box.
double sum_at_least(const Weights& weights, const Figure& first, const Figure& second,
                    const Figure& first_slopes, const Figure& second_slopes, const HalfWidths& half) {
  const Interval value = weights.sum(first.value, second.value);
  const Interval along_t = weights.sum(first_slopes.along_t, second_slopes.along_t);
  const Interval along_w = weights.sum(first_slopes.along_w, second_slopes.along_w);
  const Interval t(-half.t, half.t), w(-half.w, half.w);
  return (value + along_t * t + along_w * w).inf();
}

/// Logarithm of a ratio of at least 1, or a little more.
double log_at_most(double upper, double lower) { return (Interval(upper) / Interval(lower) - 1.0).sup(); }

double log_from_middle_of(const Range& range, double middle) {
  return std::max(log_at_most(range.upper, middle), log_at_most(middle, range.lower));
}

/// Load errors at the two psi first, each in the direction given.
constexpr std::size_t load_figures = 2;

/// What is asked of the designs of a box.
struct Question {
  const ModeFacts& mode;
  const PoleDistances& distances;
  double transmission;
  std::optional<double> size;
  Section section;
  Interval per_limit;  ///< force over limit
};

/// Of the load error at one psi; nothing near a change point. `direction`: chosen here where it is 0.
std::optional<Figure> load_figure_at(const Question& asked, const Bar& bar, const Figure& psi,
                                     Complex& direction) {
  const std::vector<Term> terms = terms_at(psi.value, asked.section);
  if (terms.empty()) return std::nullopt;
  if (direction == 0.0) direction = softest_direction(terms, bar);
  return load_figure(terms, bar, psi, direction, asked.per_limit / squared_length(exactly(direction)));
}

Figure size_figure(const ModeFacts& mode, const Interval& a, const Interval& b, double size) {
  const Interval of_a = mode.size_per_a * a / Interval(size), of_b = mode.size_per_b * b / Interval(size);
  return {of_a + of_b - 1.0, (of_b - of_a) / 2.0, (of_a + of_b) / 2.0};
}

/// All figures over ranges of t and w; none where they have no bound.
std::vector<Figure> figures_over(const Question& asked, const Interval& t, const Interval& w,
                                 std::array<Complex, load_figures>& directions) {
  const ModeFacts& mode = asked.mode;
  const auto near = psi_at(mode, asked.distances.nearest_at_most, t, w);
  const auto far = psi_at(mode, asked.distances.farthest_at_least, t, w);
  if (!near || !far) return {};
  const Interval a = CGAL::sqrt(w / t / 2.0), b = CGAL::sqrt(w * t / 2.0);
  const Bar bar{a, b * length(widened(mode.s))};
  const auto load_near = load_figure_at(asked, bar, *near, directions[0]);
  const auto load_far = load_figure_at(asked, bar, *far, directions[1]);
  if (!load_near || !load_far) return {};
  const Interval angle(asked.transmission);
  std::vector<Figure> figures{*load_near,
                              *load_far,
                              {near->value - Interval(mode.near_end) + angle, near->along_t, near->along_w},
                              {Interval(mode.far_end) + angle - far->value, -far->along_t, -far->along_w}};
  if (asked.size) figures.push_back(size_figure(mode, a, b, *asked.size));
  return figures;
}

/// Those of two figures whose sum does not change along one coordinate in the middle of a box.
std::optional<Weights> cancelling(const Interval& first_slope, const Interval& second_slope) {
  const double first = middle_of(first_slope), second = middle_of(second_slope);
  if (!(first * second < 0)) return std::nullopt;
  return Weights{std::abs(second), std::abs(first)};
}

}  // namespace

LoadTrade::LoadTrade(const Spec& spec, const ModeFacts& mode)
    : mode_(mode), limit_(*spec.limits.load_error * (1 + slack::load_limit)),
      force_(most_force_at_pen(*spec.load)), E_(spec.material->E), width_(spec.links.style.width),
      thickness_(spec.links.style.thickness) {}

bool LoadTrade::none_better(const PoleDistances& distances, const LengthBox& lengths, double transmission,
                            std::optional<double> size) const {
  if (!(distances.nearest_at_most > 0 && distances.nearest_at_most < distances.farthest_at_least))
    return false;
  const double t = std::sqrt(lengths.t.lower * lengths.t.upper);
  const double w = std::sqrt(lengths.w.lower * lengths.w.upper);
  const OutwardRounding rounding;
  const HalfWidths half{log_from_middle_of(lengths.t, t), log_from_middle_of(lengths.w, w)};
  const Interval area = Interval(width_) * thickness_, E(E_);
  const Interval factor =
      pen_is_at_V(mode_.grounding) ? 1.0 / squared_length(widened(mode_.s) - exactly(1.0)) : Interval(1);
  const Question asked{
      mode_,
      distances,
      transmission,
      size,
      {mode_.s, mode_.bend, 4.0 / (E * area * CGAL::square(Interval(width_))), 1.0 / (E * area)},
      Interval(force_) * factor / Interval(limit_)};
  std::array<Complex, load_figures> directions{};
  const std::vector<Figure> at_middle = figures_over(asked, Interval(t), Interval(w), directions);
  std::vector<Figure> over_box;  // worked out once a pair is promising
  const auto is_positive = [&](std::size_t i, std::size_t j, const std::optional<Weights>& weights) {
    if (!weights) return false;
    const Figure &load = at_middle[i], &other = at_middle[j];
    if (!(sum_at_least(*weights, load, other, load, other, half) > 0)) return false;
    if (over_box.empty())
      over_box = figures_over(asked, Interval(lengths.t.lower, lengths.t.upper),
                              Interval(lengths.w.lower, lengths.w.upper), directions);
    return !over_box.empty() && sum_at_least(*weights, load, other, over_box[i], over_box[j], half) > 0;
  };
  for (std::size_t i = 0; i < load_figures && !at_middle.empty(); ++i)
    for (std::size_t j = load_figures; j < at_middle.size(); ++j)
      if (is_positive(i, j, cancelling(at_middle[i].along_t, at_middle[j].along_t)) ||
          is_positive(i, j, cancelling(at_middle[i].along_w, at_middle[j].along_w)))
        return true;
  return false;
}

}  // namespace kempe::bounding
