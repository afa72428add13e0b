#include "synthesis/search/steps/outcome.hpp"

#include "synthesis/problem/local_frame.hpp"

namespace kempe {

FoundDesign shifted(FoundDesign design, const Point& by) {
  design.linkage = shifted(design.linkage, by);
  return design;
}

NoDesign shifted(NoDesign none, const Point& by) {
  for (Relaxation& relaxation : none.relaxations) relaxation.design = shifted(relaxation.design, by);
  return none;
}

}  // namespace kempe
