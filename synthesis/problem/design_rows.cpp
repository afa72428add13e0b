// The rows of a design problem with their derivatives, and which rows matter at a point.
#include <algorithm>
#include <cmath>

#include "geometry/segment_distance.hpp"
#include "synthesis/problem/row_parts.hpp"
#include "synthesis/problem/slack.hpp"

namespace kempe {
namespace {

using namespace row_parts;

/// Openings at which contacts are looked for between the region's two openings, before each is refined.
constexpr int openings_looked_at = 33;
/// Factor: between two openings a gap falls by no more than so many times what it rises beside them.
constexpr double falls_at_most = 2;
/// Contacts nearer than this become rows from the start, in shares of the task's size.
constexpr double contact_band = 0.05;
/// Load errors that come to this share of their limit become rows from the start; others where a solution breaks the limit there.
constexpr double load_share = 0.5;

/// Adds factor * jet(u, v, d) where d = sum weight * x[opening].
void add_linkage(RowJet& row, double factor, const LinkageJet& jet, double near_weight, double far_weight) {
  constexpr std::array<int, 4> at{log_VA, log_VB, DesignLayout::near_opening, DesignLayout::far_opening};
  Eigen::Matrix<double, 3, 4> chain = Eigen::Matrix<double, 3, 4>::Zero();
  chain(0, 0) = chain(1, 1) = 1;
  chain(2, 2) = near_weight;
  chain(2, 3) = far_weight;
  const Eigen::Vector4d gradient = factor * (chain.transpose() * jet.gradient);
  const Eigen::Matrix4d hessian = factor * (chain.transpose() * jet.hessian * chain);
  row.value += factor * jet.value;
  for (int i = 0; i < 4; ++i) {
    row.gradient[at[static_cast<std::size_t>(i)]] += gradient[i];
    for (int j = 0; j < 4; ++j)
      row.hessian(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]) += hessian(i, j);
  }
}

void add_variable(RowJet& row, const DesignVector& x, int variable, double factor) {
  row.value += factor * x[variable];
  row.gradient[variable] += factor;
}

/// Adds sign * |pole - place| / unit, or where `normal` is given the distance from a line through the place.
void add_pole_distance(RowJet& row, const DesignLayout& layout, double sign, const Point& pole,
                       const Point& place, bool from_line) {
  const Point apart = pole - place;
  const double distance = apart.norm();
  row.value += sign * distance / layout.unit;
  if (!layout.pole_is_free || distance == 0) return;
  const Point normal = apart / distance;
  row.gradient.segment<2>(pole_x) += sign * normal;
  if (!from_line)
    row.hessian.block<2, 2>(pole_x, pole_x) +=
        sign * layout.unit / distance * (Eigen::Matrix2d::Identity() - normal * normal.transpose());
}

}  // namespace

RowJet DesignProblem::near_row(std::size_t edge, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const Point pole = layout_.pole(x);
  add_linkage(jet, -1 / layout_.unit, reach_.radius(lengths_of(x), x[DesignLayout::near_opening]), 1, 0);
  const auto& [from, to] = space_.region().edges()[edge];
  const Point place = nearest_on_segment(pole, from, to);
  const bool beside_edge = place != from && place != to;
  const double side = layout_.pole_is_free && space_.region().contains(pole) ? -1 : 1;
  add_pole_distance(jet, layout_, side, pole, place, beside_edge);
  return jet;
}

RowJet DesignProblem::far_row(std::size_t corner, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  add_linkage(jet, 1 / layout_.unit, reach_.radius(lengths_of(x), x[DesignLayout::far_opening]), 0, 1);
  add_pole_distance(jet, layout_, -1, layout_.pole(x), space_.region().hull()[corner], false);
  return jet;
}

RowJet DesignProblem::contact_row(std::size_t term, double share, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  const JointFrame frame(reach_.shape(), lengths_of(x), near + share * (far - near));
  add_linkage(jet, 1 / layout_.unit, gap_jet(terms_.gaps[term], frame), 1 - share, share);
  if (goal_ == Goal::clearance)
    add_variable(jet, x, layout_.goal(), -1);
  else
    jet.value -= limits_.clearance / layout_.unit + slack::inward_gap;
  return jet;
}

RowJet DesignProblem::pole_margin_row(const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const Point pole = layout_.pole(x);
  const Point home = space_.nearest_pole(pole);
  add_pole_distance(jet, layout_, -1, pole, home, space_.is_on_edge(home));
  if (goal_ == Goal::pole_margin)
    add_variable(jet, x, layout_.goal(), 1);
  else
    jet.value += limits_.pole_margin / layout_.unit;
  return jet;
}

/// -(t - angle from the end): the opening keeps the transmission angle t from its end of the interval.
RowJet DesignProblem::end_row(bool near, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const int opening = near ? DesignLayout::near_opening : DesignLayout::far_opening;
  jet.value = near ? reach_.from_near_end(x[opening]) : reach_.from_far_end(x[opening]);
  jet.gradient[opening] = near == reach_.near_is_lower() ? 1 : -1;
  add_variable(jet, x, layout_.goal(), -1);
  return jet;
}

