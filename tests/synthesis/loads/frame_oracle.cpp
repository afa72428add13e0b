#include "tests/synthesis/loads/frame_oracle.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace kempe::test {
namespace {

using Real = long double;  ///< a long thin frame's stiffnesses span eight orders of magnitude
using Matrix6 = Eigen::Matrix<Real, 6, 6>;
using MatrixX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Columns = Eigen::Matrix<Real, Eigen::Dynamic, 2>;
using EndForces = Eigen::Matrix<Real, 6, 2>;
using Vector = Eigen::Matrix<Real, 2, 1>;

enum Link { bar_VA, bar_VB, plate_ACX, plate_BCY };

/// A beam between two joints of a link.
struct Element {
  Link link;
  FrameJoint from, to;
};

/// The joints of a straight plate, in their order along it.
std::vector<FrameJoint> in_order(const FrameTask& task, std::vector<FrameJoint> joints) {
  const auto at = [&](FrameJoint joint) { return task.joints[joint]; };
  Point along = Point::Zero();
  for (const FrameJoint a : joints)
    for (const FrameJoint b : joints)
      if ((at(b) - at(a)).norm() > along.norm()) along = at(b) - at(a);
  std::sort(joints.begin(), joints.end(),
            [&](FrameJoint a, FrameJoint b) { return at(a).dot(along) < at(b).dot(along); });
  return joints;
}

std::vector<Element> elements_of(const FrameTask& task) {
  std::vector<Element> elements{{bar_VA, joint_V, joint_A}, {bar_VB, joint_V, joint_B}};
  const auto add_plate = [&](Link link, bool straight, FrameJoint corner, FrameJoint end) {
    if (!straight) {
      elements.push_back({link, corner, joint_C});
      elements.push_back({link, corner, end});
      return;
    }
    const std::vector<FrameJoint> row = in_order(task, {corner, joint_C, end});
    elements.push_back({link, row[0], row[1]});
    elements.push_back({link, row[1], row[2]});
  };
  add_plate(plate_ACX, task.straight_ACX, joint_A, joint_X);
  add_plate(plate_BCY, task.straight_BCY, joint_B, joint_Y);
  return elements;
}

/// Stiffness of a straight beam in the plane against the movements (x, y, turn) of its two ends, in the table's frame: the
/// textbook's element in its own frame, turned.
Matrix6 stiffness_of(const FrameTask& task, const Point& from, const Point& to) {
  const Vector way = to.cast<Real>() - from.cast<Real>();
  const Real length = way.norm(), young = task.young, width = task.width, thickness = task.thickness;
  const Real second_moment = thickness * width * width * width / 12;
  const Real a = young * width * thickness / length,
             b = 12 * young * second_moment / (length * length * length), c = b * length / 2,
             d = c * length * 2 / 3, e = d / 2;
  Matrix6 own;
  own << a, 0, 0, -a, 0, 0,  //
      0, b, c, 0, -b, c,     //
      0, c, d, 0, -c, e,     //
      -a, 0, 0, a, 0, 0,     //
      0, -b, -c, 0, b, -c,   //
      0, c, e, 0, -c, d;
  const Vector u = way / length;
  Matrix6 turn = Matrix6::Zero();
  for (const int end : {0, 3}) {
    turn.block<2, 2>(end, end) << u.x(), u.y(), -u.y(), u.x();
    turn(end + 2, end + 2) = 1;
  }
  return turn.transpose() * own * turn;
}

/// The frame as one matrix: places of every link's joints, the turn of every link at each of its joints.
class Frame {
 public:
  explicit Frame(const FrameTask& task) : task_(task), elements_(elements_of(task)) {
    post_ = number_place();  // post and hand come first: what is held
    pin_[task.tracer] = number_place();
    pin_[task.pole] =
        task.pole_compliance > 0 ? number_place() : post_;  // what all links at the pole hang on
    pin_[task.pen] = number_place();
    for (const Element& element : elements_)
      for (const FrameJoint joint : {element.from, element.to}) number_joint(element.link, joint);
    stiffness_ = MatrixX::Zero(count_, count_);
    for (const Element& element : elements_) add(element);
    if (task.pole_compliance > 0) add_spring(pin_.at(task.pole), post_, task.pole_compliance);
    for (const Key& key : sprung_) add_spring(place_.at(key), pin_.at(key.second), compliance_of(key));
  }

