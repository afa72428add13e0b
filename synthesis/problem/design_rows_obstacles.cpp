// The rows of a design problem that look beyond reach and self-contact: obstacles, gap between original and copy, copy error, size.
#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/problem/row_parts.hpp"
#include "synthesis/problem/slack.hpp"

namespace kempe {
namespace {

using namespace row_parts;

/// Openings at which the copy error is looked at between the region's two.
constexpr int error_openings = 17;

}  // namespace

RowJet DesignProblem::obstacle_row_values(const Row& row, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const ObstacleTerm& term = terms_.obstacles[row.index];
  const PlacedJoints joints(reach_, roles_, lengths_of(x), layout_.pole(x), places_[row.place]);
  const PlacedJet gap = obstacle_gap_jet(term, space_.obstacles()[term.obstacle], joints);
  jet.value = gap.value / layout_.unit;
  jet.gradient[log_VA] = gap.by_u / layout_.unit;
  jet.gradient[log_VB] = gap.by_v / layout_.unit;
  if (layout_.pole_is_free) jet.gradient.segment<2>(pole_x) = gap.by_pole;
  if (goal_ == Goal::clearance) {
    jet.value -= x[layout_.goal()];
    jet.gradient[layout_.goal()] = -1;
  } else {
    jet.value -= limits_.clearance / layout_.unit + slack::inward_obstacle;
  }
  return jet;
}

RowJet DesignProblem::obstacle_row(const Row& row, const DesignVector& x, Derivatives wanted) const {
  RowJet jet = obstacle_row_values(row, x);
  if (wanted != Derivatives::second) return jet;
  constexpr double step = slack::obstacle_step;  // second derivatives as differences of exact first ones
  for (int j = 0; j < layout_.size(); ++j) {
    if (j == DesignLayout::near_opening || j == DesignLayout::far_opening) continue;
    DesignVector ahead = x, behind = x;
    ahead[j] += step;
    behind[j] -= step;
    jet.hessian.col(j) =
        (obstacle_row_values(row, ahead).gradient - obstacle_row_values(row, behind).gradient) / (2 * step);
  }
  jet.hessian = (0.5 * (jet.hessian + jet.hessian.transpose())).eval();
  return jet;
}

RowJet DesignProblem::copy_gap_row(std::size_t corner, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const SearchSpace::CornerGap gap = space_.copy_gap(space_.gap_corners()[corner], layout_.pole(x));
  jet.value = gap.distance / layout_.unit;
  if (layout_.pole_is_free) {
    const auto back = [&](const Point& z) { return as_point(std::conj(gap.factor) * as_complex(z)); };
    jet.gradient.segment<2>(pole_x) = back(gap.normal);
    if (gap.curvature != 0) {
      const Point along = back(Point(-gap.normal.y(), gap.normal.x()).normalized());
      jet.hessian.block<2, 2>(pole_x, pole_x) = gap.curvature * layout_.unit * along * along.transpose();
    }
  }
  if (goal_ == Goal::copy_gap) {
    jet.value -= x[layout_.goal()];
    jet.gradient[layout_.goal()] = -1;
  } else {
    jet.value -= *limits_.copy_gap / layout_.unit + slack::inward_distance;
  }
  return jet;
}

RowJet DesignProblem::copy_error_row(double share, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  const double opening = near + share * (far - near), scale = goal_scale();
  const CopyErrorAt here = copy_error_->at(opening);
  constexpr double step = slack::copy_error_step;
  const double curvature =
      (copy_error_->at(opening + step).worst_slope - copy_error_->at(opening - step).worst_slope) /
      (2 * step);
  jet.value = x[layout_.goal()] - here.worst / scale;
  jet.gradient[layout_.goal()] = 1;
  const std::array<std::pair<int, double>, 2> weights{
      {{DesignLayout::near_opening, 1 - share}, {DesignLayout::far_opening, share}}};
  for (const auto& [i, of_i] : weights) {
    jet.gradient[i] = -of_i * here.worst_slope / scale;
    for (const auto& [j, of_j] : weights) jet.hessian(i, j) = -of_i * of_j * curvature / scale;
  }
  return jet;
}

RowJet DesignProblem::size_row(const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const Reach::LengthFactors& f = reach_.factors();
  const double of_VA = f.size_per_VA * std::exp(x[log_VA]) / layout_.unit;
  const double of_VB = f.size_per_VB * std::exp(x[log_VB]) / layout_.unit;
  jet.value = *limits_.size / layout_.unit - of_VA - of_VB;
  jet.gradient.head<2>() << -of_VA, -of_VB;
  jet.hessian.topLeftCorner<2, 2>().diagonal() << -of_VA, -of_VB;
  return jet;
}

/// The one objective without a formula: an area, by differences. Curvature is left to the solver.
RowJet DesignProblem::footprint_objective(const DesignVector& x, Derivatives wanted) const {
  RowJet jet = zero_jet(layout_.size());
  const auto area = [&](const DesignVector& at) { return footprint_at(point_of(at)) / goal_scale(); };
  jet.value = area(x);
  if (wanted == Derivatives::none) return jet;
  constexpr double step = slack::footprint_step;
  for (int j = 0; j < layout_.size(); ++j) {
    if (j == DesignLayout::near_opening || j == DesignLayout::far_opening) continue;
    DesignVector ahead = x, behind = x;
    ahead[j] += step;
    behind[j] -= step;
    jet.gradient[j] = (area(ahead) - area(behind)) / (2 * step);
  }
  return jet;
}

void DesignProblem::add_obstacles(std::vector<Row>& rows, const DesignVector& x, double band) const {
  if (terms_.obstacles.empty()) return;
  const double unit = layout_.unit;
  const double enough = (goal_ == Goal::clearance ? x[layout_.goal()] * unit : limits_.clearance) +
                        (band + slack::inward_obstacle) * unit;
  std::vector<double> smallest(terms_.obstacles.size(), enough);
  std::vector<Row> worst(terms_.obstacles.size(), {Row::Kind::obstacle});
  const LogLengths lengths = lengths_of(x);
  const SideLengths sides = reach_.sides(lengths);
  for (std::size_t p = 0; p < places_.size(); ++p) {
    const PlacedJoints joints(reach_, roles_, lengths, sides, layout_.pole(x), places_[p]);
    for (std::size_t t = 0; t < terms_.obstacles.size(); ++t) {
      const ObstacleTerm& term = terms_.obstacles[t];
      const double gap =
          obstacle_gap(term, space_.obstacles()[term.obstacle], joints, smallest[t], Beyond::anything);
      if (gap >= smallest[t]) continue;
      smallest[t] = gap;
      worst[t] = {Row::Kind::obstacle, t, 0, p};
    }
  }
  for (std::size_t t = 0; t < worst.size(); ++t)
    if (smallest[t] < enough) rows.push_back(worst[t]);
}

void DesignProblem::add_copy_gap(std::vector<Row>& rows, const DesignVector& x) const {
  if ((!limits_.copy_gap && goal_ != Goal::copy_gap) || space_.gap_corners().empty()) return;
  rows.push_back({Row::Kind::copy_gap, space_.smallest_copy_gap(layout_.pole(x)).corner});
}

void DesignProblem::add_copy_errors(std::vector<Row>& rows, const DesignVector& x) const {
  if (!copy_error_) return;
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  double largest = 0, at = 0;
  for (int i = 0; i < error_openings; ++i) {
    const double share = i / (error_openings - 1.0);
    const double error = copy_error_->at(near + share * (far - near)).worst;
    if (error > largest) largest = error, at = share;
  }
  for (const double share : {0.0, 1.0, at}) rows.push_back({Row::Kind::copy_error, 0, share});
}

}  // namespace kempe
