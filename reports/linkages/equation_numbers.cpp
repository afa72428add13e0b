#include "reports/linkages/equation_numbers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace kempe {

std::string digits(double value) { return fmt::format("{:.10g}", value == 0 ? 0.0 : value); }

std::string signed_number(double value) {
  return fmt::format(" {} {}", value < 0 ? '-' : '+', digits(std::abs(value)));
}

std::string bracketed_digits(double value) { return value < 0 ? "(" + digits(value) + ")" : digits(value); }

}  // namespace kempe
