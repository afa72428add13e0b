// Obstacles left out as out of reach: no part of any permitted instrument ever comes near them. Checked against random
// instruments, driven over the region, whose parts are laid out by a complex sum of their own.
#include "synthesis/problem/obstacle_reach.hpp"

#include <gtest/gtest.h>

#include "synthesis/search/search.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

double distance_to_segment(Complex at, Complex from, Complex to) {
  const Complex along = to - from;
  const double share = std::norm(along) > 0
                           ? std::clamp(((at - from) * std::conj(along)).real() / std::norm(along), 0.0, 1.0)
                           : 0;
  return std::abs(at - from - share * along);
}

/// From a segment to an outline, by their ends alone: for segments that do not cross.
double distance_between(Complex a, Complex b, const Ring& ring) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Complex c = as_complex(ring[i]), d = as_complex(ring[(i + 1) % ring.size()]);
    least = std::min({least, distance_to_segment(a, c, d), distance_to_segment(b, c, d),
                      distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
  }
  return least;
}

/// The tracer at T, by the chain of links: pole, tracer and pen as the three homologous points, then A from two lengths.
struct Joints {
  Complex V, A, B, C, X, Y;
};
std::optional<Joints> joints_at(Complex k, Grounding grounding, double VA, double VB, Complex P, Complex T,
                                int side) {
  const Complex pen = P + k * (T - P);
  const Complex V = grounding == Grounding::pole ? P : grounding == Grounding::tracer ? T : pen;
  const Complex X = grounding == Grounding::pole ? T : P;
  const Complex Y = grounding == Grounding::pen ? T : pen;
  const Complex s = (Y - V) / (X - V);
  const double AX = VB / std::abs(s), apart = std::abs(X - V);
  const double forth = (VA * VA - AX * AX + apart * apart) / (2 * apart);
  if (VA * VA < forth * forth) return std::nullopt;
  const Complex ahead = (X - V) / apart, aside = Complex{0, 1} * ahead * std::sqrt(VA * VA - forth * forth);
  const Complex A = V + forth * ahead + static_cast<double>(side) * aside;
  const Complex q = s * (X - A);
  return Joints{V, A, V + q, A + q, X, Y};
}

/// All lengths between joints of one link.
std::array<double, 8> lengths_of(const Joints& j) {
  return {std::abs(j.A - j.V), std::abs(j.B - j.V), std::abs(j.C - j.A), std::abs(j.C - j.B),
          std::abs(j.X - j.A), std::abs(j.X - j.C), std::abs(j.Y - j.B), std::abs(j.Y - j.C)};
}

bool are_permitted(const std::array<double, 8>& lengths, const Spec& spec) {
  return std::all_of(lengths.begin(), lengths.end(), [&](double length) {
    return length >= spec.links.shortest && length <= spec.links.longest;
  });
}

/// The longest VA and VB with which no length of any link is longer than permitted.
struct LengthLimits {
  double VA, VB;
};
LengthLimits longest_of(const Spec& spec, Grounding grounding) {
  const Complex k = spec.copy.k();
  const Complex s = grounding == Grounding::pole     ? k
                    : grounding == Grounding::tracer ? 1.0 - k
                                                     : 1.0 - 1.0 / k;
  const double VA = spec.links.longest / std::max({1.0, std::abs(s), std::abs(1.0 - s)});
  return {VA, VA * std::abs(s)};  // AX = VB/|s| and CX = |1-s| AX stay within the limit as BY and CY do
}

double distance_of_parts(const Joints& j, const Ring& ring) {
  double least = 1e300;
  for (const auto& [a, b] : {std::pair{j.V, j.A},
                             {j.V, j.B},
                             {j.A, j.C},
                             {j.C, j.X},
                             {j.A, j.X},
                             {j.B, j.C},
                             {j.C, j.Y},
                             {j.B, j.Y}})
    least = std::min(least, distance_between(a, b, ring));
  return least;
}

Obstacle block_at(test::SpecDice& dice, double away, double radius) {
  const double bearing = dice.uniform(-pi, pi);
  return {dice.star(as_point(std::polar(away, bearing)), radius, 4), 1, 8, "block"};
}

Point place_in(test::SpecDice& dice, const Region& region) {
  const Ring& ring = region.polygons[0].outer;
  const auto corner = static_cast<std::size_t>(dice.uniform(0, static_cast<double>(ring.size()) - 1e-9));
  const double share = dice.uniform(0, 1);
  return ring[corner] + share * (ring[(corner + 1) % ring.size()] - ring[corner]);
}

