// The frame oracle against beams known by formula, and against golden values found by two other frames.
#include "tests/synthesis/loads/frame_oracle.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <complex>

namespace kempe::test {
namespace {

/// The joints at an opening: V at the origin, VA along x, the plates similar to the triangle (0, 1, s).
std::array<Point, 6> joints_at(double VA, double VB, double opening, Complex s) {
  const Complex p = VA, q = std::polar(VB, opening);
  return {Point(0, 0), as_point(p), as_point(q), as_point(p + q), as_point(p + q / s), as_point(q + s * p)};
}

double worst(const Eigen::Matrix2d& matrix) { return matrix.jacobiSvd().singularValues()[0]; }

struct Golden {
  Complex k;
  char holds;  ///< what stands at V: p(ole), t(racer), e (pen)
  double VA, VB, width, thickness, load, opening, most, least, pin;
};

FrameTask task_of(const Golden& golden) {
  FrameTask task;
  const Complex s = golden.holds == 'p'   ? golden.k
                    : golden.holds == 't' ? 1.0 - golden.k
                                          : 1.0 - 1.0 / golden.k;
  task.joints = joints_at(golden.VA, golden.VB, radians(golden.opening), s);
  if (golden.holds == 'p') task.pole = joint_V, task.tracer = joint_X, task.pen = joint_Y;
  if (golden.holds == 't') task.pole = joint_X, task.tracer = joint_V, task.pen = joint_Y;
  if (golden.holds == 'e') task.pole = joint_X, task.tracer = joint_Y, task.pen = joint_V;
  task.width = golden.width;
  task.thickness = golden.thickness;
  task.straight_ACX = task.straight_BCY = golden.k.imag() == 0;
  return task;
}

TEST(FrameOracle, GivesTheGoldenValues) {
  const Complex turned(0, 1.4);
  const Golden rows[] = {{turned, 't', 56.786, 25.807, 6, 2, 10, -150, 0.68835, 0.01443, 2.8},
                         {turned, 't', 56.786, 25.807, 6, 2, 10, -120, 0.68675, 0.01132, 1.6166},
                         {turned, 't', 56.786, 25.807, 6, 2, 10, -84.462, 0.69285, 0.00413, 1.4066},
                         {turned, 'p', 50, 35, 6, 2, 10, 100, 0.30665, 0.00188, 1.7470},
                         {turned, 'p', 50, 35, 6, 2, 10, 135, 0.29452, 0.01686, 2.4331},
                         {turned, 'p', 50, 35, 6, 2, 10, 170, 0.33344, 0.04791, 9.9078},
                         {0.4, 'e', 91.784, 76.542, 15, 5, 10, -150, 0.010115, 0.000391, 2},
                         {0.4, 'e', 91.784, 76.542, 15, 5, 10, -30, 0.010115, 0.000391, 2},
                         {0.4, 'e', 91.784, 76.542, 15, 5, 10, -90, 0.008329, 0.001503, 1},
                         {0.4, 't', 225, 135, 15, 5, 50, 40, 0.069455, 0.009450, 0.6223},
                         {0.4, 't', 225, 135, 15, 5, 50, 90, 0.039300, 0.039060, 0.4},
                         {0.4, 't', 225, 135, 15, 5, 50, 150, 0.073937, 0.005575, 0.8}};
  for (const Golden& golden : rows) {
    const FrameAnswer answer = solve_frame(task_of(golden));
    const double digit = golden.width == 6 ? 0.6e-5 : 0.6e-6;
    const Eigen::Vector2d stretch =
        golden.load * Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(answer.compliance).eigenvalues();
    EXPECT_NEAR(stretch[1], golden.most, digit) << golden.opening;
    EXPECT_NEAR(stretch[0], golden.least, digit) << golden.opening;
    EXPECT_NEAR(std::max(worst(answer.pins[0]), worst(answer.pins[1])), golden.pin, 0.6e-4) << golden.opening;
  }
}

TEST(FrameOracle, BalancesTheWholeLinkage) {
  FrameTask task;
  task.joints = joints_at(50, 35, 2, Complex(0.3, 0.9));
  task.pin_compliance = {1e-4, 2e-4, 3e-4, 4e-4};
  task.pole_compliance = 5e-4;
  const FrameAnswer answer = solve_frame(task);
  EXPECT_LT((answer.hand + answer.pole + Eigen::Matrix2d::Identity()).norm(), 1e-9);
  EXPECT_LT((answer.compliance - answer.compliance.transpose()).norm(), 1e-12);
}

TEST(FrameOracle, BendsThePensArmByForceTimesLever) {
  FrameTask task;
  task.joints = joints_at(80, 60, radians(90), Complex(-0.5, 0));
  task.pole = joint_X, task.tracer = joint_V, task.pen = joint_Y;
  task.straight_ACX = task.straight_BCY = true;
  const FrameAnswer answer = solve_frame(task);
  for (const FrameAnswer::Beam& beam : answer.beams) {
    if (beam.from != joint_Y && beam.to != joint_Y) continue;
    // The pen's force alone bends the arm to Y: its largest moment is at the other end.
    const FrameJoint other = beam.from == joint_Y ? beam.to : beam.from;
    const Point arm = task.joints[joint_Y] - task.joints[other];
    const Eigen::RowVector2d moment(-arm.y(), arm.x());  // of (1, 0) and (0, 1)
    const int end = beam.from == joint_Y ? 1 : 0;
    EXPECT_LT((beam.moments.row(end) + moment).norm(), 1e-8);
    EXPECT_LT(beam.moments.row(1 - end).norm(), 1e-8);
  }
}

TEST(FrameOracle, AddsWhatEveryPinGives) {
  // A pin's compliance adds c f^2 for the force f in it, exactly: a frame that is statically determined.
  FrameTask task;
  task.joints = joints_at(50, 35, 2, Complex(0.3, 0.9));
  const FrameAnswer stiff = solve_frame(task);
  const int pin_of[] = {joint_A, joint_B, joint_C};
  for (std::size_t i = 0; i < 3; ++i) {
    FrameTask soft = task;
    soft.pin_compliance[static_cast<std::size_t>(pin_of[i])] = 0.01;
    const FrameAnswer answer = solve_frame(soft);
    const Eigen::Matrix2d added = 0.01 * stiff.pins[i].transpose() * stiff.pins[i];
    EXPECT_LT((answer.compliance - stiff.compliance - added).norm(), 1e-9 * added.norm() + 1e-12);
  }
}

TEST(FrameOracle, RefusesADeadPoint) {
  FrameTask task;
  task.joints = joints_at(50, 35, 0, Complex(0, 1));
  EXPECT_THROW(static_cast<void>(solve_frame(task)), std::runtime_error);
}

}  // namespace
}  // namespace kempe::test
