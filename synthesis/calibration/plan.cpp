#include "synthesis/calibration/plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/decompositions.hpp"
#include "synthesis/calibration/weighted_fit.hpp"

namespace kempe {
namespace detail = calibration_detail;

namespace {

using Rows = Eigen::Matrix<double, 2, Eigen::Dynamic>;

/// Slopes of one reading by the free measures, in standard uncertainties per mm; nothing out of reach.
std::optional<Rows> rows_of(const CalibrationTask& task, const Candidate& candidate, double noise) {
  const Instrument& setup = task.setups[candidate.setup];
  const auto output = output_at(setup, setup.drawn, candidate.input);
  if (!output) return std::nullopt;
  const Measures units = detail::units_of(task);
  const double deviation = std::hypot(noise, std::abs(setup.ratio) * task.setting_uncertainty);
  Rows rows(2, static_cast<Eigen::Index>(task.free.size()));
  for (std::size_t j = 0; j < task.free.size(); ++j)
    rows.col(static_cast<Eigen::Index>(j)) =
        output->by.col(index_of(task.free[j])) * units[index_of(task.free[j])] / deviation;
  return rows;
}

Eigen::MatrixXd information_so_far(const CalibrationTask& task, double noise) {
  std::vector<std::size_t> used(task.readings.size());
  for (std::size_t i = 0; i < used.size(); ++i) used[i] = i;
  const detail::WeightedTask weighted{task, used, noise, detail::units_of(task)};
  Eigen::VectorXd residuals(weighted.rows());
  Eigen::MatrixXd slopes(weighted.rows(), static_cast<Eigen::Index>(task.free.size()));
  if (!weighted.evaluate(Measures::Zero(), task.free, residuals, &slopes)) slopes.setZero();
  return slopes.transpose() * slopes;
}

/// det(information + rows^T rows) / det(information), from the inverse of the information.
double gain(const Eigen::MatrixXd& inverse, const Rows& rows) {
  const Rows spread = rows.lazyProduct(inverse);
  const Eigen::Matrix2d small = Eigen::Matrix2d::Identity() + spread.lazyProduct(rows.transpose());
  return small.determinant();
}

class Choice {
 public:
  Choice(const CalibrationTask& task, const std::vector<Candidate>& candidates, double noise) {
    information_ = information_so_far(task, noise);
    information_.diagonal().array() += 1 / (task.plausible_deviation * task.plausible_deviation);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (auto rows = rows_of(task, candidates[i], noise)) {
        rows_.push_back(*rows);
        numbers_.push_back(i);
      }
    taken_.assign(rows_.size(), false);
  }

  std::vector<std::size_t> best(std::size_t count) {
    std::vector<std::size_t> chosen;
    while (chosen.size() < std::min(count, rows_.size())) {
      const std::size_t next = best_addition().first;
      put(next, 1);
      chosen.push_back(next);
    }
    improve(chosen);
    for (std::size_t& one : chosen) one = numbers_[one];
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  }

 private:
  void put(std::size_t row, double sign) {
    information_ += sign * rows_[row].transpose().lazyProduct(rows_[row]);
    taken_[row] = sign > 0;
  }

  std::pair<std::size_t, double> best_addition() const {
    const Eigen::MatrixXd inverse = inverse_of(information_);
    std::pair<std::size_t, double> best{0, 0};
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (const double value = taken_[i] ? 0 : gain(inverse, rows_[i]); value > best.second)
        best = {i, value};
    return best;
  }

  /// Fedorov's exchange: each chosen reading in turn gives way to the one that is best in its place.
  void improve(std::vector<std::size_t>& chosen) {
    constexpr int most_passes = 20;
    bool changed = true;
    for (int pass = 0; pass < most_passes && changed; ++pass) {
      changed = false;
      for (std::size_t& one : chosen) {
        put(one, -1);
        const std::size_t next = best_addition().first;
        changed = changed || next != one;
        put(next, 1);
        one = next;
      }
    }
  }

  Eigen::MatrixXd information_;
  std::vector<Rows> rows_;
  std::vector<std::size_t> numbers_;
  std::vector<bool> taken_;
};

/// The combination as a direction of the free measures, in mm, its first part 1 mm.
Eigen::VectorXd direction_of(const CalibrationTask& task, const Indistinct& combination) {
  const Measures units = detail::units_of(task);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(task.free.size()));
  const double first = units[index_of(combination.parts.front().measure)];
  for (const Indistinct::Part& part : combination.parts)
    for (std::size_t j = 0; j < task.free.size(); ++j)
      if (task.free[j] == part.measure)
        direction[static_cast<Eigen::Index>(j)] = part.factor * first / units[index_of(part.measure)];
  return direction;
}

Point middle_of(const Region& region) {
  Point sum(0, 0);
  double count = 0;
  for (const Polygon& polygon : region.polygons)
    for (const Point& corner : polygon.outer) {
      sum += corner;
      ++count;
    }
  return count > 0 ? Point(sum / count) : Point(0, 0);
}

double reciprocal(double tells) { return tells > 0 ? 1 / tells : std::numeric_limits<double>::infinity(); }

}  // namespace

