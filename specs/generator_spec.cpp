#include "specs/generator_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/convex_hull.hpp"
#include "geometry/point.hpp"
#include "specs/file_kind.hpp"
#include "specs/key_checks.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/expression.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {
namespace {

/// Tables of a file read key by key; what was not asked for is unknown.
class Reader {
 public:
  Reader(const toml::table& file, Complaints& complaints) : file_(file), complaints_(complaints) {}

  /// Every table and key that may stand in the file, "table.key".
  void only(const std::vector<std::string_view>& known) {
    for (const auto& [table_name, node] : file_) {
      const toml::table* table = node.as_table();
      if (table == nullptr) {
        complaints_.add(line_of(node), std::string(table_name.str()), describe(node),
                        "tables: " + tables_in(known));
        continue;
      }
      for (const auto& [key, value] : *table) {
        const std::string dotted = fmt::format("{}.{}", table_name.str(), key.str());
        if (std::find(known.begin(), known.end(), dotted) == known.end())
          refuse_unknown(line_of(value), dotted, known);
      }
    }
  }

  const toml::node* find(std::string_view table, std::string_view key) const {
    const toml::table* inside = file_[table].as_table();
    return inside != nullptr ? inside->get(key) : nullptr;
  }

  bool has(std::string_view dotted) const { return find(dotted) != nullptr; }
  /// Where a key stands; it must be there.
  int line(std::string_view dotted) const { return line_of(*find(dotted)); }
  const toml::node* find(std::string_view dotted) const {
    const std::size_t dot = dotted.find('.');
    return find(dotted.substr(0, dot), dotted.substr(dot + 1));
  }

  /// A number within [lower, upper]; `value` keeps its own if the key is absent and not required.
  void number(std::string_view table, std::string_view key, double& value, double lower, double upper,
              bool required, const char* unit) {
    const std::string dotted = fmt::format("{}.{}", table, key);
    const std::string allowed = fmt::format("a number from {} to {}{}", lower, upper, unit);
    const toml::node* node = find(table, key);
    if (node == nullptr) {
      if (required) missing(dotted, allowed);
      return;
    }
    const auto found = finite_number(*node);
    if (!found || *found < lower || *found > upper)
      complaints_.add(line_of(*node), dotted, describe(*node), allowed);
    else
      value = *found;
  }

  void angle(std::string_view table, std::string_view key, double& value, double lower, double upper,
             bool required) {
    double in_degrees = degrees(value);
    number(table, key, in_degrees, lower, upper, required, " degrees");
    value = radians(in_degrees);
  }

  void angle(std::string_view table, std::string_view key, std::optional<double>& value) {
    if (find(table, key) == nullptr) return;
    double found = 0;
    angle(table, key, found, -360, 360, true);
    value = found;
  }

  /// A pair of rising numbers within [lower, upper].
  void pair(std::string_view table, std::string_view key, double& first, double& second, double lower,
            double upper) {
    const std::string dotted = fmt::format("{}.{}", table, key);
    const std::string allowed =
        fmt::format("[lower, upper], numbers from {} to {}, lower below upper", lower, upper);
    const toml::node* node = find(table, key);
    if (node == nullptr) return missing(dotted, allowed);
    const auto both = finite_point(*node);
    if (!both) return complaints_.add(line_of(*node), dotted, describe(*node), allowed);
    if (both->x() < lower || both->y() > upper || both->x() >= both->y())
      return complaints_.add(line_of(*node), dotted, fmt::format("[{}, {}]", both->x(), both->y()), allowed);
    first = both->x();
    second = both->y();
  }

  void word(std::string_view table, std::string_view key, std::string& value,
            const std::vector<std::string_view>& words) {
    const toml::node* node = find(table, key);
    if (node == nullptr) return;
    const auto text = node->value<std::string>();
    if (!text || std::find(words.begin(), words.end(), *text) == words.end())
      return complaints_.add(line_of(*node), fmt::format("{}.{}", table, key), describe(*node),
                             fmt::format("one of \"{}\"", fmt::join(words, "\", \"")));
    value = *text;
  }

 private:
  static std::string tables_in(const std::vector<std::string_view>& known) {
    std::string tables;
    std::string_view last;
    for (const std::string_view key : known) {
      const std::string_view table = key.substr(0, key.find('.'));
      if (table != last) tables += fmt::format("{}[{}]", tables.empty() ? "" : ", ", table);
      last = table;
    }
    return tables;
  }

