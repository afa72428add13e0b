#include "reports/drawings/trace_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "reports/drawings/svg_writer.hpp"
#include "reports/pictures/svg_element.hpp"

namespace kempe {
namespace {

/// From little to much, told apart by lightness too.
constexpr std::array<std::string_view, 6> ramp{"#3b0f70", "#2a5c9c", "#1f8f8c",
                                               "#4aa84a", "#c9a400", "#e05a00"};

/// The colour of a force.
std::size_t step_of(const HandForces& scale, double force) {
  if (!(scale.most > scale.least)) return 0;
  const double share = std::clamp((force - scale.least) / (scale.most - scale.least), 0.0, 1.0);
  return std::min(ramp.size() - 1, static_cast<std::size_t>(share * ramp.size()));
}

std::string piece(const Stroke& points, std::size_t step) {
  ArcRing ring;
  for (const Point& point : points) ring.push_back({point, 0});
  return SvgElement("path").with("d", outline_path(ring, false)).with("stroke", ramp[step]).line();
}

/// Neighbouring points of one colour in one path.
std::string pieces_of(const TracedLine& line, const HandForces& scale) {
  Stroke points = line.points;
  std::vector<double> hand = line.hand;
  if (line.closed && !points.empty()) {
    points.push_back(points.front());
    hand.push_back(hand.front());
  }
  std::string text;
  Stroke run;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const std::size_t step = step_of(scale, 0.5 * (hand[i] + hand[i + 1]));
    run.push_back(points[i]);
    const bool ends = i + 2 == points.size() || step_of(scale, 0.5 * (hand[i + 1] + hand[i + 2])) != step;
    if (!ends) continue;
    run.push_back(points[i + 1]);
    text += piece(run, step);
    run.clear();
  }
  return text;
}

std::string legend(const HandForces& scale, const Box& box) {
  const double top = -box.lower.y() + 4, side = 4;
  std::string text;
  for (std::size_t step = 0; step < ramp.size(); ++step)
    text += SvgElement("rect")
                .with("x", fmt::format("{}", box.lower.x() + side * static_cast<double>(step)))
                .with("y", fmt::format("{}", top))
                .with("width", fmt::format("{}", side))
                .with("height", "2")
                .with("fill", ramp[step])
                .line();
  return text + SvgElement("text")
                    .with("x", fmt::format("{}", box.lower.x()))
                    .with("y", fmt::format("{}", top + 5.5))
                    .with("font-size", "3")
                    .with("font-family", "sans-serif")
                    .saying(fmt::format("hand {:.3g} to {:.3g} N", scale.least, scale.most))
                    .line();
}

}  // namespace

HandForces hand_forces(const Trace& trace) {
  HandForces forces;
  for (const TracedLine& line : trace.drawn)
    for (const double force : line.hand) {
      if (!std::isfinite(force)) {
        ++forces.dead_points;
        continue;
      }
      forces.least = std::min(forces.least, force);
      forces.most = std::max(forces.most, force);
    }
  return forces;
}

std::string forces_csv(const Trace& trace, const HandWork& work) {
  std::string text =
      "stroke,tracer_x_mm,tracer_y_mm,hand_x_N,hand_y_N,hand_N,friction_N,pole_N,pin_A_N,pin_B_N,pin_C_N,"
      "pin_V_N,mass_felt_kg,give_x_mm,give_y_mm\n";
  for (const TracedPose& row : trace.poses) {
    if (!row.pose) continue;
    const auto at = work.at(*row.pose, row.heading);
    if (!at) {
      fmt::format_to(std::back_inserter(text), "{},{},{},,,,,,,,,,,,\n", row.stroke, row.tracer.x(),
                     row.tracer.y());
      continue;
    }
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.stroke,
                   row.tracer.x(), row.tracer.y(), at->hand.x(), at->hand.y(), at->hand.norm(), at->friction,
                   std::abs(at->pins.post), std::abs(at->pins.A), std::abs(at->pins.B), std::abs(at->pins.C),
                   std::abs(at->pins.V), at->mass, at->give.x(), at->give.y());
  }
  return text;
}

std::string coloured_by_hand(const Trace& trace, const Box& box) {
  const HandForces scale = hand_forces(trace);
  if (!scale.any()) return {};
  std::string paths;
  for (const TracedLine& line : trace.drawn) paths += pieces_of(line, scale);
  return SvgElement("g")
             .with("id", "copy")
             .with("fill", "none")
             .with("stroke-width", "0.5")
             .with("stroke-linejoin", "round")
             .with("stroke-linecap", "round")
             .holding("\n" + paths)
             .line() +
         SvgElement("g").with("id", "legend").holding("\n" + legend(scale, box)).line();
}

}  // namespace kempe
