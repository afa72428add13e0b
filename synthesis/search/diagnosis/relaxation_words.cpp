#include "synthesis/search/diagnosis/relaxation_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace kempe {

double rounded_down(double value) {
  const double step = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / step) * step;
}

double rounded_up(double value) {
  const double step = std::pow(10, std::floor(std::log10(value)) - 5);
  return std::ceil(value / step) * step;
}

std::string place_text(const Point& place) {
  return fmt::format("({:.10g}, {:.10g})", place.x() + 0.0, place.y() + 0.0);  // + 0: no minus before zero
}

std::string holes_sentence(const Spec& spec) {
  return fmt::format("two holes of {:.6g} mm with a wall of {:.6g} mm between them stand {:.6g} mm apart",
                     joint_width(spec), least_wall(spec), hole_distance(spec));
}

std::string would_do(const std::string& key, double demanded, double possible) {
  return fmt::format("{} = {:.6g} is in the way; {:.6g} would do", key, demanded, possible);
}

std::string without_it(const std::string& what) {
  return fmt::format("{} is in the way; without it a design exists", what);
}

}  // namespace kempe
