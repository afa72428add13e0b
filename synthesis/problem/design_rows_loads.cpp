// The rows of a design problem about load error, mass and sag.
#include <algorithm>
#include <cmath>

#include "synthesis/problem/row_parts.hpp"
#include "synthesis/problem/slack.hpp"

namespace kempe {
namespace {

using namespace row_parts;

/// Openings at which the rows know the largest sag: fewer than of the load error (load_openings), as each costs much more.
constexpr int sag_openings = 5;
/// Times its limit: what a sag counts as that the equations do not give.
constexpr double largest_sag_counted = 1e6;

BarLengths bar_lengths(const LogLengths& lengths) { return {std::exp(lengths.u), std::exp(lengths.v)}; }

constexpr std::array both_points{Carrier::tracer, Carrier::pen};

/// Where a row about the openings between the region's two gets its slopes from.
constexpr std::array<int, 4> variables_of_linkage{log_VA, log_VB, DesignLayout::near_opening,
                                                  DesignLayout::far_opening};

/// From log VA, log VB and the opening at `share` to the four variables.
Eigen::Matrix<double, 3, 4> chain_at(double share) {
  Eigen::Matrix<double, 3, 4> chain = Eigen::Matrix<double, 3, 4>::Zero();
  chain(0, 0) = chain(1, 1) = 1;
  chain(2, 2) = 1 - share;
  chain(2, 3) = share;
  return chain;
}

double at_length(const std::array<double, 3>& c, double length) {
  return c[0] + length * (c[1] + length * c[2]);
}

}  // namespace

void DesignProblem::ask_for_loads() {
  const Spec& spec = space_.spec();
  const LogLengths typical{std::log(layout_.unit), std::log(layout_.unit)};
  if ((goal_ == Goal::load_error || limits_.load_error) && spec.load && spec.material)
    load_error_ = load_error_profile(spec, space_.k(), choice_.grounding);
  if ((goal_ == Goal::mass || limits_.mass) && spec.material)
    mass_ = mass_polynomial(spec, space_.k(), choice_.grounding);
  if (limits_.sag && spec.material)
    sag_ = SagProfile(space_.k(), choice_.grounding, sag_conditions(spec, choice_.layers));
  if (goal_ == Goal::load_error && load_error_)
    goal_scale_ =
        load_error_->at(bar_lengths(typical), 0.5 * (reach_.interval().lower + reach_.interval().upper))
            .worst;
  if (goal_ == Goal::mass && mass_) goal_scale_ = mass_at(typical);
}

double DesignProblem::load_error_over(const LogLengths& lengths, double from, double to, int openings) const {
  const BarLengths bars = bar_lengths(lengths);
  double largest = 0;
  for (int i = 0; i < openings; ++i)
    largest = std::max(largest, load_error_->at(bars, from + i / (openings - 1.0) * (to - from)).worst);
  return largest;
}

/// At the ends and in the middle: it changes slowly, and the finished design is looked at closely.
double DesignProblem::sag_over(const LogLengths& lengths, double from, double to) const {
  const BarLengths bars = bar_lengths(lengths);
  double largest = 0;
  for (const double opening : {from, 0.5 * (from + to), to})
    largest = std::max(largest, sag_->at(bars.VA, bars.VB, opening).most());
  return largest;
}

double DesignProblem::mass_at(const LogLengths& lengths) const {
  const BarLengths bars = bar_lengths(lengths);
  return at_length(mass_->of_VA, bars.VA) + at_length(mass_->of_VB, bars.VB);
}

/// The goal's t, or the limit, against the load error at one opening: both as logarithms, since it grows with cubes of lengths.
RowJet DesignProblem::load_error_row(double share, const DesignVector& x, Derivatives wanted) const {
  RowJet jet = zero_jet(layout_.size());
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  const LoadErrorJet error = load_error_->worst(bar_lengths(lengths_of(x)), near + share * (far - near),
                                                wanted == Derivatives::second);
  const bool is_goal = goal_ == Goal::load_error;
  const double limit = is_goal ? x[layout_.goal()] + std::log(goal_scale())
                               : std::log(*limits_.load_error * (1 - slack::inward_load_error));
  jet.value = limit - std::log(error.value);
  if (is_goal) jet.gradient[layout_.goal()] = 1;
  const Eigen::Vector3d slope = error.gradient / error.value;
  constexpr std::array<int, 4> at = variables_of_linkage;
  const Eigen::Matrix<double, 3, 4> chain = chain_at(share);
  const Eigen::Vector4d gradient = chain.transpose() * slope;
  for (int i = 0; i < 4; ++i) jet.gradient[at[static_cast<std::size_t>(i)]] -= gradient[i];
  if (wanted != Derivatives::second) return jet;
  const Eigen::Matrix3d curve = error.hessian / error.value - slope * slope.transpose();
  const Eigen::Matrix4d hessian = chain.transpose() * curve * chain;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      jet.hessian(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]) -= hessian(i, j);
  return jet;
}

