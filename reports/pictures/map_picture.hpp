#pragma once
// The report's picture: the design drawn on its workspace map, as inline SVG that needs no script.

#include <string>
#include <vector>

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

struct MapPicture {
  std::string svg;
  PictureView view;
  std::vector<MapLayer> layers;
  Point tracer = Point::Zero();  ///< where the tracer stands in it
  double detail = 0;             ///< mm: corners of outlines nearer to each other are left out
};

MapPicture map_picture(const Design& design);

/// A place of the region (of the workspace, if there is no region) where the design is good to look at: its
/// linkage assembles there.
Point place_to_show(const Design& design);

}  // namespace kempe
