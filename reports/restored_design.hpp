#pragma once
// A design from its file alone, ready to be published like one that was just found.

#include <string>
#include <tl/expected.hpp>

#include "kempe/input_error.hpp"
#include "kinematics/stop_flag.hpp"
#include "reports/data/design_json.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// The design that a file states, of which audit() has found nothing broken.
///  1. Task, mechanism, layers and the record of the search are the file's; all else (map, certified opening, footprint, quality) is
///     computed anew.
///  2. The bound is as the file claims it: draft_design() keeps it only with a proof.
///  3. The task is held to the rules of the spec's reader.
/// The error names the key that breaks one of these rules, or lengths that contradict each other.
tl::expected<Design, InputError> restored_design(const StoredDesign& stored, const std::string& file,
                                                 const StopFlag& stop = {});

}  // namespace kempe
