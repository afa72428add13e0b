// Readings that stand out: what is left at a reading, judged by the fit without it.
//
// With the hat matrix H of the weighted slopes, leaving the rows S out lowers the sum of squares by
//   q = e_S (1 - H_SS)^-1 e_S,
// so that F = (q / |S|) / ((sum of squares - q) / (freedom - |S|)) has Fisher's distribution if S is like the
// rest.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "synthesis/calibration_fit.hpp"
#include "synthesis/calibration_statistics.hpp"

namespace kempe::calibration_detail {
namespace {

class Deletion {
 public:
  Deletion(const WeightedTask& weighted, const FitOutcome& fit, bool noise_is_known)
      : slopes_(fit.slopes), residuals_(fit.residuals), square_sum_(fit.square_sum),
        noise_is_known_(noise_is_known) {
    if (fit.slopes.cols() > 0) spread_ = fit.slopes * inverse_normal(fit.slopes);
    freedom_ = static_cast<int>(weighted.rows() - fit.slopes.cols());
    // Rounding, as a weighted residual: readings without noise have no outliers.
    const double rounding = 1e-11 / weighted.units[index_of(Measure::turn)];
    floor_ = std::pow(std::max(rounding, weighted.model_error) / weighted.noise, 2);
    if (noise_is_known) floor_ = std::max(floor_, 1.0);
  }

  struct Verdict {
    double ratio = 0;        ///< F
    double probability = 1;  ///< of a larger one by chance
  };
  /// Of the readings in S leaving the fit together; nothing to say where they alone decide it.
  Verdict without(const std::vector<std::size_t>& readings) const {
    std::vector<Eigen::Index> rows;
    for (const std::size_t i : readings) {
      rows.push_back(static_cast<Eigen::Index>(2 * i));
      rows.push_back(static_cast<Eigen::Index>(2 * i + 1));
    }
    const int count = static_cast<int>(rows.size()), freedom = freedom_ - count;
    const Eigen::MatrixXd own = Eigen::MatrixXd::Identity(count, count) - hat(rows);
    const Eigen::LDLT<Eigen::MatrixXd> solver(own);
    constexpr double decides_alone = 1e-6;
    if (!(solver.vectorD().minCoeff() > decides_alone)) return {};
    const double drop = residuals_(rows).dot(solver.solve(residuals_(rows)));
    if (freedom < 1) return noise_is_known_ ? judged(drop / count, count / 2, 0) : Verdict{};
    const double rest = std::max((square_sum_ - drop) / freedom, floor_);
    return judged(drop / count / rest, count / 2, freedom);
  }

  double leverage(std::size_t reading) const {
    const auto row = static_cast<Eigen::Index>(2 * reading);
    return 0.5 * hat({row, row + 1}).trace();
  }

 private:
  static Verdict judged(double ratio, int pairs, int freedom) {
    return {ratio, fisher_upper_probability(ratio, pairs, freedom)};
  }
  /// Rows and columns of the hat matrix; all of it would grow with the square of the readings.
  Eigen::MatrixXd hat(const std::vector<Eigen::Index>& rows) const {
    const auto count = static_cast<Eigen::Index>(rows.size());
    if (slopes_.cols() == 0) return Eigen::MatrixXd::Zero(count, count);
    return spread_(rows, Eigen::all) * slopes_(rows, Eigen::all).transpose();
  }
  const Eigen::MatrixXd& slopes_;
  Eigen::MatrixXd spread_;  ///< hat matrix = spread_ slopes_^T
  Eigen::VectorXd residuals_;
  double square_sum_, floor_ = 1;
  bool noise_is_known_;
  int freedom_ = 0;
};

/// A reading is named if chance would name any of the fit's readings less often than this.
constexpr double named_by_chance = 1e-3;
/// Above this many readings two that hide each other are not sought: the pairs become too many.
constexpr std::size_t most_for_pairs = 60;

}  // namespace

std::vector<LeftOut> leave_one_out(const WeightedTask& weighted, const FitOutcome& fit, bool noise_is_known) {
  const Deletion deletion(weighted, fit, noise_is_known);
  std::vector<LeftOut> all;
  for (std::size_t i = 0; i < weighted.used.size(); ++i)
    all.push_back({std::sqrt(std::max(0.0, 2 * deletion.without({i}).ratio)), deletion.leverage(i)});
  return all;
}

std::vector<std::size_t> standing_out(const WeightedTask& weighted, const FitOutcome& fit,
                                      bool noise_is_known) {
  const Deletion deletion(weighted, fit, noise_is_known);
  const std::size_t count = weighted.used.size();
  const auto tests = static_cast<double>(count);
  std::vector<std::size_t> worst;
  double least = named_by_chance / tests;
  const auto consider = [&](const std::vector<std::size_t>& readings) {
    const double probability = deletion.without(readings).probability;
    if (!(probability < least)) return;
    least = probability;
    worst = readings;
  };
  for (std::size_t i = 0; i < count; ++i) consider({i});
  if (!worst.empty() || count > most_for_pairs) return worst;
  least = named_by_chance / (tests * (tests - 1) / 2);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) consider({i, j});
  return worst;
}

}  // namespace kempe::calibration_detail
