#pragma once
// A finished design as a value: everything design.json holds.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kempe/verification.hpp"
#include "synthesis/design/tool_advice.hpp"
#include "synthesis/loads/load_figures.hpp"
#include "synthesis/tolerance/robust.hpp"
#include "workspace/map/workspace_map.hpp"

namespace kempe {

/// Figures of merit. NaN never appears: an absent value is an empty optional.
struct Quality {
  double size = 0;              ///< mm
  double transmission_min = 0;  ///< rad, smallest over the region
  double clearance_min = 0;     ///< mm, smallest over the region
  /// mm; absent without [tolerance]
  std::optional<double> copy_error_worst, copy_error_rss, distortion_worst;
  /// mm, of an instrument within the tolerances with its loops closed; present only where first_order_understates() is true of it
  std::optional<double> copy_error_at_corner{};
  double footprint = 0;  ///< mm^2, outer bound of the area swept over the region; infinite: stopped early
  /// Of the objective, in its own unit (mm, rad, mm^2): no design can beat it.
  std::optional<double> proven_bound;
  std::optional<Robustness> robust{};  ///< absent unless it was asked for
  std::optional<LoadFigures>
      loads{};  ///< over the region; absent without [load], and where the region is not reached
  /// With pins and layers, as `loads`; absent also where the links' equations out of the plane lose their digits
  std::optional<LayeredFigures> layered{};
  std::optional<double> sag{};   ///< mm, most over the region; absent where it is not worked out
  std::optional<double> mass{};  ///< kg, of the four links; absent without [material]
};

struct SearchRecord {
  Objective objective = Objective::size;
  double value = 0;                    ///< mm, rad or mm^2
  std::vector<std::string> solvers{};  ///< names with versions, in the order of use
  std::uint64_t evaluations = 0;
  std::uint64_t seed = 0;
  bool complete = true;  ///< false if stopped early (time limit, Ctrl-C)
  /// Names of the obstacles that no permitted instrument can touch: the search left them out (obstacle_reach.hpp).
  std::vector<std::string> obstacles_out_of_reach{};
};

/// The ratio that the spec wants where the stock lengths do not allow it.
struct WantedCopy {
  double scale = 1, rotation = 0;  ///< rotation rad
  double error = 0;                ///< |k attained - k wanted|: mm of error per mm of distance from the pole
};

/// What the spec allows beside its limits: with it a design can be judged from its file alone.
struct Allowed {
  PoleSpec pole{};
  int layers = 2;                    ///< at most
  double shortest = 0, longest = 0;  ///< mm, of every length
  StockLengths stock_lengths{};
  std::vector<Grounding> groundings{};
  /// mm, least between two holes of a link; absent: an older file does not say it
  std::optional<double> wall{};
  /// mm, of the bearing or bush that links are bored for; absent: holes are those of the pins
  std::optional<double> seat{};
  std::vector<LinkSection> sections{};  ///< those to choose from; empty: there was no choice
};
Allowed allowed_by(const Spec& spec);

struct Design;
/// The spec of a searched design, as its file states it: allowed_by() and all else back in place.
Spec spec_of(const Design& design);

struct Design {
  CopyingLinkage linkage;
  std::string title{};  ///< the spec's; empty: it has none
  /// That the lengths give: as the spec gave them unless `wanted`; rotation rad.
  double scale = 1, rotation = 0;
  std::optional<WantedCopy> wanted{};
  Region region{};
  LinkStyle style{};
  LayerAssignment layers{};
  std::vector<std::string> why_not_fewer_layers{};  ///< sentences; empty with two layers
  Limits limits{};
  std::optional<Tolerance> tolerance{};
  std::vector<Obstacle> obstacles{};
  std::vector<Body> bodies{};
  std::optional<Polygon> table{};
  std::optional<ToolAdvice> tool{};
  OpeningInterval opening{};  ///< certified
  Quality quality{};
  WorkspaceMap map{};
  Region footprint{};  ///< outer bound of what all links sweep; empty if it was not asked for
  Verification verification{};
  std::optional<SearchRecord> search{};  ///< absent for `kempe workspace`
  std::optional<Allowed> allowed{};      ///< absent for `kempe workspace`, whose mechanism is given
  CuttingSpec cutting{};
  JointHardware hardware{};  ///< LinkSpec::hardware
  std::optional<Material> material{};
  std::optional<Load> load{};
};

/// The openings at which a picture may show the linkage: the certified ones; if there are none, all of its assembly mode.
inline OpeningInterval openings_to_show(const Design& design) {
  return design.opening.empty() ? design.linkage.assembly_mode().openings : design.opening;
}

}  // namespace kempe