TEST(ObstacleReach, NothingLeftOutIsEverTouchedByAPermittedInstrument) {
  test::SpecDice dice(117);
  int left_out = 0, kept = 0, instruments = 0, near_the_limit = 0;
  for (int n = 0; n < test::samples(300); ++n) {
    Spec spec = dice.spec();
    spec.links.longest = dice.log_uniform(100, 1000);
    const double span = 3 * (spec.links.longest + 300) * (1 + spec.copy.scale());
    for (int i = 0; i < 60; ++i) {
      const double away = dice.log_uniform(20, span);
      spec.obstacles.push_back(block_at(dice, away, 5));
    }
    const auto reached = obstacles_in_reach(spec, requirements_of(spec));
    kept += static_cast<int>(std::count(reached.begin(), reached.end(), true));
    left_out += static_cast<int>(std::count(reached.begin(), reached.end(), false));
    for (int tried = 0; tried < 400; ++tried) {
      const Grounding grounding = all_groundings[static_cast<std::size_t>(tried % 3)];
      const LengthLimits most = longest_of(spec, grounding);
      const double least = tried % 4 == 0 ? 0.9 : 0.02;  // many with lengths at their limit
      const double VA = most.VA * dice.log_uniform(least, 1);
      const double VB = most.VB * dice.log_uniform(least, 1);
      const Complex P = spec.pole.is_fixed() ? as_complex(std::get<Point>(spec.pole.place))
                                             : as_complex(place_in(dice, std::get<Region>(spec.pole.place)));
      const Complex T = as_complex(place_in(dice, spec.region));
      const auto joints = joints_at(spec.copy.k(), grounding, VA, VB, P, T, tried % 2 == 0 ? 1 : -1);
      if (!joints || !are_permitted(lengths_of(*joints), spec)) continue;
      ++instruments;
      const double needed = 0.5 * spec.links.style.width + spec.limits.clearance;
      for (std::size_t i = 0; i < reached.size(); ++i) {
        const double gap = distance_of_parts(*joints, spec.obstacles[i].shape.outer) - needed;
        if (reached[i]) continue;
        ASSERT_GT(gap, 0) << "spec " << n << ", obstacle " << i;
        if (gap < 0.2 * spec.links.longest) ++near_the_limit;
      }
    }
  }
  EXPECT_GT(instruments, test::expected(10000));
  EXPECT_GT(left_out, test::expected(1000));
  EXPECT_GT(kept, test::expected(1000));
  EXPECT_GT(near_the_limit, test::expected(20));  // among them some that are nearly touched
}

Spec plagiograph() {
  Spec spec;
  spec.copy = Copy::of(1.4, radians(90));
  spec.region.polygons.push_back({{{62, -5}, {70, -5}, {70, 5}, {62, 5}}, {}});
  spec.links.style.width = 6;
  spec.links.style.pin_diameter = 3;
  return spec;
}

FoundDesign found_for(const Spec& spec) {
  SearchOptions options;
  options.diagnose = false;
  return std::get<FoundDesign>(synthesize(spec, options));
}

TEST(ObstacleReach, FarObstaclesChangeNothingOfTheDesign) {
  Spec spec = plagiograph();
  const FoundDesign without = found_for(spec);
  test::SpecDice dice(118);
  for (int i = 0; i < 500; ++i) {
    const double away = dice.uniform(1000, 9000);
    spec.obstacles.push_back(block_at(dice, away, 20));
    spec.obstacles.back().name = "block " + std::to_string(i);
  }
  EXPECT_EQ(names_out_of_reach(spec).size(), 500U);
  const FoundDesign with = found_for(spec);
  EXPECT_EQ(without.linkage, with.linkage);
  EXPECT_EQ(without.evaluations, with.evaluations);
  EXPECT_EQ(without.proven_bound, with.proven_bound);
}

TEST(ObstacleReach, MovedLimitsBringObstaclesBack) {
  Spec spec = plagiograph();
  spec.obstacles.push_back({{{{900, 0}, {910, 0}, {910, 10}, {900, 10}}, {}}, 1, 8, "far"});
  Requirements limits = requirements_of(spec);
  EXPECT_FALSE(obstacles_in_reach(spec, limits).front());
  limits.longest = 2000;
  EXPECT_TRUE(obstacles_in_reach(spec, limits).front());
  limits = requirements_of(spec);
  limits.clearance = 2000;
  EXPECT_TRUE(obstacles_in_reach(spec, limits).front());
  limits = requirements_of(spec);
  limits.pole_margin = 2000;
  EXPECT_TRUE(obstacles_in_reach(spec, limits).front());
}

}  // namespace
}  // namespace kempe
