#pragma once
// The whole error of a made and loaded instrument: what lengths, play, load, bent pins and sag take each, and which change would take most
// of it away.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/design/design.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {

enum class ErrorSource {
  lengths,  ///< in the plane, by the tolerance of lengths
  play,     ///< in the plane, by the play of the pins
  load,     ///< in the plane, by bending and pull of the links
  pins,     ///< in the plane, by pins that bend between their layers
  layers,   ///< in the plane, by links that bend and twist out of it, since pins pull beside their middles
  own_weight,  ///< in the plane, by the links' own weight along a tilted table, with what pins and layers give under it
  weight,  ///< down, by the weight of links, pen and tracer
  tilt,    ///< down, by pins that tilt within their play
  pull     ///< down or up, by the same bending and twist as `layers`
};
/// False of those that let pen or tracer sink or rise.
bool is_in_plane(ErrorSource source);
/// True of those by which the pen gives way in the plane under the load: all in it but lengths and play.
bool is_give(ErrorSource source);
/// "lengths", "play", "links", "pins", "layers", "own weight", "weight", "tilt", "pull": for a person.
std::string_view name(ErrorSource source);

/// mm: a drop or a rise no larger is rounding, and told as none.
inline constexpr double no_drop = 1e-9;

/// One thing that a builder could do.
struct BudgetChange {
  std::string words;  ///< "15 x 6 mm instead of 15 x 5 mm"
  double after = 0;   ///< mm, what is then left of the error
  /// True where the same lengths break, with it, another limit of the spec, so that parts touch, say.
  bool needs_other_lengths = false;
};

/// One part of the error.
struct BudgetEntry {
  ErrorSource source;
  double error = 0;  ///< mm, of this source alone at its worst place of the region
  /// What would help, at most three, the best first; those that need other lengths last. None that does more harm by another part.
  std::vector<BudgetChange> changes{};
};

/// The one change that takes most of a figure away, of those that these lengths allow if any of them helps.
struct BestChange {
  BudgetChange change;  ///< `after`: of the figure
  double before = 0;    ///< mm, the figure as it is
  ErrorSource mostly;   ///< the entry of which it takes most away
};

/// All parts, those in the plane first, each group from the largest to the least. The sum of a group is no less than what its parts do together
/// at any one place, as far as each is right by itself: lengths and play are of the first order (copy_error.hpp).
struct ErrorBudget {
  std::vector<BudgetEntry> entries;
  /// False where the equations of the links' bending out of the plane lose their digits: then `layers` and `pull` are not stated, and sums lack
  /// them.
  bool states_layers = true;
  /// mm, how far the pen gives way in the plane, with pins, layers and the links' own weight: the most at any one place, and so no more than the
  /// sum of its entries. Without the layers where they are not stated.
  double give = 0;
  /// What would help most: against the sum in the plane, the sum out of it, and `give`; absent where nothing helps.
  std::optional<BestChange> best_in_plane{}, best_down{}, best_against_give{};
  /// mm, of the entries in the plane or of the others.
  double sum(bool in_plane) const;
  /// True if best_in_plane is best_against_give.
  bool is_one_change_for_both() const;
  /// What best_down works against: "against sinking", "against what the load lifts or lowers", or both.
  std::string_view help_out_of_plane() const;
  /// True if the links' own weight pulls along the table.
  bool has_own_weight() const;
  /// True if the load lifts or lowers tracer or pen: then what is not in the plane is down or up.
  bool pulls() const;
};

/// Of a design with load and material whose assembly mode reaches the region; nothing otherwise.
std::optional<ErrorBudget> error_budget(const Design& design);

/// mm, as ErrorBudget::give, by the design's figures alone; nothing without a load, and where what the layers add is not stated.
std::optional<double> give_in_all(const Quality& quality);

/// The parts at single openings, for pictures; mm.
class ErrorCourse {
 public:
  /// Of a design as above.
  explicit ErrorCourse(const Design& design);
  double tolerances(double opening) const;  ///< lengths and play together; 0 without a tolerance
  double give(double opening)
      const;  ///< load, pins, layers and own weight together; infinite where the layers are not stated
  double sag(double opening) const;  ///< of tracer or pen; infinite where the equations say nothing

 private:
  BarLengths bars_;
  LoadErrorProfile give_;
  LayeredErrorProfile layered_;
  SagProfile sag_;
  std::optional<CopyErrorProfile> tolerances_{};
};

}  // namespace kempe