std::vector<Candidate> candidates_on_axis(const CalibrationTask& task, std::size_t setup, double arm,
                                          double lower, double upper, int count) {
  // Places of X, V, Y on the axis, as shares of the distance from X to Y: 0, the setting, 1.
  const Instrument& instrument = task.setups[setup];
  const Instrument erect = instrument.mounted({.pole = Joint::X, .input = Joint::Y, .output = Joint::V});
  const auto share = [&](Joint joint) {
    return joint == Joint::X ? 0.0 : joint == Joint::Y ? 1.0 : erect.ratio.real();
  };
  const double along = share(instrument.mounting.input) - share(instrument.mounting.pole);
  const Point pole(instrument.drawn[index_of(Measure::pole_x)], instrument.drawn[index_of(Measure::pole_y)]);
  std::vector<Candidate> candidates;
  for (int i = 0; i < count; ++i) {
    const double angle = lower + (upper - lower) * i / std::max(1, count - 1);
    candidates.push_back({setup, pole + Point(2 * arm * std::cos(angle) * along, 0)});
  }
  return candidates;
}

Point DrawnDesign::place(double share_of_openings, double share_of_bearings) const {
  return linkage.tracer_at(usable.lower + share_of_openings * usable.width(),
                           bearing_lower + share_of_bearings * (bearing_upper - bearing_lower));
}

DrawnDesign drawn_design(const CopyingLinkage& linkage, const OpeningInterval& certified,
                         const Region& region) {
  DrawnDesign design{linkage, intersect(certified, linkage.assembly_mode().openings)};
  constexpr double least_transmission = radians(20), around = radians(30);
  if (!(design.usable.width() > 0)) design.usable = linkage.openings_with_transmission(least_transmission);
  const Point middle = middle_of(region) - linkage.pole();
  if (!(middle.norm() > 0)) return design;
  double widest = 0;
  for (const Polygon& polygon : region.polygons)
    for (const Point& corner : polygon.outer) {
      const Point at = corner - linkage.pole();
      if (at.norm() > 0) widest = std::max(widest, std::abs(std::arg(as_complex(at) / as_complex(middle))));
    }
  const double half = std::min(pi, widest + around), bearing = std::arg(as_complex(middle));
  design.bearing_lower = bearing - half;
  design.bearing_upper = bearing + half;
  return design;
}

std::vector<Candidate> candidates_over_reach(const DrawnDesign& design, bool exchanged, std::size_t setup,
                                             int radii, int bearings) {
  std::vector<Candidate> candidates;
  const CopyingLinkage& linkage = design.linkage;
  for (int i = 0; i < radii; ++i)
    for (int j = 0; j < bearings; ++j) {
      const Point tracer = design.place((i + 0.5) / radii, (j + 0.5) / bearings);
      const Complex from_pole = as_complex(tracer - linkage.pole());
      candidates.push_back(
          {setup, exchanged ? Point(linkage.pole() + as_point(linkage.k() * from_pole)) : tracer});
    }
  return candidates;
}

Eigen::MatrixXd information_of(const CalibrationTask& task, const std::vector<Candidate>& readings,
                               double noise) {
  Eigen::MatrixXd information = information_so_far(task, noise);
  for (const Candidate& reading : readings)
    if (const auto rows = rows_of(task, reading, noise)) information += rows->transpose().lazyProduct(*rows);
  return information;
}

std::vector<Candidate> d_optimal(const CalibrationTask& task, const std::vector<Candidate>& candidates,
                                 std::size_t count, double noise) {
  std::vector<Candidate> chosen;
  for (const std::size_t i : Choice(task, candidates, noise).best(count)) chosen.push_back(candidates[i]);
  return chosen;
}

double uncertainty_after(const CalibrationTask& task, const Indistinct& combination,
                         const Candidate& candidate, double noise) {
  const auto rows = rows_of(task, candidate, noise);
  return rows ? reciprocal((*rows * direction_of(task, combination)).norm())
              : std::numeric_limits<double>::infinity();
}

double uncertainty_after(const CalibrationTask& task, const Indistinct& combination, std::size_t length,
                         double uncertainty) {
  double slope = 0;
  const auto lengths = lengths_of(task.setups.front().drawn);
  for (const Indistinct::Part& part : combination.parts)
    slope += lengths.by(static_cast<Eigen::Index>(length), index_of(part.measure)) * part.factor;
  return reciprocal(std::abs(slope) / uncertainty);
}

}  // namespace kempe
