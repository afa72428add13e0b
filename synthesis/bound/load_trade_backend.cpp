#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "synthesis/bound/load_trade.hpp"
#include "synthesis/bound/load_waves.hpp"
#include "synthesis/bound/reach_intervals.hpp"
#include "synthesis/bound/slack.hpp"
#include "synthesis/solvers/minimax_step.hpp"

namespace kempe::bounding {
namespace {

/// Of a design: logarithms of t (H(t) is the hyperbolic cosine of the first) and w, and where the pole stands.
constexpr std::size_t log_t = 0, log_w = 1, pole_x = 2, pole_y = 3, coordinates = 4;
using Slopes = std::array<Interval, coordinates>;
using HalfWidths = std::array<double, coordinates>;

Slopes no_slopes() { return {Interval(0), Interval(0), Interval(0), Interval(0)}; }

Slopes times(const Interval& factor, const Slopes& slopes) {
  Slopes product = no_slopes();
  for (std::size_t i = 0; i < coordinates; ++i) product[i] = factor * slopes[i];
  return product;
}

/// No design of the box has less of a figure than the value in the middle and the slopes from there tell.
struct Figure {
  Interval value{0};
  Slopes along = no_slopes();
};

/// The designs of a box and what is asked of them.
struct Question {
  const ModeFacts& mode;
  const LoadWaves& loads;
  const DesignRange& box;
  double t, w;            ///< in the middle
  Point pole;             ///< the same
  HalfWidths half;        ///< of the box about the middle
  double place_rounding;  ///< mm
  Range psi;              ///< that they may have
  std::optional<double> size;
};

/// (c r)^2 / w with the tracer at a place; of its logarithm the slopes in the middle, and what it is off by from what they tell.
struct Reached {
  Interval middle, all;
  Interval by_x, by_y;
  Interval off;
};

/// Nothing where the pole may stand at the place.
std::optional<Reached> reached_at(const Question& asked, const Point& place) {
  const Interval about(-asked.place_rounding, asked.place_rounding);
  const auto square = [](const Interval& x, const Interval& y) { return CGAL::square(x) + CGAL::square(y); };
  const Interval x = Interval(asked.pole.x()) - place.x() + about,
                 y = Interval(asked.pole.y()) - place.y() + about;
  const Interval middle = square(x, y);
  const Interval all = square(x + Interval(-asked.half[pole_x], asked.half[pole_x]),
                              y + Interval(-asked.half[pole_y], asked.half[pole_y]));
  if (all.inf() <= 0) return std::nullopt;
  // The logarithm of r^2 is harmonic: along any direction its second derivative is 2 / r^2 at most.
  const double off = (square(Interval(asked.half[pole_x]), Interval(asked.half[pole_y])) / all.inf()).sup();
  const Interval chain = CGAL::square(widened(asked.mode.chain));
  return Reached{chain * middle / Interval(asked.w), chain * all / whole(asked.box.lengths.w),
                 2.0 * x / middle, 2.0 * y / middle, Interval(-off, off)};
}

/// Cosine of psi at a place, over 1 where it is not reached, with its slopes in the middle, and what it is off by from what they tell.
struct CosineAtPlace {
  Interval middle, all;
  Slopes along = no_slopes();
  Interval off{0};
};

CosineAtPlace cosine_of(const Question& asked, const Reached& reached) {
  const Interval H = H_over(asked.box.lengths.t);
  const double far = (Interval(asked.half[log_w]) + CGAL::abs(reached.by_x) * asked.half[pole_x] +
                      CGAL::abs(reached.by_y) * asked.half[pole_y] + reached.off)
                         .sup();
  return {reached.middle - H_at(asked.t),
          reached.all - H,
          {-H_slope(Interval(asked.t)), -reached.middle, reached.middle * reached.by_x,
           reached.middle * reached.by_y},
          reached.middle * reached.off + reached.all * CGAL::square(Interval(far)) * Interval(0, 0.5) -
              H * CGAL::square(Interval(asked.half[log_t])) * Interval(0, 0.5)};
}

/// Root(load error / limit) - 1, times |sin d|. At one psi it is a convex function of the lengths' logarithms, so it is nowhere below its
/// tangent at those of the middle; and there it is nowhere below a wave, whose slope along the cosine of psi changes by what its second
/// derivative tells. Nothing where that has no bound.
std::optional<Figure> load_figure(const Question& asked, const CosineAtPlace& cosine_of_psi) {
  const Interval reachable = arc_cosine(cosine_of_psi.all);
  const Range psi{std::max(reachable.inf(), asked.psi.lower), std::min(reachable.sup(), asked.psi.upper)};
  if (psi.empty()) return std::nullopt;
  const double start = std::clamp(middle_of(arc_cosine(cosine_of_psi.middle)), psi.lower, psi.upper);
  const Interval sine_there = sine(Interval(start)), sines = sine(whole(psi)), cosines = cosine(whole(psi));
  if (sine_there.inf() <= 0) return std::nullopt;
  const ModeFacts& mode = asked.mode;
  const Phase there = phase_at(mode, Interval(start)), all = phase_at(mode, whole(psi));
  const Lengths middle = lengths_of(asked.t, asked.w);
  const auto waves = asked.loads.of(middle.a, middle.b * length(widened(mode.s)), there);
  const Interval about = mode.bend * (whole(psi) - start);
  const Wave below = touching_from_below(waves, there) + Wave{.c = Interval(-asked.loads.sign_of_sine())};
  const Wave first = below.derivative(), second = first.derivative(), third = second.derivative();
  const Interval first_there = mode.bend * first.at(there);
  const Interval slope = -first_there / sine_there;  // along the cosine
  // The second derivative along the cosine times the cube of the sine: in psi it is second * sine - first * cosine, with the slope
  // (third + first) * sine.
  const Interval first_all = first_there + mode.bend * about * (second.at(there) + about * third.at(all));
  const double curve = (second.at(there) * sine_there - first_there * cosine(Interval(start)) +
                        mode.bend * about * sines * (mode.bend * third.at(all) + first_all))
                           .inf();
  if (curve < 0 && sines.inf() <= 0) return std::nullopt;
  const Interval falls = curve < 0 ? Interval(curve) / (sines * CGAL::square(sines)).inf() : Interval(0);
  const Interval start_cosine = cosine(Interval(start));
  const SlopesOfRoot lengths = slopes_of_root(waves, there, all, about);
  Figure figure{below.at(there) + slope * (cosine_of_psi.middle - start_cosine + cosine_of_psi.off) +
                    CGAL::square(cosines - start_cosine) * falls / 2.0,
                times(slope, cosine_of_psi.along)};
  figure.along[log_t] += lengths.by_log_t;
  figure.along[log_w] += lengths.by_log_w;
  return figure;
}

/// Of the reach, at the near end of psi (side 1) or its far end (-1): side log((H + cos psi) w / (c r)^2).
std::optional<Figure> end_figure(const Question& asked, const Reached& reached, double side) {
  const Interval end = cosine(Interval(side > 0 ? asked.psi.upper : asked.psi.lower));
  const Interval slope = H_slope(Interval(asked.t)), slopes = H_slope(whole(asked.box.lengths.t));
  const Interval H = H_over(asked.box.lengths.t);
  const Interval unfolded = H_at(asked.t) + end, all = H + end;
  if (all.inf() <= 0) return std::nullopt;
  const Interval curve = H / all - CGAL::square(slopes / all);
  const Interval value = logarithm(unfolded) - logarithm(reached.middle) +
                         curve * CGAL::square(Interval(asked.half[log_t])) * Interval(0, 0.5);
  return Figure{side * value + reached.off,
                times(Interval(side), {slope / unfolded, Interval(1), -reached.by_x, -reached.by_y})};
}

/// A convex function of the lengths' logarithms.
Figure size_figure(const Question& asked, double size) {
  const ModeFacts& mode = asked.mode;
  const Lengths middle = lengths_of(asked.t, asked.w);
  const Interval of_a = widened(mode.size_per_a) * middle.a / Interval(size),
                 of_b = widened(mode.size_per_b) * middle.b / Interval(size);
  return {of_a + of_b - 1.0, {(of_b - of_a) / 2.0, (of_a + of_b) / 2.0, Interval(0), Interval(0)}};
}

std::vector<Figure> figures_of(const Question& asked, const ReachedPlaces& places) {
  std::vector<Figure> figures;
  const auto add = [&](const Point& place, double side) {
    const auto reached = reached_at(asked, place);
    if (!reached) return;
    if (const auto end = end_figure(asked, *reached, side)) figures.push_back(*end);
    if (const auto load = load_figure(asked, cosine_of(asked, *reached))) figures.push_back(*load);
  };
  add(places.near, 1);
  add(places.far, -1);
  if (asked.size) figures.push_back(size_figure(asked, *asked.size));
  return figures;
}

/// Weights, with the sum 1, of figures whose sum is largest where it is least over the box, by their slopes in the middle. Nothing where
/// that is not positive.
std::optional<std::vector<double>> weights_of(const std::vector<Figure>& figures, const HalfWidths& half) {
  const NearestRounding nearest;
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < coordinates; ++i)
    if (half[i] > 0) free.push_back(i);
  const auto rows = static_cast<Eigen::Index>(figures.size()),
             columns = static_cast<Eigen::Index>(free.size());
  MinimaxProgram program;
  program.figures.resize(rows);
  program.figure_slopes.resize(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Figure& figure = figures[static_cast<std::size_t>(i)];
    program.figures[i] = figure.value.inf();
    for (Eigen::Index j = 0; j < columns; ++j) {
      const std::size_t coordinate = free[static_cast<std::size_t>(j)];
      program.figure_slopes(i, j) = middle_of(figure.along[coordinate]) * half[coordinate];
    }
  }
  const auto step = solve_minimax_step(program);
  if (!step || !(step->t > 0)) return std::nullopt;
  return std::vector<double>(step->figure_multipliers.begin(), step->figure_multipliers.end());
}

/// Logarithm of a ratio of at least 1, or a little more.
double log_at_most(double upper, double lower) { return (Interval(upper) / Interval(lower) - 1.0).sup(); }

double log_from_middle_of(const Range& range, double middle) {
  return std::max(log_at_most(range.upper, middle), log_at_most(middle, range.lower));
}

double from_middle_of(const Range& range, double middle) {
  return std::max((Interval(range.upper) - middle).sup(), (Interval(middle) - range.lower).sup());
}

}  // namespace

