// From the table upward: areas, grid, things, the linkage, words, the scale bar.

#include "reports/pictures/map_picture.hpp"

#include "reports/pictures/map_areas.hpp"
#include "reports/pictures/map_labels.hpp"
#include "reports/pictures/map_things.hpp"
#include "reports/pictures/mechanism_picture.hpp"
#include "reports/pictures/svg_element.hpp"

namespace kempe {
namespace {

MapPicture drawn_map(const Design& design, double coarseness) {
  const MapScene scene(design, coarseness);
  const PictureView& view = scene.view;
  std::vector<MapLayer> layers;
  LabelPlacer placer(scene.drawing, view.unit);
  placer.avoid(scale_bar_box(scene));
  const std::string labels = map_labels(scene, placer);  // first: these are always shown
  std::string inside = map_hatches(view) + map_areas(scene, layers) + map_grid(scene);
  inside += map_things(scene, layers, placer);
  inside += mechanism_svg(design, scene.pose, view.unit) + labels + map_scale_bar(scene);
  layers.push_back({"mechanism", "Linkage", "", "things"});
  layers.push_back({"grid", "Grid, mm", "", "things"});
  const SvgElement title =
      SvgElement("title").with("id", "map-title").saying("The linkage on its workspace map, seen from above");
  const SvgElement svg = SvgElement("svg")
                             .with("class", "map")
                             .with("id", "map")
                             .with("xmlns", svg_namespace)
                             .with("role", "img")
                             .with("aria-labelledby", "map-title")
                             .with("viewBox", view_box(view.left, view.top, view.width, view.height))
                             .with("font-size", letter_size * view.unit, 5)
                             .holding("\n" + title.line() + inside);
  return {svg.line(), view, scene.job, scene.whole, layers, scene.tracer, scene.detail};
}

}  // namespace

MapPicture map_picture(const Design& design) {
  // Finer than anyone sees; a map of very many corners is drawn coarser, so that the page stays a page.
  constexpr double finest = 0.15, coarsest = 5;
  constexpr std::size_t most = 500000;
  MapPicture picture;
  for (double coarseness = finest; coarseness < coarsest; coarseness *= 2) {
    picture = drawn_map(design, coarseness);
    if (picture.svg.size() <= most) break;
  }
  return picture;
}

}  // namespace kempe
