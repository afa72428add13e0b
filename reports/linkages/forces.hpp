#pragma once
// The forces of a linkage that carries loads: their columns in the table of `kempe solve`, and what they come to.

#include <optional>
#include <string>
#include <vector>

#include "kinematics/planar/reactions.hpp"
#include "reports/linkages/solve_table.hpp"

namespace kempe {

/// N mm in a N m.
inline constexpr double moment_unit = 1000;

/// One column: a part of what one constraint or driver does to the linkage.
struct ForceColumn {
  enum class Part { x, y, along, tension, moment };

  std::string name;  ///< with its unit, N or N m
  int constraint = 0;
  Part part = Part::along;

  ColumnKind kind() const { return name.ends_with("_N_m") ? ColumnKind::moment : ColumnKind::force; }
  /// N or N m; nothing where the reaction is not determined.
  std::optional<double> value(const Reaction& reaction) const;
};

/// drive_P_y_N of every driver; B_on_rod_x_N, B_on_rod_y_N of every joint; C_from_ground_x_N, ... of every guide;
/// bar_A_B_N (> 0 pulls), gears_a_and_b_N, rack_and_pinion_a_N, and moments such as angle_from_a_to_b_N_m. None
/// without loads; the drivers alone if the file wants no reactions. All names differ.
std::vector<ForceColumn> force_columns(const LinkageFile& file, const LinkageModel& model);

/// Finds the reactions of a run's moments.
class ForceFinder {
 public:
  explicit ForceFinder(const LinkageModel& model) : model_(model), solver_(model.linkage) {}

  /// One for each constraint; nothing where the motion stopped, at a singular position.
  std::optional<std::vector<Reaction>> at(const RunFrame& frame);

 private:
  const LinkageModel& model_;
  ReactionSolver solver_;
};

/// What the forces come to, for people: a sentence for each driver, one for the largest reaction, and one about those that
/// rigid links do not determine. `table` holds the columns above as its last ones.
std::vector<std::string> force_sentences(const LinkageFile& file, const LinkageModel& model,
                                         const SolveTable& table);

/// The constraints whose reactions the table leaves out though it knows the drivers' forces, as labels: "joint A (crank)".
std::vector<std::string> undetermined_reactions(const LinkageFile& file, const LinkageModel& model,
                                                const SolveTable& table);

}  // namespace kempe
