#include "specs/drawings/svg_path_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace kempe {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

void SvgScanner::skip_space() {
  while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
}

void SvgScanner::skip_separator() {
  skip_space();
  if (look() == ',') rest_.remove_prefix(1);
  skip_space();
}

bool SvgScanner::at_end() {
  skip_space();
  return rest_.empty();
}

char SvgScanner::take() {
  const char c = look();
  if (!rest_.empty()) rest_.remove_prefix(1);
  return c;
}

std::optional<double> SvgScanner::number() {
  skip_space();
  // from_chars takes neither a plus nor refuses "inf" and "nan".
  std::string_view text = rest_;
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const std::size_t sign = !text.empty() && text.front() == '-' && text.data() == rest_.data() ? 1 : 0;
  if (text.size() <= sign || !(is_digit(text[sign]) || text[sign] == '.')) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
  return value;
}

std::optional<bool> SvgScanner::flag() {
  skip_space();
  const char c = look();
  if (c != '0' && c != '1') return std::nullopt;
  rest_.remove_prefix(1);
  return c == '1';
}

std::string_view SvgScanner::word() {
  const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_letter);
  const std::string_view result = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(result.size());
  return result;
}

std::string SvgScanner::excerpt() const {
  constexpr std::size_t longest = 20;
  if (rest_.empty()) return "the end";
  std::string text(rest_.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return "\"" + text + (rest_.size() > longest ? "...\"" : "\"");
}

void draw_svg_arc(CurveFlattener& curves, double rx, double ry, double turn, bool large, bool positive_sweep,
                  const Point& to) {
  const Point from = curves.pen();
  rx = std::abs(rx);
  ry = std::abs(ry);
  if (from == to) return;
  if (rx == 0 || ry == 0) return curves.line_to(to);
  // Names as in the notes: primes are coordinates along the ellipse's axes.
  const Complex axis = std::polar(1.0, turn);
  const Complex half = 0.5 * as_complex(from - to) * std::conj(axis);
  const double needed = std::norm(Complex(half.real() / rx, half.imag() / ry));
  if (needed > 1) {
    rx *= std::sqrt(needed);
    ry *= std::sqrt(needed);
  }
  const double share =
      std::sqrt(std::max(0.0, 1 / std::max(needed, 1e-300) - 1)) * (large == positive_sweep ? -1 : 1);
  const Complex centre_prime =
      needed > 1 ? Complex{} : share * Complex(rx * half.imag() / ry, -ry * half.real() / rx);
  const Point centre = as_point(centre_prime * axis + 0.5 * as_complex(from + to));
  const auto angle = [&](Complex prime) { return std::atan2(prime.imag() / ry, prime.real() / rx); };
  const double start = angle(half - centre_prime);
  double sweep = angle(-half - centre_prime) - start;
  if (positive_sweep && sweep < 0) sweep += 2 * pi;
  if (!positive_sweep && sweep > 0) sweep -= 2 * pi;
  curves.elliptic_to(centre, as_point(rx * axis), as_point(Complex(0, ry) * axis), start, sweep, to);
}

namespace {

/// One pass over the path data: the commands as they come, with what they remember of each other.
class PathDrawer {
 public:
  PathDrawer(std::string_view data, CurveFlattener& curves) : scan_(data), curves_(curves) {}

  std::optional<std::string> draw() {
    bool first = true;
    while (!scan_.at_end()) {
      const char letter = scan_.look();
      if (!is_letter(letter) || (first && letter != 'M' && letter != 'm')) return scan_.excerpt();
      scan_.take();
      first = false;
      if (!run(letter)) return scan_.excerpt();
    }
    return std::nullopt;
  }

 private:
  /// A command with all its repetitions; false where a number is missing.
  bool run(char letter) {
    relative_ = letter >= 'a';
    char command = static_cast<char>(relative_ ? letter - 'a' + 'A' : letter);
    if (command == 'Z') {
      curves_.close();
      last_ = 'Z';
      return true;
    }
    do {
      if (!once(command)) return false;
      last_ = command;
      if (command == 'M') command = 'L';
      scan_.skip_separator();
    } while (!is_letter(scan_.look()) && !scan_.at_end());
    return true;
  }

  bool once(char command) {
    switch (command) {
      case 'M': return with_points<1>([&](const auto& p) { curves_.move_to(p[0]); });
      case 'L': return with_points<1>([&](const auto& p) { curves_.line_to(p[0]); });
      case 'H': return along(0);
      case 'V': return along(1);
      case 'C': return with_points<3>([&](const auto& p) { cubic(p[0], p[1], p[2]); });
      case 'S': return with_points<2>([&](const auto& p) { cubic(reflected("CS"), p[0], p[1]); });
      case 'Q': return with_points<2>([&](const auto& p) { quadratic(p[0], p[1]); });
      case 'T': return with_points<1>([&](const auto& p) { quadratic(reflected("QT"), p[0]); });
      case 'A': return arc();
      default: return false;
    }
  }

  template <std::size_t count, class Draw>
  bool with_points(Draw draw) {
    std::array<Point, count> points;
    const Point origin = relative_ ? curves_.pen() : Point(Point::Zero());
    for (Point& point : points) {
      const auto x = number(), y = number();
      if (!x || !y) return false;
      point = origin + Point(*x, *y);
    }
    draw(points);
    return true;
  }

  bool along(int coordinate) {
    const auto value = number();
    if (!value) return false;
    Point to = curves_.pen();
    to[coordinate] = *value + (relative_ ? to[coordinate] : 0);
    curves_.line_to(to);
    return true;
  }

  bool arc() {
    const auto rx = number(), ry = number(), turn = number();
    const auto large = flag(), positive = flag();
    if (!rx || !ry || !turn || !large || !positive) return false;
    return with_points<1>(
        [&](const auto& p) { draw_svg_arc(curves_, *rx, *ry, radians(*turn), *large, *positive, p[0]); });
  }

  void cubic(const Point& control1, const Point& control2, const Point& to) {
    curves_.cubic_to(control1, control2, to);
    control_ = control2;
  }
  void quadratic(const Point& control, const Point& to) {
    curves_.quadratic_to(control, to);
    control_ = control;
  }
  /// The last control point mirrored at the pen, if the last command was one of these.
  Point reflected(std::string_view after) const {
    return after.find(last_) == std::string_view::npos ? curves_.pen() : Point(2 * curves_.pen() - control_);
  }

  std::optional<double> number() {
    const auto value = scan_.number();
    if (value) scan_.skip_separator();
    return value;
  }
  std::optional<bool> flag() {
    const auto value = scan_.flag();
    if (value) scan_.skip_separator();
    return value;
  }

  SvgScanner scan_;
  CurveFlattener& curves_;
  Point control_ = Point::Zero();
  char last_ = ' ';
  bool relative_ = false;
};

}  // namespace

std::optional<std::string> draw_svg_path(std::string_view data, CurveFlattener& curves) {
  return PathDrawer(data, curves).draw();
}

}  // namespace kempe
