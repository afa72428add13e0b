#pragma once
// Draws that the tests of closed forms share: any grounding, a thing that is so once in n times, and what their links are cut from.

#include "geometry/chance.hpp"
#include "kempe/links.hpp"
#include "kinematics/assembly_mode.hpp"

namespace kempe::any_linkage {

inline const Material steel{"steel", 200000, 7850, 235};

inline bool one_in(Chance& chance, int n) { return chance.share() * n < 1; }

inline Grounding any_grounding(Chance& chance) {
  return all_groundings[static_cast<std::size_t>(3 * chance.share())];
}

}  // namespace kempe::any_linkage
