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
#include "kempe/grounding.hpp"
#include "kempe/links.hpp"
#include "kempe/region.hpp"

namespace kempe {

/// Where the pole may stand: one place, or anywhere in a region.
struct PoleSpec {
  std::variant<Point, Region> place = Point(Point::Zero());
  bool is_fixed() const { return std::holds_alternative<Point>(place); }
};

struct Limits {
  double clearance = 0.5;                    ///< mm, >= 0
  double transmission = 0.5235987755982988;  ///< rad, 0 <= . < pi/2; 30 degrees unless given
  std::optional<double> sheets_gap;          ///< mm; absent: original and copy may overlap
  std::optional<double> copy_error;          ///< mm, worst case under Tolerance; absent: not required
};

struct Tolerance {
  double length = 0;  ///< mm, of each length
  double play = 0;    ///< mm, of each pin
};

/// Follower on the tracer, cutter on the pen: radii, mm.
struct ToolSpec {
  std::optional<double> follower_radius;
  std::optional<double> cutter_radius;
};

struct Obstacle {
  Polygon shape;
  int lowest_layer = 1;  ///< 1 is next to the table
  int highest_layer = 1;
  std::string name = {};  ///< for people: "obstacle 2" unless the spec names it; empty if not from a spec
};

enum class Objective { size, transmission, copy_error, footprint };
std::string_view name(Objective objective);
/// True for transmission only: larger is better.
bool is_maximized(Objective objective);

struct ObjectiveSpec {
  Objective objective = Objective::size;
  std::vector<Grounding> groundings{all_groundings.begin(), all_groundings.end()};
};

/// A given mechanism, for `kempe workspace`.
struct MechanismSpec {
  Grounding grounding = Grounding::pole;
  double VA = 0, VB = 0;  ///< mm
  int assembly_mode = 0;
  std::optional<std::array<int, 4>> layers;  ///< of VA, VB, ACX, BCY; absent: the best assignment is sought
};

/// How the parts are cut: what their drawings allow for.
struct CuttingSpec {
  double hole_fit = 0;  ///< mm, a hole's diameter less the pin's; negative for a press fit
  double kerf = 0;  ///< mm, >= 0, the width that the cut takes away; drawings compensate half on each side
  std::optional<Point> sheet{};  ///< mm, width and height of a sheet; absent: parts are not nested
  double gap = 5;                ///< mm, >= 0, between parts on a sheet and to its edge
};

struct Spec {
  Copy copy;
  Region region;
  PoleSpec pole;
  LinkSpec links;
  Limits limits;
  std::optional<Tolerance> tolerance;
  ToolSpec tool;
  std::vector<Obstacle> obstacles;
  ObjectiveSpec objective;
  std::optional<MechanismSpec> mechanism;
  CuttingSpec cutting;
};

}  // namespace kempe
