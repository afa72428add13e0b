#include "tests/reports/report_specimens.hpp"

#include <cmath>

#include "synthesis/tolerance/copy_error.hpp"

namespace kempe::testing {
namespace {

ArcRegion annulus(const Point& centre, double inner, double outer) {
  return {{circle(centre, outer), {reversed(circle(centre, inner))}}};
}

ArcRegion annulus_of(const CopyingLinkage& linkage, const OpeningInterval& openings) {
  const auto radii = linkage.radii_over(openings);
  return annulus(linkage.pole(), radii.lower, radii.upper);
}

/// Between two radii and two angles.
ArcPolygon sector(const Point& centre, double inner, double outer, double from, double to) {
  constexpr int pieces = 4;
  const double bulge = std::tan((to - from) / pieces / 4);
  const auto at = [&](double radius, int i) -> Point {
    return centre + as_point(std::polar(radius, from + (to - from) * i / pieces));
  };
  ArcRing ring;
  for (int i = 0; i < pieces; ++i) ring.push_back({at(outer, i), bulge});
  ring.push_back({at(outer, pieces), 0});
  for (int i = pieces; i > 0; --i) ring.push_back({at(inner, i), -bulge});
  ring.push_back({at(inner, 0), 0});
  return {ring, {}};
}

Ring ellipse(const Point& centre, double a, double b, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    ring.push_back(centre + Point(a * std::cos(angle), b * std::sin(angle)));
  }
  return ring;
}

Ring rectangle(const Point& lower, const Point& size) {
  return {lower, lower + Point(size.x(), 0), lower + size, lower + Point(0, size.y())};
}

/// Everything that follows from linkage, style, limits and region, as far as a picture needs it.
Design design_of(const CopyingLinkage& linkage, double scale, double rotation, const Region& region,
                 const LinkStyle& style, double transmission) {
  Design design{.linkage = linkage};
  design.scale = scale;
  design.rotation = rotation;
  design.region = region;
  design.style = style;
  design.limits.transmission = transmission;
  design.opening = linkage.openings_with_transmission(transmission);
  const auto range = distance_range(region, linkage.pole());
  double least = pi / 2;
  for (const double radius : {range.nearest, range.farthest})
    if (const auto opening = linkage.opening_at(radius))
      least = std::min(least, linkage.transmission_angle(*opening));
  design.quality.size = linkage.size();
  design.quality.transmission_min = least;
  design.quality.clearance_min = 1.273;
  design.quality.footprint = 9137.5;
  WorkspaceMap& map = design.map;
  map.certified_opening = design.opening;
  map.reachable = annulus_of(linkage, linkage.assembly_mode().openings);
  map.usable = annulus_of(linkage, design.opening);
  map.collision_free = map.usable;
  const OpeningInterval whole = linkage.assembly_mode().openings;
  map.lost.push_back(
      {Cause::transmission_below_limit, {}, annulus_of(linkage, {whole.lower, design.opening.lower})});
  map.lost.push_back(
      {Cause::transmission_below_limit, {}, annulus_of(linkage, {design.opening.upper, whole.upper})});
  map.coverage.covered = true;
  map.clearance_min = 1.273;
  map.clearance_min_parts = "link VA and link BCY";
  map.clearance_min_at = region.polygons.front().outer.front();
  design.verification = {.samples = 2048,
                         .copy_error_max = 3.1e-13,
                         .loop_residual_max = 8.4e-14,
                         .scale = scale,
                         .rotation = rotation,
                         .flips = 0,
                         .holds = true};
  design.search = SearchRecord{.objective = Objective::size,
                               .value = linkage.size(),
                               .solvers = {"NLopt 2.7.1 SLSQP", "Ipopt 3.11.9"},
                               .evaluations = 48210,
                               .seed = 1};
  return design;
}

std::string part_svg(const char* outline) {
  return std::string("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 120 40\">") + outline +
         "</svg>";
}

}  // namespace

