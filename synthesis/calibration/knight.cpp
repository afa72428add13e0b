#include "synthesis/calibration/knight.hpp"

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

std::optional<KnightFault> fault_of(const std::vector<KnightReading>& readings) {
  if (readings.size() < 2) return KnightFault::too_few;
  double lowest = 1, highest = -1;
  for (const KnightReading& reading : readings) {
    if (!(reading.arm_angle >= knight_end_margin && reading.arm_angle <= pi / 2 - knight_end_margin))
      return KnightFault::at_an_end;
    lowest = std::min(lowest, std::cos(2 * reading.arm_angle));
    highest = std::max(highest, std::cos(2 * reading.arm_angle));
  }
  if (highest - lowest < knight_least_spread) return KnightFault::one_angle;
  return std::nullopt;
}

/// Straight line through (c_i, z_i): the rows that make intercept and slope from the z.
struct LineRows {
  Eigen::RowVectorXd intercept, slope;
};
LineRows line_rows(const Eigen::VectorXd& c) {
  const double count = static_cast<double>(c.size()), mean = c.mean();
  const Eigen::RowVectorXd slope =
      (c.array() - mean).matrix().transpose() / (c.array() - mean).square().sum();
  return {Eigen::RowVectorXd::Constant(c.size(), 1 / count) - mean * slope, slope};
}

}  // namespace

Measures deviations_of(const ScaleErrors& errors) {
  Measures deviations = Measures::Zero();
  for (std::size_t i = 0; i < scales.size(); ++i)
    deviations[index_of(scales[i].measure)] = scales[i].sign * errors.values()[i];
  return deviations;
}

ScaleErrors scale_errors_of(const Measures& deviations) {
  const auto error = [&](std::size_t i) { return scales[i].sign * deviations[index_of(scales[i].measure)]; };
  return {error(0), error(1), error(2), error(3)};
}

std::string_view name(KnightFault fault) {
  switch (fault) {
    case KnightFault::too_few: return "fewer than two readings";
    case KnightFault::at_an_end: return "an arm angle next to 0 or 90 degrees";
    case KnightFault::one_angle: break;
  }
  return "all readings at one arm angle";
}

tl::expected<KnightErrors, KnightFault> knight_errors(const std::vector<KnightReading>& readings) {
  if (const auto fault = fault_of(readings)) return tl::unexpected(*fault);
  const auto count = static_cast<Eigen::Index>(readings.size());
  Eigen::VectorXd c(count), measured(2 * count);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(count, 2 * count), differences = sums;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [angle, error] = readings[static_cast<std::size_t>(i)];
    c[i] = std::cos(2 * angle);
    measured.segment<2>(2 * i) = error;
    sums.block<1, 2>(i, 2 * i) << std::cos(angle), std::sin(angle);
    differences.block<1, 2>(i, 2 * i) << std::cos(angle), -std::sin(angle);
  }
  const LineRows line = line_rows(c);
  KnightErrors result;
  result.by_reading.resize(4, 2 * count);
  result.by_reading << line.slope * differences, line.slope * sums, line.intercept * differences,
      line.intercept * sums;
  const Eigen::Vector4d errors = result.by_reading * measured;
  result.errors = {errors[0], errors[1], errors[2], errors[3]};
  for (const KnightReading& reading : readings)
    result.left.push_back(reading.error - departure_of(result.errors, reading.arm_angle));
  return result;
}

Point departure_of(const ScaleErrors& errors, double arm_angle) {
  const double sum = errors.DE + errors.CF * std::cos(2 * arm_angle);
  const double difference = errors.BE + errors.AC * std::cos(2 * arm_angle);
  return {(sum + difference) / (2 * std::cos(arm_angle)), (sum - difference) / (2 * std::sin(arm_angle))};
}

}  // namespace kempe
