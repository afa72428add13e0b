#pragma once
// How a copying linkage sinks out of its plane, by the forces in its sections: what the pins pass on is unknown, every link is in
// balance, and of all such forces the true ones have the least complementary energy (Castigliano's second theorem, Menabrea's principle).
// The energy is integrated along the arms. No stiffness matrix and no deflection is written down.

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/point.hpp"

namespace kempe::section_forces {

/// A pull upwards (N) and moments about x and y (N mm) at a place of a link, each a linear function of the unknowns and of 1.
struct Bar {
  int from, to;  ///< joints
};

struct Piece {
  std::vector<int> joints;
  std::vector<Bar> bars;
  double weight;  ///< N/mm along its bars
};

/// Joins two links, or (other < 0) a link and the ground.
struct Join {
  int joint, link, other;
  double stiffness;                                ///< N mm/rad
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();  ///< rad about x and y: so it lies within its play
};

/// Loads a link at one of its joints, N mm about x and y.
struct Couple {
  int joint, link;
  Eigen::Vector2d moment;
};

struct Structure {
  std::vector<Complex> places;  ///< of the joints, mm
  std::vector<double> loads;    ///< N at the joints, downwards
  std::vector<Piece> links;
  std::vector<Join> joins;
  std::vector<std::pair<int, int>> props;  ///< joint, and a link that has it
  double bending, torsion;                 ///< N mm^2
  std::vector<Couple> couples{};
};

class LeastEnergy {
 public:
  explicit LeastEnergy(const Structure& structure) : it_(structure) {
    unknowns_ = static_cast<int>(3 * it_.joins.size() + it_.props.size());
  }

  /// The least energy, with `load` N more downwards at a joint; the unknowns afterwards stand in forces().
  double energy(int joint, double load) {
    joint_ = joint;
    load_ = load;
    const int rows = static_cast<int>(3 * it_.links.size());
    matrix_ = Eigen::MatrixXd::Zero(unknowns_ + 1, unknowns_ + 1);
    balance_ = Eigen::MatrixXd::Zero(rows, unknowns_ + 1);
    for (std::size_t i = 0; i < it_.links.size(); ++i) balance(static_cast<int>(i));
    for (std::size_t i = 0; i < it_.links.size(); ++i)
      for (const Bar& bar : it_.links[i].bars) integrate(static_cast<int>(i), bar);
    for (std::size_t i = 0; i < it_.joins.size(); ++i)
      for (const int axis : {1, 2}) {
        const auto at = static_cast<Eigen::Index>(3 * i) + axis;
        matrix_(at, at) += 1 / it_.joins[i].stiffness;
        for (const bool mirrored : {false, true})
          matrix_(mirrored ? unknowns_ : at, mirrored ? at : unknowns_) += it_.joins[i].tilt[axis - 1];
      }
    const Eigen::Index n = unknowns_;
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + rows, n + rows);
    system.topLeftCorner(n, n) = matrix_.topLeftCorner(n, n);
    system.topRightCorner(n, rows) = balance_.leftCols(n).transpose();
    system.bottomLeftCorner(rows, n) = balance_.leftCols(n);
    Eigen::VectorXd right(n + rows);
    right << -matrix_.col(n).head(n), -balance_.col(n);
    forces_ = system.fullPivLu().solve(right).head(n);
    Eigen::VectorXd all(n + 1);
    all << forces_, 1;
    return 0.5 * all.dot(matrix_ * all);
  }

  /// mm downwards at a joint, under the loads: the energy is a quadratic function of one more load there.
  double drop(int joint) {
    const double more = energy(joint, 1), less = energy(joint, -1);
    return 0.5 * (more - less);
  }

