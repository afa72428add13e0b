// What a limit on the load error costs the search: each spec without it and with one that binds, by turns, in CPU time.
//
// usage: kempe_load_limit_bench [--seeds COUNT] [--rounds COUNT] [--share SHARE ...] [SPEC.toml ...]
// SHARE: the limit, times the load error of the design that is best without one (0.98 and 0.9).
// For each spec and seed one line: CPU time without and with, their ratio, what both designs come to. At the end the median ratio.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "specs/spec_reader.hpp"
#include "synthesis/search/search.hpp"

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
  SearchOutcome outcome = synthesize(spec, options);
  return {std::move(outcome), cpu_seconds() - begin};
}

const FoundDesign* design_in(const Timed& timed) { return std::get_if<FoundDesign>(&timed.outcome); }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

Spec loaded(const std::string& name) {
  auto spec = read_spec_file(name);
  if (!spec) throw std::runtime_error("cannot read " + name);
  spec->material = spec->material.value_or(Material{"steel", 200000, 7850, 235});
  spec->load = spec->load.value_or(Load{10});
  spec->limits.load_error.reset();
  return *spec;
}

int run(int seeds, int rounds, const std::vector<double>& shares, const std::vector<std::string>& files) {
  std::vector<double> ratios;
  for (const std::string& file : files)
    for (int seed = 1; seed <= seeds; ++seed) {
      const Spec plain = loaded(file);
      const auto first = searched(plain, static_cast<std::uint64_t>(seed));
      const FoundDesign* without = design_in(first);
      if (!without) continue;
      for (const double share : shares) {
        Spec limited = plain;
        limited.limits.load_error = share * without->attained.load_error;
        double least_plain = 1e9, least_limited = 1e9;
        std::string found = "none";
        for (int round = 0; round < rounds; ++round) {
          least_plain = std::min(least_plain, searched(plain, static_cast<std::uint64_t>(seed)).seconds);
          const Timed timed = searched(limited, static_cast<std::uint64_t>(seed));
          least_limited = std::min(least_limited, timed.seconds);
          if (const FoundDesign* one = design_in(timed)) found = fmt::format("{:.9g}", one->value);
        }
        if (found != "none") ratios.push_back(least_limited / least_plain);
        fmt::print("{:30} seed {} share {:4} {:8.1f} {:8.1f} ms {:5.2f}  {:.9g} {}\n",
                   std::filesystem::path(file).stem().string(), seed, share, 1e3 * least_plain,
                   1e3 * least_limited, least_limited / least_plain, without->value, found);
        std::fflush(stdout);
      }
    }
  if (ratios.empty()) return 0;
  fmt::print("median ratio {:.2f}, most {:.2f}, of {}\n", median(ratios),
             *std::max_element(ratios.begin(), ratios.end()), ratios.size());
  return 0;
}

}  // namespace
}  // namespace kempe

int main(int count, char** words) {
  int seeds = 3, rounds = 3;
  std::vector<double> shares;
  std::vector<std::string> files;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--seeds" && i + 1 < count)
      seeds = std::stoi(words[++i]);
    else if (word == "--rounds" && i + 1 < count)
      rounds = std::stoi(words[++i]);
    else if (word == "--share" && i + 1 < count)
      shares.push_back(std::stod(words[++i]));
    else
      files.push_back(word);
  }
  if (files.empty())
    for (const char* name : {"nameplate", "plagiograph", "report-mechanism", "half-turn", "two-layer"})
      files.push_back((kempe::examples / name).string() + ".toml");
  if (shares.empty()) shares = {0.98, 0.9};
  return kempe::run(seeds, rounds, shares, files);
}
