#include "reports/linkages/function_equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/linkages/equation_numbers.hpp"
#include "synthesis/functions/precision_points.hpp"
#include "synthesis/solvers/golden_section.hpp"

namespace kempe {
namespace {

double wanted_input_angle(const FunctionTask& task, const FunctionDesign& design, double x) {
  return design.input_start + task.input_range * (x - task.x_lower) / (task.x_upper - task.x_lower);
}

double wanted_output_angle(const FunctionTask& task, const FunctionDesign& design, double y) {
  return design.output_start + task.output_range * (y - design.y_lower) / (design.y_upper - design.y_lower);
}

/// The structural error at a place, rad; 0 where the loop does not close.
double error_at(const FunctionTask& task, const FunctionDesign& design, double x) {
  const auto generated = design.linkage.output_angle(wanted_input_angle(task, design, x));
  return generated ? std::remainder(*generated - wanted_output_angle(task, design, task.wanted(x)), 2 * pi)
                   : 0;
}

/// Chebyshev's formula for the places at which x was chosen by it; empty for other places.
std::string spacing_of(const FunctionTask& task, double x) {
  if (task.method != FunctionMethod::precision_points) return "";
  const double middle = (task.x_lower + task.x_upper) / 2, half = (task.x_upper - task.x_lower) / 2;
  const std::vector<double> places = chebyshev_points(task.x_lower, task.x_upper, task.points);
  for (int j = 1; j <= task.points; ++j) {
    const double angle = 180.0 * (2 * j - 1) / (2 * task.points);
    const double at = places[static_cast<std::size_t>(j) - 1];
    if (std::abs(at - x) <= 1e-9 * half)
      return fmt::format("{}{} cos({}) = {}", digits(middle), signed_number(half), digits(angle), digits(at));
  }
  return "";
}

std::string lengths_work(const FourBar& bar, const FreudensteinCoefficients& k) {
  const double a = bar.input, c = bar.output, d = bar.ground;
  return fmt::format(
      "the ground link d = {0}\n"
      "  a = d/K1 = {0}/{1} = {2}\n"
      "  c = d/K2 = {0}/{3} = {4}\n"
      "  b = sqrt(a^2 + c^2 + d^2 - 2 a c K3) = sqrt({2}^2 + {4}^2 + {0}^2 - 2 * {2} * {4} * {5}) = {6}\n",
      digits(d), digits(k.K1), digits(a), digits(k.K2), digits(c), digits(k.K3), digits(bar.coupler));
}

std::string ripples_work(const FunctionTask& task, const FunctionDesign& design) {
  std::string text = "structural error (generated less wanted angle of the output crank), its extremes\n";
  for (const StructuralRipple& ripple : structural_ripples(task, design))
    text += fmt::format("  x = {:<12} {:+.6g} degrees\n", digits(ripple.x), degrees(ripple.error));
  return text;
}

}  // namespace

std::vector<FunctionPoint> function_points(const FunctionTask& task, const FunctionDesign& design) {
  std::vector<double> places = design.precision_points;
  std::sort(places.begin(), places.end());
  const FreudensteinCoefficients k = design.linkage.coefficients();
  std::vector<FunctionPoint> points;
  for (const double x : places) {
    FunctionPoint point;
    point.x = x;
    point.y = task.wanted(x);
    point.input_angle = wanted_input_angle(task, design, x);
    point.output_angle = wanted_output_angle(task, design, point.y);
    point.spacing = spacing_of(task, x);
    const double phi = point.input_angle, psi = point.output_angle;
    point.equation = fmt::format("{0} cos({1}){2} cos({3}){4} = cos({3} - {5})", digits(k.K1),
                                 digits(degrees(psi)), signed_number(-k.K2), digits(degrees(phi)),
                                 signed_number(k.K3), bracketed_digits(degrees(psi)));
    point.residual = k.K1 * std::cos(psi) - k.K2 * std::cos(phi) + k.K3 - std::cos(phi - psi);
    points.push_back(point);
  }
  return points;
}

std::vector<StructuralRipple> structural_ripples(const FunctionTask& task, const FunctionDesign& design) {
  const auto& curve = design.curve;
  std::vector<std::size_t> tops;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const bool continues =
        !tops.empty() && std::signbit(curve[tops.back()].error) == std::signbit(curve[i].error);
    if (!continues)
      tops.push_back(i);
    else if (std::abs(curve[i].error) > std::abs(curve[tops.back()].error))
      tops.back() = i;
  }
  std::vector<StructuralRipple> ripples;
  for (const std::size_t top : tops) {
    ripples.push_back({curve[top].x, curve[top].error});
    if (top == 0 || top + 1 == curve.size()) continue;
    const double x = top_by_golden_section([&](double at) { return std::abs(error_at(task, design, at)); },
                                           curve[top - 1].x, curve[top + 1].x, 40);
    const double error = error_at(task, design, x);
    if (std::abs(error) > std::abs(ripples.back().error)) ripples.back() = {x, error};
  }
  return ripples;
}

