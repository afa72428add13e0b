#include <fmt/format.h>

#include "synthesis/search/diagnosis/relaxations.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

std::optional<Relaxation> without(Questions& questions, const std::vector<Obstacle>& left,
                                  const std::string& words) {
  Spec spec = questions.spec();
  spec.obstacles = left;
  const auto design = questions.best_of(spec);
  if (!design) return std::nullopt;
  return Relaxation{
      .key = "obstacles", .sentence = fmt::format("{} a design exists", words), .design = *design};
}

std::optional<Relaxation> without_one(Questions& questions, std::vector<Obstacle> left, std::size_t i) {
  const std::string name = left[i].name;
  left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  return without(questions, left, fmt::format("{} is in the way; without it", name));
}

}  // namespace

void relax_obstacles(Questions& questions) {
  const std::vector<Obstacle>& all = questions.task().space().spec().obstacles;  // no other is in the way
  if (all.empty() || questions.stopped()) return;
  questions.note("obstacles");
  if (all.size() == 1) return questions.keep(without_one(questions, all, 0));
  auto none_left = without(questions, {}, "the obstacles are in the way; without them");
  if (!none_left) return;
  std::size_t single = 0;
  for (std::size_t i = 0; i < all.size() && all.size() <= questions.budget().single_obstacles; ++i)
    if (auto one = without_one(questions, all, i)) {
      questions.keep(std::move(one));
      ++single;
    }
  if (single > 0) return;
  none_left->is_least = !questions.stopped();
  questions.keep(std::move(none_left));
}

void relax_bodies(Questions& questions) {
  const Spec& asked = questions.spec();
  const auto without_these = [&](const std::string& key, const Spec& spec, const std::string& words) {
    if (questions.stopped()) return;
    questions.note(key);
    if (const auto design = questions.best_of(spec))
      questions.keep(
          Relaxation{.key = key, .sentence = fmt::format("{} a design exists", words), .design = *design});
  };
  if (!asked.bodies.empty()) {
    Spec spec = asked;
    spec.bodies.clear();
    without_these("bodies", spec,
                  asked.bodies.size() == 1
                      ? fmt::format("{} is in the way; without it", body_name(asked.bodies, 0))
                      : "the bodies are in the way; without them");
  }
  if (asked.table) {
    Spec spec = asked;
    spec.table.reset();
    without_these("table", spec, "the table's edge is in the way; without it");
  }
}

}  // namespace kempe
