#include "geometry/similarity_fit.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/slack.hpp"

namespace kempe {
namespace {

/// The pairs about their means, as complex numbers.
struct Centred {
  std::vector<Complex> tracer, pen;
  Complex tracer_mean, pen_mean;
  double tracer_spread = 0, pen_spread = 0;  ///< sums of squares
};

Centred centred(const std::vector<PointPair>& pairs) {
  Centred data{};
  for (const PointPair& pair : pairs) {
    data.tracer_mean += as_complex(pair.tracer) / static_cast<double>(pairs.size());
    data.pen_mean += as_complex(pair.pen) / static_cast<double>(pairs.size());
  }
  for (const PointPair& pair : pairs) {
    data.tracer.push_back(as_complex(pair.tracer) - data.tracer_mean);
    data.pen.push_back(as_complex(pair.pen) - data.pen_mean);
    data.tracer_spread += std::norm(data.tracer.back());
    data.pen_spread += std::norm(data.pen.back());
  }
  return data;
}

/// The factor that best carries `from` to `to`.
Complex best_factor(const std::vector<Complex>& from, const std::vector<Complex>& to, double from_spread) {
  Complex sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i) sum += std::conj(from[i]) * to[i];
  return sum / from_spread;
}

/// Sum of squared distances that the factor leaves.
double unexplained(const std::vector<Complex>& from, const std::vector<Complex>& to, Complex factor) {
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i) sum += std::norm(to[i] - factor * from[i]);
  return sum;
}

Complex without_rounding(Complex k) {
  const double size = std::abs(k);
  if (std::abs(k.real()) < slack::rounding * size) k.real(0);
  if (std::abs(k.imag()) < slack::rounding * size) k.imag(0);
  return k;
}

Point without_rounding(const Point& point, double scale) {
  return point.unaryExpr([&](double c) { return std::abs(c) < slack::rounding * scale ? 0.0 : c; });
}

std::vector<Complex> conjugated(std::vector<Complex> values) {
  for (Complex& value : values) value = std::conj(value);
  return values;
}

/// A reflection is plain if it leaves less than this share of what a rotation leaves: where the rotation fits poorly
/// itself (it leaves more than this share of the spread), and else.
constexpr double reflects_better = 0.25, poor_rotation = 0.01, reflects_exactly = 1e-4;

/// Sums of squares left by the best rotation and by the best reflection: is it plain that the pairs mirror?
bool is_mirrored(const Centred& data, double left_by_rotation) {
  const std::vector<Complex> reflected = conjugated(data.tracer);
  const Complex factor = best_factor(reflected, data.pen, data.tracer_spread);
  const double left_by_reflection = unexplained(reflected, data.pen, factor);
  if (left_by_rotation <= slack::rounding * slack::rounding * data.pen_spread) return false;
  const bool rotation_is_poor = left_by_rotation > poor_rotation * data.pen_spread;
  return left_by_reflection < (rotation_is_poor ? reflects_better : reflects_exactly) * left_by_rotation;
}

}  // namespace

std::optional<Point> SimilarityFit::fixed_point() const {
  if (k == Complex(1, 0)) return std::nullopt;
  // Adding zero makes a negative zero positive.
  return as_point(as_complex(translation) / (1.0 - k)) + Point::Zero();
}

tl::expected<SimilarityFit, PairFault> fit_similarity(const std::vector<PointPair>& pairs) {
  const Centred data = centred(pairs);
  const double size = std::sqrt(data.pen_spread) + std::abs(data.pen_mean);
  if (data.tracer_spread <= std::pow(slack::rounding * std::abs(data.tracer_mean), 2))
    return tl::unexpected(PairFault::too_few);
  if (data.pen_spread <= std::pow(slack::rounding * std::abs(data.pen_mean), 2))
    return tl::unexpected(PairFault::one_pen_point);

  SimilarityFit fit{without_rounding(best_factor(data.tracer, data.pen, data.tracer_spread)), Point::Zero()};
  const double left = unexplained(data.tracer, data.pen, fit.k);
  if (is_mirrored(data, left)) return tl::unexpected(PairFault::mirrored);
  if (left > 0.25 * data.pen_spread) return tl::unexpected(PairFault::no_similarity);

  fit.translation = without_rounding(as_point(data.pen_mean - fit.k * data.tracer_mean), size);
  fit.residual_rms = std::sqrt(left / static_cast<double>(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    fit.residual_largest = std::max(fit.residual_largest, std::abs(data.pen[i] - fit.k * data.tracer[i]));
  }
  return fit;
}

}  // namespace kempe
