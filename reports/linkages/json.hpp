#pragma once
// What `kempe mobility` and `kempe centres` say, as JSON texts for programs; the sentences in them; text.hpp has the lines
// for people.

#include <string>
#include <vector>

#include "kinematics/planar/instant_centres.hpp"
#include "kinematics/planar/mobility.hpp"
#include "specs/linkages/model.hpp"

namespace kempe {

/// "3 (n - 1) - 2 j1 - j2 = 3 (4 - 1) - 2 * 4 - 0 = 1": Gruebler's count with its numbers; with "+ 2 p" where points belong
/// to no link.
std::string gruebler_in_numbers(const Mobility& mobility);

/// One JSON object: links, joints, gruebler (with its numbers), rank, mobility, redundant sets by name, singular_position, and
/// sentences that say why the count and the true mobility differ. `drivers` is the number of driven values.
std::string mobility_json(const LinkageFile& file, const LinkageModel& model, const Mobility& mobility);

/// The sentences alone: at least one.
std::vector<std::string> mobility_sentences(const LinkageModel& model, const Mobility& mobility);

/// Why no chain of so many links can have these freedoms; empty if one can.
std::string why_no_chain(int links, int freedoms, const NumberSynthesis& synthesis);

/// One JSON object: links, freedoms, joints, largest_link, assortments [{"n2": 4, "n3": 2, ...}].
std::string number_synthesis_json(int links, int freedoms, const NumberSynthesis& synthesis);

/// One JSON object: the step, the drivers' rates, and every centre with where it comes from.
std::string centres_json(const LinkageFile& file, const LinkageModel& model, double step,
                         const RunFrame& frame, const std::vector<double>& speeds,
                         const std::vector<InstantCentre>& centres);

/// A constraint for people: "joint B (crank, rod)", "slider C (rod, ground)", "driver P.y".
std::string constraint_label(const LinkageModel& model, int number);

/// "ground, crank by Aronhold-Kennedy (through rod and rocker)" and the like: where a centre comes from.
std::string source_of(const LinkageModel& model, const InstantCentre& centre);

}  // namespace kempe
