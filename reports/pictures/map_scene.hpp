#pragma once
// What all parts of the map's picture are drawn from: the design, where its linkage stands, the frame, and the elements of one
// look.

#include <string>
#include <string_view>
#include <vector>

#include "reports/pictures/html_text.hpp"
#include "reports/pictures/picture_labels.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// What the picture shows, in SVG's frame: mm, y turned downward.
struct PictureView {
  double left = 0, top = 0, width = 1, height = 1;
  double unit = 1;  ///< one nominal pixel, mm
};

/// A part of the map that can be switched on and off: an entry of the legend.
struct MapLayer {
  std::string id;      ///< "free": its elements have the class "m-free", its switch the id "layer-free"
  std::string label;   ///< for a person
  std::string figure;  ///< its area, or what there is to say; perhaps empty
  std::string group;   ///< "map", "lost" or "things"
  bool shown = true;   ///< at first
};

/// One design as it is drawn. The design must outlive it.
struct MapScene {
  /// `coarseness` nominal pixels are left out between two corners of an outline.
  MapScene(const Design& shown, double coarseness);

  const Design& design;
  Point tracer;  ///< where the tracer stands
  Region copy;
  Pose pose{};
  PictureView view{};
  PictureBox drawing{};  ///< the view without its strips, y upward
  PictureBox job{};      ///< all that the work on the region takes; without a region the same as `whole`
  PictureBox whole{};    ///< the whole map and all obstacles, whatever the view shows of them
  AreaUnit areas{0};     ///< of every area in the legend
  double detail = 0;     ///< mm: corners of outlines nearer to each other are left out

 private:
  void frame();
  void fit_drawing(const PictureBox& box, double strip);
};

/// Size of a letter, nominal px.
inline constexpr double letter_size = 15;

/// A path of this class and a line's end; nothing without data.
std::string map_path(std::string_view css, const std::string& data);
/// A group of the class "m-ID"; nothing with nothing inside.
std::string map_group(std::string_view id, const std::string& inside);
/// Words of this class about a place, `inside` being escaped already.
std::string map_words(std::string_view css, const Point& at, const std::string& inside);

/// The hatches that areas are filled with.
std::string map_hatches(const PictureView& view);
/// Lines of round coordinates, with their figures in the strips.
std::string map_grid(const MapScene& scene);
/// Where the scale bar stands with its words.
PictureBox scale_bar_box(const MapScene& scene);
/// A round length at the map's lower right corner.
std::string map_scale_bar(const MapScene& scene);

}  // namespace kempe