ReportSpecimen plagiograph_specimen() {
  const auto linkage = *CopyingLinkage::make(copy_ratio(1.4, pi / 2), Grounding::pole, 50, 35, 3);
  Region region{{Polygon{rectangle({64, -7}, {7, 14}), {}}}};
  ReportSpecimen specimen{
      "plagiograph",
      design_of(linkage, 1.4, pi / 2, region, {.width = 8, .pin_diameter = 4, .thickness = 3}, radians(15)),
      {}};
  Design& design = specimen.design;
  design.tolerance = Tolerance{0.05, 0.02};
  const auto error = *copy_error_over(linkage, CopyTolerance::uniform(*design.tolerance), region);
  design.quality.copy_error_worst = error.worst;
  design.quality.copy_error_rss = error.rss;
  design.quality.distortion_worst = error.distortion_worst;
  design.quality.proven_bound = linkage.size() * 0.985;
  design.limits.copy_error = 1.5;
  design.obstacles.push_back({Polygon{rectangle({20, 62}, {26, 14}), {}}, 1, 4, "side clamp"});
  // As if the obstacle took a bay out of the annulus: angles 0.9 to 1.5, and an uncertain sliver beside it.
  const auto radii = linkage.radii_over(design.opening);
  const ArcPolygon bay = sector(linkage.pole(), radii.lower, radii.upper, 0.9, 1.5);
  design.map.lost.push_back({Cause::obstacle_contact, {"link ACX", "side clamp"}, {bay}});
  design.map.uncertain = {sector(linkage.pole(), radii.lower, radii.upper, 1.5, 1.53)};
  design.map.collision_free = {sector(linkage.pole(), radii.lower, radii.upper, 1.53, 0.9 + 2 * pi)};
  design.map.largest_sheets = {{"A7", 10.5, 7.4, {67.5, 0}, 0}};
  specimen.extras = {
      .program_version = "0.1.0",
      .spec_name = "plagiograph.toml",
      .spec_text =
          "# The report's plagiograph\n[copy]\nscale = 1.4\nrotation_deg = 90\n\n[region]\nrectangle_mm = "
          "{at = [64, -7], size = [7, 14]}\n\n[pole]\nat_mm = [0, 0]\n",
      .pareto = ParetoFront{"size", "mm", "copy error", "mm", {}},
      .parts = {}};
  for (int i = 0; i < 9; ++i)
    specimen.extras.pareto->rows.push_back(
        {"design " + std::to_string(i + 1), 250.0 + 40 * i, 0.2 + 0.35 / (1 + i), i == 3});
  specimen.extras.parts = {
      {"VA.svg",
       part_svg("<path d='M0,-6H50A6,6 0 0 1 50,6H0A6,6 0 0 1 0,-6Z' fill='none' stroke='black'/>")},
      {"VB.svg",
       part_svg("<path d='M0,-6H35A6,6 0 0 1 35,6H0A6,6 0 0 1 0,-6Z' fill='none' stroke='black'/>")}};
  return specimen;
}

ReportSpecimen matlab_circle_specimen() {
  const auto linkage = *CopyingLinkage::make(copy_ratio(1.5, 0), Grounding::tracer, 40, 30, 1);
  ReportSpecimen specimen{"matlab-circle",
                          design_of(linkage, 1.5, 0, {{Polygon{ellipse({50, 50}, 10, 10, 96), {}}}},
                                    {.width = 5, .pin_diameter = 3, .thickness = 3}, radians(20)),
                          {}};
  specimen.design.search.reset();
  specimen.extras = {
      .program_version = "0.1.0",
      .spec_name = "matlab-circle.toml",
      .spec_text = "[copy]\nscale = 1.5\n\n[region]\ncircle_mm = {centre = [50, 50], radius = 10}\n",
      .pareto = {},
      .parts = {}};
  return specimen;
}

