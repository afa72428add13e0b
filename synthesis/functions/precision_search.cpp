// The four-bars through Chebyshev points.
//
// det of Freudenstein's rows {0, 1, 2, j} vanishes where the linkage through the first three points passes point j. It is
// linear in every column, and a start enters two of them by its sine and cosine:
//   det = alpha + beta cos 2s + gamma sin 2s,
// so that a start s follows from the other in closed form, at most two of them on half a turn. (Half a turn more turns a
// crank's length round and changes no linkage: every start is sought on half a turn.)
//   three points   the starts that are free: none, one or two parameters
//   four points    one start given: the closed form. None: a curve, run through along each start
//   five points    both dets: for an input start they are linear in (cos 2s, sin 2s) of the output's, whose squares must
//                  add up to 1: a trigonometric polynomial of degree 8 in the input start; its zeros and dips, polished
//                  by Newton's method

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/functions/refinement.hpp"
#include "synthesis/functions/slack.hpp"
#include "synthesis/solvers/golden_section.hpp"

namespace kempe {
namespace {

constexpr int curve_grid = 1440;       ///< places on half a turn of a family with one parameter
constexpr int surface_grid = 120;      ///< on each axis of one with two
constexpr std::size_t most_dips = 60;  ///< of a surface that are run down

double least_turn(double angle) { return std::remainder(angle, 2 * pi); }

/// Freudenstein's rows for all precision points; the last column is the right-hand side with its sign
/// changed.
Eigen::Matrix<double, Eigen::Dynamic, 4> freudenstein_rows(const WantedAngles& wanted, const Starts& starts) {
  const auto& points = wanted.precision_points();
  Eigen::Matrix<double, Eigen::Dynamic, 4> rows(static_cast<Eigen::Index>(points.size()), 4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double phi = starts.input + wanted.input_turn(points[i]);
    const double psi = starts.output + wanted.output_turn(points[i]);
    rows.row(static_cast<Eigen::Index>(i)) << std::cos(psi), -std::cos(phi), 1, -std::cos(phi - psi);
  }
  return rows;
}

}  // namespace

std::optional<FreudensteinCoefficients> coefficients_through_first_three(const WantedAngles& wanted,
                                                                         const Starts& starts) {
  std::vector<double> phi, psi;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = wanted.precision_points()[i];
    phi.push_back(starts.input + wanted.input_turn(x));
    psi.push_back(starts.output + wanted.output_turn(x));
  }
  return freudenstein_three_points(phi, psi);
}

namespace {

/// det of rows {0, 1, 2, j}: zero if point j lies on the linkage through the first three.
double fourth_point_residual(const WantedAngles& wanted, const Starts& starts, int j) {
  const auto rows = freudenstein_rows(wanted, starts);
  Eigen::Matrix4d four;
  four << rows.topRows(3), rows.row(j);
  return four.determinant();
}

/// Newton on the two conditions of five points, numerical Jacobian; nothing if it does not settle.
std::optional<Starts> polished_five_point_starts(const WantedAngles& wanted, Starts starts) {
  const auto residual = [&](const Starts& at) {
    return Eigen::Vector2d(fourth_point_residual(wanted, at, 3), fourth_point_residual(wanted, at, 4));
  };
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector2d f = residual(starts);
    constexpr double h = slack::difference_step;
    Eigen::Matrix2d slope;
    slope.col(0) =
        (residual({starts.input + h, starts.output}) - residual({starts.input - h, starts.output})) / (2 * h);
    slope.col(1) =
        (residual({starts.input, starts.output + h}) - residual({starts.input, starts.output - h})) / (2 * h);
    const Eigen::FullPivLU<Eigen::Matrix2d> lu(slope);
    if (!lu.isInvertible()) return std::nullopt;
    const Eigen::Vector2d step = lu.solve(f);
    if (!step.allFinite() || step.norm() > 1) return std::nullopt;
    starts.input -= step[0];
    starts.output -= step[1];
    if (step.norm() < slack::newton_at_rest) return starts;
  }
  return std::nullopt;
}

