#include "synthesis/search/diagnosis/relaxation_words.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/slack.hpp"

namespace kempe {

double rounded_down(double length, SpecUnit unit) {
  const double value = length / in_mm(unit);
  const double step = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / step) * step * in_mm(unit);
}

double rounded_up(double length, SpecUnit unit) {
  const double value = length / in_mm(unit);
  const double step = std::pow(10, std::floor(std::log10(value)) - 5);
  return std::ceil(value / step) * step * in_mm(unit);
}

double next_size(double length, SpecUnit unit) {
  const bool in_inches = unit == SpecUnit::inch;
  const double large = in_inches ? in_mm(unit) / 16 : 1, tiny = in_inches ? large / 8 : large / 10;
  const double step = length >= 10 * large ? large : length >= large ? large / 2 : tiny;
  return step * std::ceil(length / step * (1 - slack::rounding));
}

double next_smaller(double length, SpecUnit unit) {
  const double value = length / in_mm(unit) * (1 + slack::rounding);
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double step = value < 2 * power ? power / 10 : power / 2;
  return std::floor(value / step) * step * in_mm(unit);
}

std::string six_digits(double length, SpecUnit unit) { return fmt::format("{:.6g}", length / in_mm(unit)); }

std::string place_text(const Point& place, SpecUnit unit) {
  const Point shown = place / in_mm(unit);
  return fmt::format("({:.10g}, {:.10g}) {}", shown.x() + 0.0, shown.y() + 0.0,  // + 0: no minus before zero
                     name(unit));
}

std::string holes_sentence(const Spec& spec, SpecUnit unit) {
  return fmt::format("two holes of {0} {3} with a wall of {1} {3} between them stand {2} {3} apart",
                     six_digits(joint_width(spec), unit), six_digits(least_wall(spec), unit),
                     six_digits(hole_distance(spec), unit), name(unit));
}

std::string length_would_do(const std::string& key, double demanded, double possible, SpecUnit unit) {
  return would_do(name_in(unit, key), demanded / in_mm(unit), possible / in_mm(unit));
}

std::string section_would_do(const LinkSection& section, SpecUnit unit) {
  return fmt::format("{} has none that is stiff enough; with {} x {} added a design exists",
                     name_in(unit, "links.sections_mm"), six_digits(section.width, unit),
                     six_digits(section.thickness, unit));
}

std::string would_do(const std::string& key, double demanded, double possible) {
  return fmt::format("{} = {:.6g} is in the way; {:.6g} would do", key, demanded, possible);
}

std::string without_it(const std::string& key, SpecUnit unit) {
  return fmt::format("{} is in the way; without it a design exists", name_in(unit, key));
}

}  // namespace kempe
