#include "kinematics/planar/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/decompositions.hpp"
#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

constexpr double nearby = 0.01;          ///< omega times the distance at which other factors still serve
constexpr double least_bent_rows = 100;  ///< 1/rad: with omega below it steps are long enough
constexpr int most_corrections = 24;
constexpr double rounding = std::numeric_limits<double>::epsilon();
/// Steps between two looks at the caller's wish to stop; with more unknowns than many each step takes milliseconds.
constexpr std::size_t looks_every = 64;
constexpr Eigen::Index many_unknowns = 60;

std::vector<int> driver_rows(const PlanarEquations& equations) {
  std::vector<int> rows;
  for (int driver = 0; driver < static_cast<int>(equations.values().size()); ++driver)
    rows.push_back(equations.driver_row(driver));
  return rows;
}

/// Which rows to solve for: as many independent ones as can be, constraints before drivers, drivers all. The
/// new place of each row, or nothing if constraints and drivers together are not regular.
struct RowChoice {
  int freedoms = 0;  ///< unknowns less the rank of the constraints alone
  bool regular = false;
  std::vector<int> place_of_row;
};

RowChoice choose_rows(const Eigen::MatrixXd& jacobian, const std::vector<int>& drivers, double dependent) {
  const int rows = static_cast<int>(jacobian.rows()), unknowns = static_cast<int>(jacobian.cols());
  std::vector<int> others;
  for (int row = 0; row < rows; ++row)
    if (std::find(drivers.begin(), drivers.end(), row) == drivers.end()) others.push_back(row);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(dependent);
  qr.compute(jacobian(others, Eigen::all).transpose());
  const int rank = others.empty() ? 0 : static_cast<int>(qr.rank());
  RowChoice choice;
  choice.freedoms = unknowns - rank;
  if (choice.freedoms != static_cast<int>(drivers.size())) return choice;
  std::vector<int> order;
  for (int i = 0; i < rank; ++i)
    order.push_back(others[static_cast<std::size_t>(qr.colsPermutation().indices()[i])]);
  std::sort(order.begin(), order.end());
  order.insert(order.end(), drivers.begin(), drivers.end());
  qr.compute(jacobian(order, Eigen::all));
  choice.regular = qr.rank() == unknowns;
  choice.place_of_row.assign(static_cast<std::size_t>(rows), -1);
  int next = 0;
  for (const int row : order) choice.place_of_row[static_cast<std::size_t>(row)] = next++;
  for (int& place : choice.place_of_row)
    if (place < 0) place = next++;
  return choice;
}

}  // namespace

std::string_view name(PathEnd end) {
  switch (end) {
    case PathEnd::dead_point: return "dead point";
    case PathEnd::change_point: return "change point";
    case PathEnd::over_constrained: return "over-constrained";
    case PathEnd::gave_up: return "limit of work";
    case PathEnd::interrupted: return "wish to stop";
  }
  return {};
}

std::string_view name(NoPath why) {
  switch (why) {
    case NoPath::does_not_assemble: return "does not assemble";
    case NoPath::freedom_left: return "freedom left";
    case NoPath::drivers_dependent: return "drivers not independent";
  }
  return {};
}

std::size_t plenty_of_steps(int unknowns) {
  const auto n = static_cast<std::size_t>(std::max(unknowns, 1));
  return std::clamp<std::size_t>(40000000 / (n * n), 5000, 300000);
}

tl::expected<PlanarPath, NoPathHere> PlanarPath::from(const PlanarLinkage& linkage,
                                                      const PlanarPosition& guess,
                                                      const std::vector<double>& driver_values) {
  auto closed = solve_from(linkage, guess, driver_values);
  if (!closed) return tl::unexpected(NoPathHere{NoPath::does_not_assemble, 0, std::move(closed.error()), {}});
  PlanarEquations equations(linkage);
  equations.set_values(driver_values);
  Eigen::VectorXd q = unknowns_of(closed->position), f;
  Eigen::MatrixXd jacobian;
  equations.residual_and_jacobian(q, f, jacobian);
  const RowChoice choice =
      choose_rows(equations.dimensionless(std::move(jacobian)), driver_rows(equations), slack::dependent_row);
  const bool too_few = choice.freedoms > static_cast<int>(driver_values.size());
  if (too_few || !choice.regular)
    return tl::unexpected(NoPathHere{too_few ? NoPath::freedom_left : NoPath::drivers_dependent,
                                     choice.freedoms,
                                     {},
                                     std::move(closed->position)});
  equations.reorder(choice.place_of_row);
  return PlanarPath(std::move(equations), std::move(q));
}

