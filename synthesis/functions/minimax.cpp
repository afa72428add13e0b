// The smallest largest error near a design: linear programs within a box that grows while they predict well
// and shrinks while they do not (a trust region).

#include <algorithm>
#include <cmath>

#include "synthesis/functions/conditions.hpp"
#include "synthesis/functions/slack.hpp"
#include "synthesis/solvers/minimax_step.hpp"

namespace kempe {
namespace {

constexpr int most_steps = 120, own_places = 33;

/// A place of the search and how it stands.
struct Standing {
  GeneratorVector u;
  std::vector<ErrorRipple> ripples;
  std::vector<GeneratorLimit> limits;

  Standing(const GeneratorError& error, const GeneratorVector& at)
      : u(at), ripples(ripples_of(error, at)), limits(limits_of(error, at)) {}

  double largest() const { return ripples.front().height; }
  double broken() const {
    double most = 0;
    for (const GeneratorLimit& limit : limits) most = std::max(most, limit.excess.value);
    return most;
  }
  double merit(double weight) const { return largest() + weight * broken(); }
};

MinimaxProgram program_at(const GeneratorError& error, const Standing& standing,
                          const std::vector<WantedPlace>& places, double box) {
  const FunctionTask& task = error.task();
  std::vector<Sloped> figures;
  const double near = slack::same_place_of_x * (task.x_upper - task.x_lower);
  std::vector<double> watched;
  const auto watch = [&](double x) {
    for (const double other : watched)
      if (std::abs(other - x) < near) return;
    watched.push_back(x);
    const Sloped e = error.at(standing.u, x);
    figures.push_back(e);
    figures.push_back({-e.value, -e.slope});
  };
  for (const ErrorRipple& ripple : standing.ripples) watch(ripple.x);
  for (const WantedPlace& place : places) watch(place.x);
  MinimaxProgram program;
  program.box = box;
  const auto fill = [&](const std::vector<Sloped>& rows, Eigen::MatrixXd& slopes, Eigen::VectorXd& values) {
    slopes.resize(static_cast<Eigen::Index>(rows.size()), error.size());
    values.resize(slopes.rows());
    for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
      slopes.row(i) = rows[static_cast<std::size_t>(i)].slope;
      values[i] = rows[static_cast<std::size_t>(i)].value;
    }
  };
  fill(figures, program.figure_slopes, program.figures);
  std::vector<Sloped> limits;
  for (const GeneratorLimit& limit : standing.limits) limits.push_back(limit.excess);
  fill(limits, program.limit_slopes, program.limits);
  return program;
}

}  // namespace

std::optional<FunctionDesign> minimax_fit(const FunctionTask& task, const WantedAngles& wanted,
                                          const FunctionDesign& start) {
  const GeneratorError error(task, wanted, start.linkage.branch);
  const std::vector<WantedPlace> places = wanted.some_places(own_places);
  Standing now(error, error.unknowns_of(start));
  double box = 0.05, weight = 1;
  for (int i = 0; i < most_steps && box > slack::least_box && !task.stop(); ++i) {
    const auto step = solve_minimax_step(program_at(error, now, places, box));
    if (!step) {
      box *= now.broken() > 0 ? 2 : 0.25;
      if (box > 1) break;
      continue;
    }
    if (step->limit_multipliers.size() > 0) weight = std::max(weight, 2 * step->limit_multipliers.maxCoeff());
    const double predicted = now.merit(weight) - step->t;
    if (!(predicted > slack::least_gain * now.largest())) break;
    const Standing next(error, now.u + step->d);
    const double gained = now.merit(weight) - next.merit(weight);
    if (gained > 0.05 * predicted) now = next;
    const double size = step->d.cwiseAbs().maxCoeff();
    if (gained < 0.25 * predicted) box = 0.3 * size;
    if (gained > 0.75 * predicted) box = std::max(box, std::min(0.5, 2 * size));
  }
  FunctionDesign design = with_unknowns(error, start, now.u);
  if (measure_design(task, wanted, design) != FunctionDefect::none) return std::nullopt;
  return design;
}

}  // namespace kempe
