#include "synthesis/calibration/statistics.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point.hpp"

namespace kempe {
namespace {

/// Solves probability(x) = wanted for a growing function by bisection to the last digit.
template <class Probability>
double inverse(double wanted, Probability probability) {
  double lower = 0, upper = 1;
  while (probability(upper) < wanted && upper < 1e300) upper *= 2;
  for (int i = 0; i < 200 && lower < upper; ++i) {
    const double middle = 0.5 * (lower + upper);
    if (middle == lower || middle == upper) break;
    (probability(middle) < wanted ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

}  // namespace

double student_central_probability(double value, int freedom) {
  const double angle = std::atan(value / std::sqrt(static_cast<double>(freedom)));
  const double c = std::cos(angle), s = std::sin(angle);
  const bool odd = freedom % 2 == 1;
  double term = odd ? c : 1, sum = freedom == 1 ? 0 : term;
  for (int j = odd ? 2 : 1; j <= freedom - 3; j += 2) {
    term *= c * c * j / (j + 1);
    sum += term;
  }
  return odd ? 2 / pi * (angle + s * sum) : s * sum;
}

double student_central_quantile(double probability, int freedom) {
  return inverse(probability,
                 [freedom](double value) { return student_central_probability(value, freedom); });
}

double normal_central_quantile(double probability) {
  return inverse(probability, [](double value) { return std::erf(value / std::sqrt(2.0)); });
}

double fisher_upper_probability(double value, int pairs, int freedom) {
  if (!(value > 0)) return 1;
  // With 2m over n degrees of freedom:  x^(n/2) sum over j < m of (n/2)(n/2 + 1)...(n/2 + j - 1) (1 - x)^j /
  // j!
  const double half = 0.5 * freedom, x = freedom > 0 ? half / (half + pairs * value) : 0;
  double term = freedom > 0 ? std::pow(x, half) : std::exp(-pairs * value), sum = 0;
  for (int j = 0; j < pairs; ++j) {
    sum += term;
    term *= (freedom > 0 ? (half + j) * (1 - x) : pairs * value) / (j + 1);
  }
  return sum;
}

double chi_squared_upper_probability(double value, int freedom) {
  if (!(value > 0)) return 1;
  // Sums of positive terms, each from the one before; for many degrees of freedom they are summed as logarithms.
  const bool odd = freedom % 2 == 1;
  const double half = 0.5 * value;
  double sum = odd ? std::erfc(std::sqrt(half)) : 0;
  double logarithm = odd ? 0.5 * std::log(2 * value / pi) - half : -half;
  for (int k = odd ? 3 : 2; k <= freedom; k += 2) {
    sum += std::exp(logarithm);
    logarithm += std::log(value / k);
  }
  return std::min(1.0, sum);
}

}  // namespace kempe
