#include "reports/pictures/picture_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/segment_distance.hpp"

namespace kempe {
namespace {

/// No more than the distance of any point of the box from the segment.
double distance_of_boxes(const PictureBox& box, const Point& from, const Point& to) {
  const Point below = from.cwiseMin(to) - box.upper(), above = box.lower() - from.cwiseMax(to);
  return below.cwiseMax(above).cwiseMax(0.0).norm();
}

/// The distance of a segment from a box.
double distance_from_box(const PictureBox& box, const Point& from, const Point& to) {
  const Point lower = box.lower(), upper = box.upper();
  const Hull segment{{from, to}, 2};
  return std::min(distance(Hull{{lower, {upper.x(), lower.y()}, upper}, 3}, segment),
                  distance(Hull{{lower, {lower.x(), upper.y()}, upper}, 3}, segment));
}

/// Free space between two boxes along the wider gap; negative if they overlap.
double space_between(const PictureBox& a, const PictureBox& b) {
  const Point gap = (a.centre - b.centre).cwiseAbs() - a.half - b.half;
  return gap.maxCoeff();
}

/// How far the box keeps inside the frame; negative if it leaves it.
double inset(const PictureBox& box, const PictureBox& frame) {
  return (frame.half - box.half - (box.centre - frame.centre).cwiseAbs()).minCoeff();
}

/// A label is wide and low: its box is judged at these places.
constexpr std::array<double, 5> across{-1, -0.5, 0, 0.5, 1};
constexpr std::array<double, 3> upward{-1, 0, 1};

}  // namespace

void LabelPlacer::avoid(const Point& from, const Point& to, double half_width) {
  lines_.push_back({from, to, half_width});
}

double LabelPlacer::clearness(const PictureBox& label) const {
  double least = 12 * unit_;  // further away is not better
  for (const Line& line : lines_) {
    if (distance_of_boxes(label, line.from, line.to) - line.half_width >= least) continue;
    for (const double x : across)
      for (const double y : upward) {
        const Point at = label.centre + label.half.cwiseProduct(Point(x, y));
        least = std::min(least, distance(at, line.from, line.to) - line.half_width);
      }
  }
  // Words over words or outside the picture cannot be read at all; words over a line can.
  for (const PictureBox& box : boxes_)
    if (const double space = space_between(label, box); space < 2 * unit_)
      least = std::min(least, space - 60 * unit_);
  if (const double space = inset(label, frame_); space < 0) least = std::min(least, space - 60 * unit_);
  return least;
}

Point LabelPlacer::take_best(const std::vector<PictureBox>& candidates, double far_penalty) {
  double best_score = -std::numeric_limits<double>::infinity();
  PictureBox best;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double score = clearness(candidates[i]) - far_penalty * static_cast<double>(i);
    if (score > best_score) {
      best_score = score;
      best = candidates[i];
    }
  }
  boxes_.push_back(best);
  return best.centre;
}

bool LabelPlacer::has_room(const PictureBox& label) const {
  const auto meets = [&](const PictureBox& box) { return space_between(label, box) < 2 * unit_; };
  return inset(label, frame_) >= 0 && std::none_of(boxes_.begin(), boxes_.end(), meets);
}

std::optional<Point> LabelPlacer::place_if_clear(const std::vector<PictureBox>& candidates) {
  for (const PictureBox& candidate : candidates) {
    if (!has_room(candidate)) continue;
    boxes_.push_back(candidate);
    return candidate.centre;
  }
  return std::nullopt;
}

std::optional<Point> LabelPlacer::place_if_apart(const std::vector<PictureBox>& candidates, double space) {
  for (const PictureBox& candidate : candidates) {
    const auto near = [&](const Line& line) {
      const double least = space + line.half_width;
      return distance_of_boxes(candidate, line.from, line.to) < least &&
             distance_from_box(candidate, line.from, line.to) < least;
    };
    // An outline may have a million edges: the first that is near ends the question.
    if (!has_room(candidate) || std::any_of(lines_.begin(), lines_.end(), near)) continue;
    boxes_.push_back(candidate);
    return candidate.centre;
  }
  return std::nullopt;
}

Point LabelPlacer::place_around(const Point& anchor, double radius, const Point& half,
                                const Point& preferred) {
  std::vector<PictureBox> candidates;
  const double first = std::atan2(preferred.y(), preferred.x());
  for (const double away : {4.0, 12.0, 22.0, 36.0})
    for (const int turn : {0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8}) {
      const double angle = first + turn * pi / 8;
      const Point direction(std::cos(angle), std::sin(angle));
      const double support = std::min(half.x() / std::max(1e-9, std::abs(direction.x())),
                                      half.y() / std::max(1e-9, std::abs(direction.y())));
      candidates.push_back({anchor + direction * (radius + away * unit_ + support), half});
    }
  return take_best(candidates, 0.2 * unit_);
}

Point LabelPlacer::place_beside(const PictureBox& box, const Point& half) {
  std::vector<PictureBox> candidates;
  for (const double away : {5.0, 12.0, 22.0, 40.0}) {
    const Point reach = box.half + half + Point::Constant(away * unit_);
    for (const double slide : {0.0, -0.8, 0.8}) {
      candidates.push_back({box.centre + Point(slide * box.half.x(), reach.y()), half});
      candidates.push_back({box.centre + Point(slide * box.half.x(), -reach.y()), half});
      candidates.push_back({box.centre + Point(reach.x(), slide * box.half.y()), half});
      candidates.push_back({box.centre + Point(-reach.x(), slide * box.half.y()), half});
    }
  }
  candidates.push_back({box.centre, half});
  return take_best(candidates, 0.3 * unit_);
}

}  // namespace kempe
