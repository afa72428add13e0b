// What a limit on the load error costs the search: each spec without it and with one that binds, by turns, in CPU time.
//
// usage: kempe_load_limit_bench [--seeds COUNT] [--rounds COUNT] [--share SHARE ...] [--in-all] [SPEC.toml | SPECS.jsonl ...]
// SHARE: the limit, times the load error of the design that is best without one (0.98 and 0.9). It is one of the links
// alone; with --in-all it counts pins and layers too, as the load error then does, where what they add can be stated.
// SPECS.jsonl: a spec a line, as random_specs.py leaves them in its folder.
// For each spec and seed one line: CPU time without and with, their ratio, what both designs come to; where no design keeps the limit, whether
// that is proven (why there is none is not asked). At the end, of those with a design, of those where it is proven that there is none, and
// of those where none was found: the median ratio, the largest, how many are within 1.5, and all time with the limit over all without.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "specs/json_spec.hpp"
#include "specs/spec_reader.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/search/search.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

const std::filesystem::path examples = KEMPE_SOURCE_DIR "/specs/examples/";

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Timed {
  SearchOutcome outcome;
  double seconds;
};

Timed searched(const Spec& spec, std::uint64_t seed) {
  const double begin = cpu_seconds();
  SearchOptions options;
  options.seed = seed;
  options.threads = 1;
  options.diagnose = false;
  SearchOutcome outcome = synthesize(spec, options);
  return {std::move(outcome), cpu_seconds() - begin};
}

const FoundDesign* design_in(const Timed& timed) { return std::get_if<FoundDesign>(&timed.outcome); }

/// What a search with the limit comes to.
enum class End { design, proven_none, none_found };

End end_of(const Timed& timed) {
  if (design_in(timed)) return End::design;
  const auto* none = std::get_if<NoDesign>(&timed.outcome);
  return none != nullptr && none->proven ? End::proven_none : End::none_found;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

struct NamedSpec {
  std::string name;
  Spec spec;
};

NamedSpec loaded(const std::string& name, tl::expected<Spec, InputError> spec) {
  if (!spec) throw std::runtime_error("cannot read " + name);
  spec->material = spec->material.value_or(Material{"steel", 200000, 7850, 235});
  spec->load = spec->load.value_or(Load{10});
  spec->limits.load_error.reset();
  spec->limits.load_error_in_all = false;
  return {name, std::move(*spec)};
}

std::vector<NamedSpec> specs_in(const std::filesystem::path& file) {
  if (file.extension() != ".jsonl") return {loaded(file.stem().string(), read_spec_file(file))};
  std::vector<NamedSpec> specs;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::string name = fmt::format("{}:{}", file.stem().string(), specs.size() + 1);
    specs.push_back(loaded(name, toml_from_json(line, name).and_then([&](const std::string& text) {
      return read_spec(text, name, file.parent_path());
    })));
  }
  return specs;
}

struct Cost {
  double without, with;
  End end = End::none_found;
  double ratio() const { return with / without; }
};

/// Of one spec with one seed under one limit. Prints its line.
Cost cost_of(const NamedSpec& named, std::uint64_t seed, double share, double load_error, bool in_all,
             int rounds, const FoundDesign& without) {
  Spec limited = named.spec;
  limited.limits.load_error = share * load_error;
  limited.limits.load_error_in_all = in_all;
  Cost least{HUGE_VAL, HUGE_VAL};
  std::string found;
  for (int round = 0; round < rounds; ++round) {
    least.without = std::min(least.without, searched(named.spec, seed).seconds);
    const Timed timed = searched(limited, seed);
    least.with = std::min(least.with, timed.seconds);
    least.end = end_of(timed);
    found = least.end == End::design        ? fmt::format("{:.9g}", design_in(timed)->value)
            : least.end == End::proven_none ? "none, proven"
                                            : "none found";
  }
  fmt::print("{:30} seed {} share {:4} {:8.1f} {:8.1f} ms {:5.2f}  {:.9g} {}\n", named.name, seed, share,
             1e3 * least.without, 1e3 * least.with, least.ratio(), without.value, found);
  std::fflush(stdout);
  return least;
}

/// Of the costs with one end.
void print_sum(const std::vector<Cost>& costs, End end, const char* name) {
  std::vector<double> ratios;
  double without = 0, with = 0;
  for (const Cost& cost : costs) {
    if (cost.end != end) continue;
    ratios.push_back(cost.ratio());
    without += cost.without;
    with += cost.with;
  }
  if (ratios.empty()) return;
  fmt::print("{}, of {}: median ratio {:.2f}, most {:.2f}, {} within 1.5; all together {:.2f}\n", name,
             ratios.size(), median(ratios), *std::max_element(ratios.begin(), ratios.end()),
             std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio <= 1.5; }),
             with / without);
}

/// mm, of the design that is best without a limit; infinite where it cannot be stated.
double load_error_of(const Spec& spec, const FoundDesign& design, bool in_all) {
  const auto openings = openings_over(design.linkage, spec.region);
  return !in_all    ? design.attained.load_error
         : openings ? give_in_all(spec, design.linkage, design.layers, *openings)
                    : HUGE_VAL;
}

int run(int seeds, int rounds, const std::vector<double>& shares, bool in_all,
        const std::vector<std::string>& files) {
  std::vector<Cost> costs;
  for (const std::string& file : files)
    for (const NamedSpec& named : specs_in(file))
      for (int i = 1; i <= seeds; ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        const Timed first = searched(named.spec, seed);
        const FoundDesign* without = design_in(first);
        if (!without) continue;
        const double load_error = load_error_of(named.spec, *without, in_all);
        if (!std::isfinite(load_error)) continue;
        for (const double share : shares)
          costs.push_back(cost_of(named, seed, share, load_error, in_all, rounds, *without));
      }
  print_sum(costs, End::design, "a design");
  print_sum(costs, End::proven_none, "proven that there is none");
  print_sum(costs, End::none_found, "none found");
  return 0;
}

}  // namespace
}  // namespace kempe

int main(int count, char** words) {
  int seeds = 3, rounds = 3;
  std::vector<double> shares;
  bool in_all = false;
  std::vector<std::string> files;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--seeds" && i + 1 < count)
      seeds = std::stoi(words[++i]);
    else if (word == "--rounds" && i + 1 < count)
      rounds = std::stoi(words[++i]);
    else if (word == "--share" && i + 1 < count)
      shares.push_back(std::stod(words[++i]));
    else if (word == "--in-all")
      in_all = true;
    else
      files.push_back(word);
  }
  if (files.empty())
    for (const char* name : {"nameplate", "plagiograph", "report-mechanism", "half-turn", "two-layer"})
      files.push_back((kempe::examples / name).string() + ".toml");
  if (shares.empty()) shares = {0.98, 0.9};
  return kempe::run(seeds, rounds, shares, in_all, files);
}
