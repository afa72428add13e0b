#include "kinematics/planar/step_certificate.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

constexpr double kantorovich_limit = 0.4;  ///< omega eta; the theorem asks for 1/2
constexpr double ball = 0.5;               ///< rad around the anchor, within which the bends hold
constexpr double farthest_carried = 0.3;   ///< omega times the distance from the anchor
constexpr double least_weight = 0.02;      ///< of a body that does not turn at all

}  // namespace

StepCertificate::StepCertificate(const PlanarEquations& equations)
    : angle_bends_(equations.angle_bends()), place_bends_(equations.place_bends()), size_(equations.reach()),
      weights_(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(angle_bends_.size()))), load_(weights_) {}

void StepCertificate::measure(PlanarEquations& equations, PlanarFactors& factors,
                              const Eigen::VectorXd& anchor, const Eigen::VectorXd& q) {
  const Eigen::Index square = anchor.size(), bodies = weights_.size();
  equations.bends(anchor, bends_);
  gains_.setZero(2 * bodies, bodies);
  const auto add_gains = [&](Eigen::Index unknown, auto&& row) {
    factors.inverse_row(unknown, inverse_row_);
    for (const auto& bend : bends_) {
      const double first = bend.row < square ? inverse_row_[bend.row] : 0;
      const double second =
          bend.second_row >= 0 && bend.second_row < square ? inverse_row_[bend.second_row] : 0;
      row[bend.body] += bend.bound * std::sqrt(first * first + second * second);
    }
  };
  for (Eigen::Index body = 1; body < bodies; ++body) {
    const Eigen::Index x = 3 * body - 3;
    if (angle_bends_[static_cast<std::size_t>(body)]) add_gains(x + 2, gains_.row(2 * body));
    if (!place_bends_[static_cast<std::size_t>(body)]) continue;
    load_.setZero();
    add_gains(x, gains_.row(2 * body + 1));
    add_gains(x + 1, load_);
    for (Eigen::Index b = 0; b < bodies; ++b)
      gains_(2 * body + 1, b) = std::hypot(gains_(2 * body + 1, b), load_[b]) / size_;
  }
  anchor_ = anchor;
  way_ = q - anchor;
  weigh();
}

void StepCertificate::stand_at(const Eigen::VectorXd& q) {
  if (anchor_.size() == 0) return;
  way_ = q - anchor_;
  moved_ = length(way_);
}

void StepCertificate::weigh() {
  load_ = weights_.cwiseAbs2();
  bending_ = 0;
  for (Eigen::Index body = 1; body < weights_.size(); ++body) {
    bending_ = std::max(bending_, gains_.row(2 * body).dot(load_) / weights_[body]);
    if (place_bends_[static_cast<std::size_t>(body)])
      bending_ = std::max(bending_, gains_.row(2 * body + 1).dot(load_));
  }
  moved_ = length(way_);
}

void StepCertificate::weigh_alike() {
  if (alike_) return;
  weights_.setOnes();
  alike_ = true;
  weigh();
}

void StepCertificate::weigh_by(const Eigen::VectorXd& step) {
  const Eigen::Index bodies = weights_.size();
  const auto turn = [&](Eigen::Index body) { return std::abs(step[3 * body - 1]); };
  load_.setZero();
  for (Eigen::Index body = 1; body < bodies; ++body) load_[body] = turn(body) * turn(body);
  double largest = 0;
  for (Eigen::Index body = 1; body < bodies; ++body) {
    weights_[body] = turn(body) + gains_.row(2 * body).dot(load_);
    largest = std::max(largest, weights_[body]);
  }
  if (!(largest > 0)) largest = 1;  // nothing turns: all weigh the same little
  for (Eigen::Index body = 1; body < bodies; ++body)
    weights_[body] = std::max(weights_[body] / largest, least_weight);
  alike_ = false;
  weigh();
}

double StepCertificate::length(const Eigen::VectorXd& change) const {
  double result = 0;
  for (std::size_t body = 1; body < angle_bends_.size(); ++body) {
    const Eigen::Index x = 3 * static_cast<Eigen::Index>(body) - 3;
    if (angle_bends_[body])
      result = std::max(result, std::abs(change[x + 2]) / weights_[static_cast<Eigen::Index>(body)]);
    if (place_bends_[body]) result = std::max(result, change.segment<2>(x).norm() / size_);
  }
  return result;
}

double StepCertificate::bending() const {
  if (anchor_.size() == 0 || bending_ * moved_ > farthest_carried) return -1;
  return bending_ / (1 - bending_ * moved_);
}

double StepCertificate::allowed(double wanted, double apart) const {
  const double omega = bending();
  if (omega < 0) return 0;
  const double by_theorem = omega * longest > kantorovich_limit ? kantorovich_limit / omega : longest;
  const double most = std::min({by_theorem / (1 + omega * apart), 0.5 * (ball - moved_), wanted});
  return most > std::min(slack::singular_turn, 0.5 * wanted) ? most : 0;
}

}  // namespace kempe
