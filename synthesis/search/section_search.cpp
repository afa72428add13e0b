#include "synthesis/search/section_search.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "specs/spec.hpp"
#include "synthesis/search/steps/slack.hpp"

namespace kempe {

Spec with_section(Spec spec, const LinkSection& section) {
  use_section(spec.links.style, section);
  spec.links.sections = {section};
  return spec;
}

std::string of_no_section(const Spec& spec, SpecUnit unit, const std::string& sentence) {
  const LinkSection& last = spec.links.sections.back();
  return fmt::format("with none of the {} sections; with {:g} x {:g} {}: {}", spec.links.sections.size(),
                     last.width / in_mm(unit), last.thickness / in_mm(unit), name(unit), sentence);
}

namespace {

using Clock = std::chrono::steady_clock;

bool is_better(const FoundDesign& one, const FoundDesign& other) {
  const double margin = slack::same_value * std::abs(other.value);
  return is_maximized(one.goal) ? one.value > other.value + margin : one.value < other.value - margin;
}

/// A share of the time that is left; why there is no design is looked for with the last section alone, and only where no section before
/// it had one.
SearchOptions options_for(const SearchOptions& options, Clock::time_point start, std::size_t sections_left,
                          bool has_one) {
  SearchOptions part = options;
  const double spent = std::chrono::duration<double>(Clock::now() - start).count();
  part.time_limit = std::max(0.0, options.time_limit - spent) / static_cast<double>(sections_left);
  part.diagnose = options.diagnose && sections_left == 1 && !has_one;
  return part;
}

}  // namespace

SearchOutcome best_of_sections(
    const Spec& spec, const SearchOptions& options,
    const std::function<SearchOutcome(const Spec&, const SearchOptions&)>& search) {
  const auto start = Clock::now();
  const std::size_t count = spec.links.sections.size();
  std::optional<FoundDesign> best;
  std::optional<SearchOutcome> without;
  bool proven = true, complete = true;
  std::uint64_t evaluations = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const LinkSection& section = spec.links.sections[i];
    SearchOutcome outcome =
        search(with_section(spec, section), options_for(options, start, count - i, best.has_value()));
    if (auto* found = std::get_if<FoundDesign>(&outcome)) {
      evaluations += found->evaluations;
      complete = complete && found->complete;
      found->section = section;
      if (!best || is_better(*found, *best)) best = std::move(*found);
      continue;
    }
    if (auto* stopped = std::get_if<Stopped>(&outcome)) {
      complete = false;
      stopped->proven_bound.reset();
      evaluations += stopped->evaluations;
    }
    if (auto* none = std::get_if<NoDesign>(&outcome)) {
      proven = proven && none->proven;
      evaluations += none->evaluations;
      for (Relaxation& relaxation : none->relaxations)
        if (!relaxation.design.section) relaxation.design.section = section;
    }
    without = std::move(outcome);
  }
  if (best) {
    best->evaluations = evaluations;
    best->complete = complete;
    best->proven_bound.reset();
    return *std::move(best);
  }
  if (!complete) return Stopped{evaluations, std::nullopt};
  auto& none = std::get<NoDesign>(*without);
  none.proven = proven;
  none.sentence = of_no_section(spec, options.unit, none.sentence);
  return *std::move(without);
}

}  // namespace kempe
