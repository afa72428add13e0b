#pragma once
// Where the words of a picture stand: beside what they name, clear of lines and of each other.

#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace kempe {

/// An upright box of the picture's plane (mm, y upward).
struct PictureBox {
  Point centre = Point::Zero();
  Point half = Point::Zero();
  Point lower() const { return centre - half; }
  Point upper() const { return centre + half; }
};

/// Gives each label the place that is clearest of what has been drawn and placed before.
class LabelPlacer {
 public:
  /// `frame` is where labels may stand; `unit` is one nominal pixel in mm.
  LabelPlacer(const PictureBox& frame, double unit) : frame_(frame), unit_(unit) {}

  /// A line to keep clear of, with its half width (mm).
  void avoid(const Point& from, const Point& to, double half_width);
  void avoid(const PictureBox& box) { boxes_.push_back(box); }

  /// The centre for a label of half size `half` around a mark of radius `radius` at `anchor`, best on the
  /// side `preferred`; the place is kept free from then on.
  Point place_around(const Point& anchor, double radius, const Point& half, const Point& preferred);
  /// The same beside a box: above, below, right or left of it, inside where nothing else is clear.
  Point place_beside(const PictureBox& box, const Point& half);
  /// The first of the boxes that lies within the frame and on no other label; from then on it is kept free.
  std::optional<Point> place_if_clear(const std::vector<PictureBox>& candidates);
  /// The first of the boxes that keeps `space` from lines and labels, and lies within the frame; from then on it is kept free.
  std::optional<Point> place_if_apart(const std::vector<PictureBox>& candidates, double space);

 private:
  double clearness(const PictureBox& label) const;
  /// Within the frame, and apart from all other labels.
  bool has_room(const PictureBox& label) const;
  Point take_best(const std::vector<PictureBox>& candidates, double far_penalty);

  struct Line {
    Point from, to;
    double half_width;
  };
  PictureBox frame_;
  double unit_;
  std::vector<Line> lines_;
  std::vector<PictureBox> boxes_;
};

}  // namespace kempe