std::string function_equations_text(const FunctionTask& task, const FunctionDesign& design) {
  const std::vector<FunctionPoint> points = function_points(task, design);
  const bool is_spaced = task.method == FunctionMethod::precision_points;
  std::string text = is_spaced
                         ? "\nprecision points by Chebyshev's spacing, n = " + std::to_string(task.points) +
                               ": x = (x0 + x1)/2 + (x1 - x0)/2 cos((2 j - 1) 180/(2 n))\n"
                         : "\nplaces where the structural error vanishes, found on its curve\n";
  for (const FunctionPoint& point : points)
    text += "  x = " + (point.spacing.empty() ? digits(point.x) : point.spacing) + "\n";
  text += fmt::format(
      "angles there, degrees: phi = {}{} (x - x0)/(x1 - x0), psi = {}{} (y - y0)/(y1 - y0)\n"
      "  with x0 = {}, x1 = {}, y0 = {}, y1 = {}\n",
      digits(degrees(design.input_start)), signed_number(degrees(task.input_range)),
      digits(degrees(design.output_start)), signed_number(degrees(task.output_range)), digits(task.x_lower),
      digits(task.x_upper), digits(design.y_lower), digits(design.y_upper));
  for (const FunctionPoint& point : points)
    text += fmt::format("  x = {}, y = {}: phi = {}, psi = {}\n", digits(point.x), digits(point.y),
                        digits(degrees(point.input_angle)), digits(degrees(point.output_angle)));
  const FreudensteinCoefficients k = design.linkage.coefficients();
  text += fmt::format(
      "Freudenstein's equations: K1 cos(psi) - K2 cos(phi) + K3 = cos(phi - psi)\n"
      "  K1 = d/a = {}, K2 = d/c = {}, K3 = (a^2 - b^2 + c^2 + d^2)/(2 a c) = {}\n",
      digits(k.K1), digits(k.K2), digits(k.K3));
  for (const FunctionPoint& point : points)
    text += fmt::format("  {}   (left less right {:.1e})\n", point.equation, point.residual);
  return text + lengths_work(design.linkage, k) + ripples_work(task, design);
}

nlohmann::ordered_json function_equations_json(const FunctionTask& task, const FunctionDesign& design) {
  const FreudensteinCoefficients k = design.linkage.coefficients();
  nlohmann::ordered_json object{{"coefficients", {{"K1", k.K1}, {"K2", k.K2}, {"K3", k.K3}}}};
  for (const FunctionPoint& point : function_points(task, design))
    object["points"].push_back({{"x", point.x},
                                {"y", point.y},
                                {"input_deg", degrees(point.input_angle)},
                                {"output_deg", degrees(point.output_angle)},
                                {"spacing", point.spacing},
                                {"equation", point.equation},
                                {"residual", point.residual}});
  for (const StructuralRipple& ripple : structural_ripples(task, design))
    object["ripples"].push_back({{"x", ripple.x}, {"error_deg", degrees(ripple.error)}});
  return object;
}

}  // namespace kempe
