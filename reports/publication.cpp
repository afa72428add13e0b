#include "reports/publication.hpp"

#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "kinematics/parallel.hpp"
#include "reports/audit/recheck.hpp"
#include "reports/design_package.hpp"
#include "reports/drawings/part_files.hpp"
#include "reports/drawings/parts_fault.hpp"
#include "synthesis/verification/verification.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace kempe {
namespace {

/// What a search over a million corners and the texts of its files took is freed in small pieces, a hundred megabytes
/// that glibc would keep beside what comes next.
void give_memory_back() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

tl::unexpected<NotPublished> refused(NotPublished::By by, std::string sentence) {
  return tl::unexpected(NotPublished{by, std::move(sentence)});
}

}  // namespace

tl::expected<Drafted, NotPublished> draft_design(Design& design, ReportExtras extras, FolderDraft& draft,
                                                 const TimeToFinish& time, int threads,
                                                 std::optional<CertificateOrNone> proof) {
  using enum NotPublished::By;
  if (const auto fault = parts_fault(design, design.cutting)) extras.why_no_parts = fault->sentence;
  const bool had_rules = has_rules(design), had_bound = design.quality.proven_bound.has_value();
  VerificationRun run;
  EarlyFiles early;
  const auto verify = [&] { run = run_verification(verification_task(design), {.stop = time.enough}); };
  const auto state = [&] {
    design.verification = run.found;
    design.quality.proven_bound = *proof ? (*proof)->bound : std::nullopt;
    if (*proof) extras.proof_log = certificate_name;
  };
  std::vector<std::function<void()>> jobs;
  std::function<void()> settle;
  if (proof)
    settle = [&] { verify(), state(); };
  else
    jobs = {[&] { proof = certificate_of(design, time.enough); }, verify};
  for (auto& job : early_jobs(design, design.cutting, extras, time, settle, early))
    jobs.push_back(std::move(job));
  run_parallel(jobs.size(), threads, [&](std::size_t i) { jobs[i](); });
  if (!settle) state();
  const CertificateOrNone& certificate = *proof;
  if (!design.verification.holds)
    return refused(verification,
                   "the design failed its verification, nothing is written: " + design.verification.failure);
  give_memory_back();
  auto left_out = make_design_package(
      design, design.cutting, extras, [&](const OutputFile& file) { return draft.add(file); }, time,
      std::move(early), threads);
  if (!left_out) return refused(writing, left_out.error());
  if (certificate)
    if (const auto added = draft.add({certificate_name, certificate->log}); !added)
      return refused(writing, added.error());
  if (!certificate && had_rules) left_out->push_back(left_out_sentence(certificate.error()));
  if (!certificate && had_bound) left_out->push_back("The bound is left out: no log proves it.");
  if (!run.complete) left_out->push_back("The verification was stopped early: it is of fewer positions.");
  give_memory_back();
  std::vector<std::string> faults;
  tl::expected<void, std::string> synchronised;
  const bool read_back = !time.over();
  const std::function<void()> last[] = {[&] { synchronised = draft.synchronise(); },  // it mostly waits
                                        [&] {
                                          if (read_back) faults = recheck(draft, design, design.cutting);
                                        }};
  run_parallel(std::size(last), threads, [&](std::size_t i) { last[i](); });
  if (!read_back) left_out->push_back("The drawings are not read back: the time was over.");
  if (!faults.empty())
    return refused(rereading,
                   "the drawings, read back, differ from the design; nothing is written: " + faults.front());
  if (!synchronised) return refused(writing, synchronised.error());
  return Drafted{std::move(*left_out), extras.why_no_parts.empty()};
}

}  // namespace kempe
