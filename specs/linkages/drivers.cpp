#include "specs/linkages/drivers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "specs/linkages/path_data.hpp"

namespace kempe {
namespace {

constexpr std::array<std::string_view, 5> driver_kinds{"coordinate", "angle", "distance", "slide", "path"};
constexpr double most_turns = 100;

class DriverReader {
 public:
  DriverReader(const LinkageTable& table, LinkageNames& names, LinkageFile& file)
      : table_(table), names_(names), file_(file) {}

  void read() {
    std::vector<std::string_view> given;
    for (const std::string_view kind : driver_kinds)
      if (table_.has(kind)) given.push_back(kind);
    if (given.size() != 1) {
      const std::string found = given.empty() ? "nothing" : fmt::format("both {} and {}", given[0], given[1]);
      return table_.refuse(given.empty() ? "coordinate" : given[1], found,
                           fmt::format("one of {}", fmt::join(driver_kinds, ", ")));
    }
    FileDriver driver;
    driver.line = table_.line();
    if (!read_kind(given[0], driver)) return;
    file_.drivers.push_back(std::move(driver));
  }

 private:
  double unit() const { return file_.unit.in_mm; }

  bool read_kind(std::string_view kind, FileDriver& driver) {
    forbid_foreign_keys(kind);
    if (kind == "path") return read_path(driver);
    if (kind == "angle")
      return read_angle(driver) && read_range(driver, "from_deg", "to_deg", "rate_deg", radians(1));
    const bool named = kind == "coordinate" ? read_coordinate(driver)
                       : kind == "distance" ? read_distance(driver)
                                            : read_slide(driver);
    return named && read_range(driver, "from", "to", "rate", unit()) &&
           (kind != "distance" || is_positive(driver));
  }

  /// Keys of one kind of driver that stand beside another.
  void forbid_foreign_keys(std::string_view kind) {
    const auto forbid = [&](std::string_view key, std::string_view owner) {
      if (table_.has(key))
        table_.refuse(key, fmt::format("a key of `{}` beside `{}`", owner, kind), "no such key here");
    };
    if (kind != "angle")
      for (const auto* key : {"relative_to", "from_deg", "to_deg", "rate_deg"}) forbid(key, "angle");
    if (kind != "path")
      for (const auto* key : {"polyline", "circle", "svg"}) forbid(key, "path");
    if (kind == "angle" || kind == "path")
      for (const auto* key : {"from", "to"}) forbid(key, "coordinate");
    if (kind == "angle") forbid("rate", "coordinate");
  }

  bool read_coordinate(FileDriver& driver) {
    const auto text = table_.text("coordinate");
    if (!text) return false;
    const bool good = text->size() > 2 && (text->ends_with(".x") || text->ends_with(".y"));
    if (!good) {
      table_.refuse("coordinate", fmt::format("text \"{}\"", *text));
      return false;
    }
    const std::string point = text->substr(0, text->size() - 2);
    if (!is_movable(point, "coordinate")) return false;
    driver.what = DrivenCoordinate{point, text->ends_with(".x") ? 0 : 1};
    return true;
  }

  bool is_movable(const std::string& point, std::string_view key) {
    if (!names_.require_point({point, table_.line(key)}, table_.dotted(key))) return false;
    if (!names_.local_place(point, "ground")) return true;
    table_.refuse(key, fmt::format("{}, a point of the ground", point), "a point that can move");
    return false;
  }

  bool read_angle(FileDriver& driver) {
    const auto link = names_.link(table_, "angle");
    const auto reference =
        table_.has("relative_to") ? names_.link(table_, "relative_to") : std::optional<std::string>("ground");
    if (!link || !reference) return false;
    if (*link == *reference || *link == "ground") {
      table_.refuse("angle", fmt::format("{} against {}", *link, *reference),
                    "a link against another or the ground");
      return false;
    }
    driver.what = DrivenAngle{*link, *reference};
    return true;
  }

  bool read_distance(FileDriver& driver) {
    const std::vector<std::string> ends = names_.points(table_, "distance");
    if (ends.size() != 2 || ends[0] == ends[1] || names_.share_a_link(ends[0], ends[1])) {
      if (table_.complaints().none_about(table_.dotted("distance")))
        table_.refuse("distance", fmt::format("[{}]", fmt::join(ends, ", ")),
                      "two points of different links");
      return false;
    }
    driver.what = DrivenDistance{ends[0], ends[1]};
    return true;
  }

