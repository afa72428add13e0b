#pragma once
// Outliers: readings that contradict the others.

#include <vector>

#include "synthesis/calibration/weighted_fit.hpp"

namespace kempe::calibration_detail {

/// The readings that stand out from the rest beyond chance, ascending; indices into `used`. However many hide each
/// other, up to a third of the readings. None is named where another in its place would explain nearly as much. With
/// `noise_is_known` the weights' noise is the yardstick, as long as the readings that agree best do not contradict it.
std::vector<std::size_t> standing_out(const WeightedTask& weighted, const LinearFit& about,
                                      bool noise_is_known);

/// The readings that agree best, at least two thirds of them: those that no search leaves out.
std::vector<std::size_t> agreeing_best(const WeightedTask& weighted, const LinearFit& about);

/// Studentised residual and leverage of the readings in use: each judged by the fit of the others without those left out.
struct LeftOut {
  double studentised = 0, leverage = 0;
};
std::vector<LeftOut> leave_one_out(const WeightedTask& weighted, const LinearFit& about,
                                   const std::vector<std::size_t>& left_out, bool noise_is_known);

}  // namespace kempe::calibration_detail
