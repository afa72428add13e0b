#pragma once
// The frame of a sheet (ISO 5457) and its title block (ISO 7200), and the room that they leave.

#include <string>

#include "kempe/drawing_options.hpp"
#include "reports/workshop/sheet.hpp"

namespace kempe::workshop {

/// What every title block says.
struct Job {
  std::string title;    ///< anything
  std::string copy;     ///< "scale 1.4, rotation 90 deg"
  std::string date;     ///< empty: a line to write on
  std::string hash;     ///< of design.json
  std::string version;  ///< of the program
};

enum class Orientation { portrait, landscape };

/// Width and height of a sheet, mm.
Point sheet_size(Paper paper, Orientation orientation);

/// The room for drawings inside the frame and above the title block, mm.
Box room_of(const Point& sheet_size);

/// The height that the ruler takes at the foot of the room, mm.
inline constexpr double ruler_room = 15;
/// A ruler of exactly 100 mm at the foot of the room, to check a print with: sheets at 1:1 have one.
void draw_ruler(Sheet& sheet);

/// Frame, centring marks and title block of sheet `number` of `count`.
void draw_frame(Sheet& sheet, const Job& job, std::size_t number, std::size_t count,
                const Lettering& lettering);

}  // namespace kempe::workshop
