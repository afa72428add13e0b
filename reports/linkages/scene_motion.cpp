#include "reports/linkages/scene_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "kinematics/planar/rates.hpp"

namespace kempe {
namespace {

constexpr double no_turning = 1e-9;  ///< of the fastest: what is slower stands still all the time

bool drives_angle(const LinkageModel& model, std::size_t driver) {
  const auto number = static_cast<std::size_t>(model.linkage.drivers()[driver]);
  return std::holds_alternative<RelativeAngle>(model.linkage.constraints()[number].constraint);
}

/// x, y and angle of a link's frame, from the rates of all unknowns; y and angle as the page has them.
std::array<double, 3> frame_rate(const Eigen::VectorXd& rates, int body, double unit) {
  const Eigen::Index first = 3 * (body - 1);
  return {rates[first] / unit, -rates[first + 1] / unit, -rates[first + 2]};
}

/// Where a rate changes its sign, as a place among the moments (2.5: half way between the third and the fourth). A motion that runs
/// around may turn back at its start.
std::vector<double> turning_places(const std::vector<std::optional<double>>& rate, double least,
                                   bool closed) {
  std::vector<double> places;
  std::optional<std::size_t> before;
  const auto sign = [&](std::size_t i) {
    return rate[i] && std::abs(*rate[i]) > least ? (*rate[i] > 0 ? 1 : -1) : 0;
  };
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < rate.size(); ++i) {
    if (sign(i) == 0) continue;
    if (!first) first = i;
    if (before && sign(*before) != sign(i))
      places.push_back(i == *before + 1
                           ? static_cast<double>(*before) + *rate[*before] / (*rate[*before] - *rate[i])
                           : 0.5 * static_cast<double>(*before + i));
    before = i;
  }
  if (closed && first && before && *first > 0 && sign(*first) != sign(*before))
    places.insert(places.begin(), 0);
  return places;
}

class MarkFinder {
 public:
  MarkFinder(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run, LinkageScene& scene)
      : file_(file), model_(model), run_(run), scene_(scene) {}

  void add_all() {
    if (model_.linkage.drivers().size() == 1) {
      add_links();
      for (std::size_t i = 0; i < file_.sliders.size(); ++i) add_slider(i);
    }
    std::sort(scene_.marks.begin(), scene_.marks.end(),
              [](const SceneMark& a, const SceneMark& b) { return a.moment < b.moment; });
    join_equal_places();
    if (run_.stop) {
      std::string words = std::string(kempe::name(run_.stop->end));
      const char* between = ": ";
      for (const std::string& sentence : run_.stop->sentences)
        words += std::exchange(between, "; ") + sentence;
      scene_.marks.push_back({static_cast<double>(run_.frames.size() - 1), -1, words});
    }
  }

 private:
  std::vector<std::optional<double>> over_frames(const std::function<double(const RunFrame&)>& rate) const {
    std::vector<std::optional<double>> values;
    for (const RunFrame& frame : run_.frames)
      values.push_back(frame.rate.size() > 0 ? std::optional(rate(frame)) : std::nullopt);
    return values;
  }

  static double fastest_of(const std::vector<std::optional<double>>& rate) {
    double most = 0;
    for (const auto& value : rate) most = std::max(most, std::abs(value.value_or(0)));
    return most;
  }

  /// "OA turns back", "BCY turns back" at one place: "OA, BCY turn back"; the ghosts of all stay.
  void join_equal_places() {
    constexpr std::string_view one = " turns back", many = " turn back";
    for (std::size_t i = 0; i < scene_.marks.size(); ++i) {
      if (scene_.marks[i].words.empty()) continue;
      std::string names = scene_.marks[i].words.substr(0, scene_.marks[i].words.size() - one.size());
      bool joined = false;
      for (std::size_t j = i + 1; j < scene_.marks.size(); ++j) {
        if (scene_.marks[j].words.empty() || scene_.marks[j].moment - scene_.marks[i].moment > 1e-3) continue;
        names += ", " + scene_.marks[j].words.substr(0, scene_.marks[j].words.size() - one.size());
        scene_.marks[j].words.clear();
        joined = true;
      }
      if (joined) scene_.marks[i].words = names + std::string(many);
    }
  }

