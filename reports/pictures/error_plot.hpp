#pragma once
// A curve of errors over its range, as a picture.

#include <string>
#include <utility>
#include <vector>

namespace kempe {

/// What is drawn. Texts may be anything: they are escaped.
struct ErrorPlot {
  std::string title, x_label, y_label;
  std::vector<std::pair<double, double>> curve;  ///< (x, error), x rising, at least two
  std::vector<double> marked;                    ///< x of the precision points
};

/// A whole SVG document, 720 x 420 px, axes with round numbers.
std::string error_plot_svg(const ErrorPlot& plot);

}  // namespace kempe