  void refuse_unknown(int line, const std::string& dotted, const std::vector<std::string_view>& known) {
    if (const auto meant = nearest(dotted, known)) meant_.emplace_back(*meant);
    complaints_.add(line, dotted, "an unknown key", known_instead(dotted, known));
  }

  /// One mistake is told once: not what an unknown key means.
  void missing(const std::string& dotted, const std::string& allowed) {
    if (std::find(meant_.begin(), meant_.end(), dotted) == meant_.end())
      complaints_.add(0, dotted, "no such key", allowed);
  }

  const toml::table& file_;
  Complaints& complaints_;
  std::vector<std::string> meant_;  ///< by keys that are unknown
};

/// mm and rad: poses nearer to each other are one.
constexpr double same_pose = 1e-6;
/// mm: places must lie farther apart.
constexpr double least_spread = 1e-3;
constexpr double farthest_x = 1e9;

/// Numbers far from zero that hardly differ leave no room for places between them.
void check_width(int line, std::string_view key, double lower, double upper, Complaints& complaints) {
  constexpr double least_share = 1e-10, least_width = 1e-30;
  const double least = std::max(least_width, least_share * std::max(std::abs(lower), std::abs(upper)));
  if (upper - lower < least)
    complaints.add(line, std::string(key), fmt::format("x from {} to {}", lower, upper),
                   fmt::format("an upper x at least {:.2g} above the lower", least));
}

void read_table(const Reader& reader, FunctionSpec& spec, Complaints& complaints) {
  constexpr std::size_t least_rows = 4, most_rows = 10000;
  constexpr double farthest_y = 1e290, nearest_rows = 1e-9;
  const toml::node* node = reader.find("function", "table");
  const auto refuse = [&](int line, const std::string& found) {
    complaints.add(line, "function.table", found,
                   fmt::format("[[x, y], ...] with {} to {} rows, x rising from {} to {}, y from {} to {}",
                               least_rows, most_rows, -farthest_x, farthest_x, -farthest_y, farthest_y));
  };
  const toml::array* rows = node->as_array();
  if (rows == nullptr) return refuse(line_of(*node), describe(*node));
  if (rows->size() < least_rows || rows->size() > most_rows)
    return refuse(line_of(*node), fmt::format("{} rows", rows->size()));
  for (const toml::node& row : *rows) {
    const auto pair = finite_point(row);
    if (!pair) return refuse(line_of(row), describe(row));
    if (std::abs(pair->x()) > farthest_x || std::abs(pair->y()) > farthest_y)
      return refuse(line_of(row), fmt::format("[{}, {}]", pair->x(), pair->y()));
    if (!spec.table.empty() && pair->x() <= spec.table.back().first)
      return refuse(line_of(row), fmt::format("x = {} after {}", pair->x(), spec.table.back().first));
    spec.table.emplace_back(pair->x(), pair->y());
  }
  spec.x_lower = spec.table.front().first;
  spec.x_upper = spec.table.back().first;
  check_width(line_of(*node), "function.table", spec.x_lower, spec.x_upper, complaints);
  for (std::size_t i = 1; i < spec.table.size(); ++i) {
    const double before = spec.table[i - 1].first, after = spec.table[i].first;
    if (after - before < nearest_rows * (spec.x_upper - spec.x_lower))
      return complaints.add(line_of(*node), "function.table", fmt::format("x = {} after {}", after, before),
                            fmt::format("rows at least {} of the whole range of x apart", nearest_rows));
  }
}

void read_wanted(Reader& reader, FunctionSpec& spec, Complaints& complaints) {
  const toml::node* expression = reader.find("function", "expression");
  const toml::node* table = reader.find("function", "table");
  if ((expression != nullptr) == (table != nullptr))
    return complaints.add(expression ? line_of(*expression) : 0, "function",
                          expression ? "both expression and table" : "neither expression nor table",
                          "exactly one of them");
  if (table != nullptr) return read_table(reader, spec, complaints);
  spec.expression = expression->value_or(std::string());
  constexpr std::size_t longest_expression = 1000;
  if (spec.expression.empty() || spec.expression.size() > longest_expression) {
    complaints.add(line_of(*expression), "function.expression", describe(*expression),
                   fmt::format("an expression of x, as text of at most {} characters", longest_expression));
  } else if (const auto compiled = compile_expression(spec.expression); !compiled) {
    complaints.add(line_of(*expression), "function.expression", compiled.error(),
                   "an expression of x such as log10(x)");
  }
  reader.pair("function", "x", spec.x_lower, spec.x_upper, -farthest_x, farthest_x);
  if (complaints.none_about("function.x"))
    check_width(reader.line("function.x"), "function.x", spec.x_lower, spec.x_upper, complaints);
}

constexpr double farthest_path_mm = 1e6;

/// A list of `least` to `most` places; empty, and told, where it is not.
std::vector<Point> read_path_places(const Reader& reader, std::string_view dotted, std::size_t least,
                                    std::size_t most, Complaints& complaints) {
  const toml::node* node = reader.find(dotted);
  const std::string allowed = fmt::format("[[x, y], ...] with {} to {} places, numbers from {} to {} mm",
                                          least, most, -farthest_path_mm, farthest_path_mm);
  const auto refuse = [&](const toml::node& what) {
    complaints.add(line_of(what), std::string(dotted), describe(what), allowed);
    return std::vector<Point>();
  };
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() < least || list->size() > most) return refuse(*node);
  std::vector<Point> places;
  for (const toml::node& one : *list) {
    const auto place = finite_point(one);
    if (!place || place->cwiseAbs().maxCoeff() > farthest_path_mm) return refuse(one);
    places.push_back(*place);
  }
  return places;
}

