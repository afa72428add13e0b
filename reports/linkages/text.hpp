#pragma once
// What `kempe mobility` and `kempe centres` print for people: short aligned lines. json.hpp has the same for programs.

#include <string>
#include <vector>

#include "kinematics/planar/instant_centres.hpp"
#include "kinematics/planar/mobility.hpp"
#include "specs/linkages/model.hpp"

namespace kempe {

/// Links, joints, Gruebler's count, the true mobility, and the sentences that say why they differ.
std::string mobility_text(const LinkageFile& file, const LinkageModel& model, const Mobility& mobility);

/// Joints, loops, and a line for every assortment: "4 binary, 2 ternary".
std::string number_synthesis_text(int links, int freedoms, const NumberSynthesis& synthesis);

/// Where a centre is, in the file's unit: "(97.3849, 208.365) mm", "at infinity, direction 90 degrees", "undetermined".
std::string centre_place_text(const LinkageFile& file, const LinkageModel& model,
                              const InstantCentre& centre);

/// The drivers, and a line for every centre: its pair of links, its place in the file's unit, where it comes from.
std::string centres_text(const LinkageFile& file, const LinkageModel& model, double step,
                         const RunFrame& frame, const std::vector<double>& speeds,
                         const std::vector<InstantCentre>& centres);

}  // namespace kempe
