#include "reports/linkages/centres_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/linkages/json.hpp"

namespace kempe {
namespace {

/// What is said of one of the two lines of a centre, and the centres that it goes through.
struct LineWords {
  std::string words;
  std::vector<std::string> uses;
};

LineWords line_words(const LinkageModel& model, const std::map<int, int>& numbers,
                     const InstantCentre& centre, const CentreLine& line) {
  if (line.from == CentreLine::From::slider)
    return {"on the normal of " + constraint_label(model, *line.constraint), {}};
  if (line.from == CentreLine::From::no_turning)
    return {"at infinity, for the two links do not turn against each other", {}};
  const std::string one = centre_name(numbers, centre.first, *line.via),
                    other = centre_name(numbers, *line.via, centre.second);
  return {fmt::format("links {}, {}, {}: on the line through {} and {}", numbers.at(centre.first),
                      numbers.at(*line.via), numbers.at(centre.second), one, other),
          {one, other}};
}

CentreStep step_to(const LinkageModel& model, const std::map<int, int>& numbers,
                   const InstantCentre& centre) {
  CentreStep step{&centre, centre_name(numbers, centre.first, centre.second), {}, {}};
  if (centre.source != InstantCentre::Source::lines || !centre.lines) {
    step.reason = source_of(model, centre);
    return step;
  }
  for (const CentreLine& line : *centre.lines) {
    const LineWords found = line_words(model, numbers, centre, line);
    step.reason += (step.reason.empty() ? "" : "; ") + found.words;
    step.uses.insert(step.uses.end(), found.uses.begin(), found.uses.end());
  }
  return step;
}

}  // namespace

std::map<int, int> link_numbers(const std::vector<InstantCentre>& centres) {
  std::map<int, int> numbers;
  for (const InstantCentre& centre : centres)
    for (const int body : {centre.first, centre.second}) numbers.try_emplace(body, 0);
  int next = 1;
  for (auto& [body, number] : numbers) number = next++;
  return numbers;
}

std::string centre_name(const std::map<int, int>& numbers, int first, int second) {
  const auto [smaller, larger] = std::minmax(numbers.at(first), numbers.at(second));
  return fmt::format("{}-{}", smaller, larger);
}

std::vector<CentreStep> centre_steps(const LinkageModel& model, const std::vector<InstantCentre>& centres) {
  const std::map<int, int> numbers = link_numbers(centres);
  std::vector<CentreStep> open, steps;
  std::set<std::string> known;
  for (const InstantCentre& centre : centres) {
    CentreStep step = step_to(model, numbers, centre);
    if (centre.source == InstantCentre::Source::primary) {
      known.insert(step.name);
      steps.push_back(std::move(step));
    } else {
      open.push_back(std::move(step));
    }
  }
  const auto can_be_drawn = [&known](const CentreStep& step) {
    return step.centre->source == InstantCentre::Source::lines &&
           std::all_of(step.uses.begin(), step.uses.end(),
                       [&](const std::string& name) { return known.count(name) > 0; });
  };
  for (auto next = open.begin(); !open.empty();) {
    next = std::find_if(open.begin(), open.end(), can_be_drawn);
    if (next == open.end())  // the velocities give it, or nothing does
      next = std::find_if(open.begin(), open.end(), [](const CentreStep& step) {
        return step.centre->source != InstantCentre::Source::lines;
      });
    if (next == open.end()) next = open.begin();
    known.insert(next->name);
    steps.push_back(std::move(*next));
    open.erase(next);
  }
  return steps;
}

}  // namespace kempe