/// The limit against the sag of one point at one opening.
RowJet DesignProblem::sag_row_values(const Row& row, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const BarLengths bars = bar_lengths(lengths_of(x));
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  const SagJet sag = sag_->jet(bars.VA, bars.VB, near + row.share * (far - near), both_points[row.index]);
  const double limit = *limits_.sag * (1 - slack::inward_sag), times = sag.value / limit;
  if (!std::isfinite(sag.value) || !sag.gradient.allFinite()) {
    jet.value = std::log(2.0) - std::log1p(largest_sag_counted);
    return jet;
  }
  jet.value = std::log(2.0) - (times > 0 ? std::log1p(times) : times);
  const Eigen::Vector4d gradient =
      chain_at(row.share).transpose() * sag.gradient / (limit * (1 + std::max(0.0, times)));
  for (std::size_t i = 0; i < 4; ++i)
    jet.gradient[variables_of_linkage[i]] -= gradient[static_cast<Eigen::Index>(i)];
  return jet;
}

RowJet DesignProblem::sag_row(const Row& row, const DesignVector& x, Derivatives wanted) const {
  RowJet jet = sag_row_values(row, x);
  if (wanted != Derivatives::second) return jet;
  constexpr double step = slack::sag_step;  // second derivatives as differences of exact first ones
  for (const int j : variables_of_linkage) {
    DesignVector ahead = x, behind = x;
    ahead[j] += step;
    behind[j] -= step;
    jet.hessian.col(j) =
        (sag_row_values(row, ahead).gradient - sag_row_values(row, behind).gradient) / (2 * step);
  }
  jet.hessian = (0.5 * (jet.hessian + jet.hessian.transpose())).eval();
  return jet;
}

/// For each point that sinks: at both ends and where it sinks most.
void DesignProblem::add_sags(std::vector<Row>& rows, const DesignVector& x) const {
  if (!has_limit_that_jumps()) return;
  const BarLengths bars = bar_lengths(lengths_of(x));
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  std::array<double, 2> most{}, at{};
  for (int i = 0; i < sag_openings; ++i) {
    const double share = i / (sag_openings - 1.0);
    const SagAt sag = sag_->at(bars.VA, bars.VB, near + share * (far - near));
    const std::array drops{sag.tracer.total(), sag.pen.total()};
    for (std::size_t point = 0; point < 2; ++point)
      if (!(drops[point] <= most[point])) most[point] = drops[point], at[point] = share;
  }
  for (std::size_t point = 0; point < 2; ++point) {
    if (most[point] == 0) continue;
    for (const double share : {0.0, 1.0}) rows.push_back({Row::Kind::sag, point, share});
    if (at[point] > 0 && at[point] < 1) rows.push_back({Row::Kind::sag, point, at[point]});
  }
}

/// The mass in shares of the goal's scale.
RowJet DesignProblem::mass_in_vector(const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const BarLengths bars = bar_lengths(lengths_of(x));
  const auto add = [&](int variable, const std::array<double, 3>& c, double length) {
    jet.value += at_length(c, length) / goal_scale_;
    jet.gradient[variable] += length * (c[1] + 2 * length * c[2]) / goal_scale_;
    jet.hessian(variable, variable) += length * (c[1] + 4 * length * c[2]) / goal_scale_;
  };
  add(log_VA, mass_->of_VA, bars.VA);
  add(log_VB, mass_->of_VB, bars.VB);
  return jet;
}

RowJet DesignProblem::mass_row(const DesignVector& x) const {
  RowJet jet = mass_in_vector(x);
  jet.value = *limits_.mass / goal_scale_ - jet.value;
  jet.gradient = -jet.gradient;
  jet.hessian = -jet.hessian;
  return jet;
}

/// At both ends and where it is largest; under a limit only where it comes to `least_share` of that.
void DesignProblem::add_load_errors(std::vector<Row>& rows, const DesignVector& x, double least_share) const {
  if (!load_error_) return;
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  const BarLengths bars = bar_lengths(lengths_of(x));
  std::array<double, load_openings> errors;
  for (std::size_t i = 0; i < errors.size(); ++i)
    errors[i] =
        load_error_->at(bars, near + static_cast<double>(i) / (load_openings - 1.0) * (far - near)).worst;
  const double least = has_load_limit() ? least_share * *limits_.load_error : 0;
  const auto add = [&](std::size_t i) {
    if (errors[i] < least) return;
    rows.push_back({Row::Kind::load_error, 0, static_cast<double>(i) / (load_openings - 1.0)});
  };
  const auto most = static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) - errors.begin());
  add(0);
  add(load_openings - 1);
  if (most > 0 && most < load_openings - 1) add(most);
}

}  // namespace kempe
