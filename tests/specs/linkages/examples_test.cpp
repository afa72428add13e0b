// The shipped linkages with their published figures (sources.md), each against an oracle of its own: circle
// intersections and closed forms that share nothing with the solver.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "kinematics/planar/reactions.hpp"
#include "tests/specs/linkages/example.hpp"

namespace kempe {
namespace {

TEST(LinkageExamples, ShearPressGivesTheSourcesNineRows) {
  const Example press("shear-press");
  ASSERT_FALSE(press.run.stop);
  ASSERT_EQ(press.run.frames.size(), 9u);
  const double printed[9][6] = {// xP yP xB yB xC yC, as Lot printed them
                                {.415, .500, .062, .222, .270, -.120}, {.444, .475, .075, .218, .270, -.131},
                                {.469, .450, .086, .213, .270, -.142}, {.492, .425, .097, .208, .270, -.152},
                                {.512, .400, .108, .203, .270, -.162}, {.531, .375, .117, .198, .270, -.172},
                                {.548, .350, .126, .192, .270, -.181}, {.563, .325, .135, .186, .270, -.190},
                                {.577, .300, .143, .180, .270, -.199}};
  for (std::size_t i = 0; i < 9; ++i) {
    const RunFrame& frame = press.run.frames[i];
    const Point P = press.at(frame, "P"), B = press.at(frame, "B"), C = press.at(frame, "C");
    const double figures[6] = {P.x(), P.y(), B.x(), B.y(), C.x(), C.y()};
    for (int column = 0; column < 6; ++column)
      EXPECT_EQ(std::lround(1000 * figures[column]), std::lround(1000 * printed[i][column]))
          << i << " " << column;
    const double yP = 0.5 - 0.025 * static_cast<double>(i);
    const Point exact_P(std::sqrt(0.65 * 0.65 - yP * yP), yP);
    const Point exact_B = meet(Point(0, 0), 0.23, exact_P, 0.45, 1);
    const Point exact_C(0.27, exact_B.y() - std::sqrt(0.16 - std::pow(0.27 - exact_B.x(), 2)));
    expect_near(P, exact_P, 1e-9, "P");
    expect_near(B, exact_B, 1e-9, "B");
    expect_near(C, exact_C, 1e-9, "C");
  }
  expect_near(press.at(press.run.frames[4], "P"), Point(0.512348, 0.4), 1e-6, "sources.md, row 5");
  expect_near(press.at(press.run.frames[8], "B"), Point(0.142851, 0.180259), 1e-6, "sources.md, row 9");
  EXPECT_EQ(press.mobility().mobility, 1);
}

TEST(LinkageExamples, PantographGivesTheMatlabRows) {
  Example pantograph("pantograph");
  auto& path = std::get<DriverPath>(pantograph.model.schedule.motions[0]);
  path = DriverPath({PathPiece::arc(Point(50, 50), 10, 0, 0.3)},
                    path.speed);  // the source steps its angle by 0.1
  pantograph.rerun(3);
  const struct {
    std::size_t row;
    Point A, B, C, D, E;
  } rows[] = {
      {0, {2.05128275, 5.6384607}, {3.07692412, 8.45769105}, {7.02564137, 7.81923035}, {6, 5}, {9, 7.5}},
      {1,
       {2.0323711, 5.64530493},
       {3.04855665, 8.46795739},
       {7.01118971, 7.92248588},
       {5.99500417, 5.09983342},
       {8.99250625, 7.64975012}},
      {3,
       {1.97257465, 5.66647591},
       {2.95886198, 8.49971387},
       {6.94162381, 8.12875816},
       {5.95533649, 5.29552021},
       {8.93300473, 7.94328031}}};
  for (const auto& row : rows) {
    const RunFrame& frame = pantograph.run.frames[row.row];
    expect_near(pantograph.at(frame, "A"), row.A, 2e-8, "A");
    expect_near(pantograph.at(frame, "B"), row.B, 2e-8, "B");
    expect_near(pantograph.at(frame, "C"), row.C, 2e-8, "C");
    expect_near(pantograph.at(frame, "D"), row.D, 2e-8, "D");
    expect_near(pantograph.at(frame, "E"), row.E, 2e-8, "E");
  }
  const Example around("pantograph");
  for (const RunFrame& frame : around.run.frames)
    expect_near(around.at(frame, "E"), 1.5 * around.at(frame, "D"), 1e-12, "E = 1.5 D");
  EXPECT_EQ(around.mobility().mobility, 2);
}

TEST(LinkageExamples, PlagiographCopiesPlacesVelocitiesAndAccelerations) {
  Example plagiograph("plagiograph");
  const Complex k(0, 1.4);
  for (const RunFrame& frame : plagiograph.run.frames) {
    EXPECT_LT(std::abs(plagiograph.z(frame, "Y") - k * plagiograph.z(frame, "X")), 1e-12);
    EXPECT_LT(std::abs(plagiograph.velocity(frame, "Y") - k * plagiograph.velocity(frame, "X")), 1e-11);
    EXPECT_LT(std::abs(plagiograph.acceleration(frame, "Y") - k * plagiograph.acceleration(frame, "X")),
              1e-9);
  }
  plagiograph.model.schedule.motions[0] = DriverPath({PathPiece::line(Point(70, 10), Point(65, 10))});
  plagiograph.rerun(1);
  const RunFrame& first = plagiograph.run.frames[0];
  expect_near(plagiograph.at(first, "A"), Point(4.64714054, 1.8450162), 1e-7, "A");
  expect_near(plagiograph.at(first, "C"), Point(5.83016322, 5.13901944), 1e-7, "C");
  expect_near(plagiograph.at(first, "B"), Point(1.18302268, 3.29400324), 1e-7, "B");
  expect_near(plagiograph.at(first, "Y"), Point(-1.4, 9.8), 1e-7, "Y");
  EXPECT_EQ(plagiograph.mobility().mobility, 2);
}

TEST(LinkageExamples, SixBarPlagiographCopiesTheCouplerCurveOverTheWholeTurn) {
  const Example six("six-bar-plagiograph", 720);
  ASSERT_FALSE(six.run.stop);
  const Complex k(0, 1.4);
  double extent = 0;
  for (const RunFrame& frame : six.run.frames) {
    EXPECT_LT(std::abs(six.z(frame, "Y") - k * six.z(frame, "X")), 1e-9);
    extent = std::max(extent, std::abs(six.z(frame, "X") - six.z(six.run.frames[0], "X")));
    const Point E = Point(60, -20) + on_circle(20, 2 * pi * frame.share), A = meet(Point(0, 0), 50, E, 60, 1);
    expect_near(six.at(frame, "A"), A, 1e-10, "A, always on the same side of O-E");
  }
  EXPECT_GT(extent, 25);  // a curve worth copying
  EXPECT_TRUE(
      same_assembly_mode(six.model.linkage, six.run.frames.front().position, six.run.frames.back().position));
  const Mobility mobility = six.mobility();
  EXPECT_EQ(mobility.links, 6);
  EXPECT_EQ(mobility.full_joints, 7);
  EXPECT_EQ(mobility.gruebler, 1);
  EXPECT_EQ(mobility.mobility, 1);
}

TEST(LinkageExamples, PeaucellierLipkinDrawsAStraightLine) {
  const Example inversor("peaucellier-lipkin");
  ASSERT_FALSE(inversor.run.stop);
  for (const RunFrame& frame : inversor.run.frames) {
    EXPECT_NEAR(inversor.at(frame, "Q").x(), 72, 1e-11);
    EXPECT_NEAR(inversor.at(frame, "P").norm() * inversor.at(frame, "Q").norm(), 3600, 1e-9);
    EXPECT_NEAR(cross(inversor.at(frame, "P"), inversor.at(frame, "Q")), 0, 1e-9);
  }
  EXPECT_EQ(inversor.mobility().mobility, 1);
}

/// x x' = f^2 and 1/p + 1/q = 1/f with p = x + f, q = x' + f, over a range of magnifications; the rack
/// follows the pinion.
void expect_autofocus(const Example& inversor, const char* object, const char* image, double f, double middle,
                      double radius) {
  ASSERT_FALSE(inversor.run.stop);
  double least = 1e300, most = 0;
  for (const RunFrame& frame : inversor.run.frames) {
    const Point P = inversor.at(frame, object), Q = inversor.at(frame, image);
    EXPECT_NEAR(P.y(), 0, 1e-11);
    EXPECT_NEAR(Q.y(), 0, 1e-11);
    const double x = std::abs(P.x()), x_image = std::abs(Q.x()), p = x + f, q = x_image + f;
    EXPECT_NEAR(x * x_image, f * f, 1e-9 * f * f);
    EXPECT_NEAR(1 / p + 1 / q, 1 / f, 1e-12 / f);
    EXPECT_NEAR(P.x(), middle - radius * frame.values[0], 1e-11);
    least = std::min(least, q / p);
    most = std::max(most, q / p);
  }
  EXPECT_GT(most / least, 1.3);
  EXPECT_EQ(inversor.mobility().mobility, 1);
}

TEST(LinkageExamples, InversorsDrivenByRackAndPinionObeyTheLensEquation) {
  expect_autofocus(Example("peaucellier-focus"), "P", "Q", 60, 50, 8);
  expect_autofocus(Example("hart"), "P", "Q", std::sqrt(1575), 25, 6);
  expect_autofocus(Example("right-angle-inversor"), "X", "Image", 50, 60, 10);
  const Example right_angle("right-angle-inversor");
  for (const RunFrame& frame : right_angle.run.frames)
    EXPECT_LT(right_angle.at(frame, "X").x() * right_angle.at(frame, "Image").x(),
              0);  // on both sides of the foot
}

TEST(LinkageExamples, SliderCrankFollowsItsFormulas) {
  const Example engine("slider-crank");
  const double r = 30, l = 100, e = 10, w = 2 * pi / 0.04;
  for (const RunFrame& frame : engine.run.frames) {
    const double t = 2 * pi * frame.share, h = e - r * std::sin(t), c = std::sqrt(l * l - h * h);
    const double h1 = -r * std::cos(t) * w, h2 = r * std::sin(t) * w * w;
    const double c1 = -h * h1 / c, c2 = -(h1 * h1 + h * h2 + c1 * c1) / c;
    EXPECT_NEAR(engine.at(frame, "B").x(), r * std::cos(t) + c, 1e-11);
    EXPECT_NEAR(engine.velocity(frame, "B").real(), -r * std::sin(t) * w + c1, 1e-8);
    EXPECT_NEAR(engine.acceleration(frame, "B").real(), -r * std::cos(t) * w * w + c2, 1e-5);
  }
  EXPECT_EQ(engine.mobility().links, 4);
  EXPECT_EQ(engine.mobility().mobility, 1);
}

/// The four-bar that both six-bars contain.
struct CrankRocker {
  Point A, B;
  explicit CrankRocker(double crank) : A(on_circle(25, crank)), B(meet(A, 75, Point(80, 0), 60, 1)) {}
};

TEST(LinkageExamples, WattAndStephensonSixBarsCloseBothLoopsOnOneSide) {
  const Example watt("watt-six-bar", 360), stephenson("stephenson-six-bar", 360);
  ASSERT_FALSE(watt.run.stop);
  ASSERT_FALSE(stephenson.run.stop);
  for (std::size_t i = 0; i < watt.run.frames.size(); ++i) {
    const CrankRocker bars(2 * pi * watt.run.frames[i].share);
    const Point E = meet(bars.A, 60, bars.B, 50, 1), F = meet(Point(80, 0), 75, bars.B, 45, -1);
    expect_near(watt.at(watt.run.frames[i], "B"), bars.B, 1e-10, "B");
    expect_near(watt.at(watt.run.frames[i], "G"), meet(E, 60, F, 60, 1), 1e-9, "Watt's G");
    const Point E2 = meet(bars.A, 80, bars.B, 50, 1);
    expect_near(stephenson.at(stephenson.run.frames[i], "G"), meet(E2, 90, Point(150, 40), 80, 1), 1e-9,
                "Stephenson's G");
  }
  EXPECT_EQ(watt.mobility().mobility, 1);
  EXPECT_EQ(stephenson.mobility().mobility, 1);
}

TEST(LinkageExamples, ChebyshevLineHasItsKnownDeviation) {
  const Example line("chebyshev", 2000);
  ASSERT_FALSE(line.run.stop);
  expect_near(line.at(line.run.frames.front(), "P"), Point(0, 4), 1e-12, "left end");
  expect_near(line.at(line.run.frames[1000], "P"), Point(2, 4), 1e-12, "middle");
  expect_near(line.at(line.run.frames.back(), "P"), Point(4, 4), 1e-12, "right end");
  double above = 0, below = 0;
  for (const RunFrame& frame : line.run.frames) {
    above = std::max(above, line.at(frame, "P").y() - 4);
    below = std::min(below, line.at(frame, "P").y() - 4);
  }
  // By the oracle: for each direction e of the coupler, P - e and P + e lie on the cranks' circles.
  double known_above = 0, known_below = 0;
  for (int i = 0; i <= 20000; ++i) {
    const Point e = on_circle(1, -pi / 2 - pi * i / 20000);
    const double y = meet(e, 5, Point(4, 0) - e, 5, 1).y() - 4;
    known_above = std::max(known_above, y);
    known_below = std::min(known_below, y);
  }
  EXPECT_NEAR(above, known_above, 1e-7);
  EXPECT_NEAR(below, known_below, 1e-7);
  EXPECT_NEAR(above, 0.0097537, 1e-6);  // 0.24 per cent of the stroke of 4
}

TEST(LinkageExamples, GearedFiveBarKeepsItsRatio) {
  const Example gears("geared-five-bar");
  for (const RunFrame& frame : gears.run.frames) {
    const double first = 2 * pi * frame.share;
    const Point A = on_circle(25, first), B = Point(90, 0) + on_circle(20, pi / 2 - 2 * first);
    expect_near(gears.at(frame, "P"), meet(A, 80, B, 80, 1), 1e-10, "P");
  }
  EXPECT_EQ(gears.mobility().mobility, 1);
}

TEST(LinkageExamples, PantographOfDistancesIsUnderstood) {
  const Example distances("pantograph-by-distances"), links("pantograph");
  EXPECT_EQ(distances.file.notes.size(), 2u);
  EXPECT_EQ(distances.mobility().mobility, 2);
  EXPECT_EQ(distances.mobility().shaky_freedoms(), 0);
  for (std::size_t i = 0; i < links.run.frames.size(); ++i)
    for (const char* point : {"A", "B", "C", "D", "E"})
      expect_near(distances.at(distances.run.frames[i], point), links.at(links.run.frames[i], point), 1e-12,
                  point);
}

/// The reactions at a moment, one for each constraint; those of the loads alone, without masses, if wanted.
std::vector<Reaction> reactions_in(const Example& example, const RunFrame& frame, bool masses) {
  PlanarLoads loads = example.model.loads;
  if (!masses) loads.masses.clear();
  ReactionSolver solver(example.model.linkage);
  return solver
      .at(frame.position, frame.values,
          inertia_forces(loads, frame.position, frame.rate, frame.second) -
              applied_forces(loads, frame.position))
      .value();
}

TEST(LinkageExamples, ShearPressAtWorkBalancesItsLeverByHand) {
  // Without masses the rod bears along itself alone, and the lever's moments about A vanish.
  const Example press("shear-press-forces");
  for (const RunFrame& frame : press.run.frames) {
    const Point B = press.at(frame, "B"), C = press.at(frame, "C"), P = press.at(frame, "P");
    const Point in_rod = 2000 / (C - B).y() * (C - B);  // what the blade's 2000 N push into it
    const double hand = -cross(B, in_rod) / P.x();
    const std::vector<Reaction> reactions = reactions_in(press, frame, false);
    ASSERT_EQ(reactions.size(), 4u);  // A, B, C, the hand
    expect_near(reactions[1].force, -in_rod, 1e-9, "B, on the rod");
    expect_near(reactions[0].force, -in_rod - Point(0, hand), 1e-9, "A, on the lever");
    EXPECT_NEAR(reactions[2].force.x(), in_rod.x(), 1e-9);
    EXPECT_NEAR(reactions[3].along, hand, 1e-9);
  }
}

TEST(LinkageExamples, ShearPressTakesTheWorkThatItsHandGives) {
  const Example press("shear-press-forces", 512);
  const auto energy = [&](const RunFrame& frame) {  // J
    double sum = 0;
    for (const BodyMass& mass : press.model.loads.masses) {
      const BodyPoint centre{mass.body, mass.centre};
      sum += 0.5e-6 * (mass.kg * velocity_of(frame.position, frame.rate, centre).squaredNorm() +
                       mass.inertia * std::pow(spin_of(frame.rate, mass.body), 2)) +
             9.81e-3 * mass.kg * place(frame.position, centre).y();
    }
    return sum - 2000 * press.at(frame, "C").y();
  };
  double work = 0;  // of the hand, by Simpson's rule
  for (std::size_t i = 0; i <= 512; ++i)
    work += (i == 0 || i == 512 ? 1
             : i % 2            ? 4
                                : 2) *
            reactions_in(press, press.run.frames[i], true)[3].along * (-0.2 / 512 / 3);
  EXPECT_NEAR(work, energy(press.run.frames[512]) - energy(press.run.frames[0]), 1e-7);
  EXPECT_GT(work, 140);
}

// W. F. Riley and L. D. Sturges, Engineering Mechanics: Statics, 2nd edition, problem 7-87, with the figures of their solution.
TEST(LinkageExamples, TogglePressBearsThePrintedForces) {
  const Example press("toggle-press");
  const RunFrame& first = press.run.frames.front();
  const Point D = press.at(first, "D"), arm = press.at(first, "B") - D;
  EXPECT_NEAR(degrees(std::atan(D.y() / D.x())), 78, 1e-4);
  EXPECT_NEAR(degrees(std::atan(-arm.y() / arm.x())), 67, 1e-4);
  EXPECT_NEAR(D.y(), press.at(first, "E").y(), 1e-5);
  const std::vector<Reaction> reactions = reactions_in(press, first, false);
  ASSERT_EQ(reactions.size(), 7u);  // C, D twice, F, E, B, the can
  const auto printed = [](double value, double figure) { EXPECT_NEAR(std::abs(value), figure, 0.05); };
  printed(reactions[1].force.norm(), 601.8);  // in CD
  printed(reactions[2].force.norm(), 639.5);  // in BD
  printed(reactions[4].force.norm(), 375);    // in DE
  printed(reactions[6].along, 588.7);         // on the can
  EXPECT_GT(reactions[6].along, 0) << "the can holds the piston up";
}

class EveryExample : public testing::TestWithParam<const char*> {};

/// Jumps of an eighth of the motion (45 degrees of a turn), forth and back, land where a fine walk passes.
TEST_P(EveryExample, KeepsItsAssemblyOver360CoarsePoses) {
  const Example fine(GetParam(), 720);
  ASSERT_FALSE(fine.run.stop);
  const DriveSchedule& schedule = fine.model.schedule;
  auto path = PlanarPath::from(fine.model.linkage, fine.start, schedule.values_at(0));
  ASSERT_TRUE(path);
  const int orientation = path->orientation();
  for (int i = 1; i <= 360; ++i) {
    const int eighth = i % 16 <= 8 ? i % 16 : 16 - i % 16;
    const int shift = (i / 16) % 90;  // every round lands elsewhere
    const int number = std::min(720, eighth * 90 + (eighth == 8 ? 0 : shift));
    const RunFrame& expected = fine.run.frames[static_cast<std::size_t>(number)];
    ASSERT_TRUE(path->advance(expected.values)) << i;
    EXPECT_EQ(path->orientation(), orientation);
    const PlanarPosition here = path->position();
    for (const ModelPoint& point : fine.model.points)
      ASSERT_LT((place(here, point.place) - place(expected.position, point.place)).norm(),
                1e-9 * fine.model.linkage.size())
          << point.name << " at pose " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryExample,
                         testing::Values("shear-press", "shear-press-forces", "pantograph", "plagiograph",
                                         "six-bar-plagiograph", "peaucellier-lipkin", "peaucellier-focus",
                                         "hart", "right-angle-inversor", "slider-crank", "watt-six-bar",
                                         "stephenson-six-bar", "chebyshev", "geared-five-bar",
                                         "pantograph-by-distances", "third-crank", "crank-rocker",
                                         "double-crank", "double-rocker", "change-point",
                                         "watt-straight-line", "hoecken", "jansen", "quick-return", "toggle",
                                         "toggle-press"),
                         [](const auto& example) {
                           std::string name = example.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace kempe
