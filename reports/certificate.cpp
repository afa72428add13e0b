#include "reports/certificate.hpp"

#include <cmath>

#include "reports/data/certificate_jsonl.hpp"
#include "synthesis/certificate/proof_tree.hpp"

namespace kempe {

bool has_rules(const Design& design) {
  const auto& bound = design.quality.proven_bound;
  return design.search && design.allowed && bound && std::isfinite(*bound) && !design.region.empty() &&
         (design.search->objective == Objective::size || design.search->objective == Objective::transmission);
}

std::optional<std::string> certificate_of(Design& design, const StopFlag& stop) {
  if (!has_rules(design)) return std::nullopt;
  auto& bound = design.quality.proven_bound;
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
