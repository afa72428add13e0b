#include "synthesis/search.hpp"

#include "synthesis/diagnosis.hpp"
#include "synthesis/search_run.hpp"

namespace kempe {

SearchOutcome synthesize(const Spec& spec, const SearchOptions& options) {
  const SearchRun run(spec, options);
  const SearchResult result = run.best(requirements_of(spec), goal_of(spec.objective.objective));
  if (result.design) return *result.design;
  if (result.stopped) return Stopped{result.evaluations};
  return diagnose(run, result);
}

}  // namespace kempe