/// With a router at the pen, off its point, and with bodies that turn with links: a hand's grip at the tracer, a holder at the pen.
ReportSpecimen router_specimen() {
  ReportSpecimen specimen = matlab_circle_specimen();
  specimen.name = "router";
  specimen.design.bodies = {
      {Carrier::pen, Disc{{3, -4}, 6}, 3, 8, "router"},
      {Carrier::tracer, Polygon{{{-4, -3}, {9, -3}, {9, 4}, {2, 1}, {-4, 4}}, {}}, 1, 8, "grip", Link::VB},
      {Carrier::pen, Polygon{{{6, -2}, {14, -2}, {11, 7}}, {}}, 1, 2, "holder", Link::BCY}};
  return specimen;
}

ReportSpecimen half_turn_specimen() {
  const auto linkage =
      *CopyingLinkage::make(copy_ratio(1.0 / 3, pi), Grounding::pole, 210, 70, 1, {-40, -220});
  Region region{{Polygon{rectangle({-90, -60}, {60, 40}), {}}, Polygon{ellipse({20, -30}, 30, 22, 60), {}},
                 Polygon{rectangle({70, -55}, {30, 60}), {}}}};
  ReportSpecimen specimen{
      "half-turn",
      design_of(linkage, 1.0 / 3, pi, region, {.width = 14, .pin_diameter = 6, .thickness = 5}, radians(25)),
      {}};
  specimen.extras = {.program_version = "0.1.0",
                     .spec_name = "half-turn.toml",
                     .spec_text = "[copy]\nscale = 0.3333333333333333\nrotation_deg = 180\n",
                     .pareto = {},
                     .parts = {}};
  return specimen;
}

ReportSpecimen hostile_specimen() {
  const auto linkage = *CopyingLinkage::make(copy_ratio(1, pi / 3), Grounding::pen, 120, 110, 2, {10, 5});
  const Point at = linkage.tracer_at(linkage.assembly_mode().openings.middle(), 2.1);
  ReportSpecimen specimen{
      "hostile",
      design_of(linkage, 1, pi / 3, {{Polygon{ellipse(at, 20, 9, 40), {ellipse(at, 5, 5, 12)}}}},
                {.width = 12, .pin_diameter = 6, .thickness = 4, .plate = PlateStyle::triangle}, radians(12)),
      {}};
  Coverage& coverage = specimen.design.map.coverage;
  coverage.covered = false;
  coverage.why_not = "The region leaves the workspace near (12.3, 45.6): <b>links</b> touch & \"jam\".";
  coverage.witness = at;
  coverage.cause = Cause::self_contact;
  coverage.parts = {"link VA", "link BCY"};
  specimen.design.verification.holds = false;
  specimen.design.verification.failure = "<script>alert('failure')</script> the loop does not close";
  specimen.design.title = "</title><script>window.hostile = 1</script> \"quoted\" & 'single'";
  specimen.extras = {
      .program_version = "0.1.0<script>",
      .spec_name = "a b\"'<img src=x onerror=window.hostile=1>.toml",
      .spec_text = "# </pre><script>window.hostile = 1</script>\n<!-- <script> -->\n[copy]\nscale = 1\x01\n",
      .pareto =
          ParetoFront{"<b>size</b>",
                      "mm",
                      "x\" onload=\"window.hostile=1",
                      "\xc2\xb0",
                      {{"<i>one</i>", 1, 2, false}, {"</svg><script>window.hostile=1</script>", 2, 1, true}}},
      .parts = {{"<script>window.hostile=1</script>",
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                 "onload=\"parent.hostile=1\"><script>parent.hostile=1</script></svg>"}}};
  return specimen;
}

std::vector<ReportSpecimen> report_specimens() {
  return {plagiograph_specimen(), matlab_circle_specimen(), half_turn_specimen(), hostile_specimen(),
          router_specimen()};
}

}  // namespace kempe::testing
