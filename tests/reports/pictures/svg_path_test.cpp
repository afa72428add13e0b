#include "reports/pictures/svg_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "tests/random.hpp"

namespace kempe {
namespace {

/// An independent reading of the arcs that svg_path writes: the area by the endpoint-to-centre conversion of
/// the SVG specification (appendix B.2.4), back in the frame with y upward.
double area_of_path(const std::string& path) {
  std::string spaced;
  for (const char c : path) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      spaced += std::string(" ") + c + " ";
    } else {
      spaced += c == ',' ? ' ' : c;
    }
  }
  std::istringstream in(spaced);
  double area = 0, x = 0, y = 0, startx = 0, starty = 0;
  std::string command;
  const auto line_to = [&](double tx, double ty) {
    area += 0.5 * (x * ty - tx * y);
    x = tx;
    y = ty;
  };
  while (in >> command) {
    if (command == "M") {
      in >> startx >> starty;
      x = startx;
      y = starty;
    } else if (command == "L") {
      double tx, ty;
      in >> tx >> ty;
      line_to(tx, ty);
    } else if (command == "A") {
      double rx, ry, turn, tx, ty;
      int large, sweep;
      in >> rx >> ry >> turn >> large >> sweep >> tx >> ty;
      const double mx = (x - tx) / 2, my = (y - ty) / 2, half = std::hypot(mx, my);
      const double root = std::sqrt(std::max(0.0, rx * rx - half * half)) / half * (large != sweep ? 1 : -1);
      const double cx = root * my + (x + tx) / 2, cy = -root * mx + (y + ty) / 2;
      double angle = std::atan2(ty - cy, tx - cx) - std::atan2(y - cy, x - cx);
      if (sweep != 0 && angle < 0) angle += 2 * pi;
      if (sweep == 0 && angle > 0) angle -= 2 * pi;
      area += 0.5 * rx * rx * (angle - std::sin(angle));
      line_to(tx, ty);
    } else {
      line_to(startx, starty);
    }
  }
  return -area;  // y was turned downward
}

TEST(SvgPath, KeepsTheAreaOfEveryPolygonWithArcs) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double a, double b) { return test::uniform(random, a, b); };
  for (int i = 0; i < 300; ++i) {
    ArcRing ring;
    const int corners = 2 + static_cast<int>(random() % 6);
    for (int j = 0; j < corners; ++j) {
      const double angle = 2 * pi * (j + 0.6 * uniform(0, 1)) / corners;
      ring.push_back({uniform(20, 60) * Point(std::cos(angle), std::sin(angle)),
                      random() % 3 == 0 ? 0 : uniform(-1.6, 1.6)});
    }
    EXPECT_NEAR(area_of_path(svg_path(ArcPolygon{ring, {}}, 0)), signed_area(ring), 0.3);
  }
}

TEST(SvgPath, DrawsAFullCircleAsArcs) {
  EXPECT_NEAR(area_of_path(svg_path(ArcRegion{{circle({3, -4}, 10), {reversed(circle({3, -4}, 6))}}}, 0)),
              pi * 64, 0.03);
}

TEST(SvgPath, LeavesOutWhatNobodySees) {
  Ring ring;
  for (int i = 0; i < 100000; ++i)
    ring.push_back(10 * Point(std::cos(2e-5 * pi * i), std::sin(2e-5 * pi * i)));
  const std::string path = svg_path(Polygon{ring, {}}, 0.05);
  EXPECT_LT(path.size(), 40000u);
  EXPECT_NEAR(area_of_path(path), pi * 100, 0.1);
}

}  // namespace
}  // namespace kempe
