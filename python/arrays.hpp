#pragma once
// Points of the plane as NumPy arrays.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "kempe/point.hpp"

namespace kempe::python {

/// What stands in an array where there is no value.
inline constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

/// Numbers of Python as they are where they are doubles in one piece, else a copy of them that is.
using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Points of an array of shape (n, 2), read in place.
class Points {
 public:
  /// Throws ValueError for another shape.
  explicit Points(const Numbers& numbers) : data_(numbers.data()), size_(numbers.shape(0)) {
    if (numbers.ndim() != 2 || numbers.shape(1) != 2)
      throw pybind11::value_error("points have the shape (n, 2)");
  }
  pybind11::ssize_t size() const { return size_; }
  Point operator[](pybind11::ssize_t i) const { return {data_[2 * i], data_[2 * i + 1]}; }

 private:
  const double* data_;
  pybind11::ssize_t size_;
};

/// An array (n, 2) of its own.
inline Numbers array_of(const std::vector<Point>& points) {
  Numbers numbers({static_cast<pybind11::ssize_t>(points.size()), pybind11::ssize_t{2}});
  static_assert(sizeof(Point) == 2 * sizeof(double));
  if (!points.empty()) std::memcpy(numbers.mutable_data(), points.data(), points.size() * sizeof(Point));
  return numbers;
}

/// An array (n,) of its own.
inline Numbers array_of(const std::vector<double>& values) {
  return Numbers(static_cast<pybind11::ssize_t>(values.size()), values.data());
}

/// An array (n, 2) of its own, NaN where there is no point.
inline Numbers array_of(const std::vector<std::optional<Point>>& points) {
  std::vector<Point> all;
  all.reserve(points.size());
  for (const auto& point : points) all.push_back(point.value_or(Point(not_there, not_there)));
  return array_of(all);
}

/// An array (n,) of its own, NaN where there is no value.
inline Numbers array_of(const std::vector<std::optional<double>>& values) {
  std::vector<double> all;
  all.reserve(values.size());
  for (const auto& value : values) all.push_back(value.value_or(not_there));
  return array_of(all);
}

/// The points of an array.
inline std::vector<Point> points_of(const Numbers& numbers) {
  const Points points(numbers);
  std::vector<Point> list;
  list.reserve(static_cast<std::size_t>(points.size()));
  for (pybind11::ssize_t i = 0; i < points.size(); ++i) list.push_back(points[i]);
  return list;
}

/// A list of polygons, each a tuple of its outer ring and the list of its holes.
inline pybind11::list polygons_of(const Region& region) {
  pybind11::list polygons;
  for (const Polygon& polygon : region.polygons) {
    pybind11::list holes;
    for (const Ring& hole : polygon.holes) holes.append(array_of(hole));
    polygons.append(pybind11::make_tuple(array_of(polygon.outer), holes));
  }
  return polygons;
}

}  // namespace kempe::python
