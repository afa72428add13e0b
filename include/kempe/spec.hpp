#pragma once
// The spec as values: what a person asks for, in millimetre and radian. load() makes one from a file, already checked; a
// program fills one and validate() checks it. docs/spec.md says what each key means; the fields follow it.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/body.hpp"
#include "kempe/copy.hpp"
#include "kempe/cutting.hpp"
#include "kempe/export.hpp"
#include "kempe/grounding.hpp"
#include "kempe/links.hpp"
#include "kempe/load.hpp"
#include "kempe/material.hpp"
#include "kempe/obstacle.hpp"
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
  double clearance = 0.5;              ///< mm, >= 0
  double transmission = 30 * degree;   ///< rad, 0 <= . < pi/2
  std::optional<double> copy_gap{};    ///< mm; absent: original and copy may overlap
  std::optional<double> copy_error{};  ///< mm, worst case under Tolerance; absent: not required
  /// mm, > 0, at most: of every link over its ends, its farthest joints and half a width beyond each; absent: any
  std::optional<double> longest_strip{};
  /// mm, > 0, at most: how far the pen gives way under Spec::load in its worst direction, in the plane; absent: not required
  std::optional<double> load_error{};
  /// mm, > 0, at most: how far tracer or pen sink by weight and play; absent: not required
  std::optional<double> sag{};
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

/// What is made small or, of the transmission, large.
enum class Objective {
  size,          ///< mm, half the perimeters round the links' joints, summed; made small
  transmission,  ///< rad, the smallest transmission angle over the region; made large
  copy_error,    ///< mm, the worst case over the region under Spec::tolerance; made small
  footprint,     ///< mm^2, the area swept while the tracer covers the region; made small
  load_error,    ///< mm, the most that the pen gives way over the region under Spec::load; made small
  mass           ///< kg, of the four links of Spec::material; made small
};
/// "size", "transmission", "copy_error", "footprint", "load_error" or "mass".
KEMPE_EXPORT std::string_view name(Objective objective);
/// The objective of such a word; nothing for another one.
KEMPE_EXPORT std::optional<Objective> objective_named(std::string_view word);
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

/// Most bytes of Spec::title.
inline constexpr std::size_t most_title_bytes = 200;

/// A task: how to copy, what to cover, where to stand, what to build of.
struct Spec {
  /// Heads report and drawings: one line without control characters, at most most_title_bytes bytes; empty: none.
  std::string title;
  Copy copy;                           ///< the ratio wanted
  Region region;                       ///< what the tracer must cover, mm; may be empty beside a mechanism
  PoleSpec pole;                       ///< the origin unless given
  LinkSpec links;                      ///< what to build of
  Limits limits;                       ///< what to keep
  std::optional<Tolerance> tolerance;  ///< needed where the copy error, or robust designs, are asked for
  ToolSpec tool;                       ///< for advice on the template
  std::optional<Material>
      material{};                   ///< of the links; needed where loads, weights or the mass are asked for
  std::optional<Load> load{};       ///< at the pen; absent: nothing is said of forces and deflections
  std::vector<Obstacle> obstacles;  ///< what is in the way
  std::vector<Body> bodies;         ///< what tracer and pen carry along
  std::optional<Polygon>
      table;                ///< mm, without holes: links, pins, posts and bodies stay on it; absent: no edge
  ObjectiveSpec objective;  ///< what is sought
  std::optional<MechanismSpec> mechanism;  ///< for map() alone
  CuttingSpec cutting;                     ///< how the parts are cut
};

}  // namespace kempe
