#pragma once
// The search: from a spec to the best design that keeps every limit, or to the reason why there is none.

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kinematics/stop_flag.hpp"
#include "synthesis/requirements.hpp"

namespace kempe {

struct SearchOptions {
  std::uint64_t seed = 1;
  int threads = 1;  ///< >= 1; the result does not depend on it
  /// s of wall clock, > 0; at its end the best so far comes back
  double time_limit = std::numeric_limits<double>::infinity();
  StopFlag stop{};  ///< set: the same at once
  /// Share of the work done, 0..1, and what is being done; called from one thread at a time.
  std::function<void(double share, std::string_view what)> progress{};
  bool diagnose = true;  ///< look for the least relaxations where there is no design
};

/// A design found: everything that assemble_design() needs beside the spec.
struct FoundDesign {
  CopyingLinkage linkage;
  LayerAssignment layers;
  Goal goal = Goal::size;
  double value = 0;                    ///< of the goal: mm, rad or mm^2
  OpeningInterval opening{};           ///< certified: transmission and contact kept all over it
  Attained attained{};                 ///< evaluated anew at the design returned
  std::vector<std::string> solvers{};  ///< names with versions, in the order of use
  std::uint64_t evaluations = 0;
  std::uint64_t seed = 0;
  bool complete = true;                 ///< false: stopped early, a better one may exist
  std::optional<double> lower_bound{};  ///< of the spec's objective, mm or rad; absent where none is proven
};

/// One limit that, moved so far and alone, makes a design possible; or one obstacle that, taken away alone, does.
struct Relaxation {
  std::optional<Goal> limit{};        ///< absent: an obstacle
  std::string key{};                  ///< what a person would change: "links.longest_mm"; "obstacles"
  double demanded = 0, possible = 0;  ///< of the limit, mm or rad; 0 for an obstacle
  std::string sentence;               ///< "transmission_deg = 30 is in the way; 27.4 would do"
  FoundDesign design;                 ///< that keeps all other limits
};

/// Why there is no design.
struct NoDesign {
  std::string requirement{};              ///< the limit's key, "limits.transmission_deg"
  std::string sentence{};                 ///< for a person
  std::vector<Relaxation> relaxations{};  ///< the least share first
  /// Plain, or proven by interval arithmetic (lower_bound.hpp); else a search found nothing.
  bool proven = false;
  bool diagnosed = true;  ///< false: stopped before every limit had been moved
  /// Names of the obstacles that no permitted instrument can touch.
  std::vector<std::string> obstacles_out_of_reach{};
  std::uint64_t evaluations = 0;
};

/// The search was stopped before it found a design, or the proof that there is none: neither is known.
struct Stopped {
  std::uint64_t evaluations = 0;
  std::optional<double> lower_bound{};  ///< what no design can beat, mm or rad, as far as proven
};

using SearchOutcome = std::variant<FoundDesign, NoDesign, Stopped>;

/// The best design for a spec. Guarantees:
///  1. a design returned keeps every limit of the spec, evaluated anew and its contact certified;
///  2. the same spec and seed give the same outcome, bit for bit, for any number of threads (unless stopped
///  early);
///  3. what comes back after a stop is marked as incomplete, and NoDesign comes back only where the whole search found
///  nothing, or a proof did. Under a time limit a first design is sought before the best one.
SearchOutcome synthesize(const Spec& spec, const SearchOptions& options);

}  // namespace kempe
