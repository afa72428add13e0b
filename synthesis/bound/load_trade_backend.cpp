#include <algorithm>
#include <cmath>
#include <vector>

#include "synthesis/bound/load_trade.hpp"
#include "synthesis/bound/load_waves.hpp"
#include "synthesis/bound/touch_figures.hpp"
#include "synthesis/bound/tracer_place.hpp"
#include "synthesis/solvers/minimax_step.hpp"

namespace kempe::bounding {
namespace {

/// Root(load error / limit) - 1, times |sin d|. At one psi it is a convex function of the lengths' logarithms, so it is nowhere below its
/// tangent at those of the middle; and there it is nowhere below a wave, whose slope along the cosine of psi changes by what its second
/// derivative tells. Nothing where that has no bound.
std::optional<FirstOrder> load_figure(const BoxMiddle& middle, const LoadWaves& loads,
                                      const FirstOrder& cosine_of_psi, const PsiThere& psi) {
  const ModeFacts& mode = middle.mode;
  const Phase there = phase_at(mode, Interval(psi.start)), all = phase_at(mode, whole(psi.range));
  const Lengths lengths = lengths_of(middle.t, middle.w);
  const auto waves = loads.of(lengths.a, lengths.b * length(widened(mode.s)), there);
  const Interval about = mode.bend * (whole(psi.range) - psi.start);
  const Wave below = touching_from_below(waves, there) + Wave{.c = Interval(-loads.sign_of_sine())};
  const Wave first = below.derivative(), second = first.derivative(), third = second.derivative();
  const Interval first_there = mode.bend * first.at(there);
  const Interval slope = -first_there / psi.sine_at_start;  // along the cosine
  // The second derivative along the cosine times the cube of the sine: in psi it is second * sine - first * cosine, with the slope
  // (third + first) * sine.
  const Interval first_all = first_there + mode.bend * about * (second.at(there) + about * third.at(all));
  const double curve = (second.at(there) * psi.sine_at_start - first_there * psi.cosine_at_start +
                        mode.bend * about * psi.sines * (mode.bend * third.at(all) + first_all))
                           .inf();
  if (curve < 0 && psi.sines.inf() <= 0) return std::nullopt;
  const Interval falls =
      curve < 0 ? Interval(curve) / (psi.sines * CGAL::square(psi.sines)).inf() : Interval(0);
  const SlopesOfRoot by_lengths = slopes_of_root(waves, there, all, about);
  FirstOrder figure = constant(below.at(there)) + slope * (cosine_of_psi - constant(psi.cosine_at_start)) +
                      by_lengths.by_log_t * middle.log_t() + by_lengths.by_log_w * middle.log_w();
  figure.off += CGAL::square(psi.cosines - psi.cosine_at_start) * falls / 2.0;
  return figure;
}

/// Of the reach, at the near end of psi (side 1) or its far end (-1): side log((H + cos psi) w / (c r)^2).
std::optional<FirstOrder> end_figure(const BoxMiddle& middle, const ReachedPlace& place, double side) {
  const Interval end = cosine(Interval(side > 0 ? middle.psi.upper : middle.psi.lower));
  const Interval slope = H_slope(Interval(middle.t)), slopes = H_slope(whole(middle.box.lengths.t));
  const Interval H = H_over(middle.box.lengths.t);
  const Interval unfolded = H_at(middle.t) + end, all = H + end;
  if (all.inf() <= 0) return std::nullopt;
  const FirstOrder log_unfolded = function_of(middle.log_t(), logarithm(unfolded), slope / unfolded,
                                              H / all - CGAL::square(slopes / all));
  return Interval(side) * (log_unfolded - place.log_square);
}

/// A convex function of the lengths' logarithms.
FirstOrder size_figure(const BoxMiddle& middle, double size) {
  const ModeFacts& mode = middle.mode;
  const Lengths lengths = lengths_of(middle.t, middle.w);
  const Interval of_a = widened(mode.size_per_a) * lengths.a / Interval(size),
                 of_b = widened(mode.size_per_b) * lengths.b / Interval(size);
  return constant(of_a + of_b - 1.0) + ((of_b - of_a) / 2.0) * middle.log_t() +
         ((of_a + of_b) / 2.0) * middle.log_w();
}

/// Of each no design has less than `middle`, its slopes and `off` tell.
std::vector<FirstOrder> figures_of(const BoxMiddle& middle, const LoadWaves& loads,
                                   const ReachedPlaces& places, const std::optional<double>& size) {
  std::vector<FirstOrder> figures;
  const auto add = [&](const Point& place, double side) {
    const auto there = reached(middle, place);
    if (!there) return;
    if (const auto end = end_figure(middle, *there, side)) figures.push_back(*end);
    const auto psi = psi_at(middle, *there);
    if (!psi) return;
    if (const auto load = load_figure(middle, loads, there->cosine, *psi)) figures.push_back(*load);
  };
  add(places.near, 1);
  add(places.far, -1);
  if (size) figures.push_back(size_figure(middle, *size));
  return figures;
}

/// Weights, with the sum 1, of figures whose sum is largest where it is least over the box, by their slopes in the middle. Nothing where
/// that is not positive.
std::optional<std::vector<double>> weights_of(const std::vector<FirstOrder>& figures,
                                              const BoxMiddle& middle) {
  const NearestRounding nearest;
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < FirstOrder::coordinates; ++i)
    if (middle.has_width(i)) free.push_back(i);
  const auto rows = static_cast<Eigen::Index>(figures.size()),
             columns = static_cast<Eigen::Index>(free.size());
  MinimaxProgram program;
  program.figures.resize(rows);
  program.figure_slopes.resize(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const FirstOrder& figure = figures[static_cast<std::size_t>(i)];
    program.figures[i] = figure.middle.inf() + figure.off.inf();
    for (Eigen::Index j = 0; j < columns; ++j)
      program.figure_slopes(i, j) = middle_of(figure.along[free[static_cast<std::size_t>(j)]]);
  }
  const auto step = solve_minimax_step(program);
  if (!step || !(step->t > 0)) return std::nullopt;
  return std::vector<double>(step->figure_multipliers.begin(), step->figure_multipliers.end());
}

bool is_missed(const FirstOrder& figure) { return (figure.middle + figure.off).inf() > 0; }

/// True if some weighted sum of the figures is above 0 all over the box.
bool are_never_kept_together(const std::vector<FirstOrder>& figures, const BoxMiddle& middle) {
  if (std::none_of(figures.begin(), figures.end(), is_missed)) return false;
  const auto weights = weights_of(figures, middle);
  if (!weights) return false;
  FirstOrder sum;
  for (std::size_t i = 0; i < figures.size(); ++i)
    if ((*weights)[i] > 0) sum = sum + Interval((*weights)[i]) * figures[i];
  return sum.all().inf() > 0;
}

}  // namespace

