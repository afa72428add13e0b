#include "synthesis/search/strategies/strategy.hpp"

#include "synthesis/search/strategies/footprint_strategy.hpp"
#include "synthesis/search/strategies/length_strategy.hpp"

namespace kempe {

std::unique_ptr<Strategy> strategy_for(Goal goal) {
  if (goal == Goal::footprint) return std::make_unique<FootprintStrategy>();
  return std::make_unique<LengthStrategy>();
}

}  // namespace kempe