void read_timing(const Reader& reader, PathSpec& spec, Complaints& complaints) {
  const toml::node* node = reader.find("path", "driver_deg");
  if (node == nullptr) return;
  const std::string allowed = fmt::format(
      "a number for each of the {} points, rising or falling, the last less than 360 degrees from the first",
      spec.points.size());
  const auto refuse = [&](const toml::node& what) {
    spec.turns.clear();
    complaints.add(line_of(what), "path.driver_deg", describe(what), allowed);
  };
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() != spec.points.size()) return refuse(*node);
  std::optional<double> first;
  for (const toml::node& one : *list) {
    const auto angle = finite_number(one);
    if (!angle) return refuse(one);
    if (!first) first = angle;
    const double turn = radians(*angle - *first);
    const bool turns_back = spec.turns.size() > 1 && (turn > spec.turns.back()) != (spec.turns[1] > 0);
    if (!(std::abs(turn) < 2 * pi) || (!spec.turns.empty() && turn == spec.turns.back()) || turns_back)
      return refuse(one);
    spec.turns.push_back(turn);
  }
}

void read_poses(const Reader& reader, PathSpec& spec, Complaints& complaints) {
  const toml::node* node = reader.find("path", "poses_mm");
  const std::string allowed =
      fmt::format("[[x, y, degrees], ...] with 3 to 5 different poses, numbers from {} to {}",
                  -farthest_path_mm, farthest_path_mm);
  const auto refuse = [&](const toml::node& what) {
    spec.poses.clear();
    complaints.add(line_of(what), "path.poses_mm", describe(what), allowed);
  };
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() < 3 || list->size() > 5) return refuse(*node);
  for (const toml::node& one : *list) {
    const toml::array* pose = one.as_array();
    if (pose == nullptr || pose->size() != 3) return refuse(one);
    double figures[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto figure = finite_number((*pose)[k]);
      if (!figure || std::abs(*figure) > farthest_path_mm) return refuse(one);
      figures[k] = *figure;
    }
    const BodyPlacement placement{{figures[0], figures[1]}, radians(figures[2])};
    for (const BodyPlacement& other : spec.poses)
      if ((other.at - placement.at).norm() < same_pose &&
          std::abs(std::remainder(other.angle - placement.angle, 2 * pi)) < same_pose)
        return refuse(one);
    spec.poses.push_back(placement);
  }
  for (const std::string_view key : {"path.driver_deg", "path.minimize", "limits.crank_pivot_mm",
                                     "limits.ground_deg", "limits.first_angle_deg"})
    if (reader.has(key))
      complaints.add(reader.line(key), std::string(key), "a key beside poses_mm",
                     "points_mm with it: poses are taken exactly, their timing is free");
}

void read_motion(Reader& reader, PathSpec& spec) {
  constexpr std::string_view turns_fully = "crank turns fully";
  constexpr std::array motions{CrankMotion::crank_rocker, CrankMotion::double_crank,
                               CrankMotion::rocker_crank, CrankMotion::double_rocker};
  std::vector<std::string_view> words{turns_fully};
  for (const CrankMotion motion : motions) words.push_back(name(motion));
  std::string word;
  reader.word("limits", "motion", word, words);
  if (word == turns_fully) spec.motions = {CrankMotion::crank_rocker, CrankMotion::double_crank};
  for (const CrankMotion motion : motions)
    if (word == name(motion)) spec.motions = {motion};
}

