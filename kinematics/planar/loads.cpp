#include "kinematics/planar/loads.hpp"

#include <cmath>

#include "kinematics/planar/rates.hpp"
#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

constexpr double newton_a_kg_mm = 1e-3;  ///< N in a kg mm/s^2

/// Forces and moments of every body, summed up about the origins of their frames.
class ForceSum {
 public:
  explicit ForceSum(const PlanarPosition& position)
      : position_(position), sum_(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(position.size()) - 3)) {
  }

  void add_force(const BodyPoint& at, const Point& newton) {
    if (at.body == PlanarLinkage::ground) return;
    const Point arm = turned(position_, at.body, at.local);
    sum_.segment<2>(3 * at.body - 3) += newton;
    add_moment(at.body, cross(arm, newton));
  }

  void add_moment(int body, double moment) {
    if (body != PlanarLinkage::ground) sum_[3 * body - 1] += moment;
  }

  const Eigen::VectorXd& sum() const { return sum_; }

 private:
  const PlanarPosition& position_;
  Eigen::VectorXd sum_;
};

}  // namespace

Point direction_between(const Point& a, const Point& b) {
  const Point apart = a - b;
  const double distance = apart.norm();
  if (!(distance > slack::same_point * (a.norm() + b.norm()))) return Point::Constant(std::nan(""));
  return apart / distance;
}

Eigen::VectorXd applied_forces(const PlanarLoads& loads, const PlanarPosition& position) {
  ForceSum sum(position);
  for (const PointForce& force : loads.forces)
    sum.add_force(force.at, turned(position, force.turns_with, force.newton));
  for (const PairForce& pair : loads.pairs) {
    const Point apart = direction_between(place(position, pair.a), place(position, pair.b));
    sum.add_force(pair.a, pair.newton * apart);
    sum.add_force(pair.b, -pair.newton * apart);
  }
  for (const BodyMoment& moment : loads.moments) {
    sum.add_moment(moment.body, moment.moment);
    sum.add_moment(moment.against, -moment.moment);
  }
  for (const BodyMass& mass : loads.masses) sum.add_force({mass.body, mass.centre}, mass.kg * loads.gravity);
  return sum.sum();
}

Eigen::VectorXd inertia_forces(const PlanarLoads& loads, const PlanarPosition& position,
                               const Eigen::VectorXd& rate, const Eigen::VectorXd& second) {
  ForceSum sum(position);
  for (const BodyMass& mass : loads.masses) {
    const BodyPoint centre{mass.body, mass.centre};
    sum.add_force(centre, newton_a_kg_mm * mass.kg * acceleration_of(position, rate, second, centre));
    sum.add_moment(mass.body, newton_a_kg_mm * mass.inertia * spin_of(second, mass.body));
  }
  return sum.sum();
}

}  // namespace kempe
