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

/// How many characters a text of UTF-8 has.
std::size_t characters_in(std::string_view text);

/// As number_text, for SVG attributes: a hyphen for minus.
std::string coordinate(double value, int decimals = 3);
/// The same at a text's end.
void append_coordinate(std::string& to, double value, int decimals = 3);

/// The same of a figure, as of mm, N or percent: what the decimals would round to 0 has two digits instead, "6.8e-06", down to a billionth.
std::string figure_text(double value, int decimals);
/// One of the multiples of a step, with so many decimals; where these do not tell the multiples apart with as many digits as do,
/// "1.05e-08".
std::string multiple_text(double value, double step, int decimals);
/// "12.34 mm" with a no-break space, as figure_text.
std::string length_text(double length, int decimals = 3);
/// mm, of an error: with three decimals, below a tenth with three digits, "0.354", "0.00587", "1.04e-06".
std::string error_text(double length);
/// The same with its unit.
std::string error_length(double length);
/// A limit as it was typed, to six digits: "0.0077 mm".
std::string limit_text(double length);
/// "12.34 N", as figure_text.
std::string force_text(double force, int decimals = 2);
/// "90°" from radians.
std::string angle_text(double angle, int decimals = 2);
/// The one unit in which the areas of a table or a legend are written: mm² where the largest is below 100 mm², m² where
/// it is 10 m² or more, else cm².
class AreaUnit {
 public:
  /// mm²
  explicit AreaUnit(double largest);
  /// "53.2 cm²", of an area in mm²; "< 0.01 cm²" where the figure would say 0 of what is not.
  std::string text(double area) const;

 private:
  struct Unit {
    std::string_view name;
    double in_mm2;
    int decimals;  ///< of what is below 1
  };
  Unit unit_;
};
/// An area alone, in its own unit.
std::string area_text(double area);
/// A small figure with two digits: "3.1·10⁻¹³ mm".
std::string residual_text(double length);
/// "12 345": digits in groups of three with narrow no-break spaces.
std::string count_text(unsigned long long count);

}  // namespace kempe