/// The branch that passes the precision points; nothing if they need both.
std::optional<FourBarBranch> branch_through_points(const WantedAngles& wanted, const FunctionDesign& design) {
  std::optional<FourBarBranch> branch;
  for (const double x : wanted.precision_points()) {
    FourBar bar = design.linkage;
    const double psi = design.output_start + wanted.output_turn(x);
    std::array<double, 2> miss{};
    for (const FourBarBranch one : {FourBarBranch::first, FourBarBranch::second}) {
      bar.branch = one;
      const auto angle = bar.output_angle(design.input_start + wanted.input_turn(x));
      miss[static_cast<std::size_t>(one)] = angle ? std::abs(least_turn(*angle - psi)) : pi;
    }
    const FourBarBranch nearer = miss[0] <= miss[1] ? FourBarBranch::first : FourBarBranch::second;
    if (branch && *branch != nearer) return std::nullopt;
    branch = nearer;
  }
  return branch;
}

}  // namespace

std::optional<FunctionDesign> design_from(const FunctionTask& task, const WantedAngles& wanted,
                                          const Starts& starts,
                                          const FreudensteinCoefficients& coefficients) {
  const auto bars = four_bar_from(coefficients, task.ground);
  if (!bars) return std::nullopt;
  FunctionDesign design;
  design.linkage = bars->linkage;
  design.input_start = least_turn(starts.input + (bars->input_turned ? pi : 0));
  design.output_start = least_turn(starts.output + (bars->output_turned ? pi : 0));
  design.y_lower = wanted.y_lower();
  design.y_upper = wanted.y_upper();
  design.precision_points = wanted.precision_points();
  design.motion = design.linkage.motion();
  return design;
}

FunctionCandidate judged(const FunctionTask& task, const WantedAngles& wanted, const Starts& starts) {
  FunctionCandidate candidate;
  const auto coefficients = coefficients_through_first_three(wanted, starts);
  const auto design = coefficients ? design_from(task, wanted, starts, *coefficients) : std::nullopt;
  if (!design) return candidate;
  candidate.design = *design;
  const auto moved = [](const std::optional<double>& given, double start) {
    return given && std::abs(least_turn(start - *given)) > slack::start_moved;
  };
  if (moved(task.input_start, design->input_start) || moved(task.output_start, design->output_start)) {
    candidate.defect = FunctionDefect::start;
    return candidate;
  }
  const auto branch = branch_through_points(wanted, candidate.design);
  if (!branch) {
    candidate.defect = FunctionDefect::branch;
    return candidate;
  }
  candidate.design.linkage.branch = *branch;
  candidate.defect = measure_design(task, wanted, candidate.design);
  candidate.broken =
      candidate.defect == FunctionDefect::none ? 0 : broken_limits(task, wanted, candidate.design);
  return candidate;
}

std::size_t PrecisionSearch::candidates() const {
  std::size_t sum = 0;
  for (const std::size_t some : seen) sum += some;
  return sum;
}

void PrecisionSearch::add(const FunctionCandidate& candidate) {
  ++seen[static_cast<std::size_t>(candidate.defect)];
  if (candidate.defect != FunctionDefect::none) return;
  if (!best || candidate.design.error_largest < best->error_largest) best = candidate.design;
}

namespace {

/// alpha + beta cos 2s + gamma sin 2s through a function's values on half a turn.
struct HalfTurnWave {
  double alpha = 0, beta = 0, gamma = 0;
  template <class Function>
  static HalfTurnWave of(const Function& f) {
    HalfTurnWave wave;
    for (int i = 0; i < 3; ++i) {
      const double s = pi * i / 3, value = f(s);
      wave.alpha += value / 3;
      wave.beta += 2 * value * std::cos(2 * s) / 3;
      wave.gamma += 2 * value * std::sin(2 * s) / 3;
    }
    return wave;
  }
  /// Its zero before (-1) or after (1) its crest; none where it keeps its sign.
  std::optional<double> zero(int side) const {
    const double height = std::hypot(beta, gamma);
    if (!(std::abs(alpha) <= height) || height == 0) return std::nullopt;
    return 0.5 * (std::atan2(gamma, beta) + side * std::acos(-alpha / height));
  }
};

class Search {
 public:
  Search(const FunctionTask& task, const WantedAngles& wanted) : task_(task), wanted_(wanted) {}

  PrecisionSearch run() {
    if (task_.points == 3)
      three_points();
    else if (task_.points == 4)
      four_points();
    else
      five_points();
    return std::move(search_);
  }

