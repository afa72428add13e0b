#include "reports/certificate.hpp"

#include <cmath>

#include "reports/data/certificate_jsonl.hpp"
#include "synthesis/certificate/proof_tree.hpp"

namespace kempe {

std::optional<std::string> certificate_of(Design& design, const StopFlag& stop) {
  auto& bound = design.quality.proven_bound;
  if (!design.search || !design.allowed || !bound || !std::isfinite(*bound)) return std::nullopt;
  const Spec task = task_of(design);
  certificate::ProofOptions options;
  options.stop = stop;
  const auto log = certificate::prove(task, design.search->objective, bound, options);
  if (!log) return std::nullopt;
  bound = log->bound;
  return certificate_jsonl(task, *log);
}

std::optional<std::string> certificate_of_none(const Spec& spec, const StopFlag& stop) {
  certificate::ProofOptions options;
  options.stop = stop;
  const auto log = certificate::prove(spec, Objective::size, std::nullopt, options);
  if (!log) return std::nullopt;
  return certificate_jsonl(spec, *log);
}

}  // namespace kempe