  FrameAnswer answer() {
    const int pen = pin_.at(task_.pen);
    Columns load = Columns::Zero(count_, 2);
    load.middleRows<2>(pen).setIdentity();
    constexpr int held = 4;
    const int free = count_ - held;
    const Eigen::LDLT<MatrixX> factors(stiffness_.bottomRightCorner(free, free));
    const Eigen::Matrix<Real, Eigen::Dynamic, 1> pivots = factors.vectorD();
    if (factors.info() != Eigen::Success || !(pivots.minCoeff() > 1e-16 * pivots.maxCoeff()))
      throw std::runtime_error("the frame is a mechanism");
    moved_ = Columns::Zero(count_, 2);
    moved_.bottomRows(free) = factors.solve(load.bottomRows(free));
    FrameAnswer answer;
    answer.compliance = moved_.middleRows<2>(pen).cast<double>();
    const Columns forces = stiffness_ * moved_;
    answer.pole = forces.middleRows<2>(post_).cast<double>();
    answer.hand = forces.middleRows<2>(pin_.at(task_.tracer)).cast<double>();
    answer.pins = {force_on(plate_ACX, joint_A), force_on(plate_BCY, joint_B), force_on(plate_BCY, joint_C)};
    for (const Element& element : elements_) {
      const Eigen::Matrix<double, 6, 2> ends = end_forces(element).cast<double>();
      const Point u = (task_.joints[element.to] - task_.joints[element.from]).normalized();
      FrameAnswer::Beam beam{element.from, element.to, u.transpose() * ends.middleRows<2>(3), {}};
      beam.moments << ends.row(2), ends.row(5);
      answer.beams.push_back(beam);
    }
    return answer;
  }

 private:
  using Key = std::pair<Link, FrameJoint>;

  int number_place() {
    count_ += 2;
    return count_ - 2;
  }

  /// A link's joint hangs on what is there: post, hand or pen; at A, B and C the first link. Where the pin gives way it has a place of its
  /// own and a spring.
  void number_joint(Link link, FrameJoint joint) {
    const Key key{link, joint};
    if (turn_.contains(key)) return;
    turn_[key] = count_++;
    if (!pin_.contains(joint)) {
      pin_[joint] = place_[key] = number_place();
    } else if (compliance_of(key) == 0) {
      place_[key] = pin_[joint];
    } else {
      place_[key] = number_place();
      sprung_.push_back(key);
    }
  }

  double compliance_of(const Key& key) const {
    const auto& [link, joint] = key;
    if (joint >= joint_X || link == bar_VA) return 0;
    return task_.pin_compliance[joint];
  }

  std::array<int, 6> rows_of(const Element& element) const {
    const Key from{element.link, element.from}, to{element.link, element.to};
    const int a = place_.at(from), b = place_.at(to);
    return {a, a + 1, turn_.at(from), b, b + 1, turn_.at(to)};
  }

  void add(const Element& element) {
    const Matrix6 own = stiffness_of(task_, task_.joints[element.from], task_.joints[element.to]);
    const auto rows = rows_of(element);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        stiffness_(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]) += own(i, j);
  }

  void add_spring(int own, int other, double compliance) {
    const Real stiffness = 1 / Real(compliance);
    for (const int axis : {0, 1}) {
      stiffness_(own + axis, own + axis) += stiffness;
      stiffness_(other + axis, other + axis) += stiffness;
      stiffness_(own + axis, other + axis) -= stiffness;
      stiffness_(other + axis, own + axis) -= stiffness;
    }
  }

  /// What the ends of a beam are pushed with: forces and moments on the beam.
  EndForces end_forces(const Element& element) const {
    EndForces ends;
    const auto rows = rows_of(element);
    for (int i = 0; i < 6; ++i) ends.row(i) = moved_.row(rows[static_cast<std::size_t>(i)]);
    return stiffness_of(task_, task_.joints[element.from], task_.joints[element.to]) * ends;
  }

  /// What a link is pushed with at a joint, by all that is no beam of its own.
  Eigen::Matrix2d force_on(Link link, FrameJoint joint) const {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const Element& element : elements_) {
      if (element.link != link) continue;
      if (element.from == joint) sum += end_forces(element).topRows<2>().cast<double>();
      if (element.to == joint) sum += end_forces(element).middleRows<2>(3).cast<double>();
    }
    return sum;
  }

  const FrameTask& task_;
  std::vector<Element> elements_;
  std::map<Key, int> place_, turn_;  ///< first row of x and y, row of the turn
  std::map<FrameJoint, int> pin_;    ///< first row of the pin's place
  int post_ = 0;
  std::vector<Key> sprung_;
  int count_ = 0;
  MatrixX stiffness_;
  Columns moved_;
};

}  // namespace

FrameAnswer solve_frame(const FrameTask& task) { return Frame(task).answer(); }

}  // namespace kempe::test
