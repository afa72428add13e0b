#include "specs/drawings/drawing_cover.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "specs/drawings/stroke_joining.hpp"
#include "tests/random.hpp"

namespace kempe {
namespace {

using ::testing::HasSubstr;

DrawnStroke drawn_square(const Point& at, double side) {
  return {{at, at + Point(side, 0), at + Point(side, side), at + Point(0, side)}, true};
}

Region covered(const std::vector<DrawnStroke>& strokes, Cover cover, double margin = 0) {
  const auto region = covered_region(strokes, "", "d.svg", {.cover = cover, .margin = margin});
  EXPECT_TRUE(region) << region.error().message();
  return region.value_or(Region{});
}

TEST(DrawingCover, HullHoldsEveryPointAndIsConvex) {
  std::mt19937_64 random(2);
  const auto uniform = [&] { return test::share(random); };
  for (int i = 0; i < 100; ++i) {
    DrawnStroke stroke;
    for (int j = 0; j < 50; ++j)
      stroke.points.push_back({std::round(20 * uniform()), std::round(20 * uniform())});
    const Region hull = covered({stroke}, Cover::hull);
    ASSERT_EQ(hull.polygons.size(), 1U);
    const Ring& ring = hull.polygons[0].outer;
    for (std::size_t a = 0; a < ring.size(); ++a) {
      const Point side = ring[(a + 1) % ring.size()] - ring[a];
      for (const Point& point : stroke.points) EXPECT_GE(cross(side, point - ring[a]), 0);
      EXPECT_GT(cross(side, ring[(a + 2) % ring.size()] - ring[a]), 0);
    }
  }
}

TEST(DrawingCover, OutlineFollowsTheEvenOddRule) {
  const Region ring =
      covered({drawn_square({0, 0}, 10), drawn_square({2, 2}, 6), drawn_square({4, 4}, 2)}, Cover::outline);
  EXPECT_NEAR(area(ring), 100 - 36 + 4, 1e-9);
  EXPECT_FALSE(contains(ring, {3, 3}));
  EXPECT_TRUE(contains(ring, {5, 5}));
}

TEST(DrawingCover, OutlinesThatMeetCoverAllThatAnyEncloses) {
  EXPECT_NEAR(area(covered({drawn_square({0, 0}, 10), drawn_square({5, 5}, 10)}, Cover::outline)), 175, 1e-9);
  const DrawnStroke bow{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, true};
  EXPECT_NEAR(area(covered({bow}, Cover::outline)), 50, 1e-4);
}

TEST(DrawingCover, OutlineJoinsLooseLines) {
  const std::vector<DrawnStroke> loose{
      {{{0, 0}, {10, 0}}}, {{{10, 10}, {10, 0}}}, {{{0, 10}, {10, 10.0001}}}, {{{0, 10}, {0, 0}}}};
  EXPECT_NEAR(area(covered(loose, Cover::outline)), 100, 1e-2);
  EXPECT_EQ(joined(loose, 1e-3).size(), 1U);
  EXPECT_TRUE(joined(loose, 1e-3)[0].closed);
}

TEST(DrawingCover, StrokesAreGrownByTheMargin) {
  const Region line = covered({{{{0, 0}, {10, 0}}}}, Cover::strokes, 2);
  EXPECT_GE(area(line), 40 + 4 * pi);
  EXPECT_LE(area(line), (40 + 4 * pi) * 1.01);
  EXPECT_TRUE(contains(line, {-1.9, 0}));
}

TEST(DrawingCover, AStraightDrawingNeedsAMargin) {
  const auto flat = covered_region({{{{0, 0}, {5, 5}, {10, 10}}}}, "", "d.svg", {});
  ASSERT_FALSE(flat);
  EXPECT_THAT(flat.error().message(), HasSubstr("margin_mm"));
  EXPECT_GT(area(covered({{{{0, 0}, {5, 5}, {10, 10}}}}, Cover::hull, 1)), 20);
}

TEST(DrawingCover, SaysWhatIsMissing) {
  const auto refused = [](const std::vector<DrawnStroke>& strokes, Cover cover) {
    return covered_region(strokes, "2 texts", "d.svg", {.cover = cover}).error().message();
  };
  EXPECT_THAT(refused({}, Cover::hull), HasSubstr("without lines (2 texts)"));
  EXPECT_THAT(refused({{{{0, 0}, {1, 1}}}}, Cover::outline), HasSubstr("closed outlines"));
  EXPECT_THAT(refused({drawn_square({0, 0}, 1)}, Cover::strokes), HasSubstr("margin_mm above 0"));
}

TEST(StrokeJoining, LeavesCrossroadsAlone) {
  const std::vector<DrawnStroke> star{{{{0, 0}, {1, 0}}}, {{{0, 0}, {0, 1}}}, {{{0, 0}, {-1, 0}}}};
  EXPECT_EQ(joined(star, 1e-3).size(), 3U);
}

TEST(StrokeJoining, KeepsTheLengthOfWhatItJoins) {
  std::mt19937_64 random(4);
  const auto uniform = [&](double a, double b) { return test::uniform(random, a, b); };
  for (int i = 0; i < 200; ++i) {
    Stroke path;
    for (int j = 0; j < 20; ++j) path.push_back({uniform(0, 100), uniform(0, 100)});
    std::vector<DrawnStroke> pieces;
    for (std::size_t j = 0; j < path.size(); ++j) {
      DrawnStroke piece{{path[j], path[(j + 1) % path.size()]}};
      if (random() % 2 == 0) std::swap(piece.points[0], piece.points[1]);
      pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(random() % (pieces.size() + 1)), piece);
    }
    const auto whole = joined(pieces, 1e-6);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_TRUE(whole[0].closed);
    EXPECT_EQ(whole[0].points.size(), path.size());
  }
}

}  // namespace
}  // namespace kempe
