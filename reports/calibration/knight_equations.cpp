#include "reports/calibration/knight_equations.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/linkages/equation_numbers.hpp"
#include "specs/text/printable.hpp"
#include "synthesis/calibration/knight.hpp"

namespace kempe {
namespace {

/// A reading as the equations take it.
struct UsedReading {
  const ReadingSpec& spec;
  double factor;  ///< from what was read to the departure of E: 1, or -k with tracer and pen exchanged
  KnightReading taken;
};

/// Those of the last round, without the ones left out.
std::vector<UsedReading> used_readings(const CalibrationRecord& record) {
  const bool left_out = !record.measurements.fit.keep_outliers && record.calibration.otherwise.has_value();
  std::vector<UsedReading> used;
  for (const ReadingRecord& one : record.readings) {
    if (left_out && one.fit.outlier) continue;
    const ReadingSpec& spec = record.measurements.readings[one.reading];
    const double k = spec.ratio.value_or(record.measurements.instrument->ratio);
    const double factor = spec.exchanged ? -k : 1;
    used.push_back({spec, factor, {*spec.arm_angle, factor * spec.error}});
  }
  return used;
}

tl::expected<KnightErrors, KnightFault> errors_of(const std::vector<UsedReading>& used) {
  std::vector<KnightReading> taken;
  for (const UsedReading& one : used) taken.push_back(one.taken);
  return knight_errors(taken);
}

/// A sum of products of two numbers each.
std::string sum_of_products(const std::vector<std::pair<double, double>>& products) {
  std::string text;
  for (const auto& [a, b] : products)
    text += (text.empty() ? digits(a) : signed_number(a)) + " * " + bracketed_digits(b);
  return text;
}

constexpr double rounding_of_a_mean = 1e-15;  // of cosines

struct StraightLine {  ///< through (c_i, value_i)
  std::vector<double> c;
  double mean = 0, spread = 0;
};

std::string reading_lines(const UsedReading& one, std::size_t number, StraightLine& line) {
  const Point& read = one.spec.error;
  const Point& e = one.taken.error;
  const double t = one.taken.arm_angle, angle = degrees(t);
  std::string text = fmt::format("reading {}", number);
  if (one.spec.name != text) text += " (" + printable(one.spec.name) + ")";
  text += fmt::format(": arm at {} degrees\n", digits(angle));
  for (const int axis : {0, 1}) {
    const std::string product =
        one.factor == 1 ? "" : digits(one.factor) + " * " + bracketed_digits(read[axis]) + " = ";
    text += fmt::format("  {}{} = {}{}\n", axis == 0 ? 'x' : 'y', number, product, digits(e[axis]));
  }
  const double c = std::cos(2 * t), along = e.x() * std::cos(t), across = e.y() * std::sin(t);
  text += fmt::format("  c{} = cos({}) = {}\n", number, digits(2 * angle), digits(c));
  text += fmt::format("  s{0} = {1} cos({2}){3} sin({2}) = {4}\n", number, digits(e.x()), digits(angle),
                      signed_number(e.y()), digits(along + across));
  text += fmt::format("  d{0} = {1} cos({2}){3} sin({2}) = {4}\n", number, digits(e.x()), digits(angle),
                      signed_number(-e.y()), digits(along - across));
  line.c.push_back(c);
  return text;
}

/// The line's mean and spread of c, and each reading's share in its slope and in its height at c = 0.
std::string line_lines(StraightLine& line) {
  const double count = static_cast<double>(line.c.size());
  std::string sum, squares;
  for (const double c : line.c) {
    line.mean += c / count;
    sum += sum.empty() ? digits(c) : signed_number(c);
  }
  if (std::abs(line.mean) < rounding_of_a_mean) line.mean = 0;
  std::string text = fmt::format("  m = ({}) / {} = {}\n", sum, count, digits(line.mean));
  for (const double c : line.c) {
    line.spread += (c - line.mean) * (c - line.mean);
    squares += fmt::format("{}({}{})^2", squares.empty() ? "" : " + ", digits(c), signed_number(-line.mean));
  }
  text += fmt::format("  S = {} = {}\n", squares, digits(line.spread));
  for (std::size_t i = 0; i < line.c.size(); ++i) {
    const double slope = (line.c[i] - line.mean) / line.spread;
    text += fmt::format("  w{} = ({}{}) / {} = {}\n", i + 1, digits(line.c[i]), signed_number(-line.mean),
                        digits(line.spread), digits(slope));
    text += fmt::format("  v{} = 1 / {}{} * {} = {}\n", i + 1, count, signed_number(-line.mean),
                        bracketed_digits(slope), digits(1 / count - line.mean * slope));
  }
  return text;
}

/// An entry of the matrix: w or v of the reading times the cosine of its arm angle or plus or minus the sine.
std::string entry_line(std::size_t row, std::size_t reading, bool is_y, const UsedReading& one,
                       const StraightLine& line, double value) {
  const bool by_slope = row < 2, of_difference = row % 2 == 0;  // AC, CF, BE, DE
  const double slope = (line.c[reading] - line.mean) / line.spread;
  const double share = by_slope ? slope : 1 / static_cast<double>(line.c.size()) - line.mean * slope;
  return fmt::format("  {}{}{} = {} {}({}) = {}\n", ScaleErrors::names[row], is_y ? "y" : "x", reading + 1,
                     digits(is_y && of_difference ? -share : share), is_y ? "sin" : "cos",
                     digits(degrees(one.taken.arm_angle)), digits(value));
}

}  // namespace

bool has_knight_equations(const CalibrationRecord& record) {
  return !record.rounds.empty() && record.method == CalibrationMethod::knight &&
         errors_of(used_readings(record)).has_value();
}

InputError no_knight_equations(const CalibrationRecord& record, const std::string& key) {
  return {"", 0, key, record.rounds.empty() ? "a file without readings" : "the method least_squares",
          "Knight's method and its readings (method knight)"};
}

std::string knight_equations_text(const CalibrationRecord& record) {
  const auto used = used_readings(record);
  const auto found = errors_of(used);
  if (!found) return "";
  std::string text =
      "equations    x toward the tracer F, y toward C, t the arm's angle\n"
      "  s: x cos t + y sin t, on the line e_DE + e_CF cos 2t\n"
      "  d: x cos t - y sin t, on the line e_BE + e_AC cos 2t\n";
  if (used.size() < record.readings.size())
    text += fmt::format("  {} of {} readings: the others stand out\n", used.size(), record.readings.size());
  StraightLine line;
  for (std::size_t i = 0; i < used.size(); ++i) text += reading_lines(used[i], i + 1, line);
  text +=
      "shares of the readings in a line's slope (w) and in its height at cos 2t = 0 (v)\n" + line_lines(line);
  text += "matrix from readings to errors: AC and BE from d, CF and DE from s\n";
  const auto& matrix = found->by_reading;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t i = 0; i < used.size(); ++i)
      for (const bool is_y : {false, true})
        text += entry_line(row, i, is_y, used[i], line,
                           matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(2 * i + is_y)));
  text += "errors, and the corrections to add to the scales, mm\n";
  for (std::size_t row = 0; row < 4; ++row) {
    std::vector<std::pair<double, double>> products;
    for (std::size_t i = 0; i < used.size(); ++i)
      for (const int axis : {0, 1})
        products.emplace_back(matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(2 * i) + axis),
                              used[i].taken.error[axis]);
    text += fmt::format("  e_{} = {} = {}\n", ScaleErrors::names[row], sum_of_products(products),
                        digits(found->errors.values()[row]));
  }
  for (std::size_t row = 0; row < 4; ++row) {
    const double error = found->errors.values()[row];
    text += fmt::format("  correction_{} = -{} = {}\n", ScaleErrors::names[row], bracketed_digits(error),
                        digits(-error));
  }
  return text;
}

nlohmann::ordered_json knight_equations_json(const CalibrationRecord& record) {
  const auto used = used_readings(record);
  nlohmann::ordered_json readings = nlohmann::ordered_json::array(), matrix = nlohmann::ordered_json::array();
  for (const UsedReading& one : used)
    readings.push_back({{"name", one.spec.name},
                        {"arm_angle_deg", degrees(one.taken.arm_angle)},
                        {"departure_mm", {one.taken.error.x(), one.taken.error.y()}}});
  if (const auto found = errors_of(used))
    for (Eigen::Index row = 0; row < 4; ++row) {
      matrix.emplace_back(nlohmann::ordered_json::array());
      for (Eigen::Index column = 0; column < found->by_reading.cols(); ++column)
        matrix.back().push_back(found->by_reading(row, column));
    }
  return {{"readings", readings}, {"matrix", matrix}};
}

}  // namespace kempe
