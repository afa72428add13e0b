// The wanted angles, and the places where an error is looked at: halved until the function is nearly straight between
// two, so that a steep end is seen as well as the middle.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/functions/precision_points.hpp"
#include "synthesis/functions/refinement.hpp"
#include "synthesis/functions/slack.hpp"

namespace kempe {
namespace {

constexpr int first_cells = 64;
constexpr std::size_t most_cells = 1500;
constexpr int most_halvings = 26;
constexpr int samples = 2001;

/// A peak of the function (sign 1), or a dip (-1), run up between the samples beside it.
struct Peak {
  double x = 0, height = 0;  ///< height: sign * y
  bool endless = false;      ///< it goes on rising until no doubles are left between
};

/// Halves the interval about the highest place known. A peak that settles gains less and less; towards a pole every halving
/// gains as much as the one before, or more. `range`: of y over all samples.
Peak run_up(const FunctionTask& task, int sign, double lower, double top, double upper, double range) {
  constexpr int most_rounds = 1100, first_look = 3;
  constexpr std::size_t least_rounds = 24;
  std::vector<double> heights{sign * task.wanted(top)};
  const double first_fall = heights.front() - std::min(sign * task.wanted(lower), sign * task.wanted(upper));
  for (int round = 0; round < most_rounds && !task.stop(); ++round) {
    const double left = 0.5 * (lower + top), right = 0.5 * (top + upper);
    const bool has_left = lower < left && left < top;
    const bool has_right = top < right && right < upper;
    if (!has_left && !has_right) break;
    const double highest = heights.back();
    const double at_left = has_left ? sign * task.wanted(left) : highest;
    const double at_right = has_right ? sign * task.wanted(right) : highest;
    if (!std::isfinite(at_left)) return {left, at_left, true};
    if (!std::isfinite(at_right)) return {right, at_right, true};
    if (at_left > highest && at_left >= at_right) {
      upper = top;
      top = left;
    } else if (at_right > highest) {
      lower = top;
      top = right;
    } else {
      lower = left;
      upper = right;
    }
    heights.push_back(std::max({highest, at_left, at_right}));
    if (round + 1 != 2 * first_look) continue;
    const double gain = heights.back() - heights[first_look],
                 first_gain = heights[first_look] - heights.front(),
                 fall = heights.back() - std::min(at_left, at_right);
    if (gain <= slack::peak_settles * first_gain && fall <= slack::peak_settles * first_fall)
      return {top, heights.back(), false};
  }
  // Far from zero numbers lie so wide apart that a few halvings tell nothing.
  const std::size_t last = heights.size() - 1;
  if (task.stop() || last < least_rounds) return {top, heights.back(), false};
  const double at_first = heights[last / 3] - heights.front(),
               at_last = heights[last] - heights[2 * last / 3];
  return {top, heights.back(),
          at_last > slack::pole_goes_on * at_first && at_last > slack::pole_counts * range};
}

std::string finite_everywhere(const FunctionTask& task) {
  return fmt::format("a function that is finite from x = {:.6g} to {:.6g}, both included", task.x_lower,
                     task.x_upper);
}

}  // namespace

NoDial not_finite_at(const FunctionTask& task, double x) {
  return {fmt::format("no finite value at x = {:.9g}", x), finite_everywhere(task)};
}

WantedAngles::WantedAngles(const FunctionTask& task) : task_(task) {
  y_lower_ = std::numeric_limits<double>::infinity();
  y_upper_ = -y_lower_;
  precision_ = chebyshev_points(task.x_lower, task.x_upper, task.points);
  std::reverse(precision_.begin(), precision_.end());
  no_dial_ = sampled();
  if (!no_dial_) no_dial_ = lay_out_places();
  if (!no_dial_ && !task.stop()) no_dial_ = seen_whole();
  if (no_dial_) places_.clear();
}

/// Finds the dial's ends: at samples, and where a peak between two of them stands out.
std::optional<NoDial> WantedAngles::sampled() {
  std::vector<double> x, y;
  for (int i = 0; i < samples; ++i) {
    x.push_back(task_.x_lower + (task_.x_upper - task_.x_lower) * i / (samples - 1));
    y.push_back(task_.wanted(x.back()));
    if (!std::isfinite(y.back())) return not_finite_at(task_, x.back());
    y_lower_ = std::min(y_lower_, y.back());
    y_upper_ = std::max(y_upper_, y.back());
  }
  const double range = y_upper_ - y_lower_, largest = std::max(std::abs(y_lower_), std::abs(y_upper_));
  if (!(range > slack::constant * largest && range > slack::least_range))
    return NoDial{range == 0 ? fmt::format("constant: {:.6g} at all {} places", y_lower_, samples)
                             : fmt::format("as good as constant: from {:.17g} to {:.17g} at {} places",
                                           y_lower_, y_upper_, samples),
                  fmt::format("a function whose values differ by more than {:g} of the largest, and by {:g}",
                              slack::constant, slack::least_range),
                  false};
  if (!(range <= slack::most_range))
    return NoDial{fmt::format("values from {:.6g} to {:.6g}", y_lower_, y_upper_),
                  fmt::format("values that differ by at most {:g}", slack::most_range), false};
  const double low = y_lower_, high = y_upper_;
  for (std::size_t i = 0; i < y.size() && !task_.stop(); ++i) {
    const std::size_t before = i == 0 ? i : i - 1, after = std::min(i + 1, y.size() - 1);
    for (const int sign : {-1, 1}) {
      if (sign * (y[i] - y[before]) < 0 || sign * (y[i] - y[after]) < 0 ||
          (y[i] == y[before] && y[i] == y[after]))
        continue;
      const Peak peak = run_up(task_, sign, x[before], x[i], x[after], range);
      if (!std::isfinite(peak.height)) return not_finite_at(task_, peak.x);
      if (peak.endless)
        return NoDial{fmt::format("values without end towards x = {:.9g} ({:.3g} as near as numbers come)",
                                  peak.x, sign * peak.height),
                      finite_everywhere(task_), false};
      if (sign > 0 && peak.height > high + slack::peak_stands_out * range)
        y_upper_ = std::max(y_upper_, peak.height);
      if (sign < 0 && peak.height > -low + slack::peak_stands_out * range)
        y_lower_ = std::min(y_lower_, -peak.height);
    }
  }
  return std::nullopt;
}

double WantedAngles::input_turn(double x) const {
  return task_.input_range * (x - task_.x_lower) / (task_.x_upper - task_.x_lower);
}

double WantedAngles::output_turn(double x) const {
  return task_.output_range * (task_.wanted(x) - y_lower_) / (y_upper_ - y_lower_);
}

double WantedAngles::value_at(double output_turn) const {
  return y_lower_ + output_turn / task_.output_range * (y_upper_ - y_lower_);
}

WantedPlace WantedAngles::place_at(double x) const {
  const double turn = input_turn(x);
  return {x, turn, output_turn(x), 0, std::cos(turn), std::sin(turn)};
}

std::optional<NoDial> WantedAngles::lay_out_places() {
  struct Cell {
    WantedPlace left, middle, right;
  };
  const double width = task_.x_upper - task_.x_lower;
  const auto cell = [&](const WantedPlace& left, const WantedPlace& right) {
    return Cell{left, place_at(0.5 * (left.x + right.x)), right};
  };
  std::vector<Cell> cells;
  for (int i = 0; i < first_cells; ++i)
    cells.push_back(
        cell(place_at(task_.x_lower + width * i / first_cells),
             place_at(i + 1 == first_cells ? task_.x_upper : task_.x_lower + width * (i + 1) / first_cells)));
  const auto strays = [&](const Cell& c) {
    return std::abs(c.middle.output_turn - 0.5 * (c.left.output_turn + c.right.output_turn)) /
           std::abs(task_.output_range);
  };
  bool settled = false, ran_out = false;
  for (int halving = 0; halving < most_halvings && !settled && !task_.stop(); ++halving) {
    std::vector<Cell> next;
    ran_out = cells.size() >= most_cells;
    for (const Cell& c : cells) {
      if (strays(c) > slack::nearly_straight && !ran_out && !task_.stop()) {
        next.push_back(cell(c.left, c.middle));
        next.push_back(cell(c.middle, c.right));
      } else {
        next.push_back(c);
      }
    }
    settled = next.size() == cells.size();
    cells = std::move(next);
  }
  if (ran_out && !task_.stop()) {
    double most = 0;
    for (const Cell& c : cells) most = std::max(most, strays(c));
    if (most > slack::strays_too_far)
      return NoDial{
          fmt::format("more ups and downs than {} places can follow", 2 * cells.size() + 1),
          "a smoother function, or fewer of its ups and downs within x: a four-bar turns back twice in a "
          "turn at most",
          false};
    if (most > slack::nearly_straight) unseen_ = most * std::abs(task_.output_range);
  }
  places_ = {cells.front().left};
  for (const Cell& c : cells) {
    const double share = (c.right.x - c.left.x) / (6 * width);
    places_.back().weight += share;
    places_.push_back(c.middle);
    places_.back().weight = 4 * share;
    places_.push_back(c.right);
    places_.back().weight = share;
  }
  return std::nullopt;
}

/// Every place has a value, and the places have seen both ends of the dial, and nothing beyond them.
std::optional<NoDial> WantedAngles::seen_whole() const {
  double lowest = 1, highest = 0;
  for (const WantedPlace& place : places_) {
    const double share = place.output_turn / task_.output_range;
    if (!std::isfinite(share)) return not_finite_at(task_, place.x);
    lowest = std::min(lowest, share);
    highest = std::max(highest, share);
  }
  const auto differs = [](double seen, double end) { return std::abs(seen - end) > slack::strays_too_far; };
  if (!differs(lowest, 0) && !differs(highest, 1)) return std::nullopt;
  return NoDial{
      fmt::format(
          "a peak narrower than can be followed: values from {:.6g} to {:.6g}, of which {} places see "
          "{:.6g} to {:.6g}",
          y_lower_, y_upper_, places_.size(), y_lower_ + lowest * (y_upper_ - y_lower_),
          y_lower_ + highest * (y_upper_ - y_lower_)),
      "a smoother function, or an x that begins or ends before the peak", false};
}

std::vector<WantedPlace> WantedAngles::some_places(int count) const {
  const double width = task_.x_upper - task_.x_lower;
  const auto towards_ends = [&](double x) {
    return std::acos(std::clamp(1 - 2 * (x - task_.x_lower) / width, -1.0, 1.0)) / pi;
  };
  double whole_way = 0;
  for (std::size_t i = 1; i < places_.size(); ++i)
    whole_way += std::abs(places_[i].output_turn - places_[i - 1].output_turn);
  std::vector<WantedPlace> chosen{places_.front()};
  double way = 0;
  for (std::size_t i = 1; i < places_.size(); ++i) {
    way += std::abs(places_[i].output_turn - places_[i - 1].output_turn);
    const double share =
        ((places_[i].x - task_.x_lower) / width + way / whole_way + towards_ends(places_[i].x)) / 3;
    if (share * (count - 1) >= static_cast<double>(chosen.size()) - slack::place_due ||
        i + 1 == places_.size())
      chosen.push_back(places_[i]);
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const double left = chosen[i == 0 ? i : i - 1].x, right = chosen[i + 1 == chosen.size() ? i : i + 1].x;
    chosen[i].weight = 0.5 * (right - left) / width;
  }
  return chosen;
}

}  // namespace kempe
