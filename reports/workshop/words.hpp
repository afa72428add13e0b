#pragma once
// Words of a plan that stand clear of its lines and of each other.

#include <string>

#include "reports/pictures/picture_labels.hpp"
#include "reports/workshop/sheet.hpp"

namespace kempe::workshop {

/// Words where they are clear of all that was placed before; one that has no room at what it names is led to it by a thin line.
class Words {
 public:
  /// Words stay in `field`, mm on paper.
  Words(Sheet& sheet, const Lettering& lettering, const Box& field)
      : sheet_(sheet), lettering_(lettering),
        placer_({0.5 * (field.lower + field.upper), 0.5 * (field.upper - field.lower)}, 0.3) {}

  LabelPlacer& placer() { return placer_; }
  /// Keeps words clear of a region's edges, as far as few edges can say it.
  void avoid_edges(const View& view, const Region& region);

  /// Beside a mark of that radius, mm on paper: as near as it can, there on the side `preferred` (zero: at one of its corners).
  void write(const std::string& text, const Point& anchor, double radius, double height,
             const Point& preferred = Point::Zero());
  /// In a region where it is clear there, nearest to its middle; else beside it. Nothing of an empty one.
  void write_in(const std::string& text, const View& view, const Region& region, double height);

 private:
  void lead(const PictureBox& word, const Point& to);

  Sheet& sheet_;
  const Lettering& lettering_;
  LabelPlacer placer_;
};

}  // namespace kempe::workshop