/// log of the longest (shortest) length of VA's or VB's family against t.
RowJet DesignProblem::length_row(bool longest, std::size_t family, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  const Reach::LengthFactors& f = reach_.factors();
  const double side = longest ? 1 : -1;
  const double factor =
      longest ? (family == 0 ? f.most_of_VA : f.most_of_VB) : (family == 0 ? f.least_of_VA : f.least_of_VB);
  add_variable(jet, x, layout_.goal(), side);
  add_variable(jet, x, family == 0 ? log_VA : log_VB, -side);
  jet.value -= side * std::log(factor);
  return jet;
}

RowJet DesignProblem::half_plane_row(std::size_t plane, const DesignVector& x) const {
  RowJet jet = zero_jet(layout_.size());
  jet.value = room_[plane].inside(layout_.pole(x)) / layout_.unit - slack::inward_distance;
  jet.gradient.segment<2>(pole_x) = -room_[plane].normal;
  return jet;
}

RowJet DesignProblem::row(const Row& row, const DesignVector& x, Derivatives wanted) const {
  switch (row.kind) {
    case Row::Kind::near_edge: return near_row(row.index, x);
    case Row::Kind::far_corner: return far_row(row.index, x);
    case Row::Kind::near_end: return end_row(true, x);
    case Row::Kind::far_end: return end_row(false, x);
    case Row::Kind::contact: return contact_row(row.index, row.share, x);
    case Row::Kind::obstacle: return obstacle_row(row, x, wanted);
    case Row::Kind::copy_gap: return copy_gap_row(row.index, x);
    case Row::Kind::half_plane: return half_plane_row(row.index, x);
    case Row::Kind::pole_margin: return pole_margin_row(x);
    case Row::Kind::copy_error: return copy_error_row(row.share, x);
    case Row::Kind::size: return size_row(x);
    case Row::Kind::load_error: return load_error_row(row.share, x, wanted);
    case Row::Kind::mass: return mass_row(x);
    case Row::Kind::sag: return sag_row(row, x, wanted);
    case Row::Kind::longest: return length_row(true, row.index, x);
    case Row::Kind::shortest: break;
  }
  return length_row(false, row.index, x);
}

RowJet DesignProblem::objective(const DesignVector& x, Derivatives wanted) const {
  RowJet jet = zero_jet(layout_.size());
  if (layout_.has_goal) {
    add_variable(jet, x, layout_.goal(), is_maximized(goal_) ? -1 : 1);
    return jet;
  }
  if (goal_ == Goal::footprint) return footprint_objective(x, wanted);
  if (goal_ == Goal::mass) return mass_in_vector(x);
  const Reach::LengthFactors& f = reach_.factors();
  const double of_VA = f.size_per_VA * std::exp(x[log_VA]) / layout_.unit;
  const double of_VB = f.size_per_VB * std::exp(x[log_VB]) / layout_.unit;
  jet.value = of_VA + of_VB;
  jet.gradient.head<2>() << of_VA, of_VB;
  jet.hessian.topLeftCorner<2, 2>().diagonal() << of_VA, of_VB;
  return jet;
}

void DesignProblem::add_nearest_and_farthest(std::vector<Row>& rows, const DesignVector& x) const {
  const Point pole = layout_.pole(x);
  rows.push_back({Row::Kind::near_edge, space_.region().nearest(pole).edge});
  rows.push_back({Row::Kind::far_corner, space_.region().farthest(pole).corner});
}

/// What is nearest and farthest for poles some way off in all directions: the first solution then stays
/// sensible.
void DesignProblem::add_around(std::vector<Row>& rows, const DesignVector& x) const {
  for (const double away : {0.2, 1.0})
    for (int i = 0; i < 8; ++i) {
      DesignVector beside = x;
      beside.segment<2>(pole_x) += away * as_point(std::polar(1.0, i * pi / 4));
      std::vector<Row> seen;
      add_nearest_and_farthest(seen, beside);
      for (const Row& row : seen)
        if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
    }
}

double DesignProblem::tightest_share(const GapTerm& term, const DesignVector& x, double below,
                                     double above) const {
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  for (int i = 0; i < 30; ++i) {  // bisection for the sign of the gap's slope: kinks do not matter
    const double share = 0.5 * (below + above);
    const JointFrame frame(reach_.shape(), lengths_of(x), near + share * (far - near));
    const double slope = gap_jet(term, frame).gradient[2] * (far - near);
    (slope < 0 ? below : above) = share;
  }
  return 0.5 * (below + above);
}

