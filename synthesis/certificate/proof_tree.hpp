#pragma once
// Grows the tree of a proof log. It guesses in doubles and keeps a margin at every step; the checker decides anew.

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "kinematics/stop_flag.hpp"
#include "synthesis/certificate/proof_log.hpp"

namespace kempe::certificate {

struct ProofOptions {
  std::size_t lines = 100'000;  ///< more than this, and the tree is given up
  StopFlag stop{};
};

/// Why there is no log.
enum class NoLog {
  no_rules,  ///< for the objective (only size and transmission have)
  loads,     ///< that no design exists is due to the limit on the load error, of which no line speaks
  sections,  ///< several cross-sections are allowed, and a log speaks of one
  too_long,  ///< more lines than allowed
  stopped,
  too_tight,  ///< boxes too narrow for doubles are left: a design misses a limit by as little as nothing
  bodies  ///< too long or too tight, of a spec in which a body may meet an obstacle, the table's edge or another body: no rule says so
};
/// "its proof takes more than 100000 lines"
std::string reason(NoLog why, const ProofOptions& options = {});

/// The log that no design of the spec is better than `bound` (mm of size, rad of transmission) or, without a bound, that none
/// exists. A bound that touches the best design is too tight for boxes of doubles, or takes too many of them: then the log is of
/// one that is looser by a millionth of itself (or more, up to one that is trivial), and says which. Deterministic unless stopped.
tl::expected<ProofLog, NoLog> prove(const Spec& spec, Objective objective, const std::optional<double>& bound,
                                    const ProofOptions& options = {});

}  // namespace kempe::certificate
