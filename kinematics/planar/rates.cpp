#include "kinematics/planar/rates.hpp"

namespace kempe {
namespace {

/// The point as seen from its body's origin, in the table's frame.
Point arm_of(const PlanarPosition& position, const BodyPoint& point) {
  return place(position, point) - position[static_cast<std::size_t>(point.body)].at;
}

}  // namespace

double spin_of(const Eigen::VectorXd& rates, int body) {
  return body == PlanarLinkage::ground ? 0 : rates[3 * body - 1];
}

Point velocity_of(const PlanarPosition& position, const Eigen::VectorXd& rate, const BodyPoint& point) {
  if (point.body == PlanarLinkage::ground) return Point::Zero();
  return rate.segment<2>(3 * point.body - 3) + spin_of(rate, point.body) * left_of(arm_of(position, point));
}

Point acceleration_of(const PlanarPosition& position, const Eigen::VectorXd& rate,
                      const Eigen::VectorXd& second, const BodyPoint& point) {
  if (point.body == PlanarLinkage::ground) return Point::Zero();
  const Point arm = arm_of(position, point);
  const double spin = spin_of(rate, point.body);
  return second.segment<2>(3 * point.body - 3) + spin_of(second, point.body) * left_of(arm) -
         spin * spin * arm;
}

}  // namespace kempe
