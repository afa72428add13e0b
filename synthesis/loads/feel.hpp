#pragma once
// How an instrument feels in the hand over the openings that a region uses: friction, mass, weight on a tilted table and what balances it.

#include <array>
#include <optional>

#include "synthesis/loads/friction.hpp"
#include "synthesis/loads/moving_masses.hpp"

namespace kempe {

/// Figures over an interval of openings (top_over.hpp).
struct Feel {
  double friction_share = 0;       ///< largest share of the work's drag that friction adds to it
  OpeningInterval without_lock{};  ///< openings about these where that share stays below 1
  double mass_most = 0;            ///< kg felt at the tracer, in the heaviest direction
  double mass_least = 0;           ///< kg, in the lightest
  double weight_most =
      0;  ///< N that the hand holds of the weight on the tilted table, in any bearing; 0 on a level one
  /// N, the most of the hand on the tracer: work, friction and weight together, in any bearing and direction of motion; infinite where a dead
  /// point lies among the openings. Sampled: the openings are the ends and those of the largest weight and of the most friction.
  double hand_most = 0;
  std::array<Counterweight, 2> counterweights{};
  std::optional<std::array<BalanceSpring, 2>>
      springs{};  ///< absent on a level table, and where the pole is not at V
};
/// Under a load, of links of this style and material on these joints.
Feel feel_over(const CopyingLinkage& linkage, const LinkStyle& style, const JointHardware& hardware,
               const Material& material, const Load& load, const OpeningInterval& openings);

/// "2.10 kg, 300 mm beyond V on link VA, opposite to A", for a person.
std::string words(const Counterweight& weight);
/// "12.3 N/mm from 150 mm above the pole to a point 150 mm from it on link VA", for a person.
std::string words(const BalanceSpring& spring);

}  // namespace kempe
