#pragma once
// certificate.jsonl, made for a design or for the proof that there is none.

#include <optional>
#include <string>

#include "kinematics/stop_flag.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

inline const std::string certificate_name = "certificate.jsonl";

/// True if the design has a bound of an objective that the log has rules for (size, transmission).
bool has_rules(const Design& design);

/// The log that no design is better than the design's bound; nothing where it has no bound, its objective has no rules, or the
/// tree does not close. A bound that touches the best design is made looser by a millionth of itself, in the design too: then
/// what its file says is what the log proves.
std::optional<std::string> certificate_of(Design& design, const StopFlag& stop = {});

/// The log that no design of the spec exists; nothing if the tree does not close.
std::optional<std::string> certificate_of_none(const Spec& spec, const StopFlag& stop = {});

}  // namespace kempe
