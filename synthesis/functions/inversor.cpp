// Steps: transmission of each kind as a function of its free lengths and the magnification; the smallest free
// length that keeps the limit over the range; limits of length; sensitivities by differentiating x' = f^2 /
// x.

#include "synthesis/functions/inversor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/functions/slack.hpp"

namespace kempe {
namespace {

constexpr int range_places = 65;

/// Calls f at magnifications over the range, evenly in log m, ends included.
template <class Function>
void over_range(const InversorTask& task, const Function& f) {
  for (int i = 0; i < range_places; ++i) {
    const double share = static_cast<double>(i) / (range_places - 1);
    f(task.magnification_lower * std::pow(task.magnification_upper / task.magnification_lower, share));
  }
}

template <class Transmission>
double smallest_over_range(const InversorTask& task, const Transmission& transmission) {
  double least = pi;
  over_range(task, [&](double m) { least = std::min(least, transmission(m)); });
  return least;
}

double folded(double sine) { return std::asin(std::min(1.0, std::abs(sine))); }

}  // namespace

std::string_view name(InversorKind kind) {
  switch (kind) {
    case InversorKind::peaucellier: return "peaucellier";
    case InversorKind::hart: return "hart";
    case InversorKind::right_angle: return "right_angle";
  }
  return "";
}

double peaucellier_transmission(double f, double side, double m) {
  // Pivot at the origin, the two points at x and x' on the axis, the rhombus' other corners at (mid,
  // +-spread).
  const double x = f / m, image = f * m;
  const double half = 0.5 * std::abs(image - x);
  const double spread = std::sqrt(std::max(0.0, side * side - half * half));
  const double arm = std::hypot(f, side);
  const double at_corner = folded(std::min(x, image) * spread / (arm * side));  // arm against side
  const double at_point =
      folded(2 * spread * half / (side * side));  // side against side: sin of twice the half angle
  return std::min(at_corner, at_point);
}

double hart_transmission(double f, double short_bar, double u, double m) {
  const double long_bar = std::sqrt(f * f / (u * (1 - u)) + short_bar * short_bar);
  const double upper = f / m / u, lower = f * m / (1 - u);  // the antiparallelogram's two parallel distances
  const double lean = 0.5 * (lower - upper);
  const double height = std::sqrt(std::max(0.0, short_bar * short_bar - lean * lean));
  return folded(height * std::min(upper, lower) / (long_bar * short_bar));
}

double right_angle_transmission(double m) { return std::min(std::atan(m), std::atan(1 / m)); }

namespace {

InversorDesign started(InversorKind kind, const InversorTask& task) {
  InversorDesign design;
  design.kind = kind;
  design.travel_object =
      task.focal_length / task.magnification_lower - task.focal_length / task.magnification_upper;
  design.travel_image = task.focal_length * (task.magnification_upper - task.magnification_lower);
  return design;
}

InversorAnswer finished(InversorDesign design, const InversorTask& task) {
  for (const InversorLength& length : design.lengths) {
    design.size += length.count * length.value;
    if (length.value < task.shortest || length.value > task.longest)
      return {design.kind, std::nullopt,
              fmt::format("its {} of {:.1f} mm lies outside {:.6g} .. {:.6g} mm", length.name, length.value,
                          task.shortest, task.longest)};
  }
  return {design.kind, std::move(design), ""};
}

/// Smallest value in [lower, upper] for which `holds`, searched on a geometric grid and refined; nothing if
/// nowhere.
template <class Predicate>
std::optional<double> smallest_where(double lower, double upper, const Predicate& holds) {
  constexpr int places = 400;
  double before = lower;
  for (int i = 0; i <= places; ++i) {
    double at = lower * std::pow(upper / lower, static_cast<double>(i) / places);
    if (!holds(at)) {
      before = at;
      continue;
    }
    if (i == 0) return at;
    for (int j = 0; j < 60; ++j) {
      const double middle = 0.5 * (before + at);
      (holds(middle) ? at : before) = middle;
    }
    return at;
  }
  return std::nullopt;
}

std::string no_transmission(const InversorTask& task, double best) {
  return fmt::format(
      "no lengths were found that keep the transmission angle at {:.4g} degrees over the whole range; the "
      "best found "
      "is {:.3g}",
      degrees(task.transmission), degrees(best));
}

InversorAnswer peaucellier(const InversorTask& task) {
  const double f = task.focal_length;
  if (task.magnification_lower < 1 && task.magnification_upper > 1)
    return {InversorKind::peaucellier, std::nullopt,
            "at magnification 1 its two points meet and the rhombus lies flat: the range must stay on one "
            "side of 1"};
  double best_seen = 0;
  const auto kept = [&](double side) {
    const double angle =
        smallest_over_range(task, [&](double m) { return peaucellier_transmission(f, side, m); });
    best_seen = std::max(best_seen, angle);
    return angle;
  };
  const double widest = 0.5 * f *
                        std::max(task.magnification_upper - 1 / task.magnification_upper,
                                 1 / task.magnification_lower - task.magnification_lower);
  const auto side =
      smallest_where(std::max({widest, task.shortest, slack::shortest_side * f}), 100 * f + 10 * widest,
                     [&](double l) { return kept(l) >= task.transmission && kept(l) > 0; });
  if (!side) return {InversorKind::peaucellier, std::nullopt, no_transmission(task, best_seen)};
  const double arm = std::hypot(f, *side), shortest_x = f / task.magnification_upper;
  InversorDesign design = started(InversorKind::peaucellier, task);
  design.lengths = {{"arm L", 2, arm, 2 * arm / shortest_x}, {"side l", 4, *side, 2 * *side / shortest_x}};
  design.transmission_min = kept(*side);
  return finished(std::move(design), task);
}

InversorAnswer hart(const InversorTask& task) {
  const double f = task.focal_length;
  double best_seen = 0;
  const auto kept = [&](double bar, double u) {
    const double angle = smallest_over_range(task, [&](double m) { return hart_transmission(f, bar, u, m); });
    best_seen = std::max(best_seen, angle);
    return angle;
  };
  const auto total = [&](double bar, double u) {
    return 2 * bar + 2 * std::sqrt(f * f / (u * (1 - u)) + bar * bar);
  };
  const auto longest_bar = [&](double bar, double u) {
    return std::max(bar, std::sqrt(f * f / (u * (1 - u)) + bar * bar));
  };
  // Within the longest bar where one is; else what comes nearest, to say by how much it fails.
  const auto beats = [&](double bar, double u, const std::array<double, 2>& other) {
    const double over = std::max(0.0, longest_bar(bar, u) - task.longest),
                 other_over = std::max(0.0, longest_bar(other[0], other[1]) - task.longest);
    return over != other_over ? over < other_over : total(bar, u) < total(other[0], other[1]);
  };
  std::optional<std::array<double, 2>> best;  // short bar, share
  const auto look = [&](double u) {
    const auto bar = smallest_where(std::max(task.shortest, slack::shortest_bar * f), 100 * f, [&](double b) {
      const double angle = kept(b, u);
      return angle > 0 && angle >= task.transmission;
    });
    if (bar && (!best || beats(*bar, u, *best))) best = {*bar, u};
  };
  for (int i = 1; i < 40; ++i) look(i / 40.0);
  for (double step = 1.0 / 80; best && step > slack::share_precision; step /= 2) {
    const double centre = (*best)[1];
    for (const double u : {centre - step, centre + step})
      if (u > 0.01 && u < 0.99) look(u);
  }
  if (!best) return {InversorKind::hart, std::nullopt, no_transmission(task, best_seen)};
  const auto [bar, u] = *best;
  const double product = u * (1 - u), long_bar = std::sqrt(f * f / product + bar * bar);
  const double shortest_x = f / task.magnification_upper;
  InversorDesign design = started(InversorKind::hart, task);
  design.point_share = u;
  design.lengths = {{"long bar a", 2, long_bar, 2 * product * long_bar / shortest_x},
                    {"short bar b", 2, bar, 2 * product * bar / shortest_x}};
  design.transmission_min = kept(bar, u);
  return finished(std::move(design), task);
}

InversorAnswer right_angle(const InversorTask& task) {
  const double f = task.focal_length;
  InversorDesign design = started(InversorKind::right_angle, task);
  design.transmission_min = smallest_over_range(task, right_angle_transmission);
  if (design.transmission_min < task.transmission)
    return {InversorKind::right_angle, std::nullopt,
            fmt::format("its arms meet the scale line at {:.4g} degrees at the end of the range; only "
                        "another range changes that",
                        degrees(design.transmission_min))};
  const double shortest_x = f / task.magnification_upper;
  design.lengths = {{"distance of the pivot f", 1, f, 2 * f / shortest_x},
                    {"object arm", 1, std::hypot(f, f / task.magnification_lower), 0},
                    {"image arm", 1, std::hypot(f, f * task.magnification_upper), 0}};
  return finished(std::move(design), task);
}

}  // namespace

InversorAnswer design_inversor(InversorKind kind, const InversorTask& task) {
  switch (kind) {
    case InversorKind::peaucellier: return peaucellier(task);
    case InversorKind::hart: return hart(task);
    case InversorKind::right_angle: break;
  }
  return right_angle(task);
}

std::vector<InversorAnswer> design_inversors(const InversorTask& task) {
  std::vector<InversorAnswer> answers;
  for (const InversorKind kind : all_inversors) answers.push_back(design_inversor(kind, task));
  return answers;
}

std::optional<InversorDesign> smallest(const std::vector<InversorAnswer>& answers) {
  std::optional<InversorDesign> best;
  for (const InversorAnswer& answer : answers)
    if (answer.design && (!best || answer.design->size < best->size)) best = answer.design;
  return best;
}

}  // namespace kempe
