#pragma once
// The lettering that drawings embed: made from Debian's fonts-osifont when the project is built.

#include <span>

namespace kempe::workshop {

/// osifont.ttf, whole.
std::span<const unsigned char> lettering_font();

}  // namespace kempe::workshop
