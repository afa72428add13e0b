#pragma once
// The parts of a linkage's picture that page, animation and the picture of centres share.

#include <string>
#include <string_view>

#include "reports/linkages/scene.hpp"
#include "reports/pictures/svg_element.hpp"

namespace kempe {

/// Sizes of a picture in its own unit, from the extent of what it shows.
struct PictureScale {
  Point lower, upper;  ///< of the view, margins included
  double stroke;       ///< width of a thin line
  double pin;          ///< radius of a pin
  double letter;       ///< height of letters
  int decimals;        ///< that coordinates need

  static PictureScale of(const Point& lower, const Point& upper);
  std::string view_box() const;
  std::string number(double value) const;
  std::string pair(const Point& p) const;  ///< "x,y"
  /// A straight line as path data.
  std::string line(const Point& from, const Point& to) const;
};

/// Colour of a link by its number, as a CSS colour; the ground is grey.
std::string link_colour(int body);

/// A link in its own frame: hull or bar, wheels, guides, pins; for a <g>.
std::string body_shape(const SceneBody& body, int number, const PictureScale& scale);

/// The shape of the ground, which does not move.
SvgElement ground_group(const LinkageScene& scene, const PictureScale& scale);

/// An SVG transform: where a link is at a moment.
std::string placement(const LinkageScene::Moment& moment, std::size_t body, const PictureScale& scale);

/// The sign of a fixed pivot, or of a mere mark, in the table's frame.
std::string ground_sign(const ScenePoint& point, const PictureScale& scale);

/// An element that looks like its kind (link, pin, block, guide, wheel, spoke, ground, hatch, force, trace, wanted, order, name): its class and
/// attributes say how, so that a page needs no style sheet for it, which its security policy would have to allow.
SvgElement drawn(std::string_view element, std::string_view kind, const PictureScale& scale);

}  // namespace kempe
