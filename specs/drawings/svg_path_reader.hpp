#pragma once
// The path data of SVG (https://www.w3.org/TR/SVG11/paths.html): every command, absolute and relative.

#include <optional>
#include <string>
#include <string_view>

#include "specs/drawings/curve_flattening.hpp"

namespace kempe {

/// Reads numbers, flags and commands out of SVG's attribute texts; independent of the locale.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : rest_(text) {}

  void skip_space();
  /// White space and at most one comma.
  void skip_separator();
  bool at_end();
  /// The next character, which is taken; 0 at the end.
  char take();
  char look() const { return rest_.empty() ? '\0' : rest_.front(); }
  /// A finite number (with any separator after it taken); nothing if none stands here.
  std::optional<double> number();
  /// A single 0 or 1, as arcs have it: "11" is two flags.
  std::optional<bool> flag();
  /// A name of letters; perhaps empty.
  std::string_view word();
  /// What is left, cut to a length fit for a message.
  std::string excerpt() const;

 private:
  std::string_view rest_;
};

/// Draws the path. Nothing comes back if all was well, else what stands where a number or a command should;
/// what came before it has been drawn.
std::optional<std::string> draw_svg_path(std::string_view data, CurveFlattener& curves);

/// The arc of SVG's path data from the pen's place: half axes `rx`, `ry` turned by `turn` (rad), ends at
/// `to`. Radii too small are enlarged, as SVG says (implementation notes F.6.5, F.6.6).
void draw_svg_arc(CurveFlattener& curves, double rx, double ry, double turn, bool large, bool positive_sweep,
                  const Point& to);

}  // namespace kempe
