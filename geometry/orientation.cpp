#include "geometry/orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace kempe {
namespace {

int sign(double value) { return (value > 0) - (value < 0); }

/// A sum of doubles kept without rounding: parts of increasing magnitude that do not overlap, the last one
/// has the sign of the whole.
class ExactSum {
 public:
  void add_product(double a, double b) {
    const double high = a * b;
    add(std::fma(a, b, -high));
    add(high);
  }

  int sign_of_sum() const {
    for (std::size_t i = count_; i-- > 0;) {
      if (parts_[i] != 0) return sign(parts_[i]);
    }
    return 0;
  }

 private:
  void add(double value) {
    for (std::size_t i = 0; i < count_; ++i) {
      const double sum = value + parts_[i];
      const double virtual_part = sum - value;
      parts_[i] = (value - (sum - virtual_part)) + (parts_[i] - virtual_part);
      value = sum;
    }
    parts_[count_++] = value;
  }

  std::array<double, 12> parts_{};
  std::size_t count_ = 0;
};

int exact_orientation(const Point& a, const Point& b, const Point& c) {
  ExactSum sum;
  sum.add_product(a.x(), b.y());
  sum.add_product(-a.x(), c.y());
  sum.add_product(-c.x(), b.y());
  sum.add_product(-a.y(), b.x());
  sum.add_product(a.y(), c.x());
  sum.add_product(c.y(), b.x());
  return sum.sign_of_sum();
}

/// For a point on the line of a segment: does it lie within the segment's box?
bool within_box(const Point& from, const Point& to, const Point& point) {
  return (point.array() >= from.cwiseMin(to).array()).all() &&
         (point.array() <= from.cwiseMax(to).array()).all();
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
  constexpr double bound = (3 + 16 * unit) * unit;
  if (std::abs(determinant) > bound * (std::abs(left) + std::abs(right))) return sign(determinant);
  return exact_orientation(a, b, c);
}

bool segments_meet(const Point& a1, const Point& a2, const Point& b1, const Point& b2) {
  const int b1_side = orientation(a1, a2, b1), b2_side = orientation(a1, a2, b2);
  const int a1_side = orientation(b1, b2, a1), a2_side = orientation(b1, b2, a2);
  if (b1_side * b2_side < 0 && a1_side * a2_side < 0) return true;
  return (b1_side == 0 && within_box(a1, a2, b1)) || (b2_side == 0 && within_box(a1, a2, b2)) ||
         (a1_side == 0 && within_box(b1, b2, a1)) || (a2_side == 0 && within_box(b1, b2, a2));
}

}  // namespace kempe
