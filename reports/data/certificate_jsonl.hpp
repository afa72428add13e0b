#pragma once
// certificate.jsonl: the log of a proof as text, one line a node (docs/proof.md).

#include <string>

#include "synthesis/certificate/proof_log.hpp"

namespace kempe {

/// The header and all lines of the log about the spec's task. Numbers as the shortest decimals that give the same double.
std::string certificate_jsonl(const Spec& spec, const certificate::ProofLog& log);

}  // namespace kempe
