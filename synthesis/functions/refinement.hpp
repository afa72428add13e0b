#pragma once
// The inner nouns of the function generator, shared by its fit through precision points and its search for
// the least error.

#include <array>
#include <limits>
#include <optional>

#include "synthesis/functions/function_generator.hpp"

namespace kempe {

/// The dials' pointers at x_lower and at y's smallest value, rad.
struct Starts {
  double input, output;
};

/// A place of the range with the wanted angles there, measured from the starts.
struct WantedPlace {
  double x = 0;
  double input_turn = 0, output_turn = 0;  ///< rad
  double weight = 0;                       ///< its part of a mean over x
  double cosine = 1, sine = 0;             ///< of input_turn
};

/// Why a function cannot be shown by a dial, or not be followed.
struct NoDial {
  std::string found, allowed;
  bool proven = true;  ///< false: told by the places looked at alone
};
NoDial not_finite_at(const FunctionTask& task, double x);

/// The wanted pairs of angles, measured from the starts.
class WantedAngles {
 public:
  explicit WantedAngles(const FunctionTask& task);
  double input_turn(double x) const;          ///< rad, 0 at x_lower
  double output_turn(double x) const;         ///< rad, 0 at y's smallest value
  double value_at(double output_turn) const;  ///< y that the dial shows
  WantedPlace place_at(double x) const;       ///< with weight 0
  double y_lower() const { return y_lower_; }
  double y_upper() const { return y_upper_; }
  /// What stands against the function, as far as samples show: a place without a value, a pole, no or too many ups and
  /// downs. Nothing: it has a dial.
  const std::optional<NoDial>& no_dial() const { return no_dial_; }
  /// rad: how far the function strays from straight between two places where the places ran out; else 0.
  double unseen() const { return unseen_; }
  const std::vector<double>& precision_points() const { return precision_; }  ///< ascending

  /// Ascending, both ends among them, so dense that the function is nearly straight between two: at least 129, more
  /// where it is steep or bends. Simpson's weights; they add up to 1. Empty without a dial.
  const std::vector<WantedPlace>& places() const { return places_; }
  /// About `count` of the places, both ends among them, spread evenly by a third each over x, over the way of the output
  /// dial, and towards the ends as Chebyshev does: ripples are narrow at the ends and where the function is steep.
  std::vector<WantedPlace> some_places(int count) const;

 private:
  std::optional<NoDial> sampled();
  std::optional<NoDial> lay_out_places();
  std::optional<NoDial> seen_whole() const;

  const FunctionTask& task_;
  double y_lower_, y_upper_, unseen_ = 0;
  std::optional<NoDial> no_dial_;
  std::vector<double> precision_;
  std::vector<WantedPlace> places_;
};

/// By how much the output crank turns back where the wanted function does not: the largest such amount, and between which
/// places.
struct Retreat {
  double amount = 0;  ///< rad, >= 0
  std::size_t from = 0, to = 0;
  int direction = 1;  ///< in which the wanted function goes there
};
Retreat worst_retreat(const std::vector<WantedPlace>& places, const std::vector<double>& errors);

/// A retreat up to this is allowed, rad: less happens within the error at the level end of a sine.
double allowed_retreat(const FunctionTask& task);

struct FunctionCandidate {
  FunctionDesign design;
  FunctionDefect defect = FunctionDefect::lengths;
  /// By how much the limits are exceeded, 0 without defect: falls steadily towards the designs within them. Infinite
  /// where nothing can be said.
  double broken = std::numeric_limits<double>::infinity();

  /// What a search makes small: the largest error, beyond every error what is broken.
  double cost() const;
};

/// Fills the design's figures for its linkage and starts and looks for the first defect.
FunctionDefect measure_design(const FunctionTask& task, const WantedAngles& wanted, FunctionDesign& design);

/// By how much a design exceeds its limits, see FunctionCandidate.
double broken_limits(const FunctionTask& task, const WantedAngles& wanted, const FunctionDesign& design);

/// Fills what a report needs besides: the curve, the error's mean square to rounding (as the search had it, if that was
/// stopped). Gives a place where the function turned out not to be finite.
std::optional<double> complete_design(const FunctionTask& task, const WantedAngles& wanted,
                                      FunctionDesign& design);

/// Where a design's error vanishes, ascending; by straight lines between the places once the work is stopped.
std::vector<double> zeros_of(const FunctionTask& task, const WantedAngles& wanted,
                             const FunctionDesign& design);

/// A linkage with its starts, not yet driven: nothing if the coefficients are none of a four-bar.
std::optional<FunctionDesign> design_from(const FunctionTask& task, const WantedAngles& wanted,
                                          const Starts& starts, const FreudensteinCoefficients& coefficients);

/// The linkage through the first three precision points, driven over the whole range and judged.
FunctionCandidate judged(const FunctionTask& task, const WantedAngles& wanted, const Starts& starts);

/// Freudenstein's linear equations at the first three precision points.
std::optional<FreudensteinCoefficients> coefficients_through_first_three(const WantedAngles& wanted,
                                                                         const Starts& starts);

/// The candidates through the precision points that a search has seen.
struct PrecisionSearch {
  std::optional<FunctionDesign> best;            ///< without defect, smallest largest error
  std::array<std::size_t, defect_kinds> seen{};  ///< by defect
  std::string extent;                            ///< what was looked at, for a person
  std::size_t candidates() const;
  void add(const FunctionCandidate& candidate);
};

/// The four-bars through `points` Chebyshev points: all where finitely many pass them; where starts are free beyond that,
/// the whole family on a grid, and every dip of the cost from there.
PrecisionSearch search_precision_points(const FunctionTask& task, const WantedAngles& wanted);

/// Least cost near starts, by the free ones (Subplex; at most two, a grid's step apart).
Starts refined_starts(const FunctionTask& task, const WantedAngles& wanted, const Starts& starts,
                      double step);

/// Least transmission angle that the search keeps, rad: at 0 the output crank stands at its dead point.
double kept_transmission(const FunctionTask& task);

/// What a least-squares fit weighs evenly: the range of x, or the places where a largest error may hide.
enum class SquareWeights { even_in_x, even_in_places };
inline constexpr int all_places = 0;  ///< instead of a number of places

/// The smallest mean square error near a design (which need not keep the limits), all lengths and free starts
/// varied, the limits kept. Nothing if none is found that keeps them.
std::optional<FunctionDesign> least_squares_fit(const FunctionTask& task, const WantedAngles& wanted,
                                                const FunctionDesign& start, SquareWeights weights,
                                                int places);

/// The same for the smallest largest error; the start may break the limits.
std::optional<FunctionDesign> minimax_fit(const FunctionTask& task, const WantedAngles& wanted,
                                          const FunctionDesign& start);

/// Makes the conditions that hold a minimax design exact and looks whether they prove a local minimum. Fills
/// design.optimum; moves the design only to an error that is not larger.
void settle_optimum(const FunctionTask& task, const WantedAngles& wanted, FunctionDesign& design);

/// The best design by the task's method (least squares or minimax) over many starts.
struct FunctionSearch {
  std::optional<FunctionDesign> best;
  std::array<std::size_t, defect_kinds> seen{};  ///< starts that led nowhere, by defect
  std::string extent;                            ///< what was looked at, for a person
};
FunctionSearch search_function(const FunctionTask& task, const WantedAngles& wanted);

}  // namespace kempe