struct BoxTrade::Figures {
  BoxMiddle middle;
  ReachedPlaces places;
  std::vector<FirstOrder> all;

  bool are_never_kept_with(const std::optional<FirstOrder>& other) const {
    if (!other) return false;
    std::vector<FirstOrder> figures = all;
    figures.push_back(*other);
    return are_never_kept_together(figures, middle);
  }
};

BoxTrade::BoxTrade(const LoadTrade& trade, const ReachedPlaces& places, const DesignRange& box,
                   const BetterDesign& better) {
  const OutwardRounding rounding;
  const BoxMiddle middle(trade.mode_, box, places.rounding, better.transmission);
  figures_ = std::make_unique<const Figures>(
      Figures{middle, places, figures_of(middle, *trade.loads_, places, better.size)});
}

BoxTrade::~BoxTrade() = default;

bool BoxTrade::none_better() const {
  const OutwardRounding rounding;
  return are_never_kept_together(figures_->all, figures_->middle);
}

bool BoxTrade::none_better_without(const ContactTouch& touch) const {
  const OutwardRounding rounding;
  return figures_->are_never_kept_with(
      contact_figure(figures_->middle, touch, figures_->places.near, figures_->places.far));
}

bool BoxTrade::none_better_without(const ObstacleTouch& touch) const {
  const OutwardRounding rounding;
  return figures_->are_never_kept_with(obstacle_figure(figures_->middle, touch));
}

LoadTrade::LoadTrade(const Spec& spec, const ModeFacts& mode)
    : mode_(mode), loads_(std::make_shared<const LoadWaves>(spec, mode)) {}

}  // namespace kempe::bounding
