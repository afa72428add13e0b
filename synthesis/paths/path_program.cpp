#include "synthesis/paths/path_program.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/paths/slack.hpp"

namespace kempe {

/// The coupler at one crank angle, in units of the ground link.
struct PathProgram::Coupler {
  double cosine = 2;  ///< of the angle between coupler and rocker
  bool closes = false;
  Complex crank, direction, rocker;  ///< unit vectors
};

std::vector<GrashofRows> grashof_choices(const std::vector<CrankMotion>& motions) {
  std::vector<GrashofRows> choices;
  for (const CrankMotion motion : motions) switch (motion) {
      case CrankMotion::crank_rocker: choices.push_back({1, 1}); break;
      case CrankMotion::double_crank: choices.push_back({0, 1}); break;
      case CrankMotion::rocker_crank: choices.push_back({3, 1}); break;
      case CrankMotion::double_rocker:
        choices.push_back({2, 1});
        for (int link = 0; link < 4; ++link) choices.push_back({link, -1});
        break;
      case CrankMotion::change_point: break;
    }
  return choices;
}

namespace {

/// The three rows of a choice, each kept where not positive, in ground links; x holds the logarithms of the ratios.
std::array<double, 3> grashof_values(const GrashofRows& rows, const std::array<double, 4>& lengths) {
  const double sum = lengths[0] + lengths[1] + lengths[2] + lengths[3];
  std::array<double, 3> values{};
  std::size_t row = 0;
  for (std::size_t other = 0; other < 4; ++other)
    if (const auto link = static_cast<std::size_t>(rows.link); other != link)
      values[row++] =
          rows.sign * (2 * (lengths[link] + lengths[other]) - sum) + slack::path_from_change_point;
  return values;
}

std::array<double, 4> lengths_in_ground_links(const Eigen::VectorXd& x) {
  return {1, std::exp(x[6]), std::exp(x[7]), std::exp(x[8])};
}

}  // namespace

void PathProgram::choose_motion(const Eigen::VectorXd& x) {
  double least = 0;
  for (const GrashofRows& choice : motions_) {
    const std::array<double, 3> values = grashof_values(choice, lengths_in_ground_links(x));
    const double broken = *std::max_element(values.begin(), values.end());
    if (motion_ && broken >= least) continue;
    motion_ = choice;
    least = broken;
  }
}

PathProgram::PathProgram(const PathTask& task, FourBarBranch branch, bool rising)
    : turns_(task.turns), motions_(grashof_choices(task.motions)), branch_(branch), way_(rising ? 1 : -1),
      timed_(!task.turns.empty()) {
  for (const Point& p : task.points) centre_ += as_complex(p) / static_cast<double>(task.points.size());
  unit_ = 0;
  for (const Point& p : task.points) unit_ = std::max(unit_, std::abs(as_complex(p) - centre_));
  if (task.ground_angle) frame_ = std::polar(1.0, *task.ground_angle);
  for (const Point& p : task.points) points_.push_back(inside(p));
  for (const Point& p : task.pivots_within) pivots_.push_back(as_point(inside(p)));
  given_.resize(static_cast<std::size_t>(size()));
  if (task.crank_pivot) {
    given_[0] = inside(*task.crank_pivot).real();
    given_[1] = inside(*task.crank_pivot).imag();
  }
  if (task.ground_angle) given_[3] = 0;  // z1 = alpha (B0 - A0)
  if (task.first_angle) given_[angles_at] = *task.first_angle;
  longest_ = task.longest / unit_ * (1 - slack::path_inside_limit);
  cos_limit_ =
      std::cos(std::max(task.transmission, slack::path_from_dead_points) + slack::path_inside_transmission);
}

PathProgram::Coupler PathProgram::coupler(const Eigen::VectorXd& x, double angle) const {
  const double alpha = std::exp(x[6]), beta = std::exp(x[7]), gamma = std::exp(x[8]);
  Coupler at;
  at.crank = std::polar(1.0, angle);
  const Complex to_pin = alpha * at.crank - 1.0;
  const double e2 = std::norm(to_pin), e = std::sqrt(e2);
  at.cosine = (beta * beta + gamma * gamma - e2) / (2 * beta * gamma);
  if (!(std::abs(at.cosine) < 1) || e == 0) return at;
  // The triangle of e, coupler and rocker: its angle at the rocker's pivot.
  const double along = (e2 + gamma * gamma - beta * beta) / (2 * e * gamma);
  const double beside = std::acos(std::clamp(along, -1.0, 1.0));
  at.rocker = to_pin / e * std::polar(1.0, branch_ == FourBarBranch::first ? -beside : beside);
  at.direction = (gamma * at.rocker - to_pin) / beta;
  at.closes = true;
  return at;
}

bool PathProgram::project(Eigen::VectorXd& x) const {
  for (int i = 0; i < size(); ++i)
    if (is_given(i)) x[i] = *given_[static_cast<std::size_t>(i)];
  Eigen::Matrix3cd normal = Eigen::Matrix3cd::Zero();
  Eigen::Vector3cd right = Eigen::Vector3cd::Zero();
  for (int i = 0; i < count(); ++i) {
    const Coupler at = coupler(x, angle(x, i));
    if (!at.closes) return false;
    const Eigen::Vector3cd row(1, at.crank, at.direction);
    normal += row.conjugate() * row.transpose();
    right += row.conjugate() * points_[static_cast<std::size_t>(i)];
  }
  if (is_given(0) || is_given(3)) return project_the_rest(normal, right, x);
  const Eigen::LDLT<Eigen::Matrix3cd> factors(normal);
  const Eigen::Vector3cd z = factors.solve(right);
  for (int k = 0; k < 3; ++k) {
    x[2 * k] = z[k].real();
    x[2 * k + 1] = z[k].imag();
  }
  return z.allFinite() && std::abs(z[1]) > slack::path_least_crank;
}

bool PathProgram::project_the_rest(const Eigen::Matrix3cd& normal, const Eigen::Vector3cd& right,
                                   Eigen::VectorXd& x) const {
  Eigen::Matrix<double, 6, 6> rows;  // the same equations of the real and imaginary parts
  Eigen::Matrix<double, 6, 1> wanted;
  for (int i = 0; i < 3; ++i) {
    wanted.segment<2>(2 * i) << right[i].real(), right[i].imag();
    for (int k = 0; k < 3; ++k) {
      const Complex n = normal(i, k);
      rows.block<2, 2>(2 * i, 2 * k) << n.real(), -n.imag(), n.imag(), n.real();
    }
  }
  for (int i = 0; i < 6; ++i) {
    if (!is_given(i)) continue;
    wanted -= rows.col(i) * x[i];
    rows.row(i).setZero();
    rows.col(i).setZero();
    rows(i, i) = 1;
  }
  for (int i = 0; i < 6; ++i)
    if (is_given(i)) wanted[i] = x[i];
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factors(rows);
  const Eigen::Matrix<double, 6, 1> z = factors.solve(wanted);
  for (int i = 0; i < 6; ++i)
    if (!is_given(i)) x[i] = z[i];
  return z.allFinite() && (is_given(3) ? x[2] : std::hypot(x[2], x[3])) > slack::path_least_crank;
}

bool PathProgram::errors(const Eigen::VectorXd& x, Eigen::VectorXd& value, Eigen::MatrixXd* slope) const {
  const double alpha = std::exp(x[6]), beta = std::exp(x[7]), gamma = std::exp(x[8]);
  const Complex z0(x[0], x[1]), z1(x[2], x[3]), z2(x[4], x[5]), i1(0, 1);
  value.resize(2 * count());
  if (slope) slope->setZero(2 * count(), size());
  bool closes = true;
  for (int i = 0; i < count(); ++i) {
    const Coupler at = coupler(x, angle(x, i));
    if (!at.closes) {
      value[2 * i] = value[2 * i + 1] = slack::path_not_closed;
      closes = false;
      continue;
    }
    const Complex error = z0 + z1 * at.crank + z2 * at.direction - points_[static_cast<std::size_t>(i)];
    value[2 * i] = error.real();
    value[2 * i + 1] = error.imag();
    if (!slope) continue;
    const auto set = [&](int column, Complex d) {
      (*slope)(2 * i, column) += d.real();
      (*slope)(2 * i + 1, column) += d.imag();
    };
    set(0, 1);
    set(1, i1);
    set(2, at.crank);
    set(3, i1 * at.crank);
    set(4, at.direction);
    set(5, i1 * at.direction);
    // alpha e + beta u = 1 + gamma v: what lies along v leaves the rocker's turning out.
    const Complex back = std::conj(at.rocker);
    const double across = beta * (i1 * at.direction * back).real();
    const Complex turn = z2 * i1 * at.direction / across;
    set(6, turn * (-alpha * (at.crank * back).real()));
    set(7, turn * (-beta * (at.direction * back).real()));
    set(8, turn * gamma);
    set(timed_ ? angles_at : angles_at + i,
        z1 * i1 * at.crank + turn * (-alpha * (i1 * at.crank * back).real()));
  }
  for (int i = 0; slope && i < size(); ++i)
    if (is_given(i)) slope->col(i).setZero();
  return closes;
}

int PathProgram::limit_count() const {
  const int order = timed_ ? 0 : count();
  return transmission_rows() + 6 + 2 * static_cast<int>(pivots_.size()) + order + (motion_ ? 3 : 0);
}

bool PathProgram::has_families() const {
  const auto free = std::count_if(given_.begin(), given_.end(), [](const auto& value) { return !value; });
  return free > 2 * count();
}

void PathProgram::watch_extremes(const Eigen::VectorXd& x) {
  const double first = angle(x, 0), last = angle(x, count() - 1);
  const double low = std::min(first, last), high = std::max(first, last);
  for (double turns = std::ceil(low / pi); turns * pi < high; ++turns) {
    const double place = std::fmod(turns, 2) == 0 ? 0 : pi;
    if (std::find(in_line_.begin(), in_line_.end(), place) == in_line_.end()) in_line_.push_back(place);
  }
}

/// The limits' rows, filled from the first on.
struct PathProgram::LimitRows {
  const Eigen::VectorXd& x;
  Eigen::VectorXd& value;
  Eigen::MatrixXd* slope;  ///< or null
  double alpha = std::exp(x[6]), beta = std::exp(x[7]), gamma = std::exp(x[8]);
  Complex z0{x[0], x[1]}, z1{x[2], x[3]}, z2{x[4], x[5]};
  int row = 0;
};

void PathProgram::limits(const Eigen::VectorXd& x, Eigen::VectorXd& value, Eigen::MatrixXd* slope) const {
  value.resize(limit_count());
  if (slope) slope->setZero(limit_count(), size());
  LimitRows rows{.x = x, .value = value, .slope = slope};
  for (int i = 0; i < count(); ++i) add_transmission(angle(x, i), timed_ ? angles_at : angles_at + i, rows);
  for (const double psi : in_line_) add_transmission(psi, std::nullopt, rows);
  add_lengths(rows);
  add_pivots(rows);
  if (!timed_) add_order(rows);
  if (motion_) add_motion(rows);
}

void PathProgram::add_transmission(double psi, std::optional<int> column, LimitRows& rows) const {
  auto& [x, value, slope, alpha, beta, gamma, z0, z1, z2, row] = rows;
  const double e2 = 1 + alpha * alpha - 2 * alpha * std::cos(psi);
  const double cosine = (beta * beta + gamma * gamma - e2) / (2 * beta * gamma);
  for (const double sign : {1.0, -1.0}) {
    value[row] = sign * cosine - cos_limit_;
    if (slope) {
      (*slope)(row, 6) = sign * -(2 * alpha * alpha - 2 * alpha * std::cos(psi)) / (2 * beta * gamma);
      (*slope)(row, 7) = sign * (beta / gamma - cosine);
      (*slope)(row, 8) = sign * (gamma / beta - cosine);
      if (column) (*slope)(row, *column) = sign * -(2 * alpha * std::sin(psi)) / (2 * beta * gamma);
    }
    ++row;
  }
}

/// Squares of lengths over that of the longest allowed.
void PathProgram::add_lengths(LimitRows& rows) const {
  add_link(1, std::nullopt, rows);
  add_link(rows.alpha, 6, rows);
  add_link(rows.beta, 7, rows);
  add_link(rows.gamma, 8, rows);
  add_arm(0, rows);
  add_arm(rows.beta / rows.alpha, rows);
}

/// Of |z1| ratio / alpha.
void PathProgram::add_link(double ratio, std::optional<int> column, LimitRows& rows) const {
  auto& [x, value, slope, alpha, beta, gamma, z0, z1, z2, row] = rows;
  const double share = 1 / (longest_ * longest_);
  const double square = std::norm(z1) * ratio * ratio / (alpha * alpha) * share;
  value[row] = square - 1;
  if (slope) {
    (*slope)(row, 2) = 2 * square * x[2] / std::norm(z1);
    (*slope)(row, 3) = 2 * square * x[3] / std::norm(z1);
    (*slope)(row, 6) -= 2 * square;
    if (column) (*slope)(row, *column) += 2 * square;
  }
  ++row;
}

/// Of |z2 - ratio z1|: ratio 0 from the crank's joint, beta / alpha from the rocker's.
void PathProgram::add_arm(double ratio, LimitRows& rows) const {
  auto& [x, value, slope, alpha, beta, gamma, z0, z1, z2, row] = rows;
  const double share = 1 / (longest_ * longest_);
  const Complex d = z2 - ratio * z1;
  value[row] = std::norm(d) * share - 1;
  if (slope) {
    (*slope)(row, 4) = 2 * share * d.real();
    (*slope)(row, 5) = 2 * share * d.imag();
    (*slope)(row, 2) = -2 * share * ratio * d.real();
    (*slope)(row, 3) = -2 * share * ratio * d.imag();
    const double by_ratio = -2 * share * ratio * (d.real() * z1.real() + d.imag() * z1.imag());
    (*slope)(row, 6) = -by_ratio;
    (*slope)(row, 7) = by_ratio;
  }
  ++row;
}

/// Both pivots, at every edge of where they may be: not positive to its left.
void PathProgram::add_pivots(LimitRows& rows) const {
  auto& [x, value, slope, alpha, beta, gamma, z0, z1, z2, row] = rows;
  for (std::size_t k = 0; k < pivots_.size(); ++k) {
    const Point from = pivots_[k], along = (pivots_[(k + 1) % pivots_.size()] - from).normalized();
    const auto outside = [&from, &along](Complex p) {
      return -cross(along, as_point(p) - from) + slack::path_inside_limit;
    };
    value[row] = is_given(0) ? -1 : outside(z0);  // one that is given lies within
    value[row + 1] = outside(z0 + z1 / alpha);
    for (int pivot = 0; slope && pivot < 2; ++pivot) {
      if (pivot == 0 && is_given(0)) continue;
      (*slope)(row + pivot, 0) = along.y();
      (*slope)(row + pivot, 1) = -along.x();
      if (pivot == 0) continue;
      (*slope)(row + 1, 2) = along.y() / alpha;
      (*slope)(row + 1, 3) = -along.x() / alpha;
      (*slope)(row + 1, 6) = -(along.y() * x[2] - along.x() * x[3]) / alpha;
    }
    row += 2;
  }
}

/// The crank goes on from each point to the next, and by less than a whole turn from the first to the last: the last row.
void PathProgram::add_order(LimitRows& rows) const {
  for (int i = 0; i < count(); ++i) {
    const bool whole = i + 1 == count();
    const int first = angles_at + (whole ? 0 : i), next = angles_at + (whole ? count() - 1 : i + 1);
    const double turn = way_ * (rows.x[next] - rows.x[first]), sign = whole ? 1 : -1;
    rows.value[rows.row] = sign * (turn - (whole ? 2 * pi - slack::least_turn : slack::least_turn));
    if (rows.slope) {
      (*rows.slope)(rows.row, next) = sign * way_;
      (*rows.slope)(rows.row, first) = -sign * way_;
    }
    ++rows.row;
  }
}

void PathProgram::add_motion(LimitRows& rows) const {
  const std::array<double, 4> lengths = lengths_in_ground_links(rows.x);
  const std::array<double, 3> kept = grashof_values(*motion_, lengths);
  for (int other = 0, k = 0; other < 4; ++other) {
    if (other == motion_->link) continue;
    rows.value[rows.row] = kept[static_cast<std::size_t>(k++)];
    for (int moved = 1; rows.slope && moved < 4; ++moved)
      (*rows.slope)(rows.row, ratios_at + moved - 1) = motion_->sign *
                                                       lengths[static_cast<std::size_t>(moved)] *
                                                       (moved == other || moved == motion_->link ? 1 : -1);
    ++rows.row;
  }
}

CouplerFourBar PathProgram::linkage(const Eigen::VectorXd& x) const {
  const double alpha = std::exp(x[6]), beta = std::exp(x[7]), gamma = std::exp(x[8]);
  const Complex z0(x[0], x[1]), z1(x[2], x[3]), z2(x[4], x[5]), ground = z1 / alpha;
  CouplerFourBar bar;
  bar.crank_pivot = as_point(centre_ + unit_ * frame_ * z0);
  bar.rocker_pivot = as_point(centre_ + unit_ * frame_ * (z0 + ground));
  const double length = unit_ * std::abs(ground);
  bar.crank = alpha * length;
  bar.coupler = beta * length;
  bar.rocker = gamma * length;
  bar.coupler_point = as_point(unit_ * z2 * std::abs(ground) / ground);
  bar.branch = branch_;
  return bar;
}

std::vector<double> PathProgram::crank_angles(const Eigen::VectorXd& x) const {
  const double base = std::arg(Complex(x[2], x[3])) + std::arg(frame_);
  const double whole = 2 * pi * std::floor((angle(x, 0) + base) / (2 * pi));
  std::vector<double> angles;
  for (int i = 0; i < count(); ++i) angles.push_back(angle(x, i) + base - whole);
  return angles;
}

Eigen::VectorXd PathProgram::lowest() const {
  Eigen::VectorXd bound = Eigen::VectorXd::Constant(size(), -100);
  bound.segment<3>(ratios_at).setConstant(-std::log(slack::path_largest_ratio));
  if (is_given(3)) bound[2] = 0;  // the ground link points the way given
  return kept_as_given(std::move(bound));
}

Eigen::VectorXd PathProgram::highest() const {
  Eigen::VectorXd bound = Eigen::VectorXd::Constant(size(), 100);
  bound.segment<3>(ratios_at).setConstant(std::log(slack::path_largest_ratio));
  return kept_as_given(std::move(bound));
}

Eigen::VectorXd PathProgram::kept_as_given(Eigen::VectorXd bound) const {
  for (int i = 0; i < size(); ++i)
    if (is_given(i)) bound[i] = *given_[static_cast<std::size_t>(i)];
  return bound;
}

}  // namespace kempe
