#include "synthesis/calibration/weighted_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/decompositions.hpp"
#include "synthesis/calibration/slack.hpp"

namespace kempe::calibration_detail {

Measures units_of(const CalibrationTask& task) {
  Measures units = Measures::Ones();
  const double size = task.setups.front().drawn.head<8>().cwiseAbs().maxCoeff();
  units[index_of(Measure::turn)] = 1 / size;
  return units;
}

double WeightedTask::deviation_of(std::size_t reading) const {
  const Instrument& setup = task.setups[task.readings[reading].setup];
  return std::hypot(noise, std::abs(setup.ratio) * task.setting_uncertainty);
}

bool WeightedTask::evaluate(const Measures& deviations, const std::vector<Measure>& free,
                            Eigen::VectorXd& residuals, Eigen::MatrixXd* slopes) const {
  const auto put = [&](Eigen::Index row, double value, const auto& by, double deviation) {
    residuals[row] = value / deviation;
    if (!slopes) return;
    for (std::size_t j = 0; j < free.size(); ++j)
      (*slopes)(row, static_cast<Eigen::Index>(j)) =
          by[index_of(free[j])] * units[index_of(free[j])] / deviation;
  };
  Eigen::Index row = 0;
  for (const std::size_t i : used) {
    const CalibrationReading& reading = task.readings[i];
    const Instrument& setup = task.setups[reading.setup];
    const auto fitted = output_at(setup, setup.drawn + deviations, reading.input);
    if (!fitted) return false;
    for (int axis = 0; axis < 2; ++axis)
      put(row++, fitted->at[axis] - reading.output[axis], fitted->by.row(axis), deviation_of(i));
  }
  if (task.lengths.empty()) return true;
  const auto lengths = lengths_of(task.setups.front().drawn + deviations);
  for (const MeasuredLength& length : task.lengths) {
    const auto i = static_cast<Eigen::Index>(length.length);
    put(row++, lengths.values[i] - length.value, lengths.by.row(i), length.uncertainty);
  }
  return true;
}

std::optional<FitOutcome> fit(const WeightedTask& weighted, const std::vector<Measure>& free,
                              const Measures& start) {
  const auto deviations = [&](const Eigen::VectorXd& x) {
    Measures all = start;
    for (std::size_t j = 0; j < free.size(); ++j)
      all[index_of(free[j])] += x[static_cast<Eigen::Index>(j)] * weighted.units[index_of(free[j])];
    return all;
  };
  const Residuals residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd& values,
                                  Eigen::MatrixXd* slopes) {
    return weighted.evaluate(deviations(x), free, values, slopes);
  };
  const auto count = static_cast<Eigen::Index>(free.size());
  FitOutcome outcome;
  outcome.residuals.resize(weighted.rows());
  outcome.slopes.resize(weighted.rows(), count);
  const LeastSquaresSolution solution =
      least_squares(residuals, Eigen::VectorXd::Zero(count), weighted.rows(), slack::settled);
  outcome.deviations = deviations(solution.x);
  outcome.converged = solution.converged;
  if (!weighted.evaluate(outcome.deviations, free, outcome.residuals, &outcome.slopes)) return std::nullopt;
  outcome.square_sum = outcome.residuals.squaredNorm();
  return outcome;
}

Eigen::MatrixXd inverse_normal(const Eigen::MatrixXd& slopes) {
  if (slopes.cols() == 0) return {};
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(slopes, Eigen::ComputeThinV | Eigen::ComputeThinU);
  const Eigen::VectorXd& values = svd.singularValues();
  const Eigen::VectorXd inverse = values.unaryExpr(
      [&](double value) { return value > slack::no_weight * values[0] ? 1 / (value * value) : 0.0; });
  return svd.matrixV() * inverse.asDiagonal() * svd.matrixV().transpose();
}

namespace {

Indistinct combination(const Eigen::VectorXd& factors, std::size_t held, const std::vector<Measure>& free,
                       const Measures& units) {
  Indistinct found;
  const auto factor = [&](std::size_t j) {
    return factors[static_cast<Eigen::Index>(j)] * units[index_of(free[j])] / units[index_of(free[held])];
  };
  found.parts.push_back({free[held], 1});
  for (std::size_t j = 0; j < free.size(); ++j)
    if (j != held && std::abs(factors[static_cast<Eigen::Index>(j)]) > slack::too_small_to_name)
      found.parts.push_back({free[j], factor(j)});
  return found;
}

}  // namespace

std::vector<Indistinct> indistinct_combinations(const Eigen::MatrixXd& slopes,
                                                const std::vector<Measure>& free, const Measures& units,
                                                double plausible) {
  if (free.empty()) return {};
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(slopes, Eigen::ComputeFullV);
  const Eigen::Index columns = slopes.cols();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(columns);
  values.head(svd.singularValues().size()) = svd.singularValues();
  Eigen::Index known = columns;
  while (known > 0 &&
         !(values[known - 1] * plausible >= 1 && values[known - 1] > slack::rounding_share * values[0]))
    --known;
  const Eigen::Index unknown = columns - known;
  if (unknown == 0) return {};
  const Eigen::MatrixXd space = svd.matrixV().rightCols(unknown);
  // The measures to hold: those that stand most independently in the unknown directions.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> pivots(space.transpose());
  std::vector<std::size_t> held;
  for (Eigen::Index i = 0; i < unknown; ++i)
    held.push_back(static_cast<std::size_t>(pivots.colsPermutation().indices()[i]));
  std::sort(held.begin(), held.end());
  Eigen::MatrixXd at_held(unknown, unknown);
  for (Eigen::Index i = 0; i < unknown; ++i)
    at_held.row(i) = space.row(static_cast<Eigen::Index>(held[static_cast<std::size_t>(i)]));
  const Eigen::MatrixXd factors = space * inverse_of(at_held);
  std::vector<Indistinct> found;
  for (Eigen::Index i = 0; i < unknown; ++i) {
    found.push_back(combination(factors.col(i), held[static_cast<std::size_t>(i)], free, units));
    const Eigen::ArrayXd shares = at_held.row(i).transpose().array() / values.tail(unknown).array();
    const bool tells_something = (values.tail(unknown).array() > slack::rounding_share * values[0]).all();
    if (tells_something)
      found.back().uncertainty = shares.matrix().norm() * units[index_of(found.back().parts.front().measure)];
  }
  return found;
}

NoiseEstimate estimated_noise(const WeightedTask& weighted, const FitOutcome& fit) {
  const auto readings = static_cast<Eigen::Index>(2 * weighted.used.size());
  const Eigen::MatrixXd spread = inverse_normal(fit.slopes);
  double taken = 0;
  for (Eigen::Index row = 0; row < readings && spread.size() > 0; ++row)
    taken += fit.slopes.row(row) * spread * fit.slopes.row(row).transpose();
  const double freedom = static_cast<double>(readings) - taken;
  if (freedom < 0.5) return {};
  // What was set adds a known part; only the rest is the noise of what was read.
  double squares = 0, known_part = 0;
  for (std::size_t i = 0; i < weighted.used.size(); ++i) {
    const double deviation = weighted.deviation_of(weighted.used[i]);
    squares +=
        fit.residuals.segment<2>(static_cast<Eigen::Index>(2 * i)).squaredNorm() * deviation * deviation;
    known_part +=
        (deviation * deviation - weighted.noise * weighted.noise) / static_cast<double>(weighted.used.size());
  }
  return {std::sqrt(std::max(squares / freedom - known_part, slack::least_unexplained * squares / freedom)),
          freedom};
}

}  // namespace kempe::calibration_detail
