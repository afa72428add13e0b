#include "synthesis/search/steps/outcome.hpp"

#include "synthesis/problem/local_frame.hpp"

namespace kempe {

void claim_no_more(FoundDesign& design, const JointHardware& hardware) {
  if (hardware.differs()) design.proven_bound.reset();
}

void claim_no_more(NoDesign& none, const JointHardware& hardware) {
  if (!hardware.differs()) return;
  none.proven = false;
  none.sentence +=
      "; of hardware that differs from joint to joint the thickest pin and the widest hole stood for all";
  for (Relaxation& relaxation : none.relaxations) claim_no_more(relaxation.design, hardware);
}

SearchOutcome claiming_no_more(SearchOutcome outcome, const JointHardware& hardware) {
  if (auto* found = std::get_if<FoundDesign>(&outcome)) claim_no_more(*found, hardware);
  if (auto* none = std::get_if<NoDesign>(&outcome)) claim_no_more(*none, hardware);
  if (auto* stopped = std::get_if<Stopped>(&outcome); stopped != nullptr && hardware.differs())
    stopped->proven_bound.reset();
  return outcome;
}

FoundDesign shifted(FoundDesign design, const Point& by) {
  design.linkage = shifted(design.linkage, by);
  return design;
}

NoDesign shifted(NoDesign none, const Point& by) {
  for (Relaxation& relaxation : none.relaxations) relaxation.design = shifted(relaxation.design, by);
  return none;
}

}  // namespace kempe
