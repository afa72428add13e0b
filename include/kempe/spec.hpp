#pragma once
// The spec as values: what a person asks for, in millimetre and radian. load() makes one from a file, already checked; a
// program fills one and validate() checks it. docs/spec.md says what each key means; the fields follow it.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/export.hpp"
#include "kempe/links.hpp"
#include "kempe/mechanism.hpp"
#include "kempe/point.hpp"

namespace kempe {

/// How well pairs of points fit a similarity (complex least squares).
struct PairFit {
  std::size_t pairs = 0;              ///< that were fitted
  double residual_rms = 0;            ///< mm, at the pen
  double residual_largest = 0;        ///< mm, at the pen
  Point translation = Point::Zero();  ///< the similarity's value at the tracer's origin, mm
};

/// A copy ratio: pen - pole = k (tracer - pole).
///
/// Invariant: scale(), rotation() and k() are the same ratio; only the functions below make one. Nothing is refused here:
/// validate() says what no linkage can copy by.
class KEMPE_EXPORT Copy {
 public:
  /// Scale 1 without rotation: a translation, which has no pole, until a ratio is given.
  Copy() = default;

  /// From a scale (> 0) and a rotation, rad, counter-clockwise. Both are kept as they are, 0, negative numbers and NaN too:
  /// validate() and design() refuse them, under copy.scale or copy.rotation_deg. k is exact at whole quarter turns, where sine
  /// and cosine round.
  static Copy of(double scale, double rotation);
  /// From the ratio itself: scale |k|, rotation arg k in (-pi, pi]. k is kept as it is, 0 and NaN too: validate() and design()
  /// refuse them.
  static Copy of(Complex k);
  /// The same, of a ratio that pairs of points determined; `fit` is kept for the report, its translation in the table's frame.
  static Copy fitted(Complex k, const PairFit& fit);

  double scale() const { return scale_; }                     ///< |k|
  double rotation() const { return rotation_; }               ///< rad
  Complex k() const { return k_; }                            ///< the ratio itself
  const std::optional<PairFit>& fit() const { return fit_; }  ///< present if pairs gave the ratio

 private:
  Copy(double scale, double rotation, Complex k) : scale_(scale), rotation_(rotation), k_(k) {}

  double scale_ = 1, rotation_ = 0;
  Complex k_{1, 0};
  std::optional<PairFit> fit_;
};

/// The point that carries a body.
enum class Carrier { tracer, pen };

/// A disc.
struct Disc {
  Point centre = Point::Zero();  ///< mm
  double radius = 0;             ///< mm, > 0
};

/// A body that tracer or pen carries along. It keeps its direction, or turns with a link: then it is fixed to that link, a part of its
/// plate. Nothing is asked of it and the links that have its point, nor of two bodies of one point: they are mounted on each other. Of a
/// body that turns and the pins of its own link nothing is asked either: they do not move against each other.
struct Body {
  Carrier at = Carrier::pen;  ///< what carries it
  std::variant<Disc, Polygon>
      shape;  ///< mm, seen from that point, along the table's axes or the link's; a polygon without holes
  int lowest_layer = 1;   ///< 1 is next to the table
  int highest_layer = 1;  ///< >= lowest_layer, at most 8
  std::string name = {};  ///< for people: "body 2" unless the spec names it; empty if not from a spec
  /// The link that it turns with, one that has its point: its x axis leads from there to the nearest of the link's other joints, of two
  /// equally near ones to the first of the link's name. Absent: it keeps its direction.
  std::optional<Link> turns_with = {};
};

/// Something in the way of links, pins and posts, in some of the layers.
struct Obstacle {
  Polygon shape;          ///< mm, without holes
  int lowest_layer = 1;   ///< 1 is next to the table
  int highest_layer = 1;  ///< >= lowest_layer, at most 8
  std::string name = {};  ///< for people: "obstacle 2" unless the spec names it; empty if not from a spec
};

/// The load of a copying linkage: a force at the pen in any direction in the plane, while pole and tracer are held; the masses that
/// its points carry; and what holds all this up: the pole's post and the points that rest on the table. Needs a material (Spec::material).
struct Load {
  double pen_force = 0;          ///< N, > 0
  std::vector<Carrier> rests{};  ///< each once; empty: only the pole's post carries the weight
  double pen_mass = 0;           ///< kg, >= 0, carried by the pen: a router
  double tracer_mass = 0;        ///< kg, >= 0, carried by the tracer
  double tilt = 0;               ///< rad, 0 to pi/2, of the table from level about its x axis, y uphill
  std::optional<double>
      grip{};              ///< mm, > 0: of a pin in the link that turns on it; absent: the links' thickness
  double friction = 0.15;  ///< >= 0, coefficient of friction in the pins
  /// True if the table carries that point.
  bool rests_at(Carrier point) const { return std::find(rests.begin(), rests.end(), point) != rests.end(); }
  bool operator==(const Load&) const = default;
};

/// How holes are made.
enum class Process { laser, mill, print, drill };
/// "laser", "mill", "print" or "drill".
KEMPE_EXPORT std::string_view name(Process process);
/// The fit (mm) that lets a link turn on its pin where holes are made so (docs/hardware.md has the sources): laser 0.1, mill
/// 0.05, print 0.3, drill 0.1.
KEMPE_EXPORT double usual_fit(Process process);

/// How the parts are cut: what their drawings allow for.
struct CuttingSpec {
  std::optional<Process> process{};  ///< absent: not said
  double hole_fit = 0;               ///< mm, a hole's diameter less the pin's; negative for a press fit
  double kerf = 0;  ///< mm, >= 0, the width that the cut takes away; drawings compensate half on each side
  std::optional<Point> stock_sheet{};  ///< mm, width and height of a sheet; absent: parts are not nested
  double gap = 5;                      ///< mm, >= 0, between parts on a sheet and to its edge
};

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
  /// What the pen gives way by pins, layers and the links' own weight counts towards `load_error` too; false: the links alone do.
  bool load_error_in_all = false;
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

/// A spec of a job, with notes.
struct SpecTemplate {
  std::string_view name;     ///< "sign-router"
  std::string_view purpose;  ///< what it is for, a line: its first note
  std::string_view spec;     ///< TOML (docs/spec.md)
};

/// All of them, in the order in which they are listed.
KEMPE_EXPORT std::span<const SpecTemplate> spec_templates();

}  // namespace kempe
