#include "tests/metamorphic/laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kempe::metamorphic {
namespace {

/// A limit may be missed by so much of itself: what rounding the task's own coordinates does to it.
constexpr double rounding = 1e-7;

/// In the task's own unit. Larger is worse.
double worth(const FoundDesign& design, double unit) {
  switch (design.goal) {
    case Goal::transmission: return -design.value;
    case Goal::footprint: return design.value / (unit * unit);
    default: return design.value / unit;
  }
}

bool is_worse(double worth, double than) { return worth > than + as_good * std::abs(than) + 1e-12; }

/// What is proven of designs that keep the limits of `proof`, against a design that does. `unit`: mm of the proof a mm of it.
std::vector<Finding> beaten(const Task& task, const Answer& proof, const FoundDesign& design, double unit,
                            const std::string& law) {
  if (proof.proven_none) return {{true, law, "proven that there is no design, but there is one", {task}}};
  std::vector<Finding> findings;
  const bool exact =
      std::abs(design.linkage.k() - proof.spec.copy.k()) <= 1e-12 * std::abs(proof.spec.copy.k());
  const double size = unit * design.linkage.size(), transmission = design.attained.transmission;
  if (exact && proof.least_size && size < *proof.least_size * (1 - rounding))
    findings.push_back(
        {true, law, fmt::format("size {} below the bound {}", size, *proof.least_size), {task}});
  // What of the transmission angle was not demanded was perhaps not evaluated: only the goal's own value is sure.
  if (exact && proof.most_transmission && design.goal == Goal::transmission &&
      transmission > *proof.most_transmission + rounding)
    findings.push_back(
        {true,
         law,
         fmt::format("transmission {} above the bound {}", transmission, *proof.most_transmission),
         {task}});
  return findings;
}

void add(std::vector<Finding>& findings, std::vector<Finding> more, const Task& other) {
  for (Finding& finding : more) {
    finding.tasks.push_back(other);
    findings.push_back(std::move(finding));
  }
}

/// The looser task's design may be as good as this one, but no worse.
std::vector<Finding> lost(const Answer& tighter, const Answer& looser, double unit, const std::string& law) {
  if (!tighter.design || !tighter.complete || !looser.complete) return {};
  if (!looser.design) return {{false, law, "no design found, but there is one", {}}};
  const double here = worth(*tighter.design, 1), there = worth(*looser.design, unit);
  if (!is_worse(there, here)) return {};
  return {
      {false,
       law,
       fmt::format("{} instead of {}, {:.2f} % worse", there, here, 100 * (there - here) / std::abs(here)),
       {}}};
}

}  // namespace

std::vector<Finding> check_alone(const Task& task, const Answer& answer) {
  if (!answer.design) return {};
  std::vector<Finding> findings = beaten(task, answer, *answer.design, 1, "own bound");
  Spec spec = answer.spec;
  spec.copy = Copy::of(answer.design->linkage.k());  // with a grid of lengths it may be off
  const std::string missed = limit_missed(spec, answer.design->linkage, answer.design->layers, rounding);
  if (!missed.empty()) findings.push_back({true, "own limits", "the design found misses " + missed, {task}});
  return findings;
}

std::vector<Finding> check_pair(const Task& task, const Answer& answer, const std::string& law,
                                const ChangedTask& changed, const Answer& other) {
  std::vector<Finding> findings;
  const double unit = changed.unit;
  if (changed.relation != Relation::looser) {  // the changed task's designs are all designs of the task
    if (other.design) add(findings, beaten(task, answer, *other.design, 1 / unit, law), changed.task);
    add(findings, lost(other, answer, 1 / unit, law), task);
  }
  if (changed.relation != Relation::tighter) {  // and the other way round
    if (answer.design) add(findings, beaten(changed.task, other, *answer.design, unit, law), task);
    add(findings, lost(answer, other, unit, law), task);
  }
  for (Finding& finding : findings)
    if (!finding.is_false_proof) finding.tasks = {task, changed.task};
  return findings;
}

}  // namespace kempe::metamorphic
