#include "reports/certificate.hpp"

#include <cmath>

#include "reports/data/certificate_jsonl.hpp"
#include "synthesis/bound/proven_bound.hpp"

namespace kempe {

bool has_rules(const Design& design) {
  const auto& bound = design.quality.proven_bound;
  return design.search && design.allowed && bound && std::isfinite(*bound) && !design.region.empty() &&
         (design.search->objective == Objective::size || design.search->objective == Objective::transmission);
}

CertificateOrNone certificate_of(const Design& design, const StopFlag& stop) {
  if (!has_rules(design)) return tl::unexpected(certificate::NoLog::no_rules);
  const Spec task = spec_of(design);
  certificate::ProofOptions options;
  options.stop = stop;
  const auto log = certificate::prove(task, design.search->objective, design.quality.proven_bound, options);
  if (!log) return tl::unexpected(log.error());
  return Certificate{certificate_jsonl(task, *log), log->bound};
}

tl::expected<std::string, certificate::NoLog> certificate_of_none(const Spec& spec, const StopFlag& stop) {
  if (spec.links.sections.size() > 1) return tl::unexpected(certificate::NoLog::sections);
  if (spec.limits.load_error || spec.limits.sag) {
    const auto without = proven_bound(spec, Objective::size, {.stop = stop});
    if (stop()) return tl::unexpected(certificate::NoLog::stopped);
    if (!without || !without->no_design) return tl::unexpected(certificate::NoLog::loads);
  }
  certificate::ProofOptions options;
  options.stop = stop;
  const auto log = certificate::prove(spec, Objective::size, std::nullopt, options);
  if (!log) return tl::unexpected(log.error());
  return certificate_jsonl(spec, *log);
}

std::string left_out_sentence(certificate::NoLog why) {
  return certificate_name + " is left out: " + certificate::reason(why) + ".";
}

}  // namespace kempe
