#pragma once
// What a search must respect and what it makes as good as it can be.

#include <optional>
#include <string_view>

#include "specs/spec.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// Everything discrete about a design.
struct Choice {
  Grounding grounding = Grounding::pole;
  int assembly_mode = 0;
  LayerAssignment layers;
  bool operator==(const Choice&) const = default;
};

/// The limits in force: those of a spec, or with one of them moved; and those that a spec states elsewhere or not at all. That on the
/// longest strip is kept as `longest`.
struct Requirements : Limits {
  double shortest = 0;                ///< mm, at least: of any two joints of a link, their holes apart
  double longest = 0;                 ///< mm, at most
  double pole_margin = 0;             ///< mm, the pole may stand so far outside its area
  std::optional<double> size{};       ///< mm, at most
  std::optional<double> footprint{};  ///< mm^2, at most
  std::optional<double> mass{};       ///< kg, at most
};
Requirements requirements_of(const Spec& spec);
/// The spec with the limits in force in place of its own, as far as a spec can state them: not shortest, pole_margin, size,
/// footprint and mass.
Spec with_limits(Spec spec, const Requirements& limits);

/// What is made as small (size, copy_error, footprint, load_error, mass, longest, pole_margin) or as large (transmission,
/// clearance, shortest, copy_gap) as it can be: the objectives of a spec, and every limit as an objective
/// of its own.
enum class Goal {
  size,
  transmission,
  copy_error,
  footprint,
  load_error,
  mass,
  sag,
  clearance,
  shortest,
  longest,
  copy_gap,
  pole_margin
};
std::string_view name(Goal goal);
bool is_maximized(Goal goal);
Goal goal_of(Objective objective);
/// The objective that a spec asks for a goal by; nothing for goals that are limits only.
std::optional<Objective> objective_of(Goal goal);

/// The limit in force on what a goal stands for, in its unit; nothing where there is none.
std::optional<double> limit_on(const Requirements& limits, Goal goal);
/// The limits with another one on what a goal stands for.
Requirements with_limit(Requirements limits, Goal goal, double value);

/// What a design has of each, in the goals' units: mm, rad, mm^2.
struct Attained {
  double size = 0, transmission = 0, clearance = 0, shortest = 0, longest = 0;
  double copy_gap = 0;     ///< negative: original and copy overlap
  double pole_margin = 0;  ///< distance of the pole from its area
  double copy_error = 0, footprint = 0;
  /// mm, kg; 0 without load and material. The load error of a finished design has pins and layers in it where Limits::load_error_in_all
  /// says so, that of a problem's design never has.
  double load_error = 0, mass = 0;
  double sag = 0;  ///< mm; 0 unless it is limited
  double of(Goal goal) const;
};

}  // namespace kempe
