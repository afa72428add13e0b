#pragma once
// The spec as values: what a person asks for, in millimetre and radian. load() makes one from a file, already checked; a
// program fills one and validate() checks it. docs/spec.md says what each key means; the fields follow it.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/copy.hpp"
#include "kempe/export.hpp"
#include "kempe/grounding.hpp"
#include "kempe/links.hpp"
#include "kempe/region.hpp"

namespace kempe {

/// Where the pole may stand: one place, or anywhere in a region.
struct PoleSpec {
  /// mm; a region without holes.
  std::variant<Point, Region> place = Point(Point::Zero());
  /// True for one place.
  bool is_fixed() const { return std::holds_alternative<Point>(place); }
};

/// What every design must keep over the whole region.
struct Limits {
  double clearance = 0.5;             ///< mm, >= 0
  double transmission = 30 * degree;  ///< rad, 0 <= . < pi/2
  std::optional<double> sheets_gap;   ///< mm; absent: original and copy may overlap
  std::optional<double> copy_error;   ///< mm, worst case under Tolerance; absent: not required
};

/// How far an instrument as made may be off, plus or minus.
struct Tolerance {
  double length = 0;  ///< mm, of each length
  double play = 0;    ///< mm, of each pin
  /// Every instrument within these tolerances must cover the region on its assembly mode and keep the clearance.
  bool robust = false;
};

/// Follower on the tracer, cutter on the pen: radii, mm.
struct ToolSpec {
  std::optional<double> follower_radius;  ///< of the tracer
  std::optional<double> cutter_radius;    ///< of the pen
};

/// Something in the way of links, pins and posts, in some of the layers.
struct Obstacle {
  Polygon shape;          ///< mm, without holes
  int lowest_layer = 1;   ///< 1 is next to the table
  int highest_layer = 1;  ///< >= lowest_layer, at most 8
  std::string name = {};  ///< for people: "obstacle 2" unless the spec names it; empty if not from a spec
};

/// What is made small or, of the transmission, large.
enum class Objective { size, transmission, copy_error, footprint };
/// "size", "transmission", "copy_error" or "footprint".
KEMPE_EXPORT std::string_view name(Objective objective);
/// True for transmission only: larger is better.
KEMPE_EXPORT bool is_maximized(Objective objective);

/// What is sought, and among which groundings.
struct ObjectiveSpec {
  Objective objective = Objective::size;  ///< of the design
  /// Those that are looked at; at least one, each once.
  std::vector<Grounding> groundings{all_groundings.begin(), all_groundings.end()};
};

/// A given mechanism, for map() and `kempe workspace`.
struct MechanismSpec {
  Grounding grounding = Grounding::pole;  ///< what stands at V
  double VA = 0;                          ///< mm
  double VB = 0;                          ///< mm
  int assembly_mode = 0;                  ///< which usable interval of the opening, from 0 upward from -pi
  std::optional<std::array<int, 4>> layers{};  ///< of VA, VB, ACX, BCY; absent: the best assignment is sought
};

/// How the parts are cut: what their drawings allow for.
struct CuttingSpec {
  double hole_fit = 0;  ///< mm, a hole's diameter less the pin's; negative for a press fit
  double kerf = 0;  ///< mm, >= 0, the width that the cut takes away; drawings compensate half on each side
  std::optional<Point> sheet{};  ///< mm, width and height of a sheet; absent: parts are not nested
  double gap = 5;                ///< mm, >= 0, between parts on a sheet and to its edge
};

/// A task: how to copy, what to cover, where to stand, what to build of.
struct Spec {
  Copy copy;                           ///< the ratio wanted
  Region region;                       ///< what the tracer must cover, mm; may be empty beside a mechanism
  PoleSpec pole;                       ///< the origin unless given
  LinkSpec links;                      ///< what to build of
  Limits limits;                       ///< what to keep
  std::optional<Tolerance> tolerance;  ///< needed where the copy error, or robust designs, are asked for
  ToolSpec tool;                       ///< for advice on the template
  std::vector<Obstacle> obstacles;     ///< what is in the way
  ObjectiveSpec objective;             ///< what is sought
  std::optional<MechanismSpec> mechanism;  ///< for map() alone
  CuttingSpec cutting;                     ///< how the parts are cut
};

}  // namespace kempe
