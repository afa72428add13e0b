#pragma once
// Random specs for tests of the search: any ratio, regions beside the pole, fixed and free poles.

#include <cmath>
#include <random>

#include "synthesis/search/search.hpp"
#include "tests/geometry/grid_outlines.hpp"
#include "tests/random.hpp"

namespace kempe::test {

class SpecDice {
 public:
  explicit SpecDice(unsigned seed) : random_(seed) {}

  double uniform(double lower, double upper) { return test::uniform(random_, lower, upper); }
  double log_uniform(double lower, double upper) {
    return std::exp(uniform(std::log(lower), std::log(upper)));
  }
  bool one_in(int n) { return random_() % static_cast<unsigned>(n) == 0; }

  Polygon star(const Point& centre, double radius, int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i)
      ring.push_back(centre + as_point(std::polar(radius * uniform(0.4, 1), 2 * pi * i / corners)));
    return {ring, {}};
  }

  Spec spec() {
    Spec spec;
    const double scale = log_uniform(0.1, 10);
    spec.copy = Copy::of(scale, uniform(-pi, pi));
    const double away = uniform(60, 300);
    const Point centre = as_point(std::polar(away, uniform(-pi, pi)));
    const int corners = 3 + static_cast<int>(random_() % 12);  // drawn one by one: arguments have no order
    const double radius = away * uniform(0.1, 0.6);
    if (one_in(4))
      spec.region.polygons.push_back({grid_polygon_about(random_, centre, radius).outer, {}});
    else
      spec.region.polygons.push_back(star(centre, radius, corners));
    spec.links.style.width = uniform(2, 15);
    spec.links.style.pin_diameter = spec.links.style.width * uniform(0.2, 1);
    spec.links.style.plate = one_in(2) ? PlateStyle::bent : PlateStyle::triangle;
    spec.links.layers = 2 + static_cast<int>(random_() % 2);
    spec.links.shortest = uniform(5, 20);
    spec.links.longest = uniform(600, 3000);
    spec.limits.transmission = uniform(0, radians(35));
    spec.limits.clearance = uniform(0, 2);
    if (one_in(2)) {
      const double reach = uniform(5, 40);
      spec.pole.place = Region{{{{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}, {}}}};
    }
    return spec;
  }

  Obstacle obstacle_beside(const Spec& spec) {
    const double away = spec.region.polygons[0].outer[0].norm() * uniform(0.3, 1.2);
    const int corners = 3 + static_cast<int>(random_() % 5);
    const double radius = away * uniform(0.05, 0.15);
    const Point centre = as_point(std::polar(away, uniform(-pi, pi)));
    if (one_in(2)) return {grid_polygon_about(random_, centre, radius), 1, 1, "block"};
    return {star(centre, radius, corners), 1, 1, "block"};
  }

  /// What tracer or pen carries, about its point or beside it, in some of four layers.
  Body body_beside(const Spec& spec) {
    const double away = spec.region.polygons[0].outer[0].norm(), radius = away * uniform(0.03, 0.3);
    const Carrier at = one_in(2) ? Carrier::pen : Carrier::tracer;
    const Point centre = one_in(2) ? Point::Zero() : as_point(std::polar(0.8 * radius, uniform(-pi, pi)));
    const int lowest = 1 + static_cast<int>(random_() % 2),
              highest = lowest + static_cast<int>(random_() % 3);
    if (one_in(3)) return {at, Disc{centre, radius}, lowest, highest, "router"};
    const int corners = 3 + static_cast<int>(random_() % 5);
    return {at, star(centre, radius, corners), lowest, highest, "hand"};
  }

  /// A table about region and pole, with a notch.
  Polygon table_about(const Spec& spec) {
    Box box{Point::Zero(), Point::Zero()};
    for (const Point& corner : spec.region.polygons[0].outer)
      box = {box.lower.cwiseMin(corner), box.upper.cwiseMax(corner)};
    const double size = (box.upper - box.lower).norm();
    const auto beyond = [&] { return Point(size * uniform(0.05, 0.8), size * uniform(0.05, 0.8)); };
    const Point lower = box.lower - beyond(), upper = box.upper + beyond();
    return {{lower,
             {upper.x(), lower.y()},
             upper,
             {0.5 * (lower.x() + upper.x()), upper.y() - 0.04 * size},
             {lower.x(), upper.y()}},
            {}};
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace kempe::test
