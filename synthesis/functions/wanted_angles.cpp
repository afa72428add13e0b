// The wanted angles, and the places where an error is looked at: halved until the function is nearly straight between
// two, so that a steep end is seen as well as the middle.

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

}  // namespace

WantedAngles::WantedAngles(const FunctionTask& task) : task_(task) {
  y_lower_ = std::numeric_limits<double>::infinity();
  y_upper_ = -y_lower_;
  constexpr int places = 2001;
  for (int i = 0; i < places; ++i) {
    const double y = task.wanted(task.x_lower + (task.x_upper - task.x_lower) * i / (places - 1));
    finite_ = finite_ && std::isfinite(y);
    y_lower_ = std::min(y_lower_, y);
    y_upper_ = std::max(y_upper_, y);
  }
  precision_ = chebyshev_points(task.x_lower, task.x_upper, task.points);
  std::reverse(precision_.begin(), precision_.end());
  if (usable()) lay_out_places();
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

bool WantedAngles::usable() const { return finite_ && y_upper_ > y_lower_; }

WantedPlace WantedAngles::place_at(double x) const {
  const double turn = input_turn(x);
  return {x, turn, output_turn(x), 0, std::cos(turn), std::sin(turn)};
}

void WantedAngles::lay_out_places() {
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
  const auto bends = [&](const Cell& c) {
    const double off = c.middle.output_turn - 0.5 * (c.left.output_turn + c.right.output_turn);
    return std::abs(off) > slack::nearly_straight * std::abs(task_.output_range);
  };
  for (int halving = 0; halving < most_halvings; ++halving) {
    std::vector<Cell> next;
    for (const Cell& c : cells) {
      if (bends(c) && cells.size() < most_cells) {
        next.push_back(cell(c.left, c.middle));
        next.push_back(cell(c.middle, c.right));
      } else {
        next.push_back(c);
      }
    }
    const bool settled = next.size() == cells.size();
    cells = std::move(next);
    if (settled) break;
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
