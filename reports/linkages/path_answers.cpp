#include "reports/linkages/path_answers.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace kempe {
namespace {

nlohmann::ordered_json as_json(const Point& p) { return {p.x() + 0.0, p.y() + 0.0}; }

nlohmann::ordered_json as_json(const CouplerFourBar& bar) {
  nlohmann::ordered_json pivots;
  pivots.push_back(as_json(bar.crank_pivot));
  pivots.push_back(as_json(bar.rocker_pivot));
  return {{"pivots_mm", pivots},
          {"crank_mm", bar.crank},
          {"coupler_mm", bar.coupler},
          {"rocker_mm", bar.rocker},
          {"coupler_point_mm", as_json(bar.coupler_point)},
          {"assembly_mode", bar.branch == FourBarBranch::first ? 1 : 2}};
}

nlohmann::ordered_json angles_in_degrees(const std::vector<double>& angles, double offset = 0) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const double angle : angles) list.push_back(degrees(angle + offset));
  return list;
}

nlohmann::ordered_json as_json(const PathAnswer& answer) {
  nlohmann::ordered_json object = as_json(answer.linkage);
  object["motion"] = std::string(name(answer.linkage.links().motion()));
  object["driver_deg"] = angles_in_degrees(answer.crank_angles);
  for (const Point& p : answer.reached) object["reached_mm"].push_back(as_json(p));
  object["error_rms_mm"] = answer.error_rms;
  object["error_max_mm"] = answer.error_max;
  object["lower_bound_mm"] = nullptr;
  object["transmission_min_deg"] = degrees(answer.transmission_min);
  object["cognates"] = nlohmann::ordered_json::array();
  if (answer.cognates)
    for (const Cognate& cognate : *answer.cognates) {
      nlohmann::ordered_json other = as_json(cognate.linkage);
      other["driver"] = cognate.driver == CognateDriver::crank ? "crank" : "coupler";
      other["driver_deg"] = angles_in_degrees(answer.crank_angles, cognate.offset);
      object["cognates"].push_back(std::move(other));
    }
  return object;
}

}  // namespace

PathTask path_task(const PathSpec& spec) {
  PathTask task;
  task.points = spec.points;
  task.turns = spec.turns;
  task.aim = spec.largest_distance ? PathAim::largest_distance : PathAim::mean_square;
  task.longest = spec.longest;
  task.transmission = spec.transmission;
  task.pivots_within = spec.pivots_within;
  return task;
}

PoseTask pose_task(const PathSpec& spec) {
  return {spec.poses, spec.longest, spec.transmission, spec.pivots_within};
}

bool is_used(const PoseSearch& search, const Dyad& dyad) {
  return std::any_of(search.dyads.begin(), search.dyads.end(), [&](const Dyad& used) {
    return used.centre == dyad.centre && used.circle == dyad.circle;
  });
}

std::string path_json(const PoseTask& task, const PoseSearch& search) {
  nlohmann::ordered_json object;
  for (const PoseAnswer& answer : search.answers) {
    nlohmann::ordered_json one = as_json(answer.path);
    one["reached_deg"] = angles_in_degrees(answer.angles);
    one["error_angle_max_deg"] = degrees(answer.error_angle);
    object["answers"].push_back(std::move(one));
  }
  object["bound"] = no_path_bound;
  if (task.poses.size() == 5)
    for (const Dyad& dyad : burmester_dyads(task.poses))
      object["dyads"].push_back({{"centre_mm", as_json(dyad.centre)},
                                 {"circle_point_mm", as_json(dyad.circle)},
                                 {"length_mm", dyad.length},
                                 {"within_limits", is_used(search, dyad)}});
  object["searched"] = {{"dyads", search.dyads.size()},
                        {"linkages", search.linkages},
                        {"defective", search.defective},
                        {"limited", search.limited}};
  return object.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string path_json(const PathSearch& search) {
  nlohmann::ordered_json object;
  for (const PathAnswer& answer : search.answers) object["answers"].push_back(as_json(answer));
  object["bound"] = no_path_bound;
  object["searched"] = {{"starts", search.effort.starts},
                        {"refined", search.effort.refined},
                        {"evaluations", search.effort.evaluations},
                        {"rejected", search.effort.rejected}};
  return object.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace kempe