 private:
  void three_points() {
    if (task_.input_start && task_.output_start) {
      add(Starts{*task_.input_start, *task_.output_start});
      search_.extent = "the one four-bar through these three points for the starts given";
    } else if (task_.input_start) {
      along([&](double t) { return Starts{*task_.input_start, t}; });
      search_.extent = along_words("three", "output");
    } else if (task_.output_start) {
      along([&](double t) { return Starts{t, *task_.output_start}; });
      search_.extent = along_words("three", "input");
    } else {
      over_both_starts();
      search_.extent = fmt::format(
          "the four-bars through the three points, both starts on a grid of {0} by {0} places over half a "
          "turn, refined from the {1} best places; not a proof that none exists",
          surface_grid, most_dips);
    }
  }

  void four_points() {
    const auto output_for = [&](double input, int side) { return with_output(input, side); };
    const auto input_for = [&](double output, int side) { return with_input(output, side); };
    if (task_.input_start || task_.output_start) {
      for (const int side : {-1, 1})
        if (const auto starts = task_.input_start ? output_for(*task_.input_start, side)
                                                  : input_for(*task_.output_start, side))
          add(*starts);
      search_.extent =
          fmt::format("every four-bar through the four points for the start given: {}", search_.candidates());
      return;
    }
    for (const int side : {-1, 1}) {
      along([&](double t) { return output_for(t, side); });
      along([&](double t) { return input_for(t, side); });
    }
    search_.extent = fmt::format(
        "the curve of all four-bars through the four points at {} places along each start, and every local "
        "minimum of the error and of the excess over the limits; not a proof that none exists",
        curve_grid);
  }

  void five_points() {
    std::vector<Starts> found;
    const auto polish = [&](const std::optional<Starts>& near) {
      const auto starts = near ? polished_five_point_starts(wanted_, *near) : std::nullopt;
      if (!starts) return;
      const bool known = std::any_of(found.begin(), found.end(), [&](const Starts& other) {
        return std::hypot(std::remainder(other.input - starts->input, pi),
                          std::remainder(other.output - starts->output, pi)) < slack::same_start;
      });
      if (!known) found.push_back(*starts);
    };
    std::vector<double> heights;
    for (int i = 0; i < curve_grid; ++i) heights.push_back(common_zero(pi * i / curve_grid).height);
    for (int i = 0; i < curve_grid && !task_.stop(); ++i) {
      const double before = heights[at(i - 1)], now = heights[at(i)], after = heights[at(i + 1)];
      const bool dips = std::abs(now) <= std::abs(before) && std::abs(now) <= std::abs(after);
      if (!dips && (now < 0) == (after < 0)) continue;
      polish(common_zero(pi * i / curve_grid).starts);
      polish(common_zero(pi * (i + 0.5) / curve_grid).starts);
    }
    for (const Starts& starts : found)
      if (!task_.stop()) add(starts);
    search_.extent = fmt::format(
        "the {} four-bars through the five points that {} input starts and Newton's method "
        "find; not a proof that none exists",
        found.size(), curve_grid);
  }

  /// For an input start: cos 2s and sin 2s of the output start that both determinants ask for, and by how much the sum
  /// of their squares differs from 1 (times the square of their common denominator, to stay finite).
  struct CommonZero {
    double height = 0;
    std::optional<Starts> starts;
  };
  CommonZero common_zero(double input) const {
    std::array<HalfTurnWave, 2> wave;
    for (int j = 0; j < 2; ++j)
      wave[static_cast<std::size_t>(j)] = HalfTurnWave::of([&](double output) {
        return fourth_point_residual(wanted_, {input, output}, 3 + j);
      });
    const double under = wave[0].beta * wave[1].gamma - wave[0].gamma * wave[1].beta;
    const double c = wave[0].gamma * wave[1].alpha - wave[0].alpha * wave[1].gamma;
    const double s = wave[0].alpha * wave[1].beta - wave[0].beta * wave[1].alpha;
    CommonZero zero{c * c + s * s - under * under, std::nullopt};
    if (c != 0 || s != 0)
      zero.starts = Starts{input, 0.5 * std::atan2(under < 0 ? -s : s, under < 0 ? -c : c)};
    return zero;
  }

