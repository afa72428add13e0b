#pragma once
// Grows the tree of a proof log. It guesses in doubles and keeps a margin at every step; the checker decides anew.

#include <optional>

#include "kinematics/stop_flag.hpp"
#include "synthesis/certificate/proof_log.hpp"

namespace kempe::certificate {

struct ProofOptions {
  std::size_t lines = 20'000;  ///< more than this, and the tree is given up
  StopFlag stop{};
};

/// The log that no design of the spec is better than `bound` (mm of size, rad of transmission) or, without a bound, that none
/// exists. A bound that touches the best design is too tight for boxes of doubles: then the log is of one that is looser by a
/// millionth of itself (or, at worst, a ten-thousandth), and says which. Nothing if the tree does not close within the lines allowed, or the objective has no rules (only size and
/// transmission have). Deterministic unless stopped.
std::optional<ProofLog> prove(const Spec& spec, Objective objective, const std::optional<double>& bound,
                              const ProofOptions& options = {});

}  // namespace kempe::certificate
