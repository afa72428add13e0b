#include "kinematics/planar/solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "kinematics/planar/equations.hpp"
#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

constexpr double alike = 0.999;  ///< share of the largest error at which another counts as large
constexpr int most_damped_steps = 120, most_newton_steps = 40;

/// Newton and its damped form on one linkage. Angles are scaled by the linkage's size, so that every unknown
/// is a length.
class Closing {
 public:
  Closing(const PlanarLinkage& linkage, const std::vector<double>& values)
      : equations_(linkage), weights_(Eigen::VectorXd::Ones(linkage.equation_count())) {
    equations_.set_values(values);
    scale_ = Eigen::VectorXd::Ones(equations_.unknown_count());
    for (Eigen::Index i = 2; i < scale_.size(); i += 3) scale_[i] = 1 / equations_.size();
  }

  int iterations = 0;

  /// How much the rows of one constraint count.
  void weigh(const PlanarLinkage& linkage, int constraint, double weight) {
    Eigen::Index row = 0;
    for (int i = 0; i < constraint; ++i)
      row += equation_count(linkage.constraints()[static_cast<std::size_t>(i)].constraint);
    const int rows = equation_count(linkage.constraints()[static_cast<std::size_t>(constraint)].constraint);
    weights_.segment(row, rows).setConstant(weight);
  }

  /// Levenberg-Marquardt with gain control, until Newton's own region (in sizes) is reached or nothing is gained: at a
  /// least error that is not zero the residual stands square to all that the unknowns can do about it.
  void approach(Eigen::VectorXd& q, double until = slack::newtons_region) {
    double damping = slack::damping_at_first, previous = linearise(q);
    for (int step = 0; step < most_damped_steps && previous > until * equations_.size();
         ++step, ++iterations) {
      Eigen::MatrixXd normal = jacobian_.transpose() * jacobian_;
      const Eigen::VectorXd slope = jacobian_.transpose() * f_;
      if (slope.norm() <= slack::square_on * previous * jacobian_.norm()) return;
      normal.diagonal().array() += damping;
      const Eigen::VectorXd trial = q - scale_.cwiseProduct(definite_solution(normal, slope));
      residual(trial, f_);
      const double now = f_.norm();
      if (now < previous) {
        const bool stuck = now > previous * (1 - slack::no_gain) && damping < slack::stuck_damping;
        q = trial;
        previous = linearise(q);
        damping = std::max(damping * 0.2, slack::least_damping);
        if (stuck) return;
      } else {
        damping *= 6;
        if (damping > slack::most_damping) return;
        previous = linearise(q);
      }
    }
  }

  /// Newton to the last digit. Where the equations are dependent, or nearly so, singular values that are
  /// rounding or a small distance from a singular position spoil the step: then those below a larger share
  /// are left out.
  void finish(Eigen::VectorXd& q) {
    double best = linearise(q);
    for (int step = 0; step < most_newton_steps && best > 0; ++step, ++iterations) {
      bool gained = false;
      for (const double share : slack::left_out) {
        const Eigen::VectorXd trial = q - scale_.cwiseProduct(least_squares_step(share));
        residual(trial, trial_f_);
        const double now = trial_f_.norm();
        if (!(now < 0.5 * best)) continue;
        q = trial;
        gained = true;
        break;
      }
      if (!gained) return;
      best = linearise(q);
    }
  }

 private:
  void residual(const Eigen::VectorXd& q, Eigen::VectorXd& f) {
    equations_.residual(q, f);
    f.array() *= weights_.array();
  }

  double linearise(const Eigen::VectorXd& q) {
    equations_.residual_and_jacobian(q, f_, jacobian_);
    f_.array() *= weights_.array();
    jacobian_ = weights_.asDiagonal() * jacobian_ * scale_.asDiagonal();
    return f_.norm();
  }

  Eigen::VectorXd least_squares_step(double share) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(share);
    decomposition.compute(jacobian_);
    return solution_of(decomposition, f_);
  }

  PlanarEquations equations_;
  Eigen::VectorXd scale_, weights_, f_, trial_f_;
  Eigen::MatrixXd jacobian_;
};

}  // namespace

double closing_tolerance(const PlanarLinkage& linkage, const PlanarPosition& position) {
  return slack::closed * magnitude_of(unknowns_of(position), linkage.size());
}

tl::expected<Assembled, NotAssembled> solve_from(const PlanarLinkage& linkage, const PlanarPosition& guess,
                                                 const std::vector<double>& driver_values) {
  Closing closing(linkage, driver_values);
  Eigen::VectorXd q = unknowns_of(guess);
  closing.approach(q);
  closing.finish(q);
  PlanarPosition position = position_of(q);
  const ClosureError error = closure_error(linkage, position, driver_values);
  if (error.largest <= closing_tolerance(linkage, position))
    return Assembled{std::move(position), error.largest, closing.iterations};
  const auto& worst = linkage.constraints()[static_cast<std::size_t>(error.constraint)];
  return tl::unexpected(
      NotAssembled{std::move(position), error.largest, worst.name, error.constraint, closing.iterations});
}

Missing missing_at(const PlanarLinkage& linkage, const NotAssembled& open,
                   const std::vector<double>& driver_values) {
  const auto gap = [&](int constraint, const PlanarPosition& position) {
    return gap_of(linkage, constraint, position, driver_values);
  };
  int worst = 0;
  while (gap(worst, open.nearest).as_length(linkage.size()) < alike * open.closure_error) ++worst;
  Closing closing(linkage, driver_values);
  Eigen::VectorXd q = unknowns_of(open.nearest);
  for (const double weight : slack::weights_of_worst) {
    closing.weigh(linkage, worst, weight);
    closing.approach(q, 0);
  }
  return {worst, linkage.constraints()[static_cast<std::size_t>(worst)].name, gap(worst, position_of(q))};
}

tl::expected<Assembled, NotAssembled> solve_from(const PlanarLinkage& linkage, const PlanarPosition& guess) {
  return solve_from(linkage, guess, linkage.driver_values());
}

}  // namespace kempe
