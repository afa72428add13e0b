#include "reports/drawings/blank.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "reports/drawings/bom.hpp"
#include "tests/random.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

using testing::plagiograph;
using testing::sample_design;

Design random_design(std::mt19937_64& dice) {
  const auto one_in = [&](int many) { return test::share(dice) * many < 1; };
  const double scale = test::uniform(dice, 1.2, 4), turn = one_in(4) ? 0 : test::uniform(dice, 0.1, 3.0);
  const Grounding grounding = all_groundings[static_cast<std::size_t>(test::uniform(dice, 0, 3))];
  const double VA = test::uniform(dice, 20, 300), VB = test::uniform(dice, 20, 300);
  Design design = sample_design(std::polar(one_in(2) ? scale : 1 / scale, turn), grounding, VA, VB, 0,
                                one_in(2) ? PlateStyle::bent : PlateStyle::triangle);
  design.style.width = test::uniform(dice, 4, 40);
  return design;
}

/// Corners of the outline, its arcs cut fine.
Ring corners_of(const Design& design, Link link) {
  const Pose pose = design.linkage.pose_at(design.opening.middle(), 0.7);
  return flattened(link_outline(link, pose, design.style), 1e-3, Flatten::grows).outer;
}

/// Sides of the upright rectangle round the corners turned by -angle, the longer first.
std::array<double, 2> sides_at(const Ring& corners, double angle) {
  const Point along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  std::array<double, 4> ends{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (const Point& corner : corners) {
    ends[0] = std::min(ends[0], corner.dot(along));
    ends[1] = std::max(ends[1], corner.dot(along));
    ends[2] = std::min(ends[2], corner.dot(across));
    ends[3] = std::max(ends[3], corner.dot(across));
  }
  const double a = ends[1] - ends[0], b = ends[3] - ends[2];
  return {std::max(a, b), std::min(a, b)};
}

double area_at(const Ring& corners, double angle) {
  const auto [length, width] = sides_at(corners, angle);
  return length * width;
}

/// The least of 360 angles, then of a search between the neighbours of the best.
double least_area(const Ring& corners) {
  const double step = 0.5 * pi / 360;
  int best = 0;
  for (int i = 1; i < 360; ++i)
    if (area_at(corners, i * step) < area_at(corners, best * step)) best = i;
  double low = (best - 1) * step, high = (best + 1) * step;
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (area_at(corners, a) < area_at(corners, b) ? high : low) =
        area_at(corners, a) < area_at(corners, b) ? b : a;
  }
  return area_at(corners, low);
}

TEST(Blank, IsTheSmallestRectangleRoundTheOutline) {
  std::mt19937_64 dice(2611);
  for (int i = 0; i < 60; ++i) {
    const Design design = random_design(dice);
    for (const Link link : all_links) {
      const Blank blank = blank_of(design, link);
      EXPECT_GE(blank.length, blank.width);
      EXPECT_NEAR(blank.length * blank.width / least_area(corners_of(design, link)), 1, 1e-3) << name(link);
    }
  }
}

TEST(Blank, OfABarIsItsLengthAndTwoRoundEnds) {
  const Design design = plagiograph();
  const Blank blank = blank_of(design, Link::VA);
  EXPECT_NEAR(blank.length, 50 + 12, 1e-9);
  EXPECT_NEAR(blank.width, 12, 1e-9);
}

TEST(Blank, OfABentPlateHoldsBothArms) {
  const Design design = plagiograph();  // ACX: AC = 35 and AX = 25 at a right angle
  const Blank blank = blank_of(design, Link::ACX);
  EXPECT_NEAR(blank.length, 35 + 12, 1e-9);
  EXPECT_NEAR(blank.width, 25 + 12, 1e-9);
}

TEST(Blank, AStraightPlateIsAStraightBar) {
  const Design design = sample_design(Complex(2.5), Grounding::tracer, 90, 70, 1);
  EXPECT_EQ(form_of(design, Link::ACX), "straight bar, three holes");
  EXPECT_EQ(form_of(design, Link::VA), "bar");
  EXPECT_NEAR(blank_of(design, Link::BCY).width, design.style.width, 1e-9);
  EXPECT_EQ(form_of(plagiograph(), Link::ACX), "bent plate");
}

/// The strip is as long as what is sawn off it, and the bill says both.
TEST(Strip, IsAsLongAsItsPiecesAndTheirKerfs) {
  std::mt19937_64 dice(2612);
  for (int i = 0; i < 200; ++i) {
    Design design = random_design(dice);
    design.cutting.kerf = i % 2 == 0 ? 0 : test::uniform(dice, 0.1, 3);
    const Strip strip = strip_of(design);
    const bool all = is_straight_link(design, Link::ACX);
    ASSERT_EQ(strip.pieces.size(), all ? 4U : 2U);
    double sum = 0;
    for (const Strip::Piece& piece : strip.pieces)
      sum += blank_of(design, piece.link).length + design.cutting.kerf;
    EXPECT_NEAR(strip.length, sum, 1e-9 * sum);
    for (const BomItem& item : bill_of_materials(design)) {
      if (item.item == "strip") {
        EXPECT_EQ(item.length, strip.length);
      }
      EXPECT_EQ(item.item == "link", item.blank_length > 0);
      EXPECT_GE(item.length, item.item == "link" ? item.blank_length * (1 - 1e-9) : 0);
    }
  }
}

}  // namespace
}  // namespace kempe