PlanarPath::PlanarPath(PlanarEquations equations, Eigen::VectorXd q)
    : equations_(std::move(equations)), q_(std::move(q)), factors_(equations_), certificate_(equations_),
      bent_rows_(least_bent_rows) {
  limits_.steps = plenty_of_steps(equations_.unknown_count());
  linearise();
  orientation_ = factors_.sign();
}

Point PlanarPath::at(const BodyPoint& point) const {
  if (point.body == PlanarLinkage::ground) return point.local;
  const double c = std::cos(angle(point.body)), s = std::sin(angle(point.body));
  return q_.segment<2>(3 * point.body - 3) +
         Point(c * point.local.x() - s * point.local.y(), s * point.local.x() + c * point.local.y());
}

bool PlanarPath::is_exact() const { return base_.size() == q_.size() && base_ == q_; }

bool PlanarPath::is_measured() const {
  return certificate_.anchor().size() == base_.size() && certificate_.anchor() == base_;
}

/// J and its factors at q_; false if J is singular to rounding.
bool PlanarPath::linearise() {
  if (!is_exact()) {
    equations_.residual_and_jacobian(q_, f_, jacobian_);
    factors_.compute(jacobian_);
    base_ = q_;
  }
  return factors_.sign() != 0;
}

/// Other rows to solve for, where those in use have come near to being dependent and others have not: omega must fall to a
/// tenth at least, for at a singular position of the linkage itself it is large with any rows.
bool PlanarPath::choose_rows_again() {
  const bool again = rows_chosen_at_.size() == q_.size() && rows_chosen_at_ == q_;
  if (again || equations_.row_count() == equations_.unknown_count()) return false;
  rows_chosen_at_ = q_;
  double bending = HUGE_VAL;
  if (linearise()) {
    measure();
    bending = certificate_.bending();
  }
  bent_rows_ = std::max(least_bent_rows, 10 * bending);
  equations_.residual_and_jacobian(q_, f_, jacobian_);
  const RowChoice choice =
      choose_rows(equations_.dimensionless(jacobian_), driver_rows(equations_), slack::nearly_dependent_row);
  if (!choice.regular) return false;
  PlanarPath other = *this;
  other.equations_.reorder(choice.place_of_row);
  other.factors_ = PlanarFactors(other.equations_);
  other.certificate_ = StepCertificate(other.equations_);
  other.base_.resize(0);
  other.curvature_.resize(0);
  if (!other.linearise()) return false;
  other.measure();
  if (!(other.certificate_.bending() <= 0.1 * bending)) return false;
  other.bent_rows_ = std::max(least_bent_rows, 10 * other.certificate_.bending());
  *this = std::move(other);
  return true;
}

void PlanarPath::measure() { certificate_.measure(equations_, factors_, base_, q_); }

/// How far the factors are from q_, rad, under the weights.
double PlanarPath::apart() {
  step_ = q_ - base_;
  return certificate_.length(step_);
}

/// The part of a first Newton step so long that may be taken; by gains of this place if older ones do not allow it
/// all.
double PlanarPath::allowed(double length) {
  reach_ = certificate_.allowed(length, apart());
  if (reach_ < length && !is_measured()) {
    measure();
    reach_ = certificate_.allowed(length, apart());
  }
  return reach_;
}

