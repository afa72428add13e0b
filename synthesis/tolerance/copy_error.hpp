#pragma once
// Copy error: how far the pen is from its place when lengths are not what the drawing says and pins have
// play.
//
// The tracer is held where it should be; the pen's deviation is then linear, to first order, in the eight
// length errors and the five pin displacements. Derivation, the flat plates and what play means:
// docs/tolerance.md.
//
// The finding that everything here rests on: seen from bar VA the sensitivities depend on the opening d
// alone. Not on VA, VB, the pole or the place. So a limit on the copy error is a limit on the openings, as
// the transmission limit is.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/region_reach.hpp"
#include "kinematics/copying_linkage.hpp"
#include "specs/spec.hpp"

namespace kempe {

/// The pin connections, the pole counted with them. Each joins two links with its own play:
/// pole: ground - VA at V (grounding "pole") or ground - ACX at X; V: bar VB on the pin at V, which sits fast
/// in VA, or on the pole post; A: VA - ACX; B: VB - BCY; C: ACX - BCY. A tracer or pen at V sits fast in bar
/// VA.
enum class PinConnection { pole, V, A, B, C };

/// What can be off: the eight lengths in the order of LinkLengths::names, then the five pins.
inline constexpr std::size_t error_source_count = 13;
/// "VA" .. "CY", "play of the pole", "play at V" ... In a flat plate (see is_flat) the place of CX is taken
/// by "X out of line A-C" and that of CY by "Y out of line B-C".
std::string_view error_source_name(std::size_t source, bool flat);

/// Tolerances: every length lies within +-length, every pin within a disc of radius play / 2 about its hole's
/// centre (play is the difference of the two diameters). All mm, >= 0.
struct CopyTolerance {
  std::array<double, 8> length{};
  std::array<double, 5> play{};  ///< indexed by PinConnection
  static CopyTolerance uniform(const Tolerance& tolerance);
  /// The largest displacement that a source can have: the length's tolerance, or half the play.
  double of(std::size_t source) const { return source < 8 ? length[source] : 0.5 * play[source - 8]; }
};

/// True if three lengths do not define the plates: they are straight, or so flat (height over the longest
/// side below 1/20 of the shortest side) that an error of a length moves a hole by more than twenty times as
/// much. Then a plate is toleranced as a bar: two lengths from its corner (AC and AX, BC and BY) and the
/// third hole's distance out of line.
bool is_flat(Complex shape);

/// Deviation of the pen per unit of each source, as plane vectors.
struct Sensitivities {
  std::array<Complex, 8> length;  ///< mm/mm
  /// For a displacement of the pin along the frame's x and along y.
  std::array<std::array<Complex, 2>, 5> play;
  /// The same in a frame turned by `turn` (a unit complex number).
  Sensitivities turned(Complex turn) const;
};

/// First-order copy error at one place.
struct CopyErrorAt {
  double worst = 0;  ///< mm: the longest deviation that any combination of sources reaches (sum of absolute
                     ///< terms in the direction where it is largest), found to 1e-9 of itself
  /// mm: square root of the sum of squares, every source at its limit, pins against the hole's
  double rss = 0;
  ///< wall in a random direction. Lengths spread evenly over +-t give rms = rss of t / sqrt(3)
  double worst_slope = 0;   ///< d worst / d opening, mm/rad: exact where a single direction is worst
  double rss_slope = 0;     ///< mm/rad, exact
  Complex direction{1, 0};  ///< unit vector of the longest deviation, in the frame of the sensitivities
};

/// The copy error of every linkage of one ratio and grounding as a function of the opening. Invariant: k is
/// neither 0 nor 1. A value; 3 us an evaluation.
class CopyErrorProfile {
 public:
  CopyErrorProfile(Complex k, Grounding grounding, const CopyTolerance& tolerance);

  /// Sensitivities in the frame whose x axis is bar VA's direction. At the change point (sin d = 0) they grow
  /// beyond all bounds: keep away from it.
  Sensitivities sensitivities(double opening) const;
  /// Their derivatives by the opening.
  Sensitivities sensitivity_slopes(double opening) const;

  CopyErrorAt at(double opening) const;

  /// The largest `worst` and the largest `rss` over an interval of openings (ends included, interior maxima
  /// searched).
  struct Largest {
    CopyErrorAt worst, rss;
    double worst_opening = 0, rss_opening = 0;  ///< rad
  };
  Largest largest(const OpeningInterval& openings) const;