void DesignProblem::add_contacts(std::vector<Row>& rows, const DesignVector& x, double band) const {
  const double near = x[DesignLayout::near_opening], far = x[DesignLayout::far_opening];
  constexpr int last = openings_looked_at - 1;
  std::vector<JointFrame> frames;
  for (int i = 0; i <= last && !terms_.gaps.empty(); ++i)
    frames.emplace_back(reach_.shape(), lengths_of(x), near + i * (far - near) / last);
  const double least = goal_ == Goal::clearance ? x[layout_.goal()] * layout_.unit : limits_.clearance;
  for (std::size_t t = 0; t < terms_.gaps.size(); ++t) {
    std::array<double, openings_looked_at> gap;
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = gap_value(terms_.gaps[t], frames[i]);
    for (int i = 0; i <= last; ++i) {
      const auto at = [&](int j) { return gap[static_cast<std::size_t>(std::clamp(j, 0, last))]; };
      if (at(i) > at(i - 1) || at(i) > at(i + 1) || (i > 0 && at(i) == at(i - 1))) continue;
      // Where the gap is convex it falls between two openings by no more than it rises beside them.
      const double rise = std::max(at(i - 1), at(i + 1)) - at(i);
      if (at(i) - falls_at_most * rise - least >= band * layout_.unit) continue;
      const double below = std::max(0, i - 1) / static_cast<double>(last);
      const double above = std::min(last, i + 1) / static_cast<double>(last);
      const Row row{Row::Kind::contact, t, tightest_share(terms_.gaps[t], x, below, above)};
      const JointFrame frame(reach_.shape(), lengths_of(x), near + row.share * (far - near));
      if (gap_value(terms_.gaps[t], frame) - least < band * layout_.unit) rows.push_back(row);
    }
  }
}

std::vector<Row> DesignProblem::rows_at(const DesignVector& x) const {
  std::vector<Row> rows;
  add_nearest_and_farthest(rows, x);
  if (layout_.pole_is_free) add_around(rows, x);
  if (goal_ == Goal::transmission) rows.insert(rows.end(), {{Row::Kind::near_end}, {Row::Kind::far_end}});
  if (goal_ == Goal::longest) rows.insert(rows.end(), {{Row::Kind::longest, 0}, {Row::Kind::longest, 1}});
  if (goal_ == Goal::shortest) rows.insert(rows.end(), {{Row::Kind::shortest, 0}, {Row::Kind::shortest, 1}});
  if (goal_ == Goal::pole_margin || limits_.pole_margin > 0) rows.push_back({Row::Kind::pole_margin});
  if (limits_.size) rows.push_back({Row::Kind::size});
  if (limits_.mass && mass_) rows.push_back({Row::Kind::mass});
  for (std::size_t i = 0; i < room_.size(); ++i) rows.push_back({Row::Kind::half_plane, i});
  add_contacts(rows, x, contact_band);
  add_obstacles(rows, x, contact_band);
  add_copy_gap(rows, x);
  add_copy_errors(rows, x);
  add_load_errors(rows, x, load_share);
  add_sags(rows, x);
  return rows;
}

bool DesignProblem::add_violated(std::vector<Row>& rows, const DesignVector& x, double tolerance) const {
  std::vector<Row> seen;
  add_nearest_and_farthest(seen, x);
  add_contacts(seen, x, 0);
  add_obstacles(seen, x, 0);
  add_copy_gap(seen, x);
  add_copy_errors(seen, x);
  add_load_errors(seen, x, 1 - slack::inward_load_error);
  add_sags(seen, x);
  const std::size_t before = rows.size();
  for (const Row& candidate : seen) {
    if (row(candidate, x, Derivatives::none).value > -tolerance) continue;
    if (std::find(rows.begin(), rows.end(), candidate) == rows.end()) rows.push_back(candidate);
  }
  return rows.size() > before;
}

void DesignProblem::set_room(const Point& pole) {
  room_.clear();
  if (layout_.pole_is_free && limits_.pole_margin == 0 && goal_ != Goal::pole_margin)
    room_ = space_.room_around(pole);
}

SmoothProgram DesignProblem::program(const std::vector<Row>& rows) const {
  SmoothProgram program{
      .lower = lower_bounds(), .upper = upper_bounds(), .constraint_count = static_cast<int>(rows.size())};
  program.objective = [this](const DesignVector& x, DesignVector* gradient) {
    const RowJet jet = objective(x, gradient ? Derivatives::first : Derivatives::none);
    if (gradient) *gradient = jet.gradient;
    return jet.value;
  };
  program.constraints = [this, rows](const DesignVector& x, ConstraintValues& values,
                                     ConstraintGradients* gradients) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const RowJet jet = row(rows[i], x, gradients ? Derivatives::first : Derivatives::none);
      values[static_cast<Eigen::Index>(i)] = jet.value;
      if (gradients) gradients->row(static_cast<Eigen::Index>(i)) = jet.gradient;
    }
  };
  program.hessian = [this, rows](const DesignVector& x, double factor, const Eigen::VectorXd& multipliers) {
    DesignMatrix sum = factor * objective(x).hessian;
    for (std::size_t i = 0; i < rows.size(); ++i)
      sum -= multipliers[static_cast<Eigen::Index>(i)] * row(rows[i], x).hessian;
    return sum;
  };
  return program;
}

}  // namespace kempe
