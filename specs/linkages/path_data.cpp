#include "specs/linkages/path_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "specs/drawings/svg_path_reader.hpp"

namespace kempe {
namespace {

constexpr double arc_step = pi / 12;  ///< rad of an ellipse that one cubic stands for

bool is_command(char c) { return std::string_view("MmLlHhVvCcSsQqTtAaZz").find(c) != std::string_view::npos; }

/// How many numbers a command takes.
int numbers_of(char command) {
  switch (std::tolower(command)) {
    case 'h':
    case 'v': return 1;
    case 'c': return 6;
    case 's':
    case 'q': return 4;
    case 'a': return 7;
    case 'z': return 0;
    default: return 2;
  }
}

class PathReader {
 public:
  PathReader(std::string_view data, double unit) : scan_(data), unit_(unit) {}

  tl::expected<std::vector<PathPiece>, std::string> read() {
    char command = 0;
    while (!scan_.at_end()) {
      if (is_command(scan_.look())) {
        command = scan_.take();
      } else if (command == 0 || numbers_of(command) == 0) {
        return fail("no command");
      } else if (command == 'M') {
        command = 'L';  // further pairs after a move are lines
      } else if (command == 'm') {
        command = 'l';
      }
      if (!started_ && std::tolower(command) != 'm') return fail("no M at the start");
      Numbers numbers{};
      for (int i = 0; i < numbers_of(command); ++i) {
        const bool is_flag = std::tolower(command) == 'a' && (i == 3 || i == 4);
        const auto number = is_flag ? read_flag() : scan_.number();
        if (!number) return fail("no number");
        numbers[static_cast<std::size_t>(i)] = *number;
        scan_.skip_separator();
      }
      if (const std::string fault = obey(command, numbers); !fault.empty()) return fail(fault);
    }
    if (pieces_.empty()) return tl::unexpected(std::string("a path of no length"));
    return std::move(pieces_);
  }

 private:
  using Numbers = std::array<double, 7>;

  tl::unexpected<std::string> fail(const std::string& what) const {
    return tl::unexpected(fmt::format("{} before {}", what, scan_.excerpt()));
  }

  std::optional<double> read_flag() {
    const auto flag = scan_.flag();
    return flag ? std::optional(*flag ? 1.0 : 0.0) : std::nullopt;
  }

  Point point(char command, double x, double y) const {
    const Point p = unit_ * Point(x, y);
    return std::islower(static_cast<unsigned char>(command)) ? Point(here_ + p) : p;
  }

  void add(const PathPiece& piece) {
    if (piece.length() > 0) pieces_.push_back(piece);
  }
  void line_to(const Point& to) {
    add(PathPiece::line(here_, to));
    here_ = to;
  }
  void cubic_to(const Point& b, const Point& c, const Point& d) {
    add(PathPiece::cubic(here_, b, c, d));
    here_ = d;
  }
  void quadratic_to(const Point& b, const Point& c) {
    cubic_to(here_ + 2.0 / 3 * (b - here_), c + 2.0 / 3 * (b - c), c);
  }

  std::string obey(char command, const Numbers& n) {
    const char kind = static_cast<char>(std::tolower(command));
    const Point before = here_, last_control = control_;
    const bool after_cubic = last_ == 'c' || last_ == 's', after_quadratic = last_ == 'q' || last_ == 't';
    switch (kind) {
      case 'm':
        if (started_ && !pieces_.empty()) return "a second sub-path";
        here_ = first_ = point(command, n[0], n[1]);
        started_ = true;
        break;
      case 'l': line_to(point(command, n[0], n[1])); break;
      case 'h': line_to(Point(point(command, n[0], 0).x(), before.y())); break;
      case 'v': line_to(Point(before.x(), point(command, 0, n[0]).y())); break;
      case 'c':
        control_ = point(command, n[2], n[3]);
        cubic_to(point(command, n[0], n[1]), control_, point(command, n[4], n[5]));
        break;
      case 's':
        control_ = point(command, n[0], n[1]);
        cubic_to(after_cubic ? Point(2 * before - last_control) : before, control_,
                 point(command, n[2], n[3]));
        break;
      case 'q':
        control_ = point(command, n[0], n[1]);
        quadratic_to(control_, point(command, n[2], n[3]));
        break;
      case 't':
        control_ = after_quadratic ? Point(2 * before - last_control) : before;
        quadratic_to(control_, point(command, n[0], n[1]));
        break;
      case 'a': arc_to(n, point(command, n[5], n[6])); break;
      default: line_to(first_); break;
    }
    last_ = kind;
    return {};
  }

  /// From end points to centre, SVG 1.1 appendix F.6.5.
  void arc_to(const Numbers& n, const Point& to) {
    double rx = unit_ * std::abs(n[0]), ry = unit_ * std::abs(n[1]);
    if (rx == 0 || ry == 0) return line_to(to);
    const Complex axis = std::polar(1.0, radians(n[2]));
    const Complex half = as_complex(here_ - to) / 2.0 * std::conj(axis);
    const double needed = std::hypot(half.real() / rx, half.imag() / ry);
    if (needed == 0) return;
    if (needed > 1) rx *= needed, ry *= needed;
    const double a = half.real() / rx, b = half.imag() / ry, square = a * a + b * b;
    const double away = std::sqrt(std::max(0.0, 1 / square - 1)) * (n[3] == n[4] ? -1 : 1);
    const Complex centre = away * Complex(b, -a);  // on the unit circle's scale
    const double start = std::arg(Complex(a, b) - centre), end = std::arg(Complex(-a, -b) - centre);
    double sweep = std::remainder(end - start, 2 * pi);
    if (n[4] == 1 && sweep < 0) sweep += 2 * pi;
    if (n[4] == 0 && sweep > 0) sweep -= 2 * pi;
    const Complex middle =
        as_complex(here_ + to) / 2.0 + axis * Complex(rx * centre.real(), ry * centre.imag());
    if (rx == ry) {
      add(PathPiece::arc(as_point(middle), rx, start + std::arg(axis), sweep));
      here_ = to;
      return;
    }
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / arc_step)));
    const double step = sweep / parts, reach = 4.0 / 3 * std::tan(step / 4);
    const auto place = [&](double angle, double forward) {
      const Complex on = std::polar(1.0, angle) * Complex(1, forward);
      return as_point(middle + axis * Complex(rx * on.real(), ry * on.imag()));
    };
    for (int i = 0; i < parts; ++i) {
      const double from = start + i * step, until = from + step;
      cubic_to(place(from, reach), place(until, -reach), i + 1 == parts ? to : place(until, 0));
    }
  }

  SvgScanner scan_;
  double unit_;
  bool started_ = false;
  char last_ = 0;
  Point here_ = Point::Zero(), first_ = Point::Zero(), control_ = Point::Zero();
  std::vector<PathPiece> pieces_;
};

}  // namespace

tl::expected<std::vector<PathPiece>, std::string> read_path_data(std::string_view data, double unit) {
  return PathReader(data, unit).read();
}

}  // namespace kempe