  /// The openings of `within` at which `worst` does not exceed the limit (mm), found on a grid of 0.5 degrees
  /// and refined.
  std::vector<OpeningInterval> openings_within(double limit, const OpeningInterval& within) const;

  /// Whether `worst` is above the limit (mm) at every opening of the interval, with k known to sixteen units in its last place:
  /// true is proven with directed rounding along one direction, false says nothing.
  bool surely_exceeds(double limit, const OpeningInterval& openings) const;

  /// An interval that holds every opening of `within` at which `worst` does not exceed the limit (mm): what is left out
  /// surely_exceeds() it. Wider than the tightest by a few thousandths of a radian at most. Empty if there is no such opening.
  OpeningInterval openings_not_ruled_out(double limit, const OpeningInterval& within) const;

  bool flat() const { return flat_; }
  const CopyTolerance& tolerance() const { return tolerance_; }

 private:
  /// |d worst / d opening| is nowhere larger where |sin d| is at least `sine`, but for rounding: a guess of how far to go.
  double slope_at_most(double sine) const;

  bool pole_is_at_V_, pen_is_at_V_;
  CopyTolerance tolerance_;
  Complex k_, s_, output_;  // output_: pen deviation per unit of the loops' deviation
  bool flat_;
  std::array<Complex, 3> xi_, eta_;  // hole X by AC, AX, CX in ACX's frame; hole Y by BC, BY, CY in BCY's
};

/// The profile of a linkage.
CopyErrorProfile copy_error_profile(const CopyingLinkage& linkage, const CopyTolerance& tolerance);

/// Pen's deviation per unit of each source in the table's frame, tracer at `tracer`.
tl::expected<Sensitivities, Unreachable> copy_sensitivities_at(const CopyingLinkage& linkage,
                                                               const Point& tracer);

/// First-order copy error with the tracer at `tracer` (mm, table frame); direction in the table's frame.
tl::expected<CopyErrorAt, Unreachable> copy_error_at(const CopyingLinkage& linkage,
                                                     const CopyTolerance& tolerance, const Point& tracer);

/// The longest deviation and its direction for sources with these limits. Guarantee: the returned deviation
/// is reached, and no combination of sources exceeds it by more than 1e-9 of itself.
struct LongestDeviation {
  double length = 0;        ///< mm
  Complex direction{1, 0};  ///< unit
};
LongestDeviation longest_deviation(const Sensitivities& sensitivities, const CopyTolerance& tolerance);

/// A region prepared for copy errors: its reach and places that cover it (corners, places along the rings, a
/// lattice inside), at which the similarity is fitted with equal weights.
struct ErrorPlaces {
  RegionReach reach;
  std::vector<Point> places;
};
/// `about` places, corners of rings preferred; deterministic.
ErrorPlaces error_places(const Region& region, std::size_t about = 160);

/// What one source does over the region.
struct SourceContribution {
  std::string_view name;
  double tolerance = 0;         ///< mm: the length's tolerance or half the play
  double worst = 0;             ///< mm: its largest deviation alone
  double distortion_worst = 0;  ///< mm: what of it no similarity absorbs
};

/// Copy error over a region. A similarity (a slightly different scale, rotation and origin) absorbs part of
/// what wrong lengths do: it is fitted to the places by least squares. Play changes with the load, so nothing
/// absorbs it.
struct CopyErrorOver {
  double worst = 0, rss = 0;                        ///< mm, largest over the region
  double distortion_worst = 0, distortion_rss = 0;  ///< mm, largest over the places
  double absorbed_worst = 0;  ///< mm, what the similarity alone can take away at some place
  double scale_worst = 0;     ///< relative error of the scale in the worst case
  double rotation_worst = 0;  ///< rad, error of the rotation in the worst case
  Point worst_at = Point::Zero(), distortion_at = Point::Zero();  ///< tracer, mm
  std::vector<SourceContribution> sources;  ///< thirteen, in the order of error_source_name
};

/// Nothing comes back if a place of the region is out of the linkage's reach.
tl::expected<CopyErrorOver, Unreachable> copy_error_over(const CopyingLinkage& linkage,
                                                         const CopyTolerance& tolerance,
                                                         const ErrorPlaces& region);
tl::expected<CopyErrorOver, Unreachable> copy_error_over(const CopyingLinkage& linkage,
                                                         const CopyTolerance& tolerance,
                                                         const Region& region);

}  // namespace kempe