/// The share of a way that one step may take, `step` being Newton's first step for the whole of it; 0 at a
/// singular position. Cheap certificates first: plain, weighed, then both with gains of this place.
double PlanarPath::share_of(const Eigen::VectorXd& step) {
  const auto share = [&] {
    const double length = certificate_.length(step);
    if (!std::isfinite(length)) return 0.0;
    reach_ = certificate_.allowed(length, apart());
    return reach_ < length ? reach_ / length : 1.0;
  };
  if (certificate_.anchor().size() == 0) measure();
  for (;; measure()) {
    certificate_.weigh_alike();
    const double turn = certificate_.length(step);
    const double plain = share();
    if (plain >= 1 || reach_ >= StepCertificate::longest) return plain;
    certificate_.weigh_by(step);
    const double weighed = share();
    if (weighed >= 1) return weighed;
    if (!is_measured()) continue;
    // Weights lengthen a step; whether a position is singular is told by how far bodies truly turn, or rounding carries the path over
    // to the assembly mode that touches there.
    if (weighed > plain) return weighed * turn > slack::singular_turn ? weighed : 0;
    certificate_.weigh_alike();
    return share();
  }
}

/// Length of the first Newton step if one driver moves by at most `way`.
double PlanarPath::reach_of(int driver, double way) {
  const double value = equations_.values()[static_cast<std::size_t>(driver)];
  const double growth = equations_.is_distance(driver) ? std::max(1.0, 1 + way / std::abs(value)) : 1;
  step_.setZero(q_.size());
  step_[equations_.driver_row(driver)] = equations_.driver_slope(driver) * way * growth;
  factors_.solve(step_, trial_);
  return certificate_.length(trial_);
}

/// The share of a way whose first Newton step is at most a t + b t^2 long over a share t, up to `left`.
double PlanarPath::share_of(double a, double b, double left) {
  const double reach = (a + b * left) * left;
  if (!std::isfinite(reach)) return 0;
  const double taken = allowed(reach);
  return reach <= taken ? left : 2 * taken / (a + std::sqrt(a * a + 4 * b * taken));
}

/// The share of the straight way to the target that one step may take, 0 at a singular position.
double PlanarPath::straight_share(const std::vector<double>& target) {
  const std::vector<double>& now = equations_.values();
  way_ = 0;
  if (equations_.has_distance_driver()) {
    certificate_.weigh_alike();
    double reach = 0;
    for (std::size_t i = 0; i < target.size(); ++i)
      reach += reach_of(static_cast<int>(i), std::abs(target[i] - now[i]));
    return share_of(reach, 0, 1);
  }
  step_.setZero(q_.size());
  for (std::size_t i = 0; i < target.size(); ++i) {
    const int driver = static_cast<int>(i);
    step_[equations_.driver_row(driver)] = equations_.driver_slope(driver) * (target[i] - now[i]);
  }
  factors_.solve(step_, first_);
  way_ = step_.lpNorm<Eigen::Infinity>();
  return share_of(first_);
}

/// The share of a curve that one step may take: by its slope and bend, if they are known, else by its speed.
double PlanarPath::curve_share(const DriverCurve& curve, double covered) {
  const double left = 1 - covered;
  double a = 0, b = 0;
  way_ = 0;
  certificate_.weigh_alike();
  if (curve.slopes_at && !equations_.has_distance_driver()) {
    curve.slopes_at(covered, slopes_);
    step_.setZero(q_.size());
    for (std::size_t i = 0; i < slopes_.size(); ++i) {
      const int driver = static_cast<int>(i);
      step_[equations_.driver_row(driver)] = equations_.driver_slope(driver) * slopes_[i];
    }
    factors_.solve(step_, trial_);
    a = certificate_.length(trial_);
    for (std::size_t i = 0; i < slopes_.size(); ++i)
      if (curve.most_bent[i] > 0) b += 0.5 * reach_of(static_cast<int>(i), curve.most_bent[i]);
  } else {
    for (std::size_t i = 0; i < curve.fastest.size(); ++i)
      a += reach_of(static_cast<int>(i), curve.fastest[i] * left) / left;
  }
  return share_of(a, b, left);
}

