#pragma once
// Text for HTML and SVG: everything that comes from outside passes through here.

#include <string>
#include <string_view>

namespace kempe {

/// The text with & < > " ' as character references and control characters (but tab and line feed) as U+FFFD:
/// safe between tags and inside quoted attributes.
std::string html_escaped(std::string_view text);

/// A JSON text that may stand inside a <script> element: every < as \u003c.
std::string script_escaped(std::string_view json);

/// Base64 of the bytes, padded (RFC 4648).
std::string base64(std::string_view bytes);

/// At most `decimals` decimals, trailing zeros cut, a true minus sign: "43.012", "50", "−7.5".
std::string number_text(double value, int decimals);

/// As number_text, for SVG attributes: a hyphen for minus.
std::string coordinate(double value, int decimals = 3);

/// "12.34 mm" with a no-break space.
std::string length_text(double length, int decimals = 3);
/// "90°" from radians.
std::string angle_text(double angle, int decimals = 2);
/// "53.2 cm²", or mm² below 100 mm².
std::string area_text(double area);
/// A small figure with two digits: "3.1·10⁻¹³ mm".
std::string residual_text(double length);
/// "12 345": digits in groups of three with narrow no-break spaces.
std::string count_text(unsigned long long count);

}  // namespace kempe
