#include "kinematics/planar/reactions.hpp"

#include "geometry/decompositions.hpp"
#include "kinematics/overloaded.hpp"
#include "kinematics/planar/loads.hpp"
#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

/// The direction of the force at the pitch point of two wheels, on the first, and the point.
struct ToothContact {
  Point at, along;
};

/// `first` and `second` are the wheels' centres, the radii those of the equation: only their ratio counts.
ToothContact contact_of(const GearPair& gears, const Point& first, const Point& second) {
  const Point between = second - first;
  const double share = gears.first_radius / (gears.first_radius + gears.second_radius);
  return {first + share * between, left_of(direction_between(second, first))};
}

}  // namespace

ReactionSolver::ReactionSolver(const PlanarLinkage& linkage) : linkage_(linkage), equations_(linkage_) {
  find_bearings();
}

void ReactionSolver::find_bearings() {
  for (int i = 0; i < static_cast<int>(linkage_.constraints().size()); ++i) {
    const auto* gears =
        std::get_if<GearPair>(&linkage_.constraints()[static_cast<std::size_t>(i)].constraint);
    if (!gears) continue;
    const auto first = bearing_of(gears->first, gears->carrier),
               second = bearing_of(gears->second, gears->carrier);
    if (first && second)
      bearings_.push_back({i, *first, *second});
    else
      gears_without_bearings_ = true;
  }
}

/// The wheel's point about which it turns on the carrier: a joint of the two, or joints of both with a third body at one
/// point of it, as where several links meet.
std::optional<BodyPoint> ReactionSolver::bearing_of(int wheel, int carrier) const {
  const auto joints_of = [&](int body) {
    std::vector<std::pair<BodyPoint, BodyPoint>> joints;  // of the body, of the other
    for (const auto& [name, constraint] : linkage_.constraints())
      if (const auto* joint = std::get_if<Revolute>(&constraint)) {
        if (joint->a.body == body) joints.emplace_back(joint->a, joint->b);
        if (joint->b.body == body) joints.emplace_back(joint->b, joint->a);
      }
    return joints;
  };
  for (const auto& [own, other] : joints_of(wheel)) {
    if (other.body == carrier) return own;
    for (const auto& [on_carrier, across] : joints_of(carrier))
      if (across == other) return own;
  }
  return std::nullopt;
}

void ReactionSolver::put_tooth_force(const Bearings& bearings, const PlanarPosition& position) {
  const auto& gears =
      std::get<GearPair>(linkage_.constraints()[static_cast<std::size_t>(bearings.constraint)].constraint);
  const ToothContact contact =
      contact_of(gears, place(position, bearings.first), place(position, bearings.second));
  const int row = equations_.row_of(bearings.constraint);
  rows_.row(row).setZero();
  for (const auto& [wheel, sign] : {std::pair{gears.first, 1.0}, std::pair{gears.second, -1.0}}) {
    if (wheel == PlanarLinkage::ground) continue;
    const Point arm = contact.at - position[static_cast<std::size_t>(wheel)].at;
    rows_.block<1, 3>(row, 3 * wheel - 3) << sign * contact.along.x(), sign * contact.along.y(),
        sign * cross(arm, contact.along);
  }
}

/// Rows without units: angles' columns by the bodies' arms, then each row by its largest entry, which is kept.
void ReactionSolver::scale_rows() {
  for (int body = 1; body < linkage_.body_count(); ++body) rows_.col(3 * body - 1) /= equations_.arm_of(body);
  row_scale_ = rows_.rowwise().lpNorm<Eigen::Infinity>();
  for (Eigen::Index row = 0; row < rows_.rows(); ++row)
    if (!(row_scale_[row] > 0)) row_scale_[row] = 1;
  rows_.array().colwise() /= row_scale_.array();
}

std::optional<std::vector<Reaction>> ReactionSolver::at(const PlanarPosition& position,
                                                        const std::vector<double>& driver_values,
                                                        const Eigen::VectorXd& needed) {
  equations_.set_values(driver_values);
  equations_.residual_and_jacobian(unknowns_of(position), gaps_, rows_);
  for (const Bearings& bearings : bearings_) put_tooth_force(bearings, position);
  if (!rows_.allFinite() || !needed.allFinite()) return std::nullopt;
  scale_rows();
  Eigen::VectorXd right = needed;
  for (int body = 1; body < linkage_.body_count(); ++body) right[3 * body - 1] /= equations_.arm_of(body);

  // rows P = Q R: the multipliers of least length are Q1 R^-T P^T right, and the columns of Q beyond Q1 are what may be added
  // to them without any change on the bodies.
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(slack::dependent_row);
  qr.compute(rows_);
  const Eigen::Index unknowns = rows_.cols(), equations = rows_.rows();
  if (qr.rank() < unknowns) return std::nullopt;
  Eigen::VectorXd lambda = Eigen::VectorXd::Zero(equations);
  lambda.head(unknowns) = qr.matrixR()
                              .topLeftCorner(unknowns, unknowns)
                              .triangularView<Eigen::Upper>()
                              .transpose()
                              .solve(qr.colsPermutation().transpose() * right);
  lambda.applyOnTheLeft(qr.householderQ());
  Eigen::VectorXd doubt = Eigen::VectorXd::Zero(equations);
  if (equations > unknowns) {
    Eigen::MatrixXd spare = Eigen::MatrixXd::Zero(equations, equations - unknowns);
    spare.bottomRows(equations - unknowns).setIdentity();
    spare.applyOnTheLeft(qr.householderQ());
    doubt = spare.rowwise().norm();
  }
  lambda.array() /= row_scale_.array();

  std::vector<Reaction> reactions;
  for (int i = 0; i < static_cast<int>(linkage_.constraints().size()); ++i) {
    reactions.push_back(reaction_of(i, lambda, doubt, position));
    if (!reactions.back().force.allFinite()) return std::nullopt;
  }
  return reactions;
}

Reaction ReactionSolver::reaction_of(int number, const Eigen::VectorXd& lambda, const Eigen::VectorXd& doubt,
                                     const PlanarPosition& position) const {
  const Constraint& constraint = linkage_.constraints()[static_cast<std::size_t>(number)].constraint;
  const int row = equations_.row_of(number);
  Reaction reaction;
  reaction.determined =
      doubt[row] <= slack::dependent_row && (!gears_without_bearings_ || linkage_.is_driver(number));
  reaction.along = lambda[row] * equations_.value_slope(number);
  std::visit(
      Overloaded{
          [&](const Revolute&) {
            reaction.force = {-lambda[row], -lambda[row + 1]};
            reaction.along = 0;
            reaction.determined &= doubt[row + 1] <= slack::dependent_row;
          },
          [&](const Coordinate& c) {
            reaction.force = reaction.along * turned(position, c.origin.body, c.direction);
          },
          [&](const Distance& c) {
            reaction.force = reaction.along * direction_between(place(position, c.a), place(position, c.b));
          },
          [&](const RelativeAngle&) {},
          [&](const GearPair& c) {
            reaction.along = lambda[row];
            for (const Bearings& bearings : bearings_)
              if (bearings.constraint == number)
                reaction.force =
                    lambda[row] *
                    contact_of(c, place(position, bearings.first), place(position, bearings.second)).along;
          },
          [&](const RackAndPinion& c) {
            reaction.force = reaction.along * turned(position, c.rack_origin.body, c.direction);
          }},
      constraint);
  return reaction;
}

}  // namespace kempe