/// Where correct() begins: at Newton's first step, bent as the last step was. The residual before, mm.
double PlanarPath::predict(double share) {
  if (!(way_ > 0)) {
    equations_.residual(q_, trial_f_);
    factors_.solve(trial_f_, change_);
    trial_ = q_ - change_;
    return trial_f_.head(q_.size()).lpNorm<Eigen::Infinity>();
  }
  const double way = share * way_;
  trial_ = q_ + share * first_;
  if (curvature_.size() > 0) trial_ += way * way * curvature_;
  return way;
}

/// What the last step was off from Newton's first, over the square of the way.
void PlanarPath::learn_curvature(double share) {
  const double way = share * way_;
  if (way > slack::least_way * equations_.size())
    curvature_ = (trial_ - q_ - share * first_) / (way * way);
  else
    curvature_.resize(0);
}

/// Newton from q_ to the position at `values`, a share of the way ahead: true if it converges to rounding and
/// within the certified ball. Factors serve as long as they bring the residual down fast, first those at q_.
bool PlanarPath::correct(const std::vector<double>& values, double share) {
  equations_.set_values(values);
  const double exact = 4 * rounding * magnitude_of(q_, equations_.size());
  double previous = predict(share), gain = 0;     // gain: of the last step
  bool bent = way_ > 0 && curvature_.size() > 0;  // the first point is better than Newton's
  for (int i = 0; i < most_corrections; ++i) {
    const bool renew = bent || previous * gain * gain > exact;
    if (renew)
      equations_.residual_and_jacobian(trial_, trial_f_, jacobian_);
    else
      equations_.residual(trial_, trial_f_);
    const double now = trial_f_.head(q_.size()).lpNorm<Eigen::Infinity>();
    if (now <= exact || (now > 0.25 * previous && previous <= 64 * exact)) {
      learn_curvature(share);
      step_ = trial_ - q_;
      return certificate_.length(step_) <= 2 * reach_ + slack::rounding_turn;
    }
    if (bent && now > 0.1 * previous) {  // the path bends otherwise here
      curvature_.resize(0);
      previous = predict(share);
      gain = 0;
      bent = false;
      continue;
    }
    bent = false;
    if (!(now < previous)) break;
    gain = now / previous;
    previous = now;
    if (renew) {
      factors_.compute(jacobian_);
      base_ = trial_;
      gain = 0;
    }
    factors_.solve(trial_f_, change_);
    trial_ -= change_;
  }
  base_.resize(0);
  curvature_.resize(0);
  return false;
}

/// What the constraints that are not solved for may be off, mm: looser than Newton's own residual, since they
/// only follow from the others, and looser the nearer a singular position is.
double PlanarPath::closing_limit() const {
  return slack::closed_by_others * (1 + std::max(certificate_.bending(), 0.0)) *
         magnitude_of(q_, equations_.size());
}

/// At a singular position the left null vector tells: a dead point resists the drivers, a change point does
/// not.
PathEnd PlanarPath::kind_of_singularity(const std::vector<double>& target) {
  equations_.residual_and_jacobian(q_, f_, jacobian_);
  const Eigen::Index square = q_.size();
  Eigen::MatrixXd scaled = jacobian_.topRows(square);
  for (Eigen::Index angle = 2; angle < square; angle += 3) scaled.col(angle) /= equations_.size();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeFullU);
  const Eigen::VectorXd null = svd.matrixU().col(square - 1);
  double along = 0, all = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const int driver = static_cast<int>(i);
    const double way = equations_.driver_slope(driver) * (target[i] - equations_.values()[i]);
    along += null[equations_.driver_row(driver)] * way;
    all += way * way;
  }
  return std::abs(along) <= slack::crossing_share * std::sqrt(all) ? PathEnd::change_point
                                                                   : PathEnd::dead_point;
}

/// Driven distances are measured in what they are now: where one has grown much the factors are made anew.
void PlanarPath::keep_scales() {
  if (!equations_.has_distance_driver() || !equations_.rescale_distances()) return;
  base_.resize(0);
  curvature_.resize(0);
}