  bool read_slide(FileDriver& driver) {
    const auto name = table_.text("slide");
    if (!name) return false;
    const auto found = std::find_if(file_.sliders.begin(), file_.sliders.end(),
                                    [&](const FileSlider& slider) { return slider.name() == *name; });
    if (found == file_.sliders.end()) {
      table_.refuse("slide", fmt::format("{}, which no slider carries", *name));
      return false;
    }
    driver.what = DrivenSlide{static_cast<std::size_t>(found - file_.sliders.begin())};
    return true;
  }

  bool read_range(FileDriver& driver, std::string_view from, std::string_view to, std::string_view rate,
                  double by) {
    const auto first = table_.number(from), last = table_.number(to), speed = table_.number(rate);
    if (!table_.has(from)) table_.missing(from);
    if (!first || (table_.has(to) && !last)) return false;
    DriverRange range{*first * by, last.value_or(*first) * by, {}};
    if (speed) range.rate = *speed * by;
    driver.motion = range;
    return true;
  }

  bool is_positive(const FileDriver& driver) {
    const auto& range = std::get<DriverRange>(driver.motion);
    if (range.from > 0 && range.to > 0) return true;
    table_.refuse(range.from > 0 ? "to" : "from", "a distance that is not positive", "a distance > 0");
    return false;
  }

  bool read_path(FileDriver& driver) {
    const auto point = names_.point(table_, "path");
    if (!point || !is_movable(*point, "path")) return false;
    const int given = table_.has("polyline") + table_.has("circle") + table_.has("svg");
    if (given != 1) {
      table_.refuse(given == 0 ? "polyline" : "path", given == 0 ? "nothing" : "several paths",
                    "one of polyline, circle, svg");
      return false;
    }
    std::vector<PathPiece> pieces = table_.has("polyline") ? read_polyline()
                                    : table_.has("circle") ? read_circle()
                                                           : read_svg();
    if (pieces.empty()) return false;
    DriverPath path(std::move(pieces));
    if (const auto rate = table_.number("rate")) path.speed = *rate * unit();
    driver.what = DrivenPoint{*point};
    driver.motion = std::move(path);
    return true;
  }

  std::vector<PathPiece> read_polyline() {
    const std::vector<Point> corners = table_.points("polyline");
    std::vector<PathPiece> pieces;
    for (std::size_t i = 1; i < corners.size(); ++i)
      if (corners[i] != corners[i - 1])
        pieces.push_back(PathPiece::line(corners[i - 1] * unit(), corners[i] * unit()));
    if (pieces.empty()) table_.refuse("polyline", corners.empty() ? "no places" : "a path of no length");
    return pieces;
  }

  std::vector<PathPiece> read_circle() {
    const toml::table* inner = table_.inner("circle");
    if (!inner) return {};
    const LinkageTable circle(*inner, "drivers.circle", table_.dotted("circle"), table_.complaints());
    const auto centre = circle.point("centre");
    const auto radius = circle.positive("radius");
    for (const auto* key : {"centre", "radius"})
      if (!circle.has(key)) circle.missing(key);
    const double start = circle.number("from_deg").value_or(0),
                 sweep = circle.number("sweep_deg").value_or(360);
    if (sweep == 0 || std::abs(sweep) > 360 * most_turns) {
      circle.refuse("sweep_deg", fmt::format("{:g}", sweep));
      return {};
    }
    if (!centre || !radius) return {};
    return {PathPiece::arc(*centre * unit(), *radius * unit(), radians(start), radians(sweep))};
  }

  std::vector<PathPiece> read_svg() {
    const auto data = table_.text("svg");
    if (!data) return {};
    auto pieces = read_path_data(*data, unit());
    if (pieces) return std::move(*pieces);
    table_.refuse("svg", pieces.error());
    return {};
  }

  const LinkageTable& table_;
  LinkageNames& names_;
  LinkageFile& file_;
};

}  // namespace

void read_driver(const LinkageTable& table, LinkageNames& names, LinkageFile& file) {
  DriverReader(table, names, file).read();
}

}  // namespace kempe
