#include "reports/linkages/path_answers.hpp"

#include <fmt/format.h>

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
  object["active_limits"] = nlohmann::ordered_json::array();
  for (const ActiveLimit& limit : answer.active) {
    nlohmann::ordered_json one{{"key", limit.key}};
    if (!limit.what.empty()) one["what"] = limit.what;
    object["active_limits"].push_back(std::move(one));
  }
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

const char* pole_words(CopyPole pole) {
  return pole == CopyPole::crank_pivot ? "crank_pivot" : "rocker_pivot";
}

nlohmann::ordered_json as_json(const CopyTask& task, const tl::expected<CouplerCopy, std::string>& copy) {
  nlohmann::ordered_json object{{"scale", task.scale}, {"rotation_deg", degrees(task.rotation)}};
  if (!copy) {
    object["why_not"] = copy.error();
    return object;
  }
  object["pole"] = pole_words(copy->pole);
  object["pole_mm"] =
      as_json(copy->pole == CopyPole::crank_pivot ? copy->linkage.crank_pivot : copy->linkage.rocker_pivot);
  object["four_bar"] = as_json(copy->linkage);
  object["coupler_joint_mm"] = as_json(copy->coupler_joint);
  object["arm_mm"] = copy->arm;
  object["link_mm"] = copy->link;
  object["copy_point_mm"] = as_json(copy->copy_point);
  for (const Point& p : copy->copied) object["copied_mm"].push_back(as_json(p));
  object["error_max_mm"] = copy->error_max;
  object["parallelogram_min_deg"] = degrees(copy->parallelogram_min);
  return object;
}

void add_copy(const CopiesOfAnswers& copies, std::size_t k, nlohmann::ordered_json& answer) {
  if (k < copies.copies.size()) answer["copy"] = as_json(copies.task, copies.copies[k]);
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
  task.motions = spec.motions;
  task.crank_pivot = spec.crank_pivot;
  task.ground_angle = spec.ground_angle;
  task.first_angle = spec.first_angle;
  return task;
}

PoseTask pose_task(const PathSpec& spec) {
  return {spec.poses, spec.longest, spec.transmission, spec.pivots_within, spec.motions};
}

std::vector<PlaceAskedFor> wanted_places(const PathTask& task, const PathAnswer& answer) {
  const double first = answer.crank_angles.front(), whole = answer.crank_angles.back() - first;
  std::vector<PlaceAskedFor> places;
  for (std::size_t i = 0; i < task.points.size(); ++i)
    places.push_back({task.points[i], answer.reached[i], std::nullopt, std::nullopt,
                      whole != 0 ? (answer.crank_angles[i] - first) / whole : 0});
  return places;
}

std::vector<PlaceAskedFor> wanted_places(const PoseTask& task, const PoseAnswer& answer) {
  PathTask points;
  for (const BodyPlacement& pose : task.poses) points.points.push_back(pose.at);
  std::vector<PlaceAskedFor> places = wanted_places(points, answer.path);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i].angle = task.poses[i].angle;
    places[i].reached_angle = answer.angles[i];
  }
  return places;
}

std::vector<PlaceAskedFor> of_a_cognate(std::vector<PlaceAskedFor> wanted) {
  for (PlaceAskedFor& place : wanted) place.angle = place.reached_angle = std::nullopt;
  return wanted;
}

bool is_used(const PoseSearch& search, const Dyad& dyad) {
  return std::any_of(search.dyads.begin(), search.dyads.end(), [&](const Dyad& used) {
    return used.centre == dyad.centre && used.circle == dyad.circle;
  });
}

std::string path_json(const PoseTask& task, const PoseSearch& search, const CopiesOfAnswers& copies) {
  nlohmann::ordered_json object;
  for (std::size_t k = 0; k < search.answers.size(); ++k) {
    const PoseAnswer& answer = search.answers[k];
    nlohmann::ordered_json one = as_json(answer.path);
    one["reached_deg"] = angles_in_degrees(answer.angles);
    one["error_angle_max_deg"] = degrees(answer.error_angle);
    add_copy(copies, k, one);
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

std::string path_json(const PathSearch& search, const CopiesOfAnswers& copies) {
  nlohmann::ordered_json object;
  for (std::size_t k = 0; k < search.answers.size(); ++k) {
    nlohmann::ordered_json one = as_json(search.answers[k]);
    add_copy(copies, k, one);
    object["answers"].push_back(std::move(one));
  }
  object["bound"] = no_path_bound;
  object["searched"] = {{"starts", search.effort.starts},
                        {"refined", search.effort.refined},
                        {"evaluations", search.effort.evaluations},
                        {"rejected", search.effort.rejected}};
  return object.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::optional<CopyPole> copy_pole_named(std::string_view word) {
  if (word == "crank") return CopyPole::crank_pivot;
  if (word == "rocker") return CopyPole::rocker_pivot;
  return std::nullopt;
}

CopiesOfAnswers copies_of(const std::vector<PathAnswer>& answers, const std::optional<CopyTask>& task,
                          int cognate) {
  CopiesOfAnswers made{task.value_or(CopyTask{}), {}};
  if (!task) return made;
  for (const PathAnswer& answer : answers)
    if (cognate == 0)
      made.copies.push_back(copy_on_coupler(answer, std::nullopt, *task));
    else if (answer.cognates)
      made.copies.push_back(copy_on_coupler(answer, static_cast<std::size_t>(cognate - 1), *task));
    else
      made.copies.push_back(
          tl::unexpected(std::string("the coupler point lies on a joint: there is no cognate")));
  return made;
}

std::string copy_text(const CopyTask& task, const tl::expected<CouplerCopy, std::string>& copy) {
  const std::string what = fmt::format("  copy at {:.6g} times the size, turned by {:.6g} degrees",
                                       task.scale, degrees(task.rotation));
  if (!copy) return what + ": none; " + copy.error() + "\n";
  return what + fmt::format(
                    " about the {}\n"
                    "  C on the coupler {:.6g} along, {:.6g} to the left; arm {:.6g}, link Q-C {:.6g}; "
                    "copying point {:.6g} along, "
                    "{:.6g} to the left\n"
                    "  parallelogram {:.3f} degrees from flat at least; off by {:.2g} mm at most\n",
                    copy->pole == CopyPole::crank_pivot ? "crank's pivot" : "rocker's pivot",
                    copy->coupler_joint.x(), copy->coupler_joint.y(), copy->arm, copy->link,
                    copy->copy_point.x(), copy->copy_point.y(), degrees(copy->parallelogram_min),
                    copy->error_max);
}

}  // namespace kempe