  /// N mm that a link takes from all that it is joined to at a joint, of the last energy().
  double moment(int joint, int link) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < it_.joins.size(); ++i) {
      const Join& join = it_.joins[i];
      if (join.joint != joint || (join.link != link && join.other != link)) continue;
      const Eigen::Vector2d passed = forces_.segment<2>(static_cast<Eigen::Index>(3 * i) + 1);
      sum += (join.link == link ? 1 : -1) * passed;
    }
    return sum.norm();
  }

  /// N mm, what bends and what twists a bar of a link at a share of its length from `from`, of the last energy().
  Eigen::Vector2d section(int link, const Bar& bar, double share) const {
    const auto [twisting, bending] = in_section(link, bar, share);
    Eigen::VectorXd all(unknowns_ + 1);
    all << forces_, 1;
    return {bending.dot(all), twisting.dot(all)};
  }

 private:
  using Row = Eigen::RowVectorXd;

  /// Adds a force upwards, a row of unknowns, acting at `place`, to pull and moments about `about`.
  static void push(std::array<Row, 3>& sum, const Row& force, Complex place, Complex about) {
    const Complex arm = place - about;
    sum[0] += force;
    sum[1] += arm.imag() * force;
    sum[2] -= arm.real() * force;
  }

  std::array<Row, 3> nothing() const {
    const Row zero = Row::Zero(unknowns_ + 1);
    return {zero, zero, zero};
  }
  Row unknown(std::size_t which, double sign) const {
    Row row = Row::Zero(unknowns_ + 1);
    row[static_cast<Eigen::Index>(which)] = sign;
    return row;
  }
  Row known(double value) const {
    Row row = Row::Zero(unknowns_ + 1);
    row[unknowns_] = value;
    return row;
  }

  /// The link that takes what a joint is loaded with: the first that has it.
  bool takes_load(int link, int joint) const {
    for (int i = 0; i < link; ++i)
      for (const int one : it_.links[static_cast<std::size_t>(i)].joints)
        if (one == joint) return false;
    return true;
  }

  void at_joint(int link, int joint, Complex about, std::array<Row, 3>& sum) const {
    const Complex place = it_.places[static_cast<std::size_t>(joint)];
    for (std::size_t i = 0; i < it_.joins.size(); ++i) {
      const Join& join = it_.joins[i];
      if (join.joint != joint || (join.link != link && join.other != link)) continue;
      const double sign = join.link == link ? 1 : -1;
      push(sum, unknown(3 * i, sign), place, about);
      sum[1] += unknown(3 * i + 1, sign);
      sum[2] += unknown(3 * i + 2, sign);
    }
    for (std::size_t i = 0; i < it_.props.size(); ++i)
      if (it_.props[i] == std::pair(joint, link))
        push(sum, unknown(3 * it_.joins.size() + i, 1), place, about);
    for (const Couple& couple : it_.couples) {
      if (couple.joint != joint || couple.link != link) continue;
      sum[1] += known(couple.moment.x());
      sum[2] += known(couple.moment.y());
    }
    if (!takes_load(link, joint)) return;
    const double down = it_.loads[static_cast<std::size_t>(joint)] + (joint == joint_ ? load_ : 0);
    push(sum, known(-down), place, about);
  }

  void bar_weight(const Piece& link, Complex from, Complex to, Complex about, std::array<Row, 3>& sum) const {
    push(sum, known(-link.weight * std::abs(to - from)), 0.5 * (from + to), about);
  }

  void balance(int number) {
    const Piece& link = it_.links[static_cast<std::size_t>(number)];
    auto sum = nothing();
    for (const int joint : link.joints) at_joint(number, joint, 0, sum);
    for (const Bar& bar : link.bars) bar_weight(link, place(bar.from), place(bar.to), 0, sum);
    for (int i = 0; i < 3; ++i) balance_.row(3 * number + i) = sum[static_cast<std::size_t>(i)];
  }

  Complex place(int joint) const { return it_.places[static_cast<std::size_t>(joint)]; }

  /// What twists and what bends a section of a bar: everything beyond it, on its `to` side, is the sum over what hangs there.
  std::pair<Row, Row> in_section(int number, const Bar& bar, double share) const {
    const Piece& link = it_.links[static_cast<std::size_t>(number)];
    const Complex from = place(bar.from), to = place(bar.to), along = (to - from) / std::abs(to - from);
    std::vector<int> beyond{bar.to};
    std::vector<Bar> bars;
    for (std::size_t i = 0; i < beyond.size(); ++i)
      for (const Bar& other : link.bars) {
        const bool same = other.from == bar.from && other.to == bar.to;
        const bool known_already = std::any_of(bars.begin(), bars.end(), [&](const Bar& one) {
          return one.from == other.from && one.to == other.to;
        });
        if (same || known_already || (other.from != beyond[i] && other.to != beyond[i])) continue;
        bars.push_back(other);
        beyond.push_back(other.from == beyond[i] ? other.to : other.from);
      }
    const Complex section = from + share * (to - from);
    auto sum = nothing();
    for (const int joint : beyond) at_joint(number, joint, section, sum);
    for (const Bar& other : bars) bar_weight(link, place(other.from), place(other.to), section, sum);
    bar_weight(link, section, to, section, sum);
    return {along.real() * sum[1] + along.imag() * sum[2], -along.imag() * sum[1] + along.real() * sum[2]};
  }

  void integrate(int number, const Bar& bar) {
    // Three places of Gauss: exact to the fifth power, and the moments' squares are of the fourth.
    const double middle = std::sqrt(0.6);
    for (const auto& [where, part] :
         {std::pair(-middle, 5.0 / 18), std::pair(0.0, 8.0 / 18), std::pair(middle, 5.0 / 18)}) {
      const auto [twisting, bending] = in_section(number, bar, 0.5 * (1 + where));
      const double length = part * std::abs(place(bar.to) - place(bar.from));
      matrix_ += length / it_.torsion * twisting.transpose() * twisting +
                 length / it_.bending * bending.transpose() * bending;
    }
  }

  Structure it_;
  int unknowns_ = 0, joint_ = 0;
  double load_ = 0;
  Eigen::MatrixXd matrix_, balance_;
  Eigen::VectorXd forces_;
};

}  // namespace kempe::section_forces
