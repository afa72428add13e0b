#pragma once
// From a spec to the best design that keeps every limit, or to the reason why there is none; and to a front of designs.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/export.hpp"
#include "kempe/input_error.hpp"
#include "kempe/map.hpp"
#include "kempe/spec.hpp"
#include "kempe/verification.hpp"

namespace kempe {

/// How to work, for design(), map(), front(), sketch() and generate_function().
struct Options {
  std::uint64_t seed = 1;  ///< same spec and seed, same design, bit for bit
  int threads = 1;         ///< 0 and less count as 1; the design does not depend on it
  /// s of wall clock; at its end the best so far comes back, at once if it is 0 or less; absent: no limit
  std::optional<double> time_limit{};
  /// Asked often, perhaps from several threads; once true it must stay true. The best so far then comes back.
  std::function<bool()> stop{};
  /// Called with what is being done ("searching", "proving a bound", "mapping", ...) and the share of that which is done, 0..1; each
  /// begins anew. Called from one thread at a time.
  std::function<void(double share, std::string_view what)> progress{};
  bool diagnose = true;  ///< look for the least relaxations where there is no design
  /// Share of the free workspace that may stay uncertain, not NaN; 1e-5 or 0.5 where it is less or more
  double map_tolerance = 0.005;
  /// Look for the largest rectangles that fit the workspace: the slowest part of a map
  bool largest_sheets = true;
};

/// A linkage with its parts, its map and its figures: found by design(), or given and mapped by map().
///
/// A value, cheap to copy, safe to read from several threads. Lengths mm, angles rad, places in the table's frame. It holds a
/// `Design`, the library's own record from which the reports are written, and shows of it what a program needs.
class KEMPE_EXPORT FinishedDesign {
 public:
  Copy copy() const;            ///< the ratio attained; with stock lengths it may differ from the spec's
  Grounding grounding() const;  ///< what stands at V
  int assembly_mode() const;    ///< which usable interval of the opening, from 0
  Point pole() const;           ///< mm
  LinkLengths lengths() const;  ///< mm
  std::array<int, 4> layers() const;  ///< of the links VA, VB, ACX, BCY; 1 is next to the table
  OpeningInterval opening() const;    ///< certified usable opening, rad; empty if there is none

  double size() const;              ///< mm, half the perimeters of the links' hulls, summed
  double transmission_min() const;  ///< rad, smallest over the region; 0 where the region is not reached
  /// mm, smallest gap between parts while the tracer covers the region; absent where nothing can touch.
  std::optional<double> clearance_min() const;
  double footprint() const;  ///< mm^2, outer bound of the area swept while the tracer covers the region
  /// mm, worst case over the region under Spec::tolerance; absent without it.
  std::optional<double> copy_error() const;
  /// mm, most that the pen gives way over the region under Spec::load, in its worst direction; absent without it.
  std::optional<double> load_error() const;
  /// The same with pins and layers (docs/loads.md); absent also where two joints of a link are so near each other that nothing is stated.
  std::optional<double> load_error_layered() const;
  /// mm, most that tracer or pen rises or sinks under the load, by the layers of the links, without what the links' own weight along a tilted
  /// table adds; absent as above.
  std::optional<double> load_rise() const;
  /// mm, most that the pen gives way over all openings by the links' own weight along a tilted table, which load_error() is without; absent on
  /// a level table and where load_error() is.
  std::optional<double> weight_error() const;
  /// The same with pins and layers; absent also where load_error_layered() is.
  std::optional<double> weight_error_layered() const;
  /// mm, most that tracer or pen rises or sinks by the links' own weight along a tilted table, which load_rise() is without; absent as
  /// weight_error_layered().
  std::optional<double> weight_rise() const;
  /// MPa, largest stress in a link under the load, by bending and pull in the plane alone, on a tilted table with the links' own weight along
  /// it; infinite where a hole leaves nothing of a link; absent without Spec::load.
  std::optional<double> stress() const;
  /// The same with the bending and twist out of the plane that layers and weights add, as an equivalent stress (docs/loads.md): what the
  /// material's strength is compared with; absent as load_error_layered(), and where a hole leaves nothing.
  std::optional<double> stress_layered() const;
  /// mm, most that tracer or pen sinks over the region by weight and play (docs/loads-out-of-plane.md); absent without
  /// Spec::material.
  std::optional<double> sag() const;
  std::optional<double> mass() const;  ///< kg, of the four links; absent without Spec::material
  /// Width and thickness of the links, mm: of LinkSpec::sections the one chosen.
  LinkSection section() const;
  /// mm, no instrument within Spec::tolerance has a smaller gap between its parts while its tracer covers the region: proven.
  /// Absent unless Tolerance::robust asks for it, and where some instrument is not proven to close.
  std::optional<double> robust_clearance() const;

  Objective objective() const;  ///< what was made small or large; size for a given mechanism
  /// The objective's value: mm, rad (transmission), mm^2 (footprint) or kg (mass); absent for a given mechanism.
  std::optional<double> value() const;
  /// No design for the spec can be better than this, mm (size) or rad (transmission): proven, rounded outwards with the slack
  /// that docs/proven-bound.md states. Absent for other objectives, and where nothing is proven.
  std::optional<double> proven_bound() const;
  bool complete()
      const;  ///< false: the search was stopped early, a better design may exist; of the map see Map::complete()