/// The largest distance of a place from the first, mm; told where it is zero.
double read_size(const Reader& reader, std::string_view key, const std::vector<Point>& places,
                 Complaints& complaints) {
  double size = 0;
  for (const Point& p : places) size = std::max(size, (p - places.front()).norm());
  if (!places.empty() && size < least_spread)
    complaints.add(reader.line(key), std::string(key), fmt::format("places {} mm apart", size),
                   "places at least 0.001 mm apart");
  return size;
}

/// What the file gives of the crank's pivot, the ground link's direction and the crank's first angle.
void read_given(Reader& reader, PathSpec& spec, Complaints& complaints) {
  reader.angle("limits", "ground_deg", spec.ground_angle);
  reader.angle("limits", "first_angle_deg", spec.first_angle);
  const toml::node* node = reader.find("limits", "crank_pivot_mm");
  if (node == nullptr) return;
  const auto place = finite_point(*node);
  if (!place || place->cwiseAbs().maxCoeff() > farthest_path_mm)
    return complaints.add(
        line_of(*node), "limits.crank_pivot_mm", describe(*node),
        fmt::format("[x, y], numbers from {} to {} mm", -farthest_path_mm, farthest_path_mm));
  if (!lies_within(spec.pivots_within, *place))
    return complaints.add(line_of(*node), "limits.crank_pivot_mm", describe(*node),
                          "a place within limits.pivots_within_mm");
  spec.crank_pivot = *place;
}

/// The polygon counter-clockwise; nothing where it is not convex.
std::optional<std::vector<Point>> convex(std::vector<Point> corners) {
  const auto left_of_all = [&] {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point from = corners[k], along = corners[(k + 1) % corners.size()] - from;
      for (const Point& corner : corners)
        if (cross(along, corner - from) < 0) return false;
      if (!(along.norm() > 0)) return false;
    }
    return true;
  };
  double area = 0;
  for (std::size_t k = 0; k < corners.size(); ++k)
    area += cross(corners[k] - corners[0], corners[(k + 1) % corners.size()] - corners[0]);
  if (area < 0) std::reverse(corners.begin(), corners.end());
  if (area == 0 || !left_of_all()) return std::nullopt;
  return corners;
}

}  // namespace

tl::expected<FunctionSpec, InputError> read_function_spec(std::string_view text, const std::string& file) {
  const auto parsed = parse_toml(text, file);
  if (!parsed) return tl::unexpected(or_other_kind(parsed.error(), text, FileKind::function));
  Complaints complaints(file);
  Reader reader(*parsed, complaints);
  FunctionSpec spec;
  reader.only({"function.expression", "function.table", "function.x", "function.method", "function.points",
               "input.range_deg", "input.start_deg", "output.range_deg", "output.start_deg",
               "links.ground_mm", "links.longest_ratio", "limits.transmission_deg"});
  read_wanted(reader, spec, complaints);
  reader.word("function", "method", spec.method, {"precision_points", "least_squares", "minimax"});
  double points = 3;
  reader.number("function", "points", points, 3, 5, false, "");
  spec.points = static_cast<int>(points);
  if (points != spec.points)
    complaints.add(reader.line("function.points"), "function.points", fmt::format("{}", points), "3, 4 or 5");
  reader.angle("input", "range_deg", spec.input_range, -360, 360, true);
  reader.angle("output", "range_deg", spec.output_range, -360, 360, true);
  reader.angle("input", "start_deg", spec.input_start);
  reader.angle("output", "start_deg", spec.output_start);
  reader.number("links", "ground_mm", spec.ground, 1e-3, 1e6, false, " mm");
  reader.number("links", "longest_ratio", spec.longest_ratio, 1, 1e4, false, "");
  reader.angle("limits", "transmission_deg", spec.transmission, 0, 89, false);
  constexpr double least_range_deg = 1e-6;  // far above the rounding of angles
  for (const auto& [key, range] :
       {std::pair("input.range_deg", spec.input_range), std::pair("output.range_deg", spec.output_range)})
    if (complaints.none_about(key) && !(std::abs(range) >= radians(least_range_deg)) && reader.has(key))
      complaints.add(reader.line(key), key, fmt::format("{:.6g}", degrees(range)),
                     fmt::format("a range of at least {:g} degrees, either way", least_range_deg));
  const int given = (spec.input_start ? 1 : 0) + (spec.output_start ? 1 : 0);
  if (complaints.none_about("function") && spec.method == "precision_points" && spec.points == 5 && given > 0)
    complaints.add(0, "function.points", "5 with a start given", "no start_deg: five points decide both");
  if (complaints.none_about("function") && spec.method == "precision_points" && spec.points == 4 &&
      given == 2)
    complaints.add(0, "function.points", "4 with both starts given",
                   "at most one start_deg: four points decide the other");
  if (!complaints.none()) return tl::unexpected(or_other_kind(complaints.all(), text, FileKind::function));
  return spec;
}