  std::optional<Starts> with_output(double input, int side) const {
    const auto wave = HalfTurnWave::of([&](double output) {
      return fourth_point_residual(wanted_, {input, output}, 3);
    });
    const auto output = wave.zero(side);
    return output ? std::optional(Starts{input, *output}) : std::nullopt;
  }
  std::optional<Starts> with_input(double output, int side) const {
    const auto wave = HalfTurnWave::of([&](double input) {
      return fourth_point_residual(wanted_, {input, output}, 3);
    });
    const auto input = wave.zero(side);
    return input ? std::optional(Starts{*input, output}) : std::nullopt;
  }

  /// A family with one parameter that closes after half a turn: on a grid, then down every dip.
  template <class Family>
  void along(const Family& family) {
    const auto candidate = [&](double t) {
      const std::optional<Starts> starts = family(t);
      return starts ? std::optional(judged(task_, wanted_, *starts)) : std::nullopt;
    };
    const auto cost = [&](double t) {
      const auto found = candidate(t);
      return found ? found->cost() : std::numeric_limits<double>::infinity();
    };
    std::vector<double> costs;
    for (int i = 0; i < curve_grid; ++i) {
      if (task_.stop()) return;
      const auto found = candidate(pi * i / curve_grid);
      if (found) search_.add(*found);
      costs.push_back(found ? found->cost() : std::numeric_limits<double>::infinity());
    }
    for (int i = 0; i < curve_grid && !task_.stop(); ++i) {
      if (!std::isfinite(costs[at(i)]) || costs[at(i)] > costs[at(i - 1)] || costs[at(i)] > costs[at(i + 1)])
        continue;
      const double t = top_by_golden_section([&](double place) { return -cost(place); },
                                             pi * (i - 1) / curve_grid, pi * (i + 1) / curve_grid, 45);
      if (const auto found = candidate(t)) search_.add(*found);
    }
  }

  void over_both_starts() {
    struct Dip {
      double cost;
      Starts starts;
    };
    std::vector<double> costs;
    const auto starts_at = [](int i, int j) {
      return Starts{pi * (i + 0.5) / surface_grid, pi * (j + 0.5) / surface_grid};
    };
    for (int i = 0; i < surface_grid; ++i)
      for (int j = 0; j < surface_grid; ++j) {
        if (task_.stop()) return;
        const FunctionCandidate found = judged(task_, wanted_, starts_at(i, j));
        search_.add(found);
        costs.push_back(found.cost());
      }
    const auto cost_at = [&](int i, int j) {
      const auto place = [](int k) { return static_cast<std::size_t>((k + surface_grid) % surface_grid); };
      return costs[place(i) * surface_grid + place(j)];
    };
    std::vector<Dip> dips;
    for (int i = 0; i < surface_grid; ++i)
      for (int j = 0; j < surface_grid; ++j) {
        const double here = cost_at(i, j);
        bool lowest = std::isfinite(here);
        for (const int k : {-1, 0, 1})
          for (const int l : {-1, 0, 1}) lowest = lowest && here <= cost_at(i + k, j + l);
        if (lowest) dips.push_back({here, starts_at(i, j)});
      }
    std::stable_sort(dips.begin(), dips.end(), [](const Dip& a, const Dip& b) { return a.cost < b.cost; });
    if (dips.size() > most_dips) dips.resize(most_dips);
    for (const Dip& dip : dips) {
      if (task_.stop()) return;
      search_.add(judged(task_, wanted_, refined_starts(task_, wanted_, dip.starts, pi / surface_grid)));
    }
  }

  void add(const Starts& starts) { search_.add(judged(task_, wanted_, starts)); }
  static std::size_t at(int i) { return static_cast<std::size_t>((i + curve_grid) % curve_grid); }
  static std::string along_words(std::string_view points, std::string_view start) {
    return fmt::format(
        "the four-bars through the {} points at {} {} starts over half a turn, and every local minimum of "
        "the error and of the excess over the limits; not a proof that none exists",
        points, curve_grid, start);
  }

  const FunctionTask& task_;
  const WantedAngles& wanted_;
  PrecisionSearch search_;
};

}  // namespace

PrecisionSearch search_precision_points(const FunctionTask& task, const WantedAngles& wanted) {
  return Search(task, wanted).run();
}

}  // namespace kempe
