// The linkages of lectures (specs/examples/linkages), each against what its source publishes and against formulas that share nothing
// with the solver.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "kinematics/planar/reactions.hpp"
#include "tests/specs/linkages/example.hpp"

namespace kempe {
namespace {

constexpr double degree = pi / 180;

/// The angle at the corner between the sides a and b of the triangle whose third side is c.
double corner(double a, double b, double c) { return std::acos((a * a + b * b - c * c) / (2 * a * b)); }

double direction(const Example& example, const RunFrame& frame, const char* from, const char* to) {
  return std::arg(example.z(frame, to) - example.z(frame, from));
}

/// How far an angle, followed through all frames, swings, and how far it has turned at the end.
struct Swing {
  double least = 0, most = 0, turned = 0;
  Swing(const Example& example, const char* from, const char* to) {
    double before = direction(example, example.run.frames.front(), from, to);
    for (const RunFrame& frame : example.run.frames) {
      const double now = direction(example, frame, from, to);
      turned += std::remainder(now - before, 2 * pi);
      before = now;
      least = std::min(least, turned);
      most = std::max(most, turned);
    }
  }
  double range() const { return most - least; }
};

TEST(LectureLinkages, GrashofsLawSaysWhichCrankTurnsFully) {
  // Two chains of R. L. Norton's problem, one with the law and one against it, in every order.
  int turn = 0, stick = 0;
  for (std::array<double, 4> chain : {std::array{2.0, 4.5, 7.0, 9.0}, std::array{2.0, 3.5, 7.0, 9.0}}) {
    const bool holds = chain[0] + chain[3] < chain[1] + chain[2];
    do {
      const auto [ground, crank, coupler, rocker] = chain;
      // The start: half-way between the shortest and the longest distance of crank's end and rocker's foot.
      const double nearest = std::max(std::abs(ground - crank), std::abs(coupler - rocker));
      const double farthest = std::min(ground + crank, coupler + rocker);
      const double start = corner(ground, crank, (nearest + farthest) / 2);
      const auto file = parse_linkage_file(
          fmt::format("ground = {{ O = [0, 0], D = [{}, 0] }}\n[links]\ncrank = {{ joints = [\"O\", \"A\"], "
                      "O-A = {} }}\n"
                      "coupler = {{ joints = [\"A\", \"B\"], A-B = {} }}\nrocker = {{ joints = [\"D\", "
                      "\"B\"], D-B = {} }}\n"
                      "[[drivers]]\nangle = \"crank\"\nfrom_deg = {:.17g}\nto_deg = {:.17g}\n",
                      ground, crank, coupler, rocker, start / degree, start / degree + 360),
          "four-bar.toml");
      ASSERT_TRUE(file) << file.error().message();
      const Example bars(*file, 24);
      const bool shortest_turns = holds && (ground == 2 || crank == 2);
      EXPECT_EQ(bars.run.stop.has_value(), !shortest_turns)
          << ground << " " << crank << " " << coupler << " " << rocker;
      ++(shortest_turns ? turn : stick);
      if (!bars.run.stop) continue;
      // It stops where coupler and rocker lie in one line: stretched on the way to 180 degrees, or folded on the way back to 360.
      const double reached = start + 2 * pi * bars.run.frames.back().share;
      const bool is_stretched = coupler + rocker < ground + crank;
      const double apart = is_stretched ? coupler + rocker : std::abs(coupler - rocker);
      const double expected = corner(ground, crank, apart);
      EXPECT_NEAR(reached, is_stretched ? expected : 2 * pi - expected, 1e-6);
    } while (std::next_permutation(chain.begin(), chain.end()));
  }
  EXPECT_EQ(turn, 12);
  EXPECT_EQ(stick, 36);
}

TEST(LectureLinkages, CrankRockerSwingsBetweenItsDeadPositions) {
  const Example bars("crank-rocker", 3600);
  ASSERT_FALSE(bars.run.stop);
  // The rocker turns back where crank and coupler lie in one line, stretched or folded.
  const double stretched = corner(9, 4.5, 7 + 2), folded = corner(9, 4.5, 7 - 2);
  EXPECT_NEAR(Swing(bars, "D", "B").range(), stretched - folded, 1e-6);
  EXPECT_NEAR(Swing(bars, "D", "B").turned, 0, 1e-12);
  EXPECT_NEAR(Swing(bars, "O", "A").turned, 2 * pi, 1e-12);
}

TEST(LectureLinkages, DoubleCrankTurnsBothCranksFully) {
  const Example bars("double-crank", 360);
  ASSERT_FALSE(bars.run.stop);
  EXPECT_NEAR(Swing(bars, "O", "A").turned, 2 * pi, 1e-12);
  EXPECT_NEAR(Swing(bars, "D", "B").turned, 2 * pi, 1e-12);
  // Turned about the held link, the chain is that of the crank-rocker: the corner at B is the same for the same corner at O.
  const Example rocker("crank-rocker", 360);
  for (std::size_t i = 0; i <= 360; ++i) {
    const auto at_B = [i](const Example& example) {
      const RunFrame& frame = example.run.frames[i];
      return std::remainder(direction(example, frame, "B", "A") - direction(example, frame, "B", "D"),
                            2 * pi);
    };
    EXPECT_NEAR(std::abs(at_B(bars)), std::abs(at_B(rocker)), 1e-11) << i;
  }
}

TEST(LectureLinkages, DoubleRockerTurnsItsCouplerFullyAndSwingsBothRockers) {
  const Example bars("double-rocker", 3600);
  ASSERT_FALSE(bars.run.stop);
  EXPECT_NEAR(Swing(bars, "A", "B").turned, 2 * pi, 1e-12);
  // Each rocker turns back where the coupler lies in line with the other one.
  EXPECT_NEAR(Swing(bars, "O", "A").range(), corner(4.5, 9, 7 + 2) - corner(4.5, 9, 7 - 2), 1e-6);
  EXPECT_NEAR(Swing(bars, "D", "B").range(), corner(4.5, 7, 9 + 2) - corner(4.5, 7, 9 - 2), 1e-6);
}

TEST(LectureLinkages, ChangePointStopsWithAllLinksInOneLine) {
  const Example bars("change-point");
  ASSERT_FALSE(bars.run.stop);
  for (const RunFrame& frame : bars.run.frames) {
    const Point A = on_circle(2, (-170 + 340 * frame.share) * degree), D(8, 0);
    const Point above = meet(A, 6, D, 4, 1), below = meet(A, 6, D, 4, -1), B = bars.at(frame, "B");
    EXPECT_LT(std::min((B - above).norm(), (B - below).norm()), 1e-10);
  }
  // Driven on to 190 degrees it stops at 180, where it could go on in two ways.
  LinkageFile onward = Example::parsed("change-point");
  std::get<DriverRange>(onward.drivers.front().motion).to = 190 * degree;
  const Example stopped(onward, 36);
  ASSERT_TRUE(stopped.run.stop);
  EXPECT_EQ(stopped.run.stop->end, PathEnd::change_point);
  const RunFrame& last = stopped.run.frames.back();
  EXPECT_NEAR(stopped.run.stop->share, 350.0 / 360, 1e-6);
  expect_near(stopped.at(last, "A"), Point(-2, 0), 1e-4, "A");
  expect_near(stopped.at(last, "B"), Point(4, 0), 1e-4, "B");
}

TEST(LectureLinkages, WattsLineIsAPieceOfWattsCurve) {
  const Example watt("watt-straight-line", 1400);
  ASSERT_FALSE(watt.run.stop);
  // (x^2 + y^2) (x^2 + y^2 - a^2 - b^2 + c^2)^2 + 4 a^2 y^2 (x^2 + y^2 - b^2) = 0, feet at (-a, 0) and (a, 0) (MathWorld, Watt's Curve).
  const double a = std::sqrt(26), b = 5, c = 1;
  for (const RunFrame& frame : watt.run.frames) {
    const Complex P = watt.z(frame, "P") * std::conj(Complex(5, 1)) / a;  // its x axis through both feet
    const double r = std::norm(P), s = r - a * a - b * b + c * c, y = P.imag();
    EXPECT_LT(std::abs(r * s * s + 4 * a * a * y * y * (r - b * b)), 1e-9);
  }
  // At mid-stroke the line and the curve agree to the fourth order: twice the stroke, 2^5 times the deviation.
  const auto off = [&](double height) {
    const RunFrame* nearest = &watt.run.frames.front();
    for (const RunFrame& frame : watt.run.frames)
      if (std::abs(watt.at(frame, "P").y() - height) < std::abs(watt.at(*nearest, "P").y() - height))
        nearest = &frame;
    const Point P = watt.at(*nearest, "P");
    return P.x() / std::pow(P.y(), 5);
  };
  EXPECT_NEAR(off(0.4) / off(0.2), 1, 0.02);
  EXPECT_NEAR(off(-0.4) / off(-0.2), 1, 0.02);
  for (const RunFrame& frame : watt.run.frames) {
    const Point P = watt.at(frame, "P");
    if (std::abs(P.y()) < 1) {
      EXPECT_LT(std::abs(P.x()), 0.0011);  // 2 cm of line, straight to 11 micrometres
    }
  }
}

TEST(LectureLinkages, HoeckensCurveIsChebyshevs) {
  const Example hoecken("hoecken", 720);
  ASSERT_FALSE(hoecken.run.stop);
  double least = 5, most = 0;
  for (const RunFrame& frame : hoecken.run.frames) {
    const Point P = hoecken.at(frame, "P");
    // Chebyshev's linkage, four to the left: the coupler's ends P - e and P + e lie on circles of 5 about -4 and 0. A first end that
    // meets its own circle must have the second on the other one.
    const Point left(-4, 0), right(0, 0);
    double missing = 1;
    for (const int side : {1, -1}) {
      const Point A = meet(left, 5, P, 1, side);
      missing = std::min(missing, std::abs((2 * P - A - right).norm() - 5));
    }
    EXPECT_LT(missing, 1e-9);
    if (std::abs(std::remainder(2 * pi * frame.share, 2 * pi)) <= pi / 2) {
      least = std::min(least, P.y());
      most = std::max(most, P.y());
    }
  }
  EXPECT_NEAR(least, 4, 1e-12);
  EXPECT_NEAR(most, 4.0097537, 1e-6);  // the deviation of chebyshev.toml, over half a turn
}

/// Jansen's foot by circles alone, for an angle of the crank.
Point jansens_foot(double crank) {
  const Point D(0, 0), A = Point(38, 7.8) + on_circle(15, crank);
  const Point B = meet(D, 41.5, A, 50, 1), E = meet(D, 39.3, A, 61.9, -1);
  const Point C = meet(D, 40.1, B, 55.8, 1), G = meet(C, 39.4, E, 36.7, -1);
  return meet(G, 65.7, E, 49, -1);
}

TEST(LectureLinkages, JansensFootWalks) {
  const Example leg("jansen", 720);
  ASSERT_FALSE(leg.run.stop);
  // As published with the crank upright (GIBBON, DEMO_Jansen_linkage_animation_01), to the last digit printed.
  const RunFrame& first = leg.run.frames.front();
  expect_near(leg.at(first, "B"), Point(-8.7357, 40.5702), 1e-4, "B");
  expect_near(leg.at(first, "C"), Point(-39.6678, -5.8717), 1e-4, "C");
  expect_near(leg.at(first, "G"), Point(-19.4476, -39.6874), 1e-4, "G");
  expect_near(leg.at(first, "E"), Point(17.0047, -35.4306), 1e-4, "E");
  expect_near(leg.at(first, "F"), Point(30.3109, -82.5894), 1e-4, "F");
  expect_near(leg.at(leg.run.frames.back(), "F"), leg.at(first, "F"), 1e-10, "the curve is closed");
  double low = 0, high = -100, ahead = -100, behind = 100;
  for (const RunFrame& frame : leg.run.frames) {
    const Point F = leg.at(frame, "F");
    expect_near(F, jansens_foot(pi / 2 + 2 * pi * frame.share), 1e-9, "F");
    low = std::min(low, F.y());
    high = std::max(high, F.y());
    ahead = std::max(ahead, F.x());
    behind = std::min(behind, F.x());
  }
  EXPECT_NEAR(high - low, 22.5, 0.1);      // the step's height
  EXPECT_NEAR(ahead - behind, 67.9, 0.1);  // and its length
  int on_ground = 0;
  for (const RunFrame& frame : leg.run.frames)
    if (leg.at(frame, "F").y() < low + 1) {
      ++on_ground;
      EXPECT_GT(leg.velocity(frame, "F").real(), 0) << frame.share;  // there the foot goes one way only
    }
  EXPECT_GT(on_ground, 721 / 3);
  EXPECT_EQ(leg.mobility().mobility, 1);
  EXPECT_EQ(leg.mobility().gruebler, 1);
}

TEST(LectureLinkages, QuickReturnHasItsTimeRatio) {
  const Example shaper("quick-return", 7200);
  ASSERT_FALSE(shaper.run.stop);
  std::size_t farthest = 0, nearest = 0;
  for (std::size_t i = 0; i < 7200; ++i) {
    const RunFrame& frame = shaper.run.frames[i];
    const Point A = Point(0, 25) + on_circle(10, 2 * pi * frame.share), B = 65 * A.normalized();
    expect_near(shaper.at(frame, "C"), Point(B.x() - std::sqrt(900 - std::pow(B.y() - 50, 2)), 50), 1e-10,
                "C");
    if (shaper.at(frame, "C").x() < shaper.at(shaper.run.frames[farthest], "C").x()) farthest = i;
    if (shaper.at(frame, "C").x() > shaper.at(shaper.run.frames[nearest], "C").x()) nearest = i;
  }
  // The lever turns back where the crank stands square to it.
  const double a = std::asin(10.0 / 25);
  EXPECT_NEAR(static_cast<double>(nearest) / 7200, (2 * pi - a) / (2 * pi), 2e-4);
  EXPECT_NEAR(static_cast<double>(farthest) / 7200, (pi + a) / (2 * pi), 2e-4);
  const double back = static_cast<double>(nearest - farthest);
  EXPECT_NEAR((7200 - back) / back, (pi + 2 * a) / (pi - 2 * a), 1e-3);
  const double stroke =
      shaper.at(shaper.run.frames[nearest], "C").x() - shaper.at(shaper.run.frames[farthest], "C").x();
  EXPECT_NEAR(stroke, 2 * 65 * 10 / 25.0, 1e-4);  // both ends at one height: the rod takes nothing of it
}

TEST(LectureLinkages, TogglesFactorGrowsWithoutBound) {
  const Example toggle("toggle");
  ASSERT_FALSE(toggle.run.stop);
  ReactionSolver solver(toggle.model.linkage);
  double before = 0;
  for (const RunFrame& frame : toggle.run.frames) {
    const std::vector<Reaction> reactions =
        solver.at(frame.position, frame.values, -applied_forces(toggle.model.loads, frame.position)).value();
    const double man = -reactions.back().along, factor = 3393 / man;
    const double height = toggle.at(frame, "K").y(), arm = 1.999713;
    EXPECT_NEAR(factor * 2 * std::tan(std::asin(height / arm)), 1, 1e-12);
    EXPECT_GT(factor, before);
    before = factor;
  }
  EXPECT_GT(before, 499);  // a / (2 h): with the knee at 2 mm
  const std::vector<Reaction> first =
      solver.at(toggle.start, toggle.run.frames[0].values, -applied_forces(toggle.model.loads, toggle.start))
          .value();
  EXPECT_NEAR(first.back().along, -883, 0.5);  // as published
}

}  // namespace
}  // namespace kempe