LoadTrade::LoadTrade(const Spec& spec, const ModeFacts& mode)
    : mode_(mode), loads_(std::make_shared<const LoadWaves>(spec, mode)) {}

bool LoadTrade::none_better(const ReachedPlaces& places, const DesignRange& box, double transmission,
                            std::optional<double> size) const {
  const double t = std::sqrt(box.lengths.t.lower * box.lengths.t.upper);
  const double w = std::sqrt(box.lengths.w.lower * box.lengths.w.upper);
  const double x = 0.5 * (box.x.lower + box.x.upper), y = 0.5 * (box.y.lower + box.y.upper);
  const OutwardRounding rounding;
  const HalfWidths half{log_from_middle_of(box.lengths.t, t), log_from_middle_of(box.lengths.w, w),
                        from_middle_of(box.x, x), from_middle_of(box.y, y)};
  const Question asked{
      mode_, *loads_, box, t, w, Point(x, y), half, places.rounding, mode_.usable(transmission), size};
  const std::vector<Figure> figures = figures_of(asked, places);
  const auto is_missed = [](const Figure& figure) { return figure.value.inf() > 0; };
  if (std::none_of(figures.begin(), figures.end(), is_missed)) return false;
  const auto weights = weights_of(figures, half);
  if (!weights) return false;
  Figure sum;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Interval weight((*weights)[i]);
    if (weight.sup() <= 0) continue;
    sum.value += weight * figures[i].value;
    for (std::size_t c = 0; c < coordinates; ++c) sum.along[c] += weight * figures[i].along[c];
  }
  for (std::size_t c = 0; c < coordinates; ++c) sum.value += sum.along[c] * Interval(-half[c], half[c]);
  return sum.value.inf() > 0;
}

}  // namespace kempe::bounding
