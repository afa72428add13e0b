// kempe_report_specimens FOLDER: writes, for the browser tests, each specimen's report and beside it
// positions that the library has computed, for the page's own kinematics to be compared with.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "reports/data/atomic_file.hpp"
#include "tests/random.hpp"
#include "tests/reports/report_specimens.hpp"
#include "workspace/contact/contact_scene.hpp"
#include "workspace/contact/self_contact.hpp"

namespace {

using Json = nlohmann::ordered_json;
using kempe::testing::ReportSpecimen;

Json point(const kempe::Point& at) { return {at.x(), at.y()}; }

std::string why(kempe::Unreachable reason) {
  switch (reason) {
    case kempe::Unreachable::too_far: return "too far";
    case kempe::Unreachable::too_near: return "too near";
    case kempe::Unreachable::beyond_change_point: break;
  }
  return "beyond the change point";
}

Json position(const ReportSpecimen& specimen, const kempe::ContactScene& scene, const kempe::Point& tracer) {
  const kempe::Design& design = specimen.design;
  const kempe::CopyingLinkage& linkage = design.linkage;
  const kempe::Point reach = tracer - linkage.pole();
  const auto opening = linkage.opening_at(reach.norm());
  if (!opening) return {{"tracer", point(tracer)}, {"why", why(opening.error())}};
  const kempe::Pose pose = *linkage.pose_with_tracer_at(tracer);
  Json points = Json::array(), gaps = Json::array();
  for (const kempe::Joint joint : kempe::all_joints) points.push_back(point(pose[joint]));
  for (const auto& pair : kempe::contact_pairs(linkage, design.layers))
    gaps.push_back(kempe::gap(pair, pose, linkage.shape(), design.style));
  const double nearest = kempe::tightest_obstacle(scene, *opening, std::atan2(reach.y(), reach.x())).gap;
  return {{"tracer", point(tracer)},
          {"opening", *opening},
          {"transmission", linkage.transmission_angle(*opening)},
          {"scale", linkage.size()},
          {"pose", points},
          {"gaps", gaps},
          {"obstacle_gap", std::isfinite(nearest) ? Json(nearest) : Json()}};
}

/// Places over the reach and a little beyond it.
std::string positions(const ReportSpecimen& specimen) {
  const kempe::Design& design = specimen.design;
  const kempe::CopyingLinkage& linkage = design.linkage;
  const kempe::ContactScene scene(
      {.linkage = linkage,
       .style = design.style,
       .layers = design.layers,
       .limits = {.clearance = 1e6, .transmission = 0},  // nothing is too far to count
       .obstacles = design.obstacles,
       .bodies = design.bodies,
       .table = design.table});
  const auto radii = linkage.radii_over(linkage.assembly_mode().openings);
  std::mt19937_64 random(11);
  const auto uniform = [&] { return kempe::test::share(random); };
  Json all = Json::array();
  for (int i = 0; i < 300; ++i) {
    const double radius = 0.9 * radii.lower + (1.1 * radii.upper - 0.9 * radii.lower) * uniform();
    all.push_back(position(specimen, scene,
                           linkage.pole() + kempe::as_point(std::polar(radius, 2 * kempe::pi * uniform()))));
  }
  return all.dump();
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: kempe_report_specimens FOLDER\n", stderr);
    return 2;
  }
  std::vector<kempe::OutputFile> files;
  for (const ReportSpecimen& specimen : kempe::testing::report_specimens()) {
    files.push_back({specimen.name + ".html", kempe::html_report(specimen.design, specimen.extras)});
    files.push_back({specimen.name + ".positions.json", positions(specimen)});
  }
  if (const auto written = kempe::write_whole(arguments[1], files); !written) {
    std::fprintf(stderr, "%s\n", written.error().c_str());
    return 1;
  }
  return 0;
}
