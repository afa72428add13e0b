#pragma once
// Random numbers and linkages for tests, the same on every machine.

#include <cmath>
#include <cstdint>
#include <random>

#include "kinematics/planar/linkage.hpp"
#include "tests/random.hpp"

namespace kempe::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : random_(seed) {}
  double uniform(double lower, double upper) { return test::uniform(random_, lower, upper); }
  double logarithmic(double lower, double upper) {
    return std::exp(uniform(std::log(lower), std::log(upper)));
  }
  int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
  Point point(double reach) { return {uniform(-reach, reach), uniform(-reach, reach)}; }

 private:
  std::mt19937_64 random_;
};

/// A position with every body somewhere within `reach`, at any angle.
inline PlanarPosition random_position(Random& random, int bodies, double reach) {
  PlanarPosition position(static_cast<std::size_t>(bodies));
  for (std::size_t body = 1; body < position.size(); ++body)
    position[body] = {random.point(reach), random.uniform(-pi, pi)};
  return position;
}

/// Ground (0,0)-(d,0), crank a, coupler b, rocker c; driven by the crank's angle.
inline PlanarLinkage four_bar(double d, double a, double b, double c) {
  PlanarLinkage linkage;
  const int crank = linkage.add_body("crank"), coupler = linkage.add_body("coupler"),
            rocker = linkage.add_body("rocker");
  linkage.add(Revolute{{0, Point(0, 0)}, {crank, Point(0, 0)}}, "A");
  linkage.add(Revolute{{crank, Point(a, 0)}, {coupler, Point(0, 0)}}, "B");
  linkage.add(Revolute{{coupler, Point(b, 0)}, {rocker, Point(c, 0)}}, "C");
  linkage.add(Revolute{{rocker, Point(0, 0)}, {0, Point(d, 0)}}, "D");
  linkage.drive(RelativeAngle{crank, 0, 0}, "crank");
  return linkage;
}

/// The point at distances `a` from A and `b` from B, on the left of AB for side +1; not finite if there is
/// none.
inline Point meet(const Point& A, double a, const Point& B, double b, int side) {
  const Point e = B - A;
  const double d = e.norm(), along = (a * a - b * b + d * d) / (2 * d);
  const double off = std::sqrt(a * a - along * along);
  return A + along * e / d + side * off * Point(-e.y(), e.x()) / d;
}

}  // namespace kempe::test
