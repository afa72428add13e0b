#include "reports/page/html_report.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>

#include "reports/page/sections.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/map_contours.hpp"
#include "reports/pictures/map_picture.hpp"
#include "tests/reports/report_specimens.hpp"

namespace kempe::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string report_of(const ReportSpecimen& specimen) {
  return html_report(specimen.design, specimen.extras);
}

/// The page without the scripts and styles that the build inlines: what is made of the design.
std::string without_assets(std::string page) {
  for (const char* tag : {"style", "script"}) {
    const std::string open = std::string("<") + tag, close = std::string("</") + tag + ">";
    for (auto from = page.find(open); from != std::string::npos; from = page.find(open, from)) {
      if (page.compare(from, 31, "<script type=\"application/json\"") == 0) {
        ++from;
        continue;
      }
      page.erase(from, page.find(close, from) + close.size() - from);
    }
  }
  return page;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(HtmlReport, NamesEveryLengthWithTheLettersOfTheDrawing) {
  const std::string page = report_of(plagiograph_specimen());
  for (const char* row : {"V – A</td><td class=\"number\">50.00<", "V – B</td><td class=\"number\">35.00<",
                          "A – C</td><td class=\"number\">35.00<", "B – C</td><td class=\"number\">50.00<",
                          "A – X</td><td class=\"number\">25.00<", "C – X</td><td class=\"number\">43.01<",
                          "B – Y</td><td class=\"number\">70.00<", "C – Y</td><td class=\"number\">86.02<"})
    EXPECT_THAT(page, HasSubstr(row));
  for (const char letter : {'V', 'A', 'B', 'C', 'X', 'Y'})
    EXPECT_THAT(page, HasSubstr(std::string("<tspan class=\"letter\">") + letter + "</tspan>"));
}

/// "to the left" of the way from one joint to the next, as the drawn pose has it.
std::string side_of(const Point& from, const Point& to, const Point& point) {
  return cross(to - from, point - from) > 0 ? "to the left" : "to the right";
}

TEST(HtmlReport, TellsHowToPutTheLinksTogetherAsTheyAreDrawn) {
  ReportSpecimen specimen = plagiograph_specimen();
  for (const Complex k : {Complex(0, 1.4), Complex(0, -1.4), std::polar(0.6, 2.0), std::polar(2.5, -1.0)})
    for (const Grounding grounding : all_groundings)
      for (const AssemblyMode& mode : assembly_modes(shape_of(k, grounding))) {
        const auto linkage = CopyingLinkage::make(k, grounding, 50, 35, mode.number);
        ASSERT_TRUE(linkage);
        specimen.design.linkage = *linkage;
        const Pose pose = linkage->pose_at(mode.openings.middle(), 0);
        EXPECT_THAT(
            report_sections::making(specimen.design),
            HasSubstr(fmt::format("going from V to A the bar VB lies {}, going from A to C the tip X {}, "
                                  "and going from B to C the tip Y {}.",
                                  side_of(pose.V, pose.A, pose.B), side_of(pose.A, pose.C, pose.X),
                                  side_of(pose.B, pose.C, pose.Y))));
      }
}

TEST(HtmlReport, DrawsTheHolesAsTheyAreDrilled) {
  ReportSpecimen specimen = plagiograph_specimen();
  Design& design = specimen.design;
  design.style = {.width = 40, .pin_diameter = 8, .thickness = 8};
  design.cutting.hole_fit = 0.1;
  const auto figure_of = [&](const std::string& link) {
    const std::string page = report_of(specimen);
    const auto from = page.find("aria-label=\"Link " + link + " with its dimensions\"");
    return page.substr(from, page.find("</figcaption>", from) - from);
  };
  design.hardware = {};
  EXPECT_THAT(figure_of("VA"), HasSubstr("holes of 8.1\u00a0mm for pins of 8\u00a0mm"));
  EXPECT_EQ(count_of(figure_of("VA"), "r=\"4.05\""), 2U);
  design.hardware = "608 bearing";
  EXPECT_THAT(figure_of("ACX"), HasSubstr("holes of 22\u00a0mm, each for a bearing 608 8 x 22 x 7"));
  EXPECT_EQ(count_of(figure_of("ACX"), "r=\"11\""), 3U);
  design.hardware = "M6 shoulder bolt";
  design.hardware.at[static_cast<std::size_t>(Joint::V)] = "608 bearing";
  const std::string bar = figure_of("VA");
  EXPECT_THAT(
      bar,
      HasSubstr("holes: V 22\u00a0mm for a bearing 608 8 x 22 x 7, A 8.1\u00a0mm for a pin of 8\u00a0mm"));
  EXPECT_EQ(count_of(bar, "r=\"11\"") + count_of(bar, "r=\"4.05\""), 2U);
}

TEST(HtmlReport, SaysWhatPassesAnEmptyLayer) {
  ReportSpecimen specimen = plagiograph_specimen();
  specimen.design.layers.of = {2, 3, 3, 2};
  const std::string page = report_of(specimen);
  EXPECT_THAT(page, HasSubstr("empty; pole post V, tracer X, pen Y pass"));
  EXPECT_THAT(page, HasSubstr("link VA, layer 2"));
}

TEST(HtmlReport, LoadsNothingFromElsewhere) {
  for (const ReportSpecimen& specimen : report_specimens()) {
    const std::string page = without_assets(report_of(specimen));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    EXPECT_THAT(page, Not(HasSubstr("unsafe-")));
    EXPECT_THAT(page, Not(HasSubstr("<link"))) << specimen.name;
    EXPECT_THAT(page, Not(HasSubstr("@import"))) << specimen.name;
    EXPECT_EQ(count_of(page, " src=\""), count_of(page, " src=\"data:image/svg+xml;base64,"))
        << specimen.name;
    const std::regex address(R"((href|url|src)\s*[=(]\s*["']?\s*(https?:)?//)");
    EXPECT_FALSE(std::regex_search(page, address)) << specimen.name;
  }
}

TEST(HtmlReport, EscapesEverythingFromOutside) {
  const std::string page = without_assets(report_of(hostile_specimen()));
  EXPECT_THAT(page, Not(HasSubstr("<script>")));
  EXPECT_THAT(page, Not(HasSubstr("<b>links")));
  EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(page, Not(HasSubstr("x\" onload")));
  EXPECT_THAT(page, HasSubstr("&lt;/pre&gt;&lt;script&gt;window.hostile = 1&lt;/script&gt;"));
  EXPECT_EQ(page.find('\x01'), std::string::npos);
}

TEST(HtmlReport, OfTheSameDesignHasTheSameBytes) {
  EXPECT_EQ(report_of(plagiograph_specimen()), report_of(plagiograph_specimen()));
}

TEST(HtmlReport, SaysWhatIsNotCoveredAndNotVerified) {
  const std::string page = report_of(hostile_specimen());
  EXPECT_THAT(page, HasSubstr("Region not covered"));
  EXPECT_THAT(page, HasSubstr("Not verified"));
  EXPECT_THAT(page, HasSubstr("The region leaves the workspace near (12.3, 45.6)"));
}

TEST(HtmlReport, OfAGivenLinkageHasNoSearch) {
  const std::string page = report_of(matlab_circle_specimen());
  EXPECT_THAT(page, HasSubstr("workspace of a given linkage"));
  EXPECT_THAT(page, Not(HasSubstr("id=\"search\"")));
  EXPECT_THAT(report_of(plagiograph_specimen()), HasSubstr("id=\"search\""));
}

TEST(HtmlReport, OfAMillionCornersStaysBelowTwoMegabytes) {
  ReportSpecimen specimen = plagiograph_specimen();
  Ring ring;
  constexpr int corners = 1000000;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    ring.push_back(Point(67.5, 0) +
                   (3 + 0.3 * std::sin(50000 * angle)) * Point(std::cos(angle), std::sin(angle)));
  }
  specimen.design.region = {{Polygon{ring, {}}}};
  specimen.extras.spec_text.assign(20000000, 'x');
  const std::string page = report_of(specimen);
  EXPECT_LT(page.size(), 2000000u);
  EXPECT_THAT(page, HasSubstr("bytes left out here"));
}

TEST(MapPicture, ShowsRegionCopyAndLinkageAndKnowsHowFarTheMapReaches) {
  for (const ReportSpecimen& specimen : report_specimens()) {
    const Design& design = specimen.design;
    const MapPicture picture = map_picture(design);
    const PictureView& view = picture.view;
    const auto inside = [&](const Point& at) {
      return at.x() > view.left && at.x() < view.left + view.width && -at.y() > view.top &&
             -at.y() < view.top + view.height;
    };
    const auto reach = design.linkage.radii_over(design.linkage.assembly_mode().openings);
    for (int i = 0; i < 360; ++i) {
      const Point at = design.linkage.pole() + as_point(std::polar(reach.upper, radians(i)));
      EXPECT_LE(((at - picture.whole.centre).cwiseAbs() - picture.whole.half).maxCoeff(), 1e-3 * reach.upper)
          << specimen.name;
    }
    for (const Region& region :
         {design.region, similar_image(design.region, design.linkage.k(), design.linkage.pole())})
      for (const Polygon& polygon : region.polygons)
        for (const Point& at : polygon.outer) EXPECT_TRUE(inside(at)) << specimen.name;
    const auto pose = design.linkage.pose_with_tracer_at(picture.tracer);
    ASSERT_TRUE(pose.has_value()) << specimen.name;
    for (const Joint joint : all_joints) EXPECT_TRUE(inside((*pose)[joint])) << specimen.name;
  }
}

TEST(MapPicture, HasASwitchForEveryLayerThatIsDrawn) {
  for (const ReportSpecimen& specimen : report_specimens()) {
    const MapPicture picture = map_picture(specimen.design);
    const std::string page = report_of(specimen);
    for (const MapLayer& layer : picture.layers) {
      EXPECT_THAT(picture.svg, HasSubstr("class=\"m-" + layer.id + "\"")) << specimen.name;
      EXPECT_THAT(page, HasSubstr("id=\"layer-" + layer.id + "\"")) << specimen.name;
      EXPECT_THAT(page, HasSubstr("#layer-" + layer.id + ":not(:checked)")) << specimen.name;
    }
  }
}

TEST(HtmlText, EncodesBase64AsTheStandardSays) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(HtmlText, ShowsFiguresThatItsDecimalsWouldRoundToZero) {
  EXPECT_EQ(force_text(12.345), "12.35\u00a0N");
  EXPECT_EQ(force_text(0.00123), "0.0012\u00a0N");
  EXPECT_EQ(force_text(0), "0\u00a0N");
  EXPECT_EQ(figure_text(0.00004, 4), "4e-05");
  EXPECT_EQ(figure_text(0.00006, 4), "0.0001");
  EXPECT_EQ(figure_text(1e-13, 4), "0");
  EXPECT_EQ(multiple_text(0.35, 0.05, 3), "0.35");
  EXPECT_EQ(multiple_text(0.0125, 0.0005, 3), "0.0125");
  EXPECT_EQ(multiple_text(0.012, 0.0005, 3), "0.012");
  EXPECT_EQ(multiple_text(1.05e-8, 5e-10, 3), "1.05e-08");
  EXPECT_EQ(multiple_text(1e-8, 5e-10, 3), "1e-08");
  EXPECT_EQ(multiple_text(0, 5e-10, 3), "0");
}

TEST(HtmlReport, SaysWhatTheHandHolds) {
  ReportSpecimen specimen = plagiograph_specimen();
  specimen.design.load = Load{.pen_force = 0.001};
  specimen.design.quality.loads = LoadFigures{.pin_force_max = 0.002, .hand_force_max = 0.0014};
  const std::string page = report_of(specimen);
  EXPECT_THAT(page, HasSubstr("The hand holds 0.0014\u00a0N against the pen's force"));
  EXPECT_THAT(page, HasSubstr("way under 0.001\u00a0N at"));
  EXPECT_THAT(page, Not(HasSubstr("holds 0 N")));
}

TEST(HtmlReport, NamesTheTolerancesThatThereAre) {
  ReportSpecimen specimen = plagiograph_specimen();
  const auto page_with = [&](double length, double play) {
    specimen.design.tolerance = Tolerance{.length = length, .play = play};
    return report_of(specimen);
  };
  EXPECT_THAT(page_with(0.1, 0.05), HasSubstr("Lengths to ±0.1\u00a0mm, pins with 0.05\u00a0mm of play"));
  EXPECT_THAT(page_with(0.1, 0), HasSubstr("Lengths to ±0.1\u00a0mm, pins without play."));
  EXPECT_THAT(page_with(0, 0.05), HasSubstr("Lengths as drawn, pins with 0.05\u00a0mm of play"));
  for (const auto& [length, play] : {std::pair{0.0, 0.05}, std::pair{0.1, 0.0}, std::pair{1e-5, 2e-5}})
    EXPECT_THAT(page_with(length, play), Not(HasSubstr("±0\u00a0mm")));
}

TEST(MapPicture, TellsTheLevelsOfItsContoursApart) {
  ReportSpecimen specimen = plagiograph_specimen();
  for (const double length : {0.1, 1e-3, 1e-5, 1e-7}) {
    specimen.design.tolerance = Tolerance{.length = length, .play = 0};
    const auto circles = copy_error_circles(specimen.design);
    ASSERT_GE(circles.size(), 3U);
    const double step = step_of_levels(circles);
    std::map<std::string, double> levels;
    for (const ContourCircle& circle : circles) {
      const auto [same, is_new] = levels.emplace(level_text(circle, step, 3), circle.level);
      EXPECT_NEAR(same->second, circle.level, 1e-9 * circle.level) << same->first;
    }
    for (const auto& [words, level] : levels) EXPECT_LT(words.size(), 13U) << words;
  }
}

TEST(HtmlText, WritesLargeAreasInSquareMetres) {
  EXPECT_EQ(area_text(91608840), "91.61\u00a0m²");
  EXPECT_EQ(area_text(9.99e6), "99900\u00a0cm²");
  EXPECT_EQ(area_text(5320), "53.2\u00a0cm²");
  EXPECT_EQ(area_text(53.2), "53.2\u00a0mm²");
  EXPECT_EQ(AreaUnit(5e8).text(123400), "0.1234\u00a0m²");
  EXPECT_EQ(AreaUnit(5e8).text(1), "< 0.0001\u00a0m²");
}

TEST(HtmlReport, SaysWhichLimitsTheCertifiedOpeningKeeps) {
  ReportSpecimen specimen = plagiograph_specimen();
  specimen.design.quality.copy_error_worst = 0.4;
  specimen.design.quality.copy_error_at_corner = 0.6;
  specimen.design.limits.copy_error = 0.5;
  const std::string page = report_of(specimen);
  EXPECT_THAT(page, Not(HasSubstr("every limit is kept")));
  EXPECT_THAT(page, HasSubstr("over which the limits on transmission angle and clearance are kept"));
  EXPECT_THAT(page, HasSubstr("<dt>Copy error at worst</dt><dd><b class=\"bad\">0.6\u00a0mm</b><small>limit "
                              "0.5\u00a0mm; 0.4\u00a0mm to the first order</small>"));
  specimen.design.limits.copy_error = 0.7;
  EXPECT_THAT(report_of(specimen), HasSubstr("<dt>Copy error at worst</dt><dd>0.6\u00a0mm<small>limit "
                                             "0.7\u00a0mm; 0.4\u00a0mm to the first order</small>"));
}

TEST(HtmlText, WritesNumbersAsAPersonWould) {
  EXPECT_EQ(number_text(50, 3), "50");
  EXPECT_EQ(number_text(-7.5, 3), "\u22127.5");
  EXPECT_EQ(number_text(-1e-9, 3), "0");
  EXPECT_EQ(count_text(1234567), "1\u202f234\u202f567");
  EXPECT_EQ(residual_text(3.1e-13), "3.1·10⁻¹³\u00a0mm");
  EXPECT_EQ(residual_text(0), "0\u00a0mm");
  EXPECT_EQ(residual_text(9.99e-5), "1·10⁻⁴\u00a0mm");
}

}  // namespace
}  // namespace kempe::testing
