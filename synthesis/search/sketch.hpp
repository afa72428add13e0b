#pragma once
// A design for a spec that differs a little from one whose design is known: what a page shows while a handle is dragged.
//
//   follow    the last design's choice, solved anew from its lengths and pole, certified like any design
//   compare   the bound's tree without contact, in few boxes: how far any other design may be better, and where it would be
//   switch    to a design of another grounding, assembly mode or layers, where the bound leaves room for one
//   look      where that leaves it open, in turn: one of the last designs of other choices is followed too, or one choice is
//             looked at as a search does
//
// Bodies and many layers make some hundred choices. Then of those that differ in their layers alone a sketch solves the few that
// promise most and some in turn, and it either switches or looks: a frame is over before all have been solved.
//
// A sketch keeps every limit, as a search's design does; of the gap to obstacles it says no more than that it is at least the
// clearance limit. What it lacks is the search: another design may be better, by no more than the distance from the bound.

#include <cstddef>
#include <optional>
#include <vector>

#include "synthesis/search/steps/outcome.hpp"
#include "synthesis/search/steps/search_options.hpp"

namespace kempe {

/// How much work a sketch may take. Counts, no times: the same sketch on every machine.
struct SketchBudget {
  std::size_t boxes = 600;  ///< of the bound's tree
  double near = 0.01;       ///< share of the bound: a design so near to it is not compared with others
  /// Of the one choice that a sketch looks at as a search does, the choices in turn, while the design is not near its bound.
  ChoiceBudget look{.poles = 4, .lattice = 8, .evaluations = 60, .starts = 3, .starts_if_none = 5};
  /// With more choices than these, of those that differ in their layers alone a sketch solves so many that promise most, and
  /// another one so many in turn.
  std::size_t choices = 24, promising = 2, in_turn = 2;
  /// Among obstacles, and with many choices.
  ChoiceBudget brief_look{.poles = 3, .lattice = 3, .evaluations = 10, .starts = 1, .starts_if_none = 2};
};

/// A sketch, and what the next one begins with.
struct SketchedDesign {
  std::optional<FoundDesign> design{};  ///< absent: none was found near the last one
  /// What no design can beat, of the objective in its own unit, proven; absent where the tree did not end, or the objective has none.
  std::optional<double> bound{};
  bool proven_none = false;  ///< it is proven that no design exists
  /// The last design that was found, in the coordinates of the table: where the next sketch begins.
  std::optional<FoundDesign> last{};
  /// The last designs of other choices, at most one a choice: they are followed in turn, for one of them may become the best.
  std::vector<FoundDesign> others{};
  /// Counts the sketches of one drag: whose turn it is among the other choices.
  std::size_t count = 0;
};

/// The sketch that a search's design is.
SketchedDesign sketch_of(const FoundDesign& design);

/// The sketch of `spec` from that of a spec that differs a little; a stop ends it with what is known. Guarantees:
///  1. a design keeps every limit of the spec, evaluated anew, its contact and its obstacles certified;
///  2. the same arguments give the same sketch, bit for bit, unless stopped;
///  3. nothing comes back where nothing was found, or where only a search can choose: lengths of a grid or a stock, one of several
///     sections, and robust designs.
SketchedDesign sketched(const Spec& spec, const SketchedDesign& previous, const SketchBudget& budget = {},
                        const StopFlag& stop = {});

}  // namespace kempe
