#include "kinematics/planar/singularity.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/decompositions.hpp"
#include "kinematics/planar/equations.hpp"
#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

constexpr std::size_t most_sentences = 6;

/// Where a body is held: a joint, a guided or a driven point.
struct Hold {
  int body;
  Point at;
  std::string name;
};

/// Unit vector of the motion that the drivers do not stop; empty if there are no unknowns.
Eigen::VectorXd free_motion(const PlanarLinkage& linkage, const PlanarPosition& position) {
  PlanarEquations equations(linkage);
  Eigen::VectorXd f;
  Eigen::MatrixXd jacobian;
  equations.residual_and_jacobian(unknowns_of(position), f, jacobian);
  if (jacobian.cols() == 0) return {};
  for (Eigen::Index angle = 2; angle < jacobian.cols(); angle += 3) jacobian.col(angle) /= equations.size();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  return svd.matrixV().col(jacobian.cols() - 1);
}

class Singularity {
 public:
  Singularity(const PlanarLinkage& linkage, const PlanarPosition& position, double tolerance)
      : linkage_(linkage), position_(position), tolerance_(tolerance),
        motion_(free_motion(linkage, position)) {
    for (const auto& [name, constraint] : linkage.constraints())
      for (const BodyPoint& point : held_points(constraint))
        holds_.push_back({point.body, place(position, point), name});
  }

  std::vector<std::string> sentences() {
    find_joints_in_line();
    find_square_rods();
    result_.resize(std::min(result_.size(), most_sentences));
    std::string moving;
    for (int body = 1; body < linkage_.body_count(); ++body)
      if (moves(body) && !linkage_.is_particle(body))
        moving += (moving.empty() ? "" : ", ") + linkage_.body_name(body);
    if (!moving.empty()) result_.push_back("free to move while the drivers stand still: " + moving);
    return result_;
  }

 private:
  static std::vector<BodyPoint> held_points(const Constraint& constraint) {
    if (const auto* joint = std::get_if<Revolute>(&constraint)) return {joint->a, joint->b};
    if (const auto* line = std::get_if<Coordinate>(&constraint)) return {line->point};
    if (const auto* distance = std::get_if<Distance>(&constraint)) return {distance->a, distance->b};
    return {};
  }

  bool moves(int body) const {
    if (body == PlanarLinkage::ground || motion_.size() == 0) return false;
    return motion_.segment<3>(3 * body - 3).norm() > slack::takes_part;
  }
  /// How fast two bodies turn against each other in the free motion.
  double turn(int a, int b) const {
    const auto spin = [&](int body) { return body == PlanarLinkage::ground ? 0 : motion_[3 * body - 1]; };
    return std::abs(spin(a) - spin(b));
  }

  void add(const std::string& sentence) {
    if (std::find(result_.begin(), result_.end(), sentence) == result_.end()) result_.push_back(sentence);
  }

  /// Sine of the angle at `corner` between the ways to two points, or 1 if they are too near.
  double sine(const Point& a, const Point& corner, const Point& b) const {
    const Point u = a - corner, v = b - corner;
    const double least = slack::same_point * linkage_.size();
    return u.norm() > least && v.norm() > least ? std::abs(cross(u, v)) / (u.norm() * v.norm()) : 1;
  }

  void find_joints_in_line() {
    for (const auto& [name, constraint] : linkage_.constraints()) {
      const auto* joint = std::get_if<Revolute>(&constraint);
      if (!joint || turn(joint->a.body, joint->b.body) < slack::takes_part) continue;
      const Point corner = place(position_, joint->a);
      for (const Hold& a : holds_)
        for (const Hold& b : holds_)
          if (a.body == joint->a.body && b.body == joint->b.body && a.body != 0 && b.body != 0 &&
              sine(a.at, corner, b.at) < tolerance_)
            add(a.name + ", " + name + " and " + b.name + " in line (" + linkage_.body_name(a.body) + ", " +
                linkage_.body_name(b.body) + ")");
    }
  }

  void find_square_rods() {
    for (const auto& [name, constraint] : linkage_.constraints()) {
      const auto* line = std::get_if<Coordinate>(&constraint);
      if (!line || !moves(line->point.body)) continue;
      const Point at = place(position_, line->point);
      const Point normal = linkage_.size() * turned(position_, line->origin.body, line->direction);
      for (const Hold& hold : holds_)
        if (hold.body == line->point.body && sine(hold.at, at, at + normal) < tolerance_)
          add(hold.name + " and " + name + " square to the guide of " + name);
    }
  }

  const PlanarLinkage& linkage_;
  const PlanarPosition& position_;
  double tolerance_;
  Eigen::VectorXd motion_;
  std::vector<Hold> holds_;
  std::vector<std::string> result_;
};

}  // namespace

std::vector<std::string> describe_singularity(const PlanarLinkage& linkage, const PlanarPosition& position,
                                              double tolerance) {
  return Singularity(linkage, position, tolerance).sentences();
}

}  // namespace kempe
