#pragma once
// A number that no design can beat: a proven lower bound of `size`, or upper bound of the transmission angle,
// over every permitted grounding, assembly mode, layer assignment, pair of lengths and place of the pole.
//
// Branch and bound with interval arithmetic over a relaxation of the problem: the reach, the transmission
// limit, the lengths' limits, the copy error, the gap between original and copy and the linkage's contact with
// itself, with obstacles, bodies and the table's edge (at places of the tracer) are kept; the stock lengths are not. Steps and
// proof: docs/proven-bound.md.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "kinematics/stop_flag.hpp"
#include "specs/spec.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// A design that keeps all limits looked at: a start for the search, and mostly its result.
struct RelaxedDesign {
  Grounding grounding = Grounding::pole;
  int assembly_mode = 0;
  double VA = 0, VB = 0;       ///< mm
  Point pole = Point::Zero();  ///< mm
  LayerAssignment layers;      ///< meaningless if contact was not looked at
};

/// What a search makes of a design of the tree.
struct Trial {
  /// Value of the best design that is certain by now: mm of size, rad of transmission.
  std::optional<double> best{};
  /// Places of the tracer where an obstacle was met, for this design's layers.
  std::vector<Point> in_the_way;
  /// Nothing came of it and nothing was learnt: the same design would fare the same again.
  bool in_vain = false;
};

/// About the value (mm or rad) of a design next to this one; nothing if none is found.
using ValueNear = std::function<std::optional<double>(const RelaxedDesign&)>;

/// The tree as a search. First it is a bound, but only what the trials made certain counts as known; then, where `tolerance` is smaller than
/// that of the bound, it goes on with the obstacles where and as far away as the search keeps them, until it closes on the search's own optimum.
struct Trials {
  std::function<Trial(const RelaxedDesign&)> run;
  /// Of designs that keep all but the limit on the load error; asked only where there is such a limit.
  ValueNear without_load_limit{};
  int most = 0;  ///< trials, all of the last box included; the tree ends with them where none led to a design
  std::vector<Point> places{};  ///< of the tracer: where the search looks at obstacles
  double margin = 0;            ///< mm that it keeps away from them beyond the clearance
  double tolerance =
      0;  ///< share of the best value known: nothing better by more is to be left; may be more than the bound's
  /// BoundOptions::share_of_gap of the bound of designs that need not keep the limit on the load error (ProvenBound::without_load_limit).
  double share_of_load_limit = 0;
};

struct BoundOptions {
  /// Value of a design already found (mm of size, rad of transmission): the bound need not rise above it.
  std::optional<double> incumbent = std::nullopt;
  /// The search ends when bound >= (1 - tolerance) * best value known (for transmission: bound <= (1 +
  /// tolerance) * it).
  double tolerance = 0.001;
  /// It also ends once gap(bound, best value met) <= this share * gap(best value met, incumbent).
  double share_of_gap = 0;
  /// Boxes that may be looked at (a box's test for contact in a layer assignment counts as one more, one for obstacles by what it
  /// costs): what limits the time, so that the result does not depend on the machine.
  std::size_t boxes = 200000;
  /// Keep contact of the linkage with itself. Without it the bound is looser, but found in a few hundred
  /// boxes.
  bool self_contact = true;
  /// Keep the limit on the load error too, if there is one. No line of a proof's log speaks of it (docs/proof.md), so a bound that is told
  /// goes without.
  bool load_limit = false;
  /// Least distance of two joints of a link, mm, instead of the spec's least_joint_distance().
  std::optional<double> shortest = std::nullopt;
  /// Threads that set up the tests for obstacles; the tree itself grows on one.
  int threads = 1;
  /// Ends the tree early: what is proven so far comes back, as when the boxes run out.
  StopFlag stop{};
  /// Told now and then the share of the work done, 0..1, which never falls: of the gap that was to be closed, or of the boxes.
  std::function<void(double share)> progress{};
};

struct ProvenBound {
  /// No design of the spec has a smaller size (mm), or a larger transmission angle (rad). Meaningless if
  /// no_design.
  double value = 0;
  /// It is proven that no design keeps the limits looked at: then none keeps all of them.
  bool no_design = false;
  /// The tolerance was reached; else the boxes ran out first, and the bound is valid but may be looser than
  /// need be.
  bool tight = false;
  /// Of a search: so was that of the trials.
  bool exhausted = false;
  /// Of a search with a limit on the load error, if tight: the same bound of designs that need not keep it. Absent if it was stopped.
  std::optional<double> without_load_limit{};
  /// Best value of the relaxation that was met (incumbent included): a better bound than this cannot be had
  /// by it. Absent if none was met.
  std::optional<double> relaxation;
  /// The best design of the relaxation met, if it is better than the incumbent. Limits are kept to 1e-9
  /// (rad).
  std::optional<RelaxedDesign> design;
  /// The middle of the most promising boxes that were left when the boxes ran out, the best first, at most one a grounding
  /// and assembly mode: no designs, but places where one better than `relaxation` may hide. Empty if tight.
  std::vector<RelaxedDesign> promising;
  /// The bound if the vertex were one of these alone (indexed by Grounding); absent where none is possible or
  /// permitted. Groundings worse than the best are looked at no longer than needed, so theirs are loose.
  std::array<std::optional<double>, 3> by_grounding;
  std::size_t boxes = 0;  ///< looked at, counted as in BoundOptions::boxes
};

/// Where a search may start: the design and the promising places of a bound.
std::vector<RelaxedDesign> starts_of(const ProvenBound& bound);

/// The bound for the spec's objective; nothing for objectives other than size and transmission, for a spec without a region, or if it was
/// stopped before every grounding had been looked at. Deterministic unless stopped. Guarantee: value <= size of every design that keeps
/// the spec's limits with the exact ratio k (transmission: >=).
std::optional<ProvenBound> proven_bound(const Spec& spec, const BoundOptions& options = {});

/// The same for an objective of the caller's choice.
std::optional<ProvenBound> proven_bound(const Spec& spec, Objective objective,
                                        const BoundOptions& options = {});

/// The same as a search, in the spec's own frame; nothing where proven_bound() gives nothing.
std::optional<ProvenBound> searched_by_tree(const Spec& spec, Objective objective,
                                            const BoundOptions& options, const Trials& trials);

}  // namespace kempe
