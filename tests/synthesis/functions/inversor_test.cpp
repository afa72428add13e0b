// The inversors rebuilt from their lengths by intersecting circles and lines: no formula of the library is
// used.
#include "synthesis/functions/inversor.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kempe {
namespace {

/// Where circles about a and b meet, on the left of a -> b.
Point meeting(const Point& a, double ra, const Point& b, double rb) {
  const Point along = b - a;
  const double d = along.norm(), t = (ra * ra - rb * rb + d * d) / (2 * d);
  const double h = std::sqrt(std::max(0.0, ra * ra - t * t));
  return a + along / d * t + Point(-along.y(), along.x()) / d * h;
}

InversorTask lens(double lower, double upper, double transmission_deg = 12) {
  InversorTask task;
  task.focal_length = 150;
  task.magnification_lower = lower;
  task.magnification_upper = upper;
  task.transmission = radians(transmission_deg);
  return task;
}

void expect_lens_equation(double f, double x, double image) {
  EXPECT_NEAR(x * image, f * f, 1e-9 * f * f);
  EXPECT_NEAR(1 / (x + f) + 1 / (image + f), 1 / f, 1e-12);
}

TEST(Inversor, PeaucellierKeepsTheLensEquation) {
  const InversorTask task = lens(1.3, 2.5, 8);
  const auto answer = design_inversor(InversorKind::peaucellier, task);
  ASSERT_TRUE(answer.design) << answer.why_not;
  const double L = answer.design->lengths[0].value, l = answer.design->lengths[1].value;
  for (double m = 1.3; m <= 2.5; m += 0.05) {
    const double x = 150 / m;
    const Point corner = meeting({0, 0}, L, {x, 0}, l);
    // The other end of the rhombus: the mirror image of P at the line through the corners (x, y) and (x, -y).
    const double image = 2 * corner.x() - x;
    EXPECT_NEAR((Point(image, 0) - corner).norm(), l, 1e-9);
    expect_lens_equation(150, x, image);
  }
}

TEST(Inversor, HartKeepsTheLensEquationThroughMagnificationOne) {
  const InversorTask task = lens(0.5, 2);
  const auto answer = design_inversor(InversorKind::hart, task);
  ASSERT_TRUE(answer.design) << answer.why_not;
  const double a = answer.design->lengths[0].value, b = answer.design->lengths[1].value,
               u = answer.design->point_share;
  for (double m = 0.5; m <= 2; m += 0.05) {
    const double x = 150 / m;
    const double BD = x / u;
    const Point A(0, 0);
    // Triangle A B D: AB = a, AD = b, BD = x/u, with BD horizontal.
    const double along = (a * a - b * b + BD * BD) / (2 * BD);  // from B back to the foot of A
    const double height = std::sqrt(a * a - along * along);
    const Point B(along, height), D(along - BD, height);
    EXPECT_NEAR((D - A).norm(), b, 1e-9);
    // C closes with CB = b, CD = a, on A's side.
    const Point C =
        meeting(B, b, D, a).y() < meeting(D, a, B, b).y() ? meeting(B, b, D, a) : meeting(D, a, B, b);
    const Point O = A + u * (B - A), P = A + u * (D - A), Q = C + u * (B - C);
    EXPECT_NEAR(cross(P - O, Q - O), 0, 1e-6);
    EXPECT_LT((P - O).dot(Q - O), 0);
    EXPECT_NEAR((P - O).norm(), x, 1e-9);
    expect_lens_equation(150, x, (Q - O).norm());
  }
}

TEST(Inversor, RightAngleKeepsTheLensEquation) {
  const InversorTask task = lens(0.5, 2);
  const auto answer = design_inversor(InversorKind::right_angle, task);
  ASSERT_TRUE(answer.design) << answer.why_not;
  const double f = answer.design->lengths[0].value;
  for (double m = 0.5; m <= 2; m += 0.05) {
    const Point pivot(0, f), object(-150 / m, 0);
    const Point arm = object - pivot, other(-arm.y(), arm.x());  // a quarter turn further
    const double image = pivot.x() + other.x() * (-pivot.y() / other.y());
    expect_lens_equation(150, 150 / m, image);
  }
}

TEST(Inversor, KeepsItsTransmissionLimitAndIsTheSmallestThatDoes) {
  for (const double limit : {3.0, 5.0, 8.0}) {
    for (const InversorKind kind : {InversorKind::peaucellier, InversorKind::hart}) {
      const auto answer = design_inversor(kind, lens(1.4, 2.5, limit));
      ASSERT_TRUE(answer.design) << name(kind) << ": " << answer.why_not;
      EXPECT_GE(answer.design->transmission_min, radians(limit) - 1e-9);
      EXPECT_LE(answer.design->transmission_min, radians(limit) + 0.2);
    }
  }
}

TEST(Inversor, NoSmallerLengthsOnAFineGridKeepTheLimit) {
  const InversorTask task = lens(1.3, 2.5, 8);
  const auto keeps = [&](const auto& transmission) {
    for (int i = 0; i <= 50; ++i)
      if (transmission(1.3 * std::pow(2.5 / 1.3, i / 50.0)) < task.transmission) return false;
    return true;
  };
  const double peaucellier_size = design_inversor(InversorKind::peaucellier, task).design->size;
  for (double side = 40; side < 2000; side *= 1.003) {
    const double size = 4 * side + 2 * std::hypot(150, side);
    if (size >= peaucellier_size * (1 - 1e-6)) continue;
    EXPECT_FALSE(keeps([&](double m) { return peaucellier_transmission(150, side, m); })) << side;
  }
  const double hart_size = design_inversor(InversorKind::hart, task).design->size;
  for (double share = 0.02; share < 0.99; share += 0.01)
    for (double bar = 20; bar < 1000; bar *= 1.01) {
      const double size = 2 * bar + 2 * std::sqrt(150 * 150 / (share * (1 - share)) + bar * bar);
      if (size >= hart_size * (1 - 1e-4)) continue;
      EXPECT_FALSE(keeps([&](double m) { return hart_transmission(150, bar, share, m); }))
          << share << " " << bar;
    }
}

TEST(Inversor, TheBestIsTheSmallestOfThoseThatExist) {
  const auto answers = design_inversors(lens(1.3, 2.5, 8));
  double least = 1e300;
  for (const InversorAnswer& answer : answers) {
    ASSERT_TRUE(answer.design) << answer.why_not;
    EXPECT_NEAR(answer.design->travel_object, 150 / 1.3 - 150 / 2.5, 1e-9);
    EXPECT_NEAR(answer.design->travel_image, 150 * (2.5 - 1.3), 1e-9);
    double sum = 0;
    for (const InversorLength& length : answer.design->lengths) sum += length.count * length.value;
    EXPECT_NEAR(answer.design->size, sum, 1e-9);
    least = std::min(least, sum);
  }
  EXPECT_EQ(smallest(answers)->size, least);
  EXPECT_FALSE(smallest(design_inversors(lens(0.1, 10, 40))));
}

TEST(Inversor, SizeGrowsWithTheLimit) {
  double before = 0;
  for (const double limit : {2.0, 6.0, 10.0, 14.0}) {
    const auto best = design_inversor(InversorKind::hart, lens(0.5, 2, limit)).design;
    ASSERT_TRUE(best);
    EXPECT_GE(best->size, before * (1 - 1e-6));
    before = best->size;
  }
}

TEST(Inversor, SaysWhyThereIsNone) {
  EXPECT_NE(design_inversor(InversorKind::peaucellier, lens(0.5, 2)).why_not.find("on one side of 1"),
            std::string::npos);
  EXPECT_NE(design_inversor(InversorKind::right_angle, lens(0.1, 10, 30)).why_not.find("degrees"),
            std::string::npos);
  EXPECT_NE(design_inversor(InversorKind::hart, lens(0.01, 100, 60)).why_not.find("transmission"),
            std::string::npos);
}

TEST(Inversor, SensitivityIsTheLimitOfDifferences) {
  const auto design = *design_inversor(InversorKind::peaucellier, lens(1.3, 2.5, 8)).design;
  const double L = design.lengths[0].value, l = design.lengths[1].value, x = 150 / 2.5, h = 1e-4;
  const auto image = [&](double arm, double side) { return 2 * meeting({0, 0}, arm, {x, 0}, side).x() - x; };
  EXPECT_NEAR(design.lengths[0].sensitivity, (image(L + h, l) - image(L - h, l)) / (2 * h), 1e-5);
  EXPECT_NEAR(design.lengths[1].sensitivity, -(image(L, l + h) - image(L, l - h)) / (2 * h), 1e-5);
}

}  // namespace
}  // namespace kempe
