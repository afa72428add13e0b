#include "tests/metamorphic/answer.hpp"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

#include "tests/synthesis/kept_limits.hpp"
#include "workspace/reach.hpp"

namespace kempe::metamorphic {
namespace {

/// Sets a flag when the thread that made it has worked for so many seconds, whatever else the machine does.
class WorkLimit {
 public:
  explicit WorkLimit(double seconds) {
    clockid_t clock{};
    pthread_getcpuclockid(pthread_self(), &clock);
    const double end = seconds_of(clock) + seconds;
    watch_ = std::jthread([this, clock, end](const std::stop_token& ended) {
      while (!ended.stop_requested() && seconds_of(clock) < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      reached_ = true;
    });
  }
  const std::atomic<bool>* reached() const { return &reached_; }

 private:
  static double seconds_of(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  std::atomic<bool> reached_{false};
  std::jthread watch_;
};

/// The best design that a bound met on its way, if the map says that it keeps all limits.
std::optional<FoundDesign> design_of(const Spec& spec, Objective objective, const ProvenBound& bound) {
  if (!bound.design) return std::nullopt;
  const RelaxedDesign& met = *bound.design;
  const auto linkage =
      CopyingLinkage::make(spec.copy.k(), met.grounding, met.VA, met.VB, met.assembly_mode, met.pole);
  if (!linkage || !limit_missed(spec, *linkage, met.layers, 1e-9).empty()) return std::nullopt;
  const auto openings = openings_over(*linkage, spec.region);
  FoundDesign found{.linkage = *linkage, .layers = met.layers, .goal = goal_of(objective), .complete = false};
  found.attained.transmission =
      std::min(linkage->transmission_angle(openings->lower), linkage->transmission_angle(openings->upper));
  found.value = objective == Objective::transmission ? found.attained.transmission : linkage->size();
  return found;
}

void add_bound(Answer& answer, Objective objective, std::size_t boxes) {
  const auto bound = proven_bound(answer.spec, objective, {.boxes = boxes});
  if (!bound) return;
  if (bound->no_design) {
    answer.proven_none = true;
    return;
  }
  if (objective == Objective::size)
    answer.least_size = std::max(answer.least_size.value_or(0), bound->value);
  else
    answer.most_transmission = std::min(answer.most_transmission.value_or(pi), bound->value);
  if (!answer.design) answer.design = design_of(answer.spec, objective, *bound);
}

void search(Answer& answer, double seconds) {
  const WorkLimit limit(seconds);
  const SearchOutcome outcome = synthesize(answer.spec, {.stop = limit.reached(), .diagnose = false});
  answer.complete = !std::holds_alternative<Stopped>(outcome);
  if (const auto* none = std::get_if<NoDesign>(&outcome)) answer.proven_none = none->proven;
  const auto* found = std::get_if<FoundDesign>(&outcome);
  if (!found) return;
  answer.design = *found;
  answer.complete = found->complete;
  if (found->proven_bound && found->goal == Goal::size) answer.least_size = found->proven_bound;
  if (found->proven_bound && found->goal == Goal::transmission)
    answer.most_transmission = found->proven_bound;
}

}  // namespace

Answer answer_of(const Task& task, const AnswerOptions& options) {
  Answer answer{.spec = read(task)};
  answer.complete = false;
  if (options.search) search(answer, options.seconds);
  for (const Objective objective : {Objective::size, Objective::transmission})
    add_bound(answer, objective, options.boxes);
  return answer;
}

std::string limit_missed(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers,
                         double slack) {
  // What assemble_given() does, but for the footprint, which takes as long as all the rest.
  Design design{.linkage = linkage,
                .region = spec.region,
                .style = spec.links.style,
                .layers = layers,
                .limits = spec.limits,
                .obstacles = spec.obstacles};
  design.map = map_workspace(map_task(design), {.map_tolerance = 0.5, .largest_sheets = false});
  if (!design.map.coverage.covered) return "region";
  const auto openings = openings_over(linkage, spec.region);
  design.quality.transmission_min =
      std::min(linkage.transmission_angle(openings->lower), linkage.transmission_angle(openings->upper));
  design.quality.clearance_min = design.map.clearance_min;
  if (spec.limits.copy_error)
    design.quality.copy_error_worst =
        copy_error_over(linkage, CopyTolerance::uniform(*spec.tolerance), spec.region)->worst;
  return test::first_limit_missed(spec, design, slack);
}

}  // namespace kempe::metamorphic