void PlanarPath::accept() {
  q_.swap(trial_);
  f_.swap(trial_f_);
  certificate_.stand_at(q_);
  ++steps_;
  keep_scales();
}

/// The loop of all motion. `certified_share(covered)` is how much further the next step may go,
/// `values_at(share, values)` the drivers there.
template <class Share, class Values>
tl::expected<void, PathStop> PlanarPath::move(const Share& certified_share, const Values& values_at) {
  double covered = 0, trust = 1;
  const std::size_t most_tried = tried_ + limits_.steps;
  std::vector<double> before, next;
  const auto stopped = [&](PathEnd end) {
    return tl::unexpected(PathStop{end, covered, equations_.values()});
  };
  const auto singular = [&] {
    values_at(std::min(1.0, covered + slack::look_ahead), next);
    return stopped(kind_of_singularity(next));
  };
  while (covered < 1) {
    if (tried_ >= most_tried) return stopped(PathEnd::gave_up);
    const bool looks = ++tried_ % looks_every == 0 || q_.size() > many_unknowns;
    if (looks && limits_.stop && limits_.stop()) return stopped(PathEnd::interrupted);
    // The factors of the last correction will do where they are near enough.
    bool regular = (base_.size() > 0 && factors_.sign() != 0) || linearise();
    double share = regular ? certified_share(covered) : 0;
    if (regular && !is_exact() && (!(share > 0) || certificate_.bending() * apart() > nearby)) {
      regular = linearise();
      share = regular ? certified_share(covered) : 0;
    }
    share *= trust;
    const double reached = covered + share >= 1 ? 1 : covered + share;
    const bool stands = !(reached > covered) || trust < slack::least_trust;
    if ((stands || certificate_.bending() > bent_rows_) && choose_rows_again()) {
      trust = 1;
      continue;
    }
    if (stands) return singular();
    before = equations_.values();
    values_at(reached, next);
    if (!correct(next, (reached - covered) / (1 - covered))) {
      equations_.set_values(before);
      trust *= 0.5;
      continue;
    }
    if (trial_f_.size() > q_.size() && trial_f_.lpNorm<Eigen::Infinity>() > closing_limit()) {
      equations_.set_values(before);
      return stopped(PathEnd::over_constrained);
    }
    accept();
    covered = reached;
    trust = std::min(1.0, 2 * trust);
  }
  return {};
}

tl::expected<void, PathStop> PlanarPath::advance(const std::vector<double>& target) {
  const std::vector<double> from = equations_.values();
  return move([&](double covered) { return (1 - covered) * straight_share(target); },
              [&](double share, std::vector<double>& values) {
                values = target;
                if (share < 1)
                  for (std::size_t i = 0; i < values.size(); ++i)
                    values[i] = from[i] + share * (target[i] - from[i]);
              });
}

tl::expected<void, PathStop> PlanarPath::follow(const DriverCurve& curve) {
  return move([&](double covered) { return curve_share(curve, covered); }, curve.values_at);
}

Eigen::VectorXd PlanarPath::velocity(const std::vector<double>& speeds) {
  linearise();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(q_.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const int driver = static_cast<int>(i);
    right[equations_.driver_row(driver)] = equations_.driver_slope(driver) * speeds[i];
  }
  factors_.solve(right, right);
  return right;
}

Eigen::VectorXd PlanarPath::acceleration(const Eigen::VectorXd& rate, const std::vector<double>& speeds,
                                         const std::vector<double>& accelerations) {
  linearise();
  Eigen::VectorXd bend;
  equations_.second_derivative(q_, rate, bend);
  Eigen::VectorXd right = -bend.head(q_.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const int driver = static_cast<int>(i);
    right[equations_.driver_row(driver)] +=
        equations_.driver_slope(driver) * accelerations[i] + equations_.driver_bend(driver, speeds[i]);
  }
  factors_.solve(right, right);
  return right;
}

}  // namespace kempe