tl::expected<InversorSpec, InputError> read_inversor_spec(std::string_view text, const std::string& file) {
  const auto parsed = parse_toml(text, file);
  if (!parsed) return tl::unexpected(or_other_kind(parsed.error(), text, FileKind::inversor));
  Complaints complaints(file);
  Reader reader(*parsed, complaints);
  InversorSpec spec;
  reader.only({"lens.focal_length_mm", "lens.magnification", "limits.transmission_deg", "links.shortest_mm",
               "links.longest_mm"});
  reader.number("lens", "focal_length_mm", spec.focal_length, 1e-3, 1e6, true, " mm");
  reader.pair("lens", "magnification", spec.magnification_lower, spec.magnification_upper, 1e-3, 1e3);
  spec.transmission = radians(10);
  reader.angle("limits", "transmission_deg", spec.transmission, 0, 89, false);
  reader.number("links", "shortest_mm", spec.shortest, 0, 1e6, false, " mm");
  spec.longest = 1e6;
  reader.number("links", "longest_mm", spec.longest, 0, 1e6, false, " mm");
  if (!complaints.none()) return tl::unexpected(or_other_kind(complaints.all(), text, FileKind::inversor));
  return spec;
}

tl::expected<PathSpec, InputError> read_path_spec(std::string_view text, const std::string& file) {
  const auto parsed = parse_toml(text, file);
  if (!parsed) return tl::unexpected(or_other_kind(parsed.error(), text, FileKind::path));
  Complaints complaints(file);
  Reader reader(*parsed, complaints);
  PathSpec spec;
  reader.only({"path.points_mm", "path.poses_mm", "path.driver_deg", "path.minimize", "limits.longest_mm",
               "limits.transmission_deg", "limits.pivots_within_mm", "limits.motion", "limits.crank_pivot_mm",
               "limits.ground_deg", "limits.first_angle_deg"});
  constexpr std::size_t most_points = 60, most_corners = 50;
  double size = 0;
  const bool points = reader.has("path.points_mm"), poses = reader.has("path.poses_mm");
  if (points == poses) {
    complaints.add(points ? reader.line("path.poses_mm") : 0, "path.points_mm",
                   points ? "both points_mm and poses_mm" : "no such key",
                   "either points_mm = [[x, y], ...] or poses_mm = [[x, y, degrees], ...], in order");
  } else if (points) {
    spec.points = read_path_places(reader, "path.points_mm", 3, most_points, complaints);
    size = read_size(reader, "path.points_mm", spec.points, complaints);
  } else {
    read_poses(reader, spec, complaints);
    std::vector<Point> places;
    for (const BodyPlacement& pose : spec.poses) places.push_back(pose.at);
    size = read_size(reader, "path.poses_mm", places, complaints);
  }
  if (!spec.points.empty()) read_timing(reader, spec, complaints);
  std::string aim = "mean_square";
  reader.word("path", "minimize", aim, {"mean_square", "largest_distance"});
  spec.largest_distance = aim == "largest_distance";
  spec.longest = 10 * size;
  reader.number("limits", "longest_mm", spec.longest, 1e-3, farthest_path_mm, false, " mm");
  reader.angle("limits", "transmission_deg", spec.transmission, 0, 89, false);
  read_motion(reader, spec);
  if (reader.has("limits.pivots_within_mm")) {
    const auto corners = read_path_places(reader, "limits.pivots_within_mm", 3, most_corners, complaints);
    const auto polygon = corners.empty() ? std::optional(corners) : convex(corners);
    if (polygon)
      spec.pivots_within = *polygon;
    else
      complaints.add(reader.line("limits.pivots_within_mm"), "limits.pivots_within_mm",
                     "a polygon that is not convex", "the corners of a convex polygon, in order");
  }
  read_given(reader, spec, complaints);
  if (!complaints.none()) return tl::unexpected(or_other_kind(complaints.all(), text, FileKind::path));
  return spec;
}

}  // namespace kempe
