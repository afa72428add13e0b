#pragma once
// design.json: a design as a file, and the file read back without trusting a word of it.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/input_error.hpp"
#include "synthesis/design/design.hpp"
#include "synthesis/verification/verification.hpp"

namespace kempe {

/// The file's text: the keys of docs/design-file.md, in its order. Lengths mm and angles degrees with full double precision, a
/// newline at the end; what is absent or infinite is null. The text depends on the design alone, not on the
/// locale.
std::string design_json(const Design& design);

/// What design.json says, with null for the region, which may have a million corners.
nlohmann::ordered_json design_values(const Design& design);

/// What the file states of the map; absent where it says nothing.
struct StoredMap {
  std::optional<double> reachable, usable, collision_free, uncertain;  ///< mm^2
  std::optional<double> map_tolerance;                                 ///< share, of MapOptions
  std::vector<FittingSheet> sheets;                                    ///< the largest one among them
};

/// What the file states of the search beside its objective and value.
struct StoredSearch {
  std::vector<std::string> solvers;
  std::uint64_t evaluations = 0, seed = 0;
  bool complete = true;
};

/// What a design file says, checked for form but not believed: `mechanism.lengths` are those of the file even
/// if they no longer close or copy, so that verification can see it.
struct StoredDesign {
  std::string title;               ///< empty: the file has none
  double scale = 1, rotation = 0;  ///< wanted; rotation rad
  Complex k{1, 0};                 ///< copy_ratio(scale, rotation)
  Region region;
  Grounding grounding = Grounding::pole;
  Complex shape{1, 0};
  std::optional<int> assembly_mode;  ///< absent in a file of the contract's minimal form
  /// The eight lengths, the orientation, the places and the opening, all as stored.
  DrawnMechanism mechanism;
  LinkStyle style;
  LayerAssignment layers;
  std::optional<Material> material;  ///< absent: the spec gave none
  std::optional<Load> load;
  JointHardware hardware;              ///< plain pins unless the file says otherwise
  std::optional<Limits> limits;        ///< absent in a file of the contract's minimal form
  std::optional<Tolerance> tolerance;  ///< absent: the spec gave none
  std::vector<Obstacle> obstacles;
  std::vector<Body> bodies;
  std::optional<Polygon> table;
  std::optional<Allowed> allowed;  ///< absent: the file says nothing, or that the mechanism was given
  std::optional<CuttingSpec> cutting;
  Quality quality;                  ///< as claimed
  std::optional<double> footprint;  ///< mm^2, as claimed
  bool region_covered = false;      ///< as claimed
  StoredMap map;                    ///< as claimed
  Verification verification;        ///< as claimed; not yet believed
  std::optional<WantedCopy> wanted;
  std::optional<ToolAdvice> tool;
  std::optional<Objective> objective;  ///< that was searched for
  std::optional<double> value;         ///< its value, as claimed, in the file's unit (mm, degrees, mm^2)
  StoredSearch search;                 ///< as claimed
  /// Tables of the top level that the file has, null or not; and keys that this version does not know.
  std::vector<std::string> tables, unknown_keys;
};

/// Reads a design file's text. `file` is its name for messages. Refused, with the key, what stands there and
/// what is allowed: text that is no JSON or cut short (with its line), another format, missing keys, wrong
/// types, keys that stand twice, numbers that are not finite or out of range, links or joints that are not
/// those of the mechanism.
tl::expected<StoredDesign, InputError> read_design(std::string_view text, const std::string& file);

/// What a stored design's map is made of, `linkage` being linkage_of() it: its limits, obstacles, bodies and table, no region.
MapTask map_task(const StoredDesign& design, const CopyingLinkage& linkage);

/// The check of a stored design, from its stored lengths alone.
VerificationTask verification_task(const StoredDesign& design);

/// The linkage in closed form that the file describes, or why its figures contradict each other: lengths that
/// are not those of this shape, an opening or an orientation of no assembly mode mode (all to 1e-9 of the mechanism's
/// size).
tl::expected<CopyingLinkage, InputError> linkage_of(const StoredDesign& design, const std::string& file);

}  // namespace kempe
