#pragma once
// What a search comes back with: a design, the reason why there is none, or that it was stopped.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "synthesis/problem/requirements.hpp"

namespace kempe {

/// A design found: everything that assemble_design() needs beside the spec.
struct FoundDesign {
  CopyingLinkage linkage;
  LayerAssignment layers;
  Goal goal = Goal::size;
  double value = 0;                    ///< of the goal: mm, rad, mm^2 or kg
  OpeningInterval opening{};           ///< certified: transmission and contact kept all over it
  Attained attained{};                 ///< evaluated anew at the design returned
  std::vector<std::string> solvers{};  ///< names with versions, in the order of use
  std::uint64_t evaluations = 0;
  std::uint64_t seed = 0;
  bool complete = true;                  ///< false: stopped early, a better one may exist
  std::optional<double> proven_bound{};  ///< of the spec's objective, mm or rad; absent where none is proven
  /// Of a robust design: the goal's value of the best design found that need not be robust.
  std::optional<double> nominal_value{};
  /// The one of LinkSpec::sections that it was found with; absent where there was no choice.
  std::optional<LinkSection> section{};
};

/// One change that, alone, makes a design possible: of a limit's value, of another key, or an obstacle taken away.
struct Relaxation {
  std::optional<Goal> limit{};       ///< whose value is changed; absent: something else is
  std::string key{};                 ///< what a person would change: "links.longest_mm"; "obstacles"
  double demanded = 0;               ///< of the limit, mm or rad
  std::optional<double> possible{};  ///< the same; absent: left out, taken away, or no limit
  std::string sentence;              ///< "transmission_deg = 30 is in the way; 27.4 would do"
  FoundDesign design;                ///< of the spec with this change alone
  /// False: the search for a smaller change was ended before it found none, by its budget, time or request.
  bool is_least = true;
};

/// Why there is no design.
struct NoDesign {
  std::string requirement{};              ///< the limit's key, "limits.transmission_deg"
  std::string sentence{};                 ///< for a person
  std::vector<Relaxation> relaxations{};  ///< the least share first
  /// Plain, or proven by interval arithmetic (bound/proven_bound.hpp); else a search found nothing.
  bool proven = false;
  bool diagnosed = true;  ///< false: ended, by its budget, time or request, before every limit had been moved
  /// Names of the obstacles that no permitted instrument can touch.
  std::vector<std::string> obstacles_out_of_reach{};
  std::uint64_t evaluations = 0;
};

/// The search was stopped before it found a design, or the proof that there is none: neither is known.
struct Stopped {
  std::uint64_t evaluations = 0;
  std::optional<double> proven_bound{};  ///< what no design can beat, mm or rad, as far as proven
};

using SearchOutcome = std::variant<FoundDesign, NoDesign, Stopped>;

/// Where joints have hardware of their own (JointHardware::differs), every pin is taken for the thickest and every hole for the
/// widest: a design that is found keeps the limits, but nothing is proven of those that are not. Takes away what claims it.
void claim_no_more(FoundDesign& design, const JointHardware& hardware);
void claim_no_more(NoDesign& none, const JointHardware& hardware);
SearchOutcome claiming_no_more(SearchOutcome outcome, const JointHardware& hardware);

/// The same design or reason, its poles shifted.
FoundDesign shifted(FoundDesign design, const Point& by);
NoDesign shifted(NoDesign none, const Point& by);

}  // namespace kempe
