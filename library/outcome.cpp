// Workings::outcome(): what the search comes back with, as the public Outcome.

#include <cmath>

#include "library/workings.hpp"

namespace kempe {

Outcome Workings::outcome(FinishedDesign design) {
  Outcome outcome;
  outcome.kind_ = Outcome::Kind::design;
  outcome.proven_bound_ = design.proven_bound();
  outcome.design_ = std::move(design);
  return outcome;
}

Outcome Workings::outcome(const NoDesign& none) {
  Outcome outcome;
  outcome.kind_ = Outcome::Kind::no_design;
  outcome.reason_ = none.sentence;
  outcome.proven_ = none.proven;
  for (const Relaxation& relaxation : none.relaxations)
    outcome.changes_.push_back({relaxation.key, relaxation.sentence});
  return outcome;
}

Outcome Workings::outcome(const Stopped& stopped) {
  Outcome outcome;
  outcome.kind_ = Outcome::Kind::stopped;
  outcome.reason_ = "stopped before a design was found or proven impossible";
  if (stopped.proven_bound && std::isfinite(*stopped.proven_bound))
    outcome.proven_bound_ = stopped.proven_bound;
  return outcome;
}

Outcome Workings::outcome(InputError fault) {
  Outcome outcome;
  outcome.kind_ = Outcome::Kind::bad_spec;
  outcome.reason_ = fault.message();
  outcome.fault_ = std::move(fault);
  return outcome;
}

Outcome Workings::uncertified(std::string reason) {
  Outcome outcome;
  outcome.kind_ = Outcome::Kind::no_design;
  outcome.reason_ = std::move(reason);
  return outcome;
}

}  // namespace kempe