  /// Where the six points are when the tracer stands at a place, mm; or why it cannot be reached (on the pole: too near). In
  /// closed form (docs/notation.md). Contact plays no part: see Map::at().
  std::variant<Pose, Unreachable> pose_with_tracer_at(const Point& tracer) const;

  /// Where the tracer can stand.
  const Map& map() const { return map_; }

  /// What design.json would hold (docs/design-file.md).
  std::string json() const;
  /// The whole error with what would help against each part of it, as `error_budget` of `kempe synthesize --json` (docs/loads.md); empty
  /// without Spec::load or Spec::material, and where the region is not reached.
  std::string error_budget_json() const;
  /// Mass felt at the tracer, friction, the hand's force, counterweights and springs, as `feel` of `kempe synthesize --json`
  /// (docs/loads-out-of-plane.md); empty as above.
  std::string feel_json() const;

 private:
  friend struct Workings;
  FinishedDesign(std::shared_ptr<const Design> inside, std::string spec_text);
  std::shared_ptr<const Design> inside_;
  std::string spec_text_;  ///< for the report
  Map map_;
};

/// One limit that, moved so far and alone, makes a design possible; or one obstacle that, taken away alone, does.
struct PossibleChange {
  std::string key;       ///< "links.longest_mm"; "obstacles"
  std::string sentence;  ///< "transmission_deg = 30 is in the way; 27.4 would do"
};

/// What comes of a spec: a design, or why there is none, or what is wrong with the spec.
class Outcome {
 public:
  /// What came of it.
  enum class Kind {
    design,     ///< there is one
    no_design,  ///< none was found; proven() says if none exists
    stopped,    ///< neither is known
    bad_spec    ///< fault() says what is wrong
  };

  /// What came of it.
  Kind kind() const { return kind_; }
  /// True if there is a design.
  explicit operator bool() const { return design_.has_value(); }
  /// The design. Undefined without one, as of an empty std::optional: ask first.
  const FinishedDesign& operator*() const { return *design_; }
  /// The design's members; undefined without one.
  const FinishedDesign* operator->() const { return &*design_; }

  /// Why there is no design, a sentence for a person; empty if there is one.
  const std::string& reason() const { return reason_; }
  /// True if it is proven that no design exists; else a search found none.
  bool proven() const { return proven_; }
  /// Without a design: what would make one possible, the least change first.
  const std::vector<PossibleChange>& changes() const { return changes_; }
  /// What no design for the spec can beat: mm for size, rad for transmission; absent for other objectives, and where nothing is
  /// proven. With a design FinishedDesign::proven_bound() says the same.
  const std::optional<double>& proven_bound() const { return proven_bound_; }
  /// What is wrong with the spec; present exactly for bad_spec.
  const std::optional<InputError>& fault() const { return fault_; }

 private:
  friend struct Workings;
  Kind kind_ = Kind::stopped;
  std::optional<FinishedDesign> design_;
  std::string reason_;
  bool proven_ = false;
  std::optional<double> proven_bound_;
  std::vector<PossibleChange> changes_;
  std::optional<InputError> fault_;
};

/// The best design for a spec, as docs/search.md says. The spec is checked first (validate()): its faults are the only errors.
/// Guarantees:
///  1. a design keeps every limit of the spec, evaluated anew, its contact certified, and its map covers the region;
///  2. the same spec and seed give the same outcome, bit for bit, for any number of threads (unless stopped early);
///  3. nothing is shared between calls: they may run in several threads at once.
KEMPE_EXPORT Outcome design(const Spec& spec, const Options& options = {});

/// The map of the mechanism that Spec::mechanism gives, among the spec's obstacles (docs/workspace-map.md). The limits are not required of it: the
/// map says where they are kept. Of the options seed, threads and diagnose play no part. Where the spec gives no
/// mechanism, or an area for its pole, fault() says so.
KEMPE_EXPORT Outcome map(const Spec& spec, const Options& options = {});

/// A point of a front: no other of its points is better in both objectives.
struct FrontPoint {
  double first = 0;   ///< the first objective's value: mm, rad (transmission), mm^2 (footprint) or kg (mass)
  double second = 0;  ///< the second's
  FinishedDesign design;  ///< without a bound, which would be that of the spec's own objective
};

/// A front, from the best in the first objective to the best in the second.
struct Front {
  std::vector<FrontPoint> points;  ///< in that order
  bool complete = true;  ///< false: stopped early; points are missing, or a map is coarser than asked for
  Objective first = Objective::size;           ///< of FrontPoint::first
  Objective second = Objective::transmission;  ///< of FrontPoint::second
};

/// The front between two objectives by the epsilon constraint method (docs/search.md): about `points` designs, at least 2; fewer where
/// searches give the same design again. Of several sections each has a front of about `points`; what a design of another section beats
/// is left out. All limits of the spec hold at every point, its own objective plays no part. Or, as an Outcome, why there is none; a
/// robust spec and one that lacks what an objective needs are faults, and so are two objectives that are one, and points outside 2 to
/// 200 (keys "between", "points").
KEMPE_EXPORT std::variant<Front, Outcome> front(const Spec& spec, Objective first, Objective second,
                                                int points = 15, const Options& options = {});

}  // namespace kempe
