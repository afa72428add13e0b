#pragma once
// A linkage file as the general solver's bodies and constraints, with its names.

#include <map>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/planar/assemblies.hpp"
#include "kinematics/planar/linkage.hpp"
#include "kinematics/planar/loads.hpp"
#include "kinematics/planar/run.hpp"
#include "specs/linkages/linkage_file.hpp"

namespace kempe {

/// What a point of the file is to the solver.
struct ModelPoint {
  std::string name;
  BodyPoint place;
};

/// Invariant: every name of the file's point_names() stands in `points` in that order; body numbers are those
/// of `linkage`; the linkage's drivers are those of `schedule`, in order.
struct LinkageModel {
  PlanarLinkage linkage;
  std::vector<ModelPoint> points;
  DriveSchedule schedule;
  PlanarLoads loads;

  const BodyPoint& point(const std::string& name) const;
  /// What a driver moves, for people: "P.x", "angle of crank", "distance A-B".
  std::string driver_label(int driver) const;
  /// Number of a link's body; 0 for "ground".
  int body(const std::string& name) const;
  /// True if the point stands still.
  bool is_fixed(const std::string& name) const { return point(name).body == PlanarLinkage::ground; }

  std::map<std::string, std::size_t> point_numbers;
  std::map<std::string, int> bodies;
};

/// Builds the model. Constraints are named for people: "joint B (lever, rod)", "slider C", "drive of P.y".
LinkageModel linkage_model(const LinkageFile& file);

/// A first guess of the position: every link laid as well as it can be on the file's guessed and fixed
/// points; what no point tells is laid at the middle of the rest.
PlanarPosition guessed_position(const LinkageFile& file, const LinkageModel& model);

/// Why no assembly mode was taken.
struct NoAssembly {
  /// What remained open, if nothing closes; nothing if the search was stopped.
  std::optional<Missing> missing;
  std::size_t closings = 0;        ///< how many were found
  std::vector<std::string> unmet;  ///< bounds that the best of them does not meet; empty if nothing closes
};

/// The closed positions at the start of the motion, the chosen one first: within all bounds, nearest to the
/// guess (by the sum of squared distances of guessed points), else in the order of finding.
tl::expected<std::vector<PlanarPosition>, NoAssembly> start_assembly_modes(const LinkageFile& file,
                                                                           const LinkageModel& model,
                                                                           const AssemblySearch& search = {});

}  // namespace kempe
