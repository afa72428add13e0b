// Steps: lay out the wanted pairs of angles; fit Freudenstein's coefficients to precision points for every
// choice of the free starts; turn them into links; look at the whole driven range for defects; keep the
// smallest structural error.

#include "synthesis/function_generator.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/function_refinement.hpp"
#include "synthesis/precision_points.hpp"

namespace kempe {
namespace {

constexpr int curve_places = 181;
constexpr int start_grid = 48;  // places tried for a free start

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

}  // namespace

std::string_view name(FunctionMethod method) {
  switch (method) {
    case FunctionMethod::precision_points: return "precision_points";
    case FunctionMethod::least_squares: return "least_squares";
    case FunctionMethod::minimax: return "minimax";
  }
  return "";
}

std::string_view name(FunctionDefect defect) {
  switch (defect) {
    case FunctionDefect::none: return "none";
    case FunctionDefect::does_not_assemble: return "the loop comes apart within the range";
    case FunctionDefect::branch: return "the precision points lie on both branches";
    case FunctionDefect::order: return "the output crank turns back within the range";
    case FunctionDefect::transmission: return "the transmission angle falls below the limit";
    case FunctionDefect::lengths: return "a link vanishes or grows too long";
  }
  return "";
}

WantedAngles::WantedAngles(const FunctionTask& task) : task_(task) {
  y_lower_ = std::numeric_limits<double>::infinity();
  y_upper_ = -y_lower_;
  constexpr int places = 2001;
  for (int i = 0; i < places; ++i) {
    const double y = task.wanted(task.x_lower + (task.x_upper - task.x_lower) * i / (places - 1));
    finite_ = finite_ && std::isfinite(y);
    y_lower_ = std::min(y_lower_, y);
    y_upper_ = std::max(y_upper_, y);
  }
  precision_ = chebyshev_points(task.x_lower, task.x_upper, task.points);
  std::reverse(precision_.begin(), precision_.end());
}

double WantedAngles::input_turn(double x) const {
  return task_.input_range * (x - task_.x_lower) / (task_.x_upper - task_.x_lower);
}

double WantedAngles::output_turn(double x) const {
  return task_.output_range * (task_.wanted(x) - y_lower_) / (y_upper_ - y_lower_);
}

double WantedAngles::value_at(double output_turn) const {
  return y_lower_ + output_turn / task_.output_range * (y_upper_ - y_lower_);
}

bool WantedAngles::usable() const { return finite_ && y_upper_ > y_lower_; }

std::optional<FreudensteinCoefficients> freudenstein_three_points(const std::vector<double>& phi,
                                                                  const std::vector<double>& psi) {
  if (phi.size() != 3 || psi.size() != 3) return std::nullopt;
  Eigen::Matrix3d rows;
  Eigen::Vector3d right;
  for (int i = 0; i < 3; ++i) {
    const auto j = static_cast<std::size_t>(i);
    rows.row(i) << std::cos(psi[j]), -std::cos(phi[j]), 1;
    right[i] = std::cos(phi[j] - psi[j]);
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(rows);
  if (lu.rcond() < 1e-12) return std::nullopt;
  const Eigen::Vector3d k = lu.solve(right);
  return FreudensteinCoefficients{k[0], k[1], k[2]};
}

namespace {

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

template <class Function>
double bisected_root(const Function& f, double lower, double upper) {
  const bool rising = f(lower) < 0;
  for (int i = 0; i < 100 && upper - lower > 1e-15; ++i) {
    const double middle = 0.5 * (lower + upper);
    ((f(middle) < 0) == rising ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

/// All roots of f on a full turn that a grid of start_grid * 4 places separates.
template <class Function>
std::vector<double> roots_on_a_turn(const Function& f) {
  constexpr int places = 4 * start_grid;
  std::vector<double> roots;
  double before = f(-pi);
  for (int i = 1; i <= places; ++i) {
    const double at = -pi + 2 * pi * i / places, now = f(at);
    if ((before < 0) != (now < 0)) roots.push_back(bisected_root(f, at - 2 * pi / places, at));
    before = now;
  }
  return roots;
}

std::vector<double> tried_starts(const std::optional<double>& given) {
  if (given) return {*given};
  std::vector<double> all;
  for (int i = 0; i < start_grid; ++i) all.push_back(-pi + 2 * pi * (i + 0.5) / start_grid);
  return all;
}

/// Newton on the two conditions of five points, numerical Jacobian; nothing if it does not settle.
std::optional<Starts> polished_five_point_starts(const WantedAngles& wanted, Starts starts) {
  const auto residual = [&](const Starts& at) {
    return Eigen::Vector2d(fourth_point_residual(wanted, at, 3), fourth_point_residual(wanted, at, 4));
  };
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector2d f = residual(starts);
    constexpr double h = 1e-7;
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
    if (step.norm() < 1e-13) return starts;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Starts> precise_starts(const FunctionTask& task, const WantedAngles& wanted) {
  std::vector<Starts> found;
  if (task.points == 3) {
    for (const double input : tried_starts(task.input_start))
      for (const double output : tried_starts(task.output_start)) found.push_back({input, output});
  } else if (task.points == 4 && task.output_start) {
    for (const double input : roots_on_a_turn([&](double at) {
           return fourth_point_residual(wanted, {at, *task.output_start}, 3);
         }))
      found.push_back({input, *task.output_start});
  } else if (task.points == 4) {
    for (const double input : tried_starts(task.input_start))
      for (const double output : roots_on_a_turn([&](double at) {
             return fourth_point_residual(wanted, {input, at}, 3);
           }))
        found.push_back({input, output});
  } else {
    for (const double input : tried_starts(std::nullopt))
      for (const double output : tried_starts(std::nullopt))
        if (const auto starts = polished_five_point_starts(wanted, {input, output})) {
          const bool known = std::any_of(found.begin(), found.end(), [&](const Starts& s) {
            return std::hypot(wrapped(s.input - starts->input), wrapped(s.output - starts->output)) < 1e-7;
          });
          if (!known) found.push_back(*starts);
        }
  }
  return found;
}

namespace {

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
      miss[static_cast<std::size_t>(one)] = angle ? std::abs(wrapped(*angle - psi)) : pi;
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
  design.input_start = wrapped(starts.input + (bars->input_turned ? pi : 0));
  design.output_start = wrapped(starts.output + (bars->output_turned ? pi : 0));
  design.y_lower = wanted.y_lower();
  design.y_upper = wanted.y_upper();
  design.precision_points = wanted.precision_points();
  design.motion = design.linkage.motion();
  return design;
}

FunctionCandidate judged(const FunctionTask& task, const WantedAngles& wanted, const Starts& starts,
                         const FreudensteinCoefficients& coefficients) {
  FunctionCandidate candidate;
  const auto design = design_from(task, wanted, starts, coefficients);
  if (!design) return candidate;
  candidate.design = *design;
  const auto branch = branch_through_points(wanted, candidate.design);
  if (!branch) {
    candidate.defect = FunctionDefect::branch;
    return candidate;
  }
  candidate.design.linkage.branch = *branch;
  candidate.defect = trace_curve(task, wanted, candidate.design);
  return candidate;
}

namespace {

StructuralErrorSample sample_at(const FunctionTask& task, const WantedAngles& wanted,
                                const FunctionDesign& design, double x, double output_angle) {
  const double phi = design.input_start + wanted.input_turn(x);
  const double error = wrapped(output_angle - design.output_start - wanted.output_turn(x));
  return {x, task.wanted(x), wanted.value_at(wanted.output_turn(x) + error), phi, output_angle, error};
}

/// The largest |error| near a place of the curve where it is largest: golden section between its neighbours.
double top_of_ripple(const WantedAngles& wanted, const FunctionDesign& design, std::size_t i) {
  constexpr double golden = 0.6180339887498949;
  const auto height = [&](double x) {
    const auto psi = design.linkage.output_angle(design.input_start + wanted.input_turn(x));
    return psi ? std::abs(wrapped(*psi - design.output_start - wanted.output_turn(x))) : 0.0;
  };
  double lower = design.curve[i - 1].x, upper = design.curve[i + 1].x;
  for (int j = 0; j < 40; ++j) {
    const double part = golden * (upper - lower), left = upper - part, right = lower + part;
    (height(left) > height(right) ? upper : lower) = height(left) > height(right) ? right : left;
  }
  return height(0.5 * (lower + upper));
}

/// The largest |error| over the whole range, between the curve's places too.
double largest_error(const WantedAngles& wanted, const FunctionDesign& design) {
  double largest = 0;
  for (const StructuralErrorSample& at : design.curve) largest = std::max(largest, std::abs(at.error));
  const double seen = largest;
  for (std::size_t i = 1; i + 1 < design.curve.size(); ++i) {
    const double here = std::abs(design.curve[i].error);
    if (here >= 0.98 * seen && here >= std::abs(design.curve[i - 1].error) &&
        here >= std::abs(design.curve[i + 1].error))
      largest = std::max(largest, top_of_ripple(wanted, design, i));
  }
  return largest;
}

/// True if the output crank turns back, by more than a hundredth of its range, where the wanted function does
/// not: the dial would pass its values in another order. Less happens within the error at the level end of a
/// sine.
bool turns_back(const FunctionTask& task, const WantedAngles& wanted,
                const std::vector<StructuralErrorSample>& curve) {
  const double allowed = 0.01 * std::abs(task.output_range);
  double direction = 0, farthest = 0, wanted_before = wanted.output_turn(curve.front().x);
  for (const StructuralErrorSample& at : curve) {
    const double now = wanted.output_turn(at.x), asked = now - wanted_before, generated = now + at.error;
    wanted_before = now;
    if (asked * direction <= 0) {  // the wanted function starts or turns
      direction = asked;
      farthest = generated;
    }
    farthest = direction > 0 ? std::max(farthest, generated) : std::min(farthest, generated);
    if (std::abs(farthest - generated) > allowed) return true;
  }
  return false;
}

bool lengths_fit(const FunctionTask& task, const FourBar& l) {
  const auto [shortest, longest] = std::minmax({l.ground, l.input, l.coupler, l.output});
  return shortest > 0 && longest <= task.longest_ratio * shortest;
}

}  // namespace

FunctionDefect trace_curve(const FunctionTask& task, const WantedAngles& wanted, FunctionDesign& design) {
  design.curve.clear();
  if (!lengths_fit(task, design.linkage)) return FunctionDefect::lengths;
  const auto transmission =
      design.linkage.least_transmission_angle(design.input_start, design.input_start + task.input_range);
  if (!transmission) return FunctionDefect::does_not_assemble;
  design.transmission_min = *transmission;
  double sum = 0;
  for (int i = 0; i < curve_places; ++i) {
    const double x = task.x_lower + (task.x_upper - task.x_lower) * i / (curve_places - 1);
    const auto psi = design.linkage.output_angle(design.input_start + wanted.input_turn(x));
    if (!psi) return FunctionDefect::does_not_assemble;
    design.curve.push_back(sample_at(task, wanted, design, x, *psi));
    sum += design.curve.back().error * design.curve.back().error;
  }
  design.error_rms = std::sqrt(sum / curve_places);
  design.error_largest = largest_error(wanted, design);
  if (turns_back(task, wanted, design.curve)) return FunctionDefect::order;
  return design.transmission_min < task.transmission ? FunctionDefect::transmission : FunctionDefect::none;
}

namespace {

/// Candidates seen so far: the best without defect, and what the others failed of.
class Field {
 public:
  void add(const FunctionCandidate& candidate) {
    ++count_[static_cast<std::size_t>(candidate.defect)];
    if (candidate.defect != FunctionDefect::none) return;
    const auto near = std::find_if(best_.begin(), best_.end(), [&](const FunctionDesign& other) {
      return are_neighbours(other, candidate.design);
    });
    if (near != best_.end()) {
      if (near->error_largest <= candidate.design.error_largest) return;
      best_.erase(near);
    }
    const auto place =
        std::upper_bound(best_.begin(), best_.end(), candidate.design,
                         [](const auto& a, const auto& b) { return a.error_largest < b.error_largest; });
    best_.insert(place, candidate.design);
    if (best_.size() > kept) best_.pop_back();
  }

  void add(FunctionDefect defect) { ++count_[static_cast<std::size_t>(defect)]; }

  /// The designs without defect, smallest largest error first, apart from each other; at most `kept`.
  const std::vector<FunctionDesign>& best() const { return best_; }

  static constexpr std::size_t kept = 12;

  /// The design with the rejections counted, or why there is none.
  tl::expected<FunctionDesign, NoFunctionDesign> verdict(const std::optional<FunctionDesign>& chosen) const {
    if (chosen) {
      FunctionDesign design = *chosen;
      design.rejected_branch = count(FunctionDefect::branch);
      design.rejected_order = count(FunctionDefect::order);
      design.rejected_other = count(FunctionDefect::does_not_assemble) + count(FunctionDefect::transmission) +
                              count(FunctionDefect::lengths);
      return design;
    }
    NoFunctionDesign none;
    std::size_t most = 0;
    for (std::size_t i = 1; i < count_.size(); ++i)
      if (count_[i] > most) {
        most = count_[i];
        none.commonest = static_cast<FunctionDefect>(i);
      }
    none.sentence =
        most == 0 ? "no four-bar passes all the precision points"
                  : "every four-bar found has a defect; the commonest: " + std::string(name(none.commonest));
    return tl::unexpected(none);
  }

 private:
  /// True for starts of neighbouring places of the grid: a refinement of one would find the other.
  static bool are_neighbours(const FunctionDesign& a, const FunctionDesign& b) {
    constexpr double near = 1.5 * 2 * pi / start_grid;
    return a.linkage.branch == b.linkage.branch && std::abs(wrapped(a.input_start - b.input_start)) < near &&
           std::abs(wrapped(a.output_start - b.output_start)) < near;
  }

  std::size_t count(FunctionDefect defect) const { return count_[static_cast<std::size_t>(defect)]; }
  std::array<std::size_t, 6> count_{};
  std::vector<FunctionDesign> best_;
};

}  // namespace

tl::expected<FunctionDesign, NoFunctionDesign> generate_function(const FunctionTask& asked) {
  FunctionTask task = asked;
  if (task.method != FunctionMethod::precision_points) task.points = 3;  // of the starts of the search
  const WantedAngles wanted(task);
  if (!wanted.usable())
    return tl::unexpected(
        NoFunctionDesign{FunctionDefect::none, "the function is constant or not finite on its range"});
  Field field;
  for (const Starts& starts : precise_starts(task, wanted))
    if (const auto coefficients = coefficients_through_first_three(wanted, starts))
      field.add(judged(task, wanted, starts, *coefficients));
  if (task.method != FunctionMethod::precision_points) {
    const FunctionSearch search = search_function(task, wanted);
    for (const FunctionDefect defect : search.defects) field.add(defect);
    return field.verdict(search.best);
  }
  const bool has_freedom = task.points == 3 && (!task.input_start || !task.output_start);
  std::optional<FunctionDesign> chosen;
  for (const FunctionDesign& precise : field.best()) {
    const FunctionDesign design = has_freedom ? with_best_starts(task, wanted, precise) : precise;
    if (!chosen || design.error_largest < chosen->error_largest) chosen = design;
  }
  return field.verdict(chosen);
}

}  // namespace kempe
