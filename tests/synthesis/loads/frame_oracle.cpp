#include "tests/synthesis/loads/frame_oracle.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace kempe::test {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2>;

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
Matrix6d stiffness_of(const FrameTask& task, const Point& from, const Point& to) {
  const double length = (to - from).norm(), area = task.width * task.thickness,
               second_moment = task.thickness * task.width * task.width * task.width / 12;
  const double a = task.young * area / length,
               b = 12 * task.young * second_moment / (length * length * length), c = b * length / 2,
               d = c * length * 2 / 3, e = d / 2;
  Matrix6d own;
  own << a, 0, 0, -a, 0, 0,  //
      0, b, c, 0, -b, c,     //
      0, c, d, 0, -c, e,     //
      -a, 0, 0, a, 0, 0,     //
      0, -b, -c, 0, b, -c,   //
      0, c, e, 0, -c, d;
  const Point u = (to - from) / length;
  Matrix6d turn = Matrix6d::Zero();
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
    for (const FrameJoint joint : {task.pole, task.tracer, task.pen})
      pin_[joint] = number_place();  // the held ones first
    for (const Element& element : elements_)
      for (const FrameJoint joint : {element.from, element.to}) number_joint(element.link, joint);
    stiffness_ = Eigen::MatrixXd::Zero(count_, count_);
    for (const Element& element : elements_) add(element);
    for (const Key& key : sprung_) add_spring(key);
  }

  FrameAnswer answer() {
    const int pen = pin_.at(task_.pen);
    Columns load = Columns::Zero(count_, 2);
    load.middleRows<2>(pen).setIdentity();
    constexpr int held = 4;
    const int free = count_ - held;
    const Eigen::LDLT<Eigen::MatrixXd> factors(stiffness_.bottomRightCorner(free, free));
    const Eigen::VectorXd pivots = factors.vectorD();
    if (factors.info() != Eigen::Success || !(pivots.minCoeff() > 1e-13 * pivots.maxCoeff()))
      throw std::runtime_error("the frame is a mechanism");
    moved_ = Columns::Zero(count_, 2);
    moved_.bottomRows(free) = factors.solve(load.bottomRows(free));
    FrameAnswer answer;
    answer.compliance = moved_.middleRows<2>(pen);
    const Columns forces = stiffness_ * moved_;
    answer.pole = forces.middleRows<2>(pin_.at(task_.pole));
    answer.hand = forces.middleRows<2>(pin_.at(task_.tracer));
    answer.pins = {force_on(plate_ACX, joint_A), force_on(plate_BCY, joint_B), force_on(plate_BCY, joint_C)};
    for (const int bar : {0, 1}) {
      const Point u =
          (task_.joints[elements_[static_cast<std::size_t>(bar)].to] - task_.joints[joint_V]).normalized();
      answer.axial[static_cast<std::size_t>(bar)].row(0) =
          u.transpose() * end_forces(elements_[static_cast<std::size_t>(bar)]).middleRows<2>(3);
      answer.axial[static_cast<std::size_t>(bar)].row(1).setZero();
    }
    for (const Element& element : elements_) {
      const auto ends = end_forces(element);
      Eigen::Matrix2d moments;
      moments << ends.row(2), ends.row(5);
      answer.beams.push_back({element.from, element.to, moments});
    }
    return answer;
  }

 private:
  using Key = std::pair<Link, FrameJoint>;

  int number_place() {
    count_ += 2;
    return count_ - 2;
  }

  /// A link's joint hangs on its pin: the post, the hand or the pen; in A, B and C on the first link there. With a
  /// compliance it has a place of its own, and a spring.
  void number_joint(Link link, FrameJoint joint) {
    const Key key{link, joint};
    if (turn_.contains(key)) return;
    turn_[key] = count_++;
    if (!pin_.contains(joint)) {
      pin_[joint] = place_[key] = number_place();
    } else if (task_.pin_compliance[joint] == 0) {
      place_[key] = pin_[joint];
    } else {
      place_[key] = number_place();
      sprung_.push_back(key);
    }
  }

  std::array<int, 6> rows_of(const Element& element) const {
    const Key from{element.link, element.from}, to{element.link, element.to};
    const int a = place_.at(from), b = place_.at(to);
    return {a, a + 1, turn_.at(from), b, b + 1, turn_.at(to)};
  }

  void add(const Element& element) {
    const Matrix6d own = stiffness_of(task_, task_.joints[element.from], task_.joints[element.to]);
    const auto rows = rows_of(element);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        stiffness_(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]) += own(i, j);
  }

  void add_spring(const Key& key) {
    const double stiffness = 1 / task_.pin_compliance[key.second];
    const int own = place_.at(key), other = pin_.at(key.second);
    for (const int axis : {0, 1}) {
      stiffness_(own + axis, own + axis) += stiffness;
      stiffness_(other + axis, other + axis) += stiffness;
      stiffness_(own + axis, other + axis) -= stiffness;
      stiffness_(other + axis, own + axis) -= stiffness;
    }
  }

  /// What the ends of a beam are pushed with: forces and moments on the beam.
  Eigen::Matrix<double, 6, 2> end_forces(const Element& element) const {
    Eigen::Matrix<double, 6, 2> ends;
    const auto rows = rows_of(element);
    for (int i = 0; i < 6; ++i) ends.row(i) = moved_.row(rows[static_cast<std::size_t>(i)]);
    return stiffness_of(task_, task_.joints[element.from], task_.joints[element.to]) * ends;
  }

  /// What a link is pushed with at a joint, by all that is no beam of its own.
  Eigen::Matrix2d force_on(Link link, FrameJoint joint) const {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const Element& element : elements_) {
      if (element.link != link) continue;
      if (element.from == joint) sum += end_forces(element).topRows<2>();
      if (element.to == joint) sum += end_forces(element).middleRows<2>(3);
    }
    return sum;
  }

  const FrameTask& task_;
  std::vector<Element> elements_;
  std::map<Key, int> place_, turn_;  ///< first row of x and y, row of the turn
  std::map<FrameJoint, int> pin_;    ///< first row of the pin's place
  std::vector<Key> sprung_;
  int count_ = 0;
  Eigen::MatrixXd stiffness_;
  Columns moved_;
};

}  // namespace

FrameAnswer solve_frame(const FrameTask& task) { return Frame(task).answer(); }

}  // namespace kempe::test
