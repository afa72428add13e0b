#pragma once
// The spec as values: what a person asks for, already checked, in millimetre and radian. spec_reader.hpp makes it
// from TOML; a program may fill it directly.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/region.hpp"
#include "kinematics/copying_linkage.hpp"

namespace kempe {

/// How well pairs of points fit a similarity (complex least squares).
struct PairFit {
  std::size_t pairs = 0;
  double residual_rms = 0;            ///< mm, at the pen
  double residual_largest = 0;        ///< mm, at the pen
  Point translation = Point::Zero();  ///< the similarity's value at the tracer's origin, mm
};

struct CopySpec {
  double scale = 1;            ///< > 0
  double rotation = 0;         ///< rad, in (-pi, pi]
  Complex k{1, 0};             ///< copy_ratio(scale, rotation): use this, it is exact at quarter turns
  std::optional<PairFit> fit;  ///< present if the spec gave pairs
};

/// Where the pole may stand: one place, or anywhere in a region.
struct PoleSpec {
  std::variant<Point, Region> place = Point(Point::Zero());
  bool is_fixed() const { return std::holds_alternative<Point>(place); }
};

enum class PlateStyle {
  bent,     ///< two arms: C-A-X with its corner at A, C-B-Y with its corner at B
  triangle  ///< the hull of the three joints
};

/// What the links are made of: all that decides their outlines.
struct LinkStyle {
  double width = 12;        ///< mm, > 0; a bar is its segment grown by half of this
  double pin_diameter = 6;  ///< mm, > 0, <= width
  double thickness = 4;     ///< mm, > 0
  PlateStyle plate = PlateStyle::bent;
  bool operator==(const LinkStyle&) const = default;
};

/// Lengths that the workshop dictates.
struct WorkshopSpec {
  std::optional<double> grid;                   ///< mm: lengths are multiples of this
  std::vector<double> stock;                    ///< mm: lengths are from this list; empty: any
  std::array<std::optional<double>, 8> locked;  ///< mm, in the order of LinkLengths::names
  bool any() const;
};

struct LinkSpec {
  LinkStyle style;
  int layers = 2;        ///< at most, >= 2
  double shortest = 15;  ///< mm, between joints of one link
  double longest = 400;  ///< mm
  std::optional<double>
      wall{};  ///< mm, > 0, least wall between two holes of a link; absent: a tenth of the pin
  WorkshopSpec workshop;
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
  CopySpec copy;
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

/// The least wall between two holes of a link, mm: `links.wall`, or what stands in for it.
double least_wall(const Spec& spec);
/// What a joint takes of its link, mm: the pin's diameter, or the hole's if that is wider.
double joint_width(const Spec& spec);
/// The distance of two joints of a link whose holes have no more than the least wall between them, mm.
double hole_distance(const Spec& spec);
/// The least distance of two joints of a link, mm: `links.shortest`, or hole_distance() if that is more. All eight lengths
/// of a linkage keep it: they are the distances of all pairs of joints that share a link.
double least_joint_distance(const Spec& spec);
/// The thickest pin with which hole_distance() is `distance` (mm); 0 or less if there is none.
double pin_for_hole_distance(const Spec& spec, double distance);

}  // namespace kempe
