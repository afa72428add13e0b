#pragma once
// The report's picture: the design drawn on its workspace map, as inline SVG that needs no script.

#include <string>
#include <vector>

#include "reports/pictures/map_scene.hpp"

namespace kempe {

/// The picture with all that a page needs to move it.
struct MapPicture {
  std::string svg;
  PictureView view;
  PictureBox job;    ///< of MapScene
  PictureBox whole;  ///< of MapScene
  std::vector<MapLayer> layers;
  Point tracer = Point::Zero();  ///< where the tracer stands in it
  double detail = 0;             ///< mm: corners of outlines nearer to each other are left out
};

MapPicture map_picture(const Design& design);

}  // namespace kempe