  void add_links() {
    std::vector<std::pair<int, std::vector<std::optional<double>>>> spins;
    double fastest = 0;
    for (const FileLink& link : file_.links) {
      const int body = model_.body(link.name);
      spins.emplace_back(body, over_frames([body](const RunFrame& f) { return spin_of(f.rate, body); }));
      fastest = std::max(fastest, fastest_of(spins.back().second));
    }
    for (const auto& [body, spin] : spins)
      if (fastest_of(spin) > no_turning * fastest) add(body, spin, model_.linkage.body_name(body));
  }

  /// Of a slider on the ground.
  void add_slider(std::size_t number) {
    const FileSlider& slider = file_.sliders[number];
    if (model_.body(slider.line.link) != PlanarLinkage::ground) return;
    const BodyPoint guided = slider.point.empty() ? BodyPoint{model_.body(slider.link), Point::Zero()}
                                                  : model_.point(slider.point);
    const Point along(std::cos(slider.line.direction), std::sin(slider.line.direction));
    const auto speed =
        over_frames([&](const RunFrame& f) { return along.dot(velocity_of(f.position, f.rate, guided)); });
    if (fastest_of(speed) > 0) add(guided.body, speed, slider.name());
  }

  void add(int body, const std::vector<std::optional<double>>& rate, const std::string& name) {
    for (const double place : turning_places(rate, no_turning * fastest_of(rate), scene_.closed))
      scene_.marks.push_back({place, body, name + " turns back"});
  }

  const LinkageFile& file_;
  const LinkageModel& model_;
  const PlanarRun& run_;
  LinkageScene& scene_;
};

std::string row_or_null(const std::vector<double>& row) {
  if (row.empty()) return "null";
  std::string text;
  for (const double value : row) text += fmt::format("{}{:.10g}", text.empty() ? "[" : ",", value);
  return text + "]";
}

}  // namespace

void add_scene_motion(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run, int steps,
                      LinkageScene& scene) {
  const double unit = file.unit.in_mm;
  scene.seconds_a_step = file.duration / steps;
  scene.links = static_cast<std::size_t>(model.linkage.body_count());
  for (std::size_t driver = 0; driver < model.linkage.drivers().size(); ++driver)
    scene.driven.push_back(
        {model.driver_label(static_cast<int>(driver)), drives_angle(model, driver) ? "deg" : file.unit.name});
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const RunFrame& frame = run.frames[i];
    LinkageScene::Moment& moment = scene.moments[i];
    for (std::size_t driver = 0; driver < scene.driven.size(); ++driver)
      moment.driven.push_back(drives_angle(model, driver) ? degrees(frame.values[driver])
                                                          : frame.values[driver] / unit);
    if (frame.rate.size() == 0) continue;
    for (int body = 1; body < model.linkage.body_count(); ++body)
      for (const Eigen::VectorXd* rates : {&frame.rate, &frame.second})
        for (const double value : frame_rate(*rates, body, unit)) moment.rates.push_back(value);
  }
  MarkFinder(file, model, run, scene).add_all();
}

std::string scene_motion_json(const LinkageScene& scene) {
  nlohmann::ordered_json head{{"links", scene.links}, {"seconds_a_step", scene.seconds_a_step}};
  for (const char* list : {"names", "bodies", "drivers", "marks"})
    head[list] = nlohmann::ordered_json::array();
  for (const ScenePoint& point : scene.points) head["names"].push_back(point.name);
  for (std::size_t body = 0; body < scene.links; ++body) head["bodies"].push_back(scene.bodies[body].name);
  for (const LinkageScene::Driver& driver : scene.driven)
    head["drivers"].push_back({driver.label, driver.unit});
  for (const SceneMark& mark : scene.marks)
    if (!mark.words.empty()) head["marks"].push_back({{"at", mark.moment}, {"words", mark.words}});
  std::string text = head.dump();
  text.pop_back();
  text += ",\"values\":[";
  for (std::size_t i = 0; i < scene.moments.size(); ++i)
    text += (i ? "," : "") + row_or_null(scene.moments[i].driven);
  text += "],\"rates\":[";
  for (std::size_t i = 0; i < scene.moments.size(); ++i)
    text += (i ? ",\n" : "") + row_or_null(scene.moments[i].rates);
  return text + "]}";
}

}  // namespace kempe
