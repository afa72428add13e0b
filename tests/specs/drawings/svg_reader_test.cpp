#include "specs/drawings/svg_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "specs/drawings/svg_path_reader.hpp"
#include "specs/drawings/svg_units.hpp"
#include "tests/random.hpp"

namespace kempe {
namespace {

using ::testing::HasSubstr;

/// A page of 100 x 50 mm whose user unit is a millimetre.
std::string page(const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "width=\"100mm\" "
         "height=\"50mm\" viewBox=\"0 0 100 50\">" +
         inside + "</svg>";
}

StrokeDrawing drawn(const std::string& text) {
  auto drawing = read_svg(text, "d.svg");
  EXPECT_TRUE(drawing) << drawing.error().message();
  return drawing ? *drawing : StrokeDrawing{};
}

std::string refusal(const std::string& text) {
  const auto drawing = read_svg(text, "d.svg");
  return drawing ? "" : drawing.error().message();
}

/// The one stroke that the inside of a page draws.
Stroke stroke(const std::string& inside) {
  const StrokeDrawing drawing = drawn(page(inside));
  EXPECT_EQ(drawing.strokes.size(), 1U) << inside;
  return drawing.strokes.empty() ? Stroke{} : drawing.strokes[0].points;
}

void expect_points(const Stroke& points, const Stroke& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT((points[i] - expected[i]).norm(), 1e-9) << i;
}

TEST(SvgReader, PutsTheOriginAtThePagesLowerLeftCorner) {
  expect_points(stroke("<line x1=\"0\" y1=\"50\" x2=\"100\" y2=\"0\"/>"), {{0, 0}, {100, 50}});
  EXPECT_LT((drawn(page("")).page - Point(100, 50)).norm(), 1e-12);
}

TEST(SvgReader, KnowsAllUnits) {
  const double px = 25.4 / 96;
  for (const auto& [text, mm] : std::vector<std::pair<std::string, double>>{{"1", px},
                                                                            {"1px", px},
                                                                            {"1mm", 1},
                                                                            {"1cm", 10},
                                                                            {"1Q", 0.25},
                                                                            {"1in", 25.4},
                                                                            {"1pt", 25.4 / 72},
                                                                            {"1pc", 25.4 / 6},
                                                                            {"1e1mm", 10},
                                                                            {"50%", 100 * px}})
    EXPECT_NEAR(svg_length(text, 200).value() * px, mm, 1e-12) << text;
  for (const char* wrong : {"", "mm", "1 2", "1furlong", "nan", "inf", "0x10", "1e999"})
    EXPECT_FALSE(svg_length(wrong, 200)) << wrong;
}

TEST(SvgReader, FitsTheViewBoxAsThePageSays) {
  const auto corner = [](const std::string& attributes) {
    return drawn("<svg " + attributes + "><line x1=\"0\" y1=\"0\" x2=\"10\" y2=\"10\"/></svg>")
        .strokes.at(0)
        .points;
  };
  expect_points(corner("width=\"20mm\" height=\"10mm\" viewBox=\"0 0 10 10\""), {{5, 10}, {15, 0}});
  expect_points(
      corner("width=\"20mm\" height=\"10mm\" viewBox=\"0 0 10 10\" preserveAspectRatio=\"xMinYMid\""),
      {{0, 10}, {10, 0}});
  expect_points(corner("width=\"20mm\" height=\"10mm\" viewBox=\"0 0 10 10\" preserveAspectRatio=\"none\""),
                {{0, 10}, {20, 0}});
  expect_points(
      corner("width=\"20mm\" height=\"10mm\" viewBox=\"0 0 10 10\" preserveAspectRatio=\"xMidYMax slice\""),
      {{0, 20}, {20, 0}});
  const double px = 25.4 / 96;
  expect_points(corner("viewBox=\"0 0 10 10\""), {{0, 10 * px}, {10 * px, 0}});
  expect_points(corner("width=\"10\" height=\"10\""), {{0, 10 * px}, {10 * px, 0}});
}

TEST(SvgReader, AppliesTransformsFromTheInsideOut) {
  expect_points(
      stroke(
          "<g transform=\"translate(10 20) rotate(90)\"><path transform=\"scale(2)\" d=\"M0 0 L5 0\"/></g>"),
      {{10, 30}, {10, 20}});
  expect_points(stroke("<path transform=\"rotate(180, 10, 10) , translate(1)\" d=\"M0 0H1\"/>"),
                {{19, 30}, {18, 30}});
  expect_points(stroke("<path transform=\"matrix(0 1 -1 0 30 0)\" d=\"M1 2L3 4\"/>"), {{28, 49}, {26, 47}});
  expect_points(stroke("<path transform=\"skewX(45)\" d=\"M0 0L0 10\"/>"), {{0, 50}, {10, 40}});
  EXPECT_THAT(refusal(page("\n<g transform=\"spin(3)\"/>")), HasSubstr("d.svg:2: transform"));
}

TEST(SvgReader, ReadsEveryPathCommand) {
  expect_points(stroke("<path d='M 1 1 2 1 l1,0 0 1H9V9h-1v-1z'/>"),
                {{1, 49}, {2, 49}, {3, 49}, {3, 48}, {9, 48}, {9, 41}, {8, 41}, {8, 42}});
  expect_points(stroke("<path d='m.5.5-.5-.5 1e1+1E0'/>"), {{0.5, 49.5}, {0, 50}, {10, 49}});
  const Stroke arc = stroke("<path d='M10 0a10 10 0 0110 10'/>");
  for (const Point& p : arc) EXPECT_NEAR((p - Point(10, 40)).norm(), 10, 1e-9);
  EXPECT_LT((arc.back() - Point(20, 40)).norm(), 1e-12);
  EXPECT_EQ(drawn(page("<path d='M0 0L1 1z l2 0 M5 5L6 6'/>")).strokes.size(), 3U);
  EXPECT_EQ(drawn(page("<path d=''/>")).strokes.size(), 0U);
}

TEST(SvgReader, SmoothCommandsMirrorTheLastControlPoint) {
  expect_points(stroke("<path d='M0 0C0 10 10 10 10 0S20 -10 20 0'/>"),
                stroke("<path d='M0 0C0 10 10 10 10 0C10 -10 20 -10 20 0'/>"));
  expect_points(stroke("<path d='M0 0Q5 10 10 0T20 0t10 0'/>"),
                stroke("<path d='M0 0Q5 10 10 0Q15 -10 20 0q5 10 10 0'/>"));
  expect_points(stroke("<path d='M0 0L10 0S20 5 20 0'/>"), stroke("<path d='M0 0L10 0C10 0 20 5 20 0'/>"));
  for (const Point& point : stroke("<path d='M0 0L10 0T20 0'/>")) EXPECT_EQ(point.y(), 50);
}

TEST(SvgReader, RefusesBrokenPathDataWithItsPlace) {
  for (const char* data : {"10 10", "L1 1", "M", "M1", "M1 1 L", "M1 1 L2", "M1 1 X2 2",
                           "M1 1 A1 1 0 2 0 3 3", "M1 1 C1 1 2 2", "M1 1 Lnan 1", "M1 1 L1 inf", "M1e999 1"})
    EXPECT_THAT(refusal(page(std::string("\n\n<path d='") + data + "'/>")), HasSubstr("d.svg:3: d: found"))
        << data;
}

TEST(SvgReader, DrawsAllShapes) {
  expect_points(stroke("<rect x='1' y='2' width='3' height='4'/>"), {{1, 48}, {4, 48}, {4, 44}, {1, 44}});
  EXPECT_GT(stroke("<rect x='1' y='2' width='30' height='4' rx='2'/>").size(), 20U);
  expect_points(stroke("<polygon points='1,1 2,1 2,2'/>"), {{1, 49}, {2, 49}, {2, 48}});
  EXPECT_FALSE(drawn(page("<polyline points='1,1 2,1 2,2'/>")).strokes.at(0).closed);
  EXPECT_TRUE(drawn(page("<circle cx='10' cy='10' r='5'/>")).strokes.at(0).closed);
  for (const Point& p : stroke("<ellipse cx='10' cy='10' rx='8' ry='4'/>"))
    EXPECT_NEAR(std::pow((p.x() - 10) / 8, 2) + std::pow((p.y() - 40) / 4, 2), 1, 1e-12);
}

/// Distance from a point to a polyline, the slow way.
double distance_to_stroke(const Stroke& line, const Point& p) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point way = line[i + 1] - line[i];
    const double t = std::clamp((p - line[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - line[i] - t * way).norm());
  }
  return nearest;
}

TEST(SvgReader, KeepsTheToleranceOnRandomCurves) {
  std::mt19937_64 random(5);
  const auto uniform = [&](double a, double b) { return test::uniform(random, a, b); };
  for (int i = 0; i < 200; ++i) {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    map.linear() << uniform(-3, 3), uniform(-3, 3), uniform(-3, 3), uniform(-3, 3);
    const double tolerance = std::pow(10, uniform(-4, -1));
    const Point p[4] = {{uniform(0, 50), uniform(0, 50)},
                        {uniform(0, 50), uniform(0, 50)},
                        {uniform(0, 50), uniform(0, 50)},
                        {uniform(0, 50), uniform(0, 50)}};
    CurveFlattener cubic(map, tolerance), ellipse(map, tolerance);
    cubic.move_to(p[0]);
    cubic.cubic_to(p[1], p[2], p[3]);
    const double sweep = uniform(-6.2, 6.2), from = uniform(-3, 3);
    const auto on_ellipse = [&](double t) { return Point(p[0] + p[1] * std::cos(t) + p[2] * std::sin(t)); };
    ellipse.move_to(on_ellipse(from));
    ellipse.elliptic_to(p[0], p[1], p[2], from, sweep, on_ellipse(from + sweep));
    const Stroke cubic_line = cubic.take().at(0).points, ellipse_line = ellipse.take().at(0).points;
    for (double t = 0; t <= 1; t += 0.0137) {
      const double u = 1 - t;
      const Point on_cubic =
          u * u * u * p[0] + 3 * u * u * t * p[1] + 3 * u * t * t * p[2] + t * t * t * p[3];
      EXPECT_LE(distance_to_stroke(cubic_line, map * on_cubic), tolerance * (1 + 1e-6));
      EXPECT_LE(distance_to_stroke(ellipse_line, map * on_ellipse(from + t * sweep)), tolerance * (1 + 1e-6));
    }
  }
}

TEST(SvgReader, ArcsPassThroughBothEndsOnTheEllipseAskedFor) {
  std::mt19937_64 random(6);
  const auto uniform = [&](double a, double b) { return test::uniform(random, a, b); };
  for (int i = 0; i < 500; ++i) {
    const Point from(uniform(-9, 9), uniform(-9, 9)), to(uniform(-9, 9), uniform(-9, 9));
    const double rx = uniform(10, 20), ry = uniform(10, 20), turn = uniform(-3, 3);
    const bool large = random() % 2 == 0, positive = random() % 2 == 0;
    CurveFlattener curves(Eigen::Affine2d::Identity(), 1e-4);
    curves.move_to(from);
    draw_svg_arc(curves, rx, ry, turn, large, positive, to);
    const Stroke line = curves.take().at(0).points;
    EXPECT_EQ(line.front(), from);
    EXPECT_EQ(line.back(), to);
    // In the ellipse's axes, scaled to the unit circle: the arc turns one way all along, by more than pi if
    // large.
    double swept = 0;
    const auto unit = [&](const Point& p) {
      const Complex z = as_complex(p) * std::polar(1.0, -turn);
      return Point(z.real() / rx, z.imag() / ry);
    };
    double longest = 0;
    for (std::size_t j = 1; j + 1 < line.size(); ++j) {
      const Point a = unit(line[j]) - unit(line[j - 1]), b = unit(line[j + 1]) - unit(line[j]);
      swept += std::atan2(cross(a, b), a.dot(b));
      longest = std::max(longest, a.norm());
    }
    swept += (swept > 0 ? 1 : -1) * longest;
    EXPECT_EQ(swept > 0, positive);
    EXPECT_TRUE(std::abs(std::abs(swept) - pi) < 0.1 || (std::abs(swept) > pi) == large);
  }
}

TEST(SvgReader, FollowsUseWithinTheFileOnly) {
  expect_points(
      stroke("<defs><path id='p' d='M0 0H1'/></defs><use href='#p' x='5' y='6' transform='scale(2)'/>"),
      {{10, 38}, {12, 38}});
  expect_points(stroke("<symbol id='s' viewBox='0 0 2 2'><path d='M0 0H2'/></symbol><use xlink:href='#s' "
                       "width='10' height='10'/>"),
                {{0, 50}, {10, 50}});
  const StrokeDrawing drawing =
      drawn(page("<use href='other.svg#p'/><image href='http://example.org/x.png'/><image href='data:x'/>"));
  EXPECT_EQ(drawing.references, 2U);
  EXPECT_EQ(drawing.images, 2U);
  EXPECT_TRUE(drawing.strokes.empty());
}

TEST(SvgReader, DrawsOnlyWhatIsDisplayed) {
  EXPECT_TRUE(
      drawn(page("<g display='none'><path d='M0 0H1'/></g><path style='fill:none;display:none' d='M0 0H1'/>"
                 "<path visibility='hidden' d='M0 0H1'/><clipPath><path d='M0 0H1'/></clipPath>"
                 "<script>alert(1)</script><style>path{}</style><defs><path d='M0 0H1'/></defs>"))
          .strokes.empty());
}

TEST(SvgReader, SaysThatTextIsNoPath) {
  EXPECT_THAT(drawn(page("<text x='1' y='1'>Kempe</text><path d='M0 0H1'/>")).remark(),
              HasSubstr("1 text is not drawn"));
  const auto region = read_svg_region(page("<text>Kempe</text>"), "d.svg", {});
  ASSERT_FALSE(region);
  EXPECT_THAT(region.error().message(), HasSubstr("turn text into paths"));
}

TEST(SvgReader, RefusesEntityBombsAndOtherHostileFiles) {
  EXPECT_THAT(refusal("<?xml version='1.0'?><!DOCTYPE svg [<!ENTITY a \"aaaa\"><!ENTITY b "
                      "\"&a;&a;&a;\">]><svg>&b;</svg>"),
              HasSubstr("entities"));
  EXPECT_EQ(
      refusal("<!DOCTYPE svg [<!ENTITY ns_svg \"http://www.w3.org/2000/svg\">]><svg xmlns=\"&ns_svg;\"/>"),
      "");
  EXPECT_EQ(refusal("<!DOCTYPE svg [<!ENTITY secret SYSTEM "
                    "\"file:///etc/passwd\">]><svg><title>&secret;</title></svg>"),
            "");
  EXPECT_THAT(refusal("<svg><g></svg>"), HasSubstr("broken XML"));
  EXPECT_THAT(refusal("<svg><path d='M0 0H1'"), HasSubstr("broken XML"));
  EXPECT_THAT(refusal("<html/>"), HasSubstr("<html>"));
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal(std::string("\x00\x01\xff\xfe", 4)), "");
  EXPECT_THAT(refusal(page("<g id='a'><use href='#a'/></g>")), HasSubstr("nested deeper"));
  std::string deep = "<svg>";
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  EXPECT_THAT(refusal(deep + "</svg>"), HasSubstr("nested deeper"));
  std::string laughs = "<defs><path id='u0' d='M0 0H1'/>";
  for (int i = 1; i < 30; ++i) {
    const std::string use = "<use href='#u" + std::to_string(i - 1) + "'/>";
    laughs += "<g id='u" + std::to_string(i) + "'>" + use + use + use + "</g>";
  }
  EXPECT_THAT(refusal(page(laughs + "</defs><use href='#u29'/>")), HasSubstr("million elements"));
  std::string arcs;
  for (int i = 0; i < 20'000; ++i) arcs += "a1e6 1e6 0 1 1 1 1";
  EXPECT_THAT(refusal(page("<path d='M0 0" + arcs + "'/>")), HasSubstr("million points"));
  EXPECT_THAT(refusal(page("<path d='M0 0L1e9 0'/>")), HasSubstr("ten kilometres"));
  EXPECT_THAT(refusal("<svg width='wide'/>"), HasSubstr("width"));
  EXPECT_THAT(refusal("<svg viewBox='0 0 0 1'/>"), HasSubstr("viewBox"));
}

}  // namespace
}  // namespace kempe
