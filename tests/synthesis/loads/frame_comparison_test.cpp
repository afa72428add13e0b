// Loads in the plane, in closed form, against the frame oracle: random linkages of every grounding, straight and bent.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/strength.hpp"
#include "tests/kinematics/planar/random_linkages.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/loads/frame_oracle.hpp"

namespace kempe::test {
namespace {

/// A linkage at an opening, as the library and as the frame sees it.
struct LoadedCase {
  Complex k;
  Grounding grounding;
  BarLengths lengths;
  LinkStyle style;
  Material material;
  double opening, hole;
  PinCompliance pins;
};

/// The plates' shape, from the definition of each grounding: pen - pole = k (tracer - pole).
Complex plate_shape(Complex k, Grounding grounding) {
  if (grounding == Grounding::pole) return k;
  return grounding == Grounding::tracer ? 1.0 - k : 1.0 - 1.0 / k;
}

LoadedCase random_frame_case(Random& random) {
  LoadedCase one;
  const int kind = random.below(3);
  const double rotation = kind == 0 ? 0 : kind == 1 ? pi : random.uniform(-pi, pi);
  do
    one.k = (kind == 1 ? -1.0 : 1.0) * random.logarithmic(0.05, 20) *
            (kind == 2 ? std::polar(1.0, rotation) : 1.0);
  while (std::abs(one.k - 1.0) < 0.02);
  one.grounding = static_cast<Grounding>(random.below(3));
  one.lengths = {random.logarithmic(20, 800), random.logarithmic(20, 800)};
  one.style = {.width = random.uniform(4, 40), .pin_diameter = 3, .thickness = random.uniform(1, 12)};
  one.material = {"some", random.logarithmic(1000, 300000), 1000, 100};
  one.opening = random.uniform(-pi, pi);
  one.hole = random.uniform(0, 0.8) * one.style.width;
  if (random.below(2))
    one.pins = {random.logarithmic(1e-6, 1e-2), random.logarithmic(1e-6, 1e-2),
                random.logarithmic(1e-6, 1e-2), random.logarithmic(1e-6, 1e-2),
                random.logarithmic(1e-6, 1e-2)};
  return one;
}

FrameTask frame_task_of(const LoadedCase& one) {
  const Complex s = plate_shape(one.k, one.grounding), p = one.lengths.VA,
                q = std::polar(one.lengths.VB, one.opening);
  FrameTask task;
  task.joints = {Point(0, 0),     as_point(p),         as_point(q),
                 as_point(p + q), as_point(p + q / s), as_point(q + s * p)};
  if (one.grounding == Grounding::pole) task.pole = joint_V, task.tracer = joint_X, task.pen = joint_Y;
  if (one.grounding == Grounding::pen) task.pole = joint_X, task.tracer = joint_Y, task.pen = joint_V;
  task.width = one.style.width;
  task.thickness = one.style.thickness;
  task.young = one.material.E;
  task.straight_ACX = task.straight_BCY = one.k.imag() == 0;
  task.pin_compliance = {one.pins.V, one.pins.A, one.pins.B, one.pins.C};
  task.pole_compliance = one.pins.pole;
  return task;
}

/// How far the frame's forces from outside are from balance: each other, and about the pole.
double imbalance_of(const FrameAnswer& frame, const FrameTask& task) {
  const Point hand = task.joints[task.tracer] - task.joints[task.pole],
              pen = task.joints[task.pen] - task.joints[task.pole];
  double most = (frame.hand + frame.pole + Eigen::Matrix2d::Identity()).norm() / (1 + frame.hand.norm());
  for (const int axis : {0, 1})
    most = std::max(most, std::abs(cross(hand, frame.hand.col(axis)) + cross(pen, Point::Unit(axis))) /
                              (pen.norm() + hand.norm() * frame.hand.norm()));
  return most;
}

double most_of(const Eigen::Matrix2d& force) { return force.jacobiSvd().singularValues()[0]; }

/// Stress at the middle of a plate, from its two pieces: bending and pull of each, worst over the directions of the force.
double stress_of(const FrameAnswer& answer, std::size_t first, const LoadedCase& one) {
  const double w = one.style.width, t = one.style.thickness, h = one.hole;
  const double bend = 6 * w / (t * (w * w * w - h * h * h)), pull = 1 / (t * (w - h));
  const FrameAnswer::Beam &a = answer.beams[first], &b = answer.beams[first + 1];
  const FrameJoint middle = a.to == b.from ? a.to : a.from;
  double most = 0;
  for (const FrameAnswer::Beam* beam : {&a, &b}) {
    const Eigen::RowVector2d moment = bend * beam->moments.row(beam->from == middle ? 0 : 1);
    most = std::max({most, (moment + pull * beam->pull).norm(), (moment - pull * beam->pull).norm()});
  }
  return most;
}

TEST(LoadsInThePlane, AreThoseOfAFrame) {
  Random random(71);
  double apart = 0;
  int lost = 0;
  const auto expect_alike = [&](double one, double other, double scale, const char* what) {
    apart = std::max(apart, std::abs(one - other) / scale);
    EXPECT_NEAR(one, other, 1e-6 * scale) << what;
  };
  for (int i = 0; i < samples(3000); ++i) {
    const LoadedCase one = random_frame_case(random);
    // Towards the change points all forces grow without bound; at the end of its reach the frame is a mechanism inside.
    const double from_reach = one.opening - std::arg(plate_shape(one.k, one.grounding));
    if (std::min(std::abs(std::sin(one.opening)), std::abs(std::sin(from_reach))) < 0.02) continue;
    const FrameAnswer frame = solve_frame(frame_task_of(one));
    if (imbalance_of(frame, frame_task_of(one)) >
        1e-8) {  // the frame's own rounding: arms of 1:100, slender as a wire
      ++lost;
      continue;
    }
    const LoadErrorAt error = LoadErrorProfile(one.k, one.grounding, one.style, one.material, 1, one.pins)
                                  .at(one.lengths, one.opening);
    const Eigen::Vector2d stretch =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(frame.compliance).eigenvalues();
    expect_alike(error.worst, stretch[1], stretch[1], "worst");
    expect_alike(error.least, stretch[0], stretch[1], "least");
    const PinForces pins = pin_forces(one.k, one.grounding, one.opening);
    expect_alike(pins.A, most_of(frame.pins[0]), pins.A, "A");
    expect_alike(pins.B, most_of(frame.pins[1]), pins.B, "B");
    expect_alike(pins.C, most_of(frame.pins[2]), pins.C, "C");
    expect_alike(pins.V, frame.beams[1].pull.norm(), pins.V, "V");
    expect_alike(pins.pole, most_of(frame.pole), pins.pole, "pole");
    expect_alike(hand_force(one.k), most_of(frame.hand), hand_force(one.k), "hand");
    const LinkStresses stress =
        link_stresses(one.k, one.grounding, one.style, one.hole, one.lengths, one.opening);
    const double net = one.style.thickness * (one.style.width - one.hole);
    expect_alike(stress.VA, frame.beams[0].pull.norm() / net, stress.VA, "stress of VA");
    expect_alike(stress.VB, frame.beams[1].pull.norm() / net, stress.VB, "stress of VB");
    expect_alike(stress.ACX, stress_of(frame, 2, one), stress.ACX, "stress of ACX");
    expect_alike(stress.BCY, stress_of(frame, 4, one), stress.BCY, "stress of BCY");
    if (HasFailure())
      FAIL() << "k " << one.k << " grounding " << static_cast<int>(one.grounding) << " opening "
             << one.opening << " VA " << one.lengths.VA << " VB " << one.lengths.VB;
  }
  EXPECT_LT(lost, 1 + samples(3000) / 100);
  RecordProperty("apart_in_billionths", static_cast<int>(1e9 * apart));
}

}  // namespace
}  // namespace kempe::test
