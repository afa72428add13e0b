#include "specs/linkages/linkage_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "specs/file_kind.hpp"
#include "specs/linkages/drivers.hpp"
#include "specs/linkages/loads_reader.hpp"
#include "specs/linkages/names.hpp"
#include "specs/linkages/reader.hpp"
#include "specs/linkages/rigid_link.hpp"
#include "specs/linkages/straight_bars.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

constexpr std::size_t most_links = 200, most_conditions = 1000;
constexpr std::size_t most_places = 10000000;  ///< of links over a whole motion: about a gigabyte and a half

LengthUnit unit_named(const std::string& name) {
  static constexpr std::pair<const char*, double> known[] = {
      {"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}};
  for (const auto& [text, mm] : known)
    if (name == text) return {name, mm};
  return {};
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

class LinkageReader {
 public:
  LinkageReader(const toml::table& root, const std::string& file)
      : complaints_(file), root_(root, "", "", complaints_), names_(complaints_, result_) {
    result_.file = file;
    result_.name = std::filesystem::path(file).stem().string();
  }

  tl::expected<LinkageFile, InputError> read() {
    read_head();
    read_ground();
    each_in_table("links", [&](const NameAt& name, const toml::table& table) { read_link(name, table); });
    read_bars();
    for (const NameAt& name : root_.names("points"))
      if (names_.define_point(name, "points")) result_.free_points.push_back(name.name);
    each_in_list("sliders", [&](const LinkageTable& table) { read_slider(table); });
    each_in_list("angles", [&](const LinkageTable& table) { read_angle(table); });
    each_in_list("gears", [&](const LinkageTable& table) { read_gears(table); });
    each_in_list("racks", [&](const LinkageTable& table) { read_rack(table); });
    each_in_list("drivers", [&](const LinkageTable& table) { read_driver(table, names_, result_); });
    read_loads();
    read_motion();
    read_guess();
    read_bounds();
    read_output();
    if (complaints_.none()) check_extent();
    if (!complaints_.none()) return tl::unexpected(complaints_.all());
    return std::move(result_);
  }

 private:
  double length(double value) const { return value * result_.unit.in_mm; }
  Point place(const Point& value) const { return value * result_.unit.in_mm; }

  /// What is there must be something, and no more than can be solved in some seconds and kept in memory.
  void check_extent() {
    const std::size_t bodies = result_.links.size() + result_.free_points.size();
    if (bodies == 0) complaints_.add(0, "links", "nothing", "at least one link");
    if (bodies > most_links)
      complaints_.add(0, "links", fmt::format("{} links and points without a link", bodies),
                      fmt::format("at most {}", most_links));
    const std::size_t conditions = result_.bars.size() + result_.sliders.size() + result_.angles.size() +
                                   result_.gears.size() + result_.racks.size() + result_.drivers.size();
    if (conditions > most_conditions)
      complaints_.add(0, "links",
                      fmt::format("{} bars, sliders, angles, gears, racks and drivers", conditions),
                      fmt::format("at most {}", most_conditions));
    if (const std::size_t loads = result_.loads.count(); loads > most_conditions)
      complaints_.add(0, "links", fmt::format("{} forces, moments and masses", loads),
                      fmt::format("at most {}", most_conditions));
    if (complaints_.none() && result_.steps > result_.most_steps())
      complaints_.add(0, "motion.steps", fmt::format("{}", result_.steps),
                      fmt::format("at most {} with {} links", result_.most_steps(), bodies));
  }

  template <class Visit>
  void each_in_table(std::string_view key, const Visit& visit) {
    const toml::table* table = root_.inner(key);
    if (!table) return;
    const LinkageTable sorted(*table, "", "", scratch_);
    for (const NameAt& name : sorted.keys()) {
      const toml::node& node = *table->get(name.name);
      if (const toml::table* inner = node.as_table())
        visit(name, *inner);
      else
        complaints_.add(name.line, fmt::format("{}.{}", key, name.name), describe(node), "a table");
    }
  }

  template <class Visit>
  void each_in_list(const std::string& key, const Visit& visit) {
    if (!root_.has(key)) return;
    const toml::array* list = root_.list(key);
    if (!list) return;
    int number = 0;
    for (const toml::node& element : *list) {
      ++number;
      if (const toml::table* table = element.as_table())
        visit(LinkageTable(*table, key, fmt::format("{}[{}]", key, number), complaints_));
      else
        root_.refuse(key, describe(element));
    }
  }

  void read_head() {
    if (const auto name = root_.text("name")) result_.name = *name;
    if (const auto unit = root_.one_of("unit", {"mm", "cm", "m", "in"})) result_.unit = unit_named(*unit);
  }

  void read_ground() {
    const toml::table* table = root_.inner("ground");
    if (!table) return;
    const LinkageTable ground(*table, "ground", "ground", complaints_);
    for (const NameAt& name : ground.keys()) {
      const auto at = ground.point(name.name);
      if (names_.define_point(name, "ground") && at) result_.ground.emplace_back(name.name, place(*at));
    }
  }

  void read_link(const NameAt& name, const toml::table& inner) {
    const LinkageTable table(inner, "links.*", "links." + name.name, complaints_);
    if (!names_.define_link(name)) return;
    FileLink link{name.name, {}};
    if (table.has("at")) {
      read_local_places(table, link);
    } else if (const std::vector<NameAt> joints = table.names("joints"); joints.empty()) {
      if (!table.has("joints"))
        table.refuse("joints", "nothing", "joints = [\"A\", \"B\"], or at = {A = [0, 0], ...}");
    } else if (has_repeats(table, joints)) {
      // complained about
    } else if (table.has("along")) {
      read_straight(table, joints, link);
    } else {
      read_measures(table, joints, link);
    }
    if (link.joints.empty())  // wrong, and complained about: its points exist all the same
      for (const NameAt& joint : table.names("joints"))
        link.joints.emplace_back(joint.name, Point(static_cast<double>(link.joints.size()), 0));
    names_.define_joints(link, name.line);
    result_.links.push_back(std::move(link));
  }

  bool has_repeats(const LinkageTable& table, const std::vector<NameAt>& joints) {
    std::set<std::string> seen;
    for (const NameAt& joint : joints)
      if (!seen.insert(joint.name).second) {
        table.refuse("joints", fmt::format("{} twice", joint.name));
        return true;
      }
    if (joints.size() < 2) table.refuse("joints", fmt::format("only {}", joints[0].name));
    return joints.size() < 2;
  }

  void read_local_places(const LinkageTable& table, FileLink& link) {
    const toml::table* at = table.inner("at");
    if (!at) return;
    const LinkageTable places(*at, "ground", table.dotted("at"), complaints_);  // "ground" has the same rule
    for (const NameAt& joint : places.keys()) {
      const auto where = places.point(joint.name);
      if (!where) continue;
      for (const auto& [other, there] : link.joints)
        if (there == place(*where))
          table.refuse("at", fmt::format("{} and {} at one place", other, joint.name), "joints apart");
      link.joints.emplace_back(joint.name, place(*where));
    }
    if (link.joints.empty()) table.refuse("at", "no points");
    for (const NameAt& key : table.keys())
      if (key.name != "at") table.refuse(key.name, "a key beside `at`", "`at` alone: it gives all places");
  }

  void read_straight(const LinkageTable& table, const std::vector<NameAt>& joints, FileLink& link) {
    const std::vector<double> along = table.numbers("along");
    if (along.empty()) return;
    bool rising = along.size() == joints.size() && along[0] == 0;
    for (std::size_t i = 1; i < along.size(); ++i) rising = rising && along[i] > along[i - 1];
    if (!rising)
      return table.refuse("along", fmt::format("[{:g}]", fmt::join(along, ", ")),
                          "as many rising numbers as joints, the first 0");
    for (std::size_t i = 0; i < joints.size(); ++i)
      link.joints.emplace_back(joints[i].name, Point(length(along[i]), 0));
  }

  void read_measures(const LinkageTable& table, const std::vector<NameAt>& joints, FileLink& link) {
    RigidLinkTask task;
    for (const NameAt& joint : joints) task.joints.push_back(joint.name);
    if (const auto side = table.one_of("side", {"left", "right"}))
      task.side = *side == "left" ? Side::left : Side::right;
    bool good = true;
    for (const NameAt& key : table.keys())
      if (key.name.find('-') != std::string::npos) good = read_measure(table, key.name, task) && good;
    if (!good) return;
    auto places = place_joints(task);
    if (!places)
      return complaints_.add(table.line(), table.dotted("joints"), places.error().found,
                             places.error().allowed);
    for (std::size_t i = 0; i < joints.size(); ++i) link.joints.emplace_back(joints[i].name, (*places)[i]);
  }

  /// "A-B = 3" or "A-B-C_deg = 90".
  bool read_measure(const LinkageTable& table, const std::string& key, RigidLinkTask& task) {
    const bool is_angle = key.ends_with("_deg");
    const std::vector<std::string> parts = split(is_angle ? key.substr(0, key.size() - 4) : key, '-');
    std::vector<std::size_t> numbers;
    for (const std::string& part : parts) {
      const auto found = std::find(task.joints.begin(), task.joints.end(), part);
      if (found == task.joints.end()) {
        table.refuse(key,
                     fmt::format("{}, which is no joint of this link", part.empty() ? "an empty name" : part),
                     fmt::format("{}", fmt::join(task.joints, ", ")));
        return false;
      }
      numbers.push_back(static_cast<std::size_t>(found - task.joints.begin()));
    }
    const std::set<std::size_t> different(numbers.begin(), numbers.end());
    if (parts.size() != (is_angle ? 3u : 2u) || different.size() != parts.size()) {
      table.refuse(key, "the key " + key, "A-B for a length, A-B-C_deg for an angle at B");
      return false;
    }
    const auto value = is_angle ? table.number(key) : table.positive(key);
    if (!value) return false;
    if (is_angle)
      task.angles.push_back({numbers[0], numbers[1], numbers[2], radians(*value)});
    else
      task.lengths.push_back({numbers[0], numbers[1], length(*value)});
    return true;
  }

  void read_bars() {
    const toml::table* inner = root_.inner("bars");
    if (!inner) return;
    const LinkageTable table(*inner, "bars", "bars", complaints_);
    std::vector<FileBar> bars;
    for (const NameAt& key : table.keys()) {
      const std::vector<std::string> ends = split(key.name, '-');
      const auto value = table.positive(key.name);
      if (ends.size() != 2 || ends[0] == ends[1]) {
        table.refuse(key.name, "the key " + key.name, "a key of two different points such as A-B");
        continue;
      }
      for (const std::string& end : ends) names_.check_name({end, key.line}, table.dotted(key.name));
      if (value) bars.push_back({ends[0], ends[1], length(*value)});
    }
    take_bars(join_straight_bars(bars, result_.unit), inner->empty() ? 0 : line_of(*inner));
  }

  void take_bars(StraightBars bars, int line) {
    for (FileLink& link : bars.links) {
      names_.add_link(link.name);
      names_.define_joints(link, line);
      result_.links.push_back(std::move(link));
    }
    for (FileBar& bar : bars.remaining) {
      for (const std::string& end : {bar.a, bar.b})
        if (!names_.is_point(end) && names_.define_point({end, line}, "bars"))
          result_.free_points.push_back(end);
      if (names_.share_a_link(bar.a, bar.b))
        complaints_.add(line, fmt::format("bars.{}-{}", bar.a, bar.b), "a bar between two points of one link",
                        "points of different links");
      result_.bars.push_back(std::move(bar));
    }
    result_.notes.insert(result_.notes.end(), bars.notes.begin(), bars.notes.end());
  }

  FileLine read_line(const LinkageTable& table) {
    FileLine line;
    line.link = names_.link(table, "on").value_or("ground");
    line.through = names_.place_on(table, "through", line.link).value_or(Point::Zero());
    if (table.has("towards")) {
      const Point towards = names_.place_on(table, "towards", line.link).value_or(line.through + Point(1, 0));
      if (towards == line.through) table.refuse("towards", "the same place as `through`");
      line.direction = std::arg(as_complex(towards - line.through));
      if (table.has("direction_deg"))
        table.refuse("direction_deg", "both direction_deg and towards", "one of them");
    } else if (const auto direction = table.number("direction_deg")) {
      line.direction = radians(*direction);
    } else if (!table.has("direction_deg")) {
      table.missing("direction_deg");
    }
    return line;
  }

  void read_slider(const LinkageTable& table) {
    FileSlider slider;
    if (table.has("point") == table.has("link"))
      return table.refuse(table.has("point") ? "link" : "point",
                          table.has("point") ? "both point and link" : "nothing", "either point = or link =");
    if (table.has("point"))
      slider.point = names_.point(table, "point").value_or("");
    else
      slider.link = names_.link(table, "link").value_or("");
    slider.line = read_line(table);
    if (slider.link == "ground") table.refuse("link", "the ground");
    const bool own = !slider.link.empty() ? slider.link == slider.line.link
                                          : names_.local_place(slider.point, slider.line.link).has_value();
    if (own)
      table.refuse("on", fmt::format("{}, which {} belongs to", slider.line.link, slider.name()),
                   "another link");
    result_.sliders.push_back(std::move(slider));
  }

  void read_angle(const LinkageTable& table) {
    const auto from = names_.link(table, "from"), to = names_.link(table, "to");
    const auto angle = table.number("angle_deg");
    if (!table.has("angle_deg")) table.missing("angle_deg");
    if (!from || !to || !angle) return;
    if (*from == *to) return table.refuse("to", fmt::format("{} twice", *to), "two different links");
    result_.angles.push_back({*from, *to, radians(*angle)});
  }

  void read_gears(const LinkageTable& table) {
    FileGears gears;
    const std::vector<NameAt> wheels = table.names("wheels");
    if (wheels.size() != 2)
      return table.refuse("wheels", wheels.empty() ? "nothing" : fmt::format("{} names", wheels.size()));
    for (const NameAt& wheel : wheels) names_.require_link(wheel, table.dotted("wheels"));
    gears.first = wheels[0].name;
    gears.second = wheels[1].name;
    gears.carrier = table.has("carrier") ? names_.link(table, "carrier").value_or("ground") : "ground";
    if (gears.first == gears.second || gears.first == gears.carrier || gears.second == gears.carrier)
      return table.refuse("wheels", "one link in two roles", "three different links");
    const std::string key = table.has("teeth") ? "teeth" : "radii";
    std::vector<double> sizes = table.numbers(key);
    if (sizes.size() != 2 || !(sizes[0] > 0) || !(sizes[1] > 0)) {
      if (!table.has(key)) return table.refuse("radii", "nothing");
      return table.refuse(key, "something else");
    }
    if (key == "teeth" && table.has("radii")) table.refuse("teeth", "both teeth and radii", "one of them");
    gears.first_radius = length(sizes[0]);
    gears.second_radius = length(sizes[1]) * (table.truth("inner") ? -1 : 1);
    const std::vector<double> mesh =
        table.has("mesh_deg") ? table.numbers("mesh_deg") : std::vector<double>{0, 0};
    if (mesh.size() != 2) return table.refuse("mesh_deg", fmt::format("{} numbers", mesh.size()));
    gears.value = gears.first_radius * radians(mesh[0]) + gears.second_radius * radians(mesh[1]);
    result_.gears.push_back(std::move(gears));
  }

  void read_rack(const LinkageTable& table) {
    FileRack rack;
    const auto pinion = names_.link(table, "pinion"), centre = names_.point(table, "centre");
    rack.line = read_line(table);
    const auto radius = table.positive("radius");
    if (!table.has("radius")) table.missing("radius");
    const bool right = table.one_of("side", {"left", "right"}) == "right";
    if (!pinion || !centre || !radius) return;
    if (!names_.local_place(*centre, *pinion))
      return table.refuse("centre", fmt::format("{}, which is no point of {}", *centre, *pinion));
    if (*pinion == rack.line.link) return table.refuse("on", "the pinion itself", "another link");
    rack.pinion = *pinion;
    rack.centre = *centre;
    rack.radius = length(*radius) * (right ? -1 : 1);
    rack.value = rack.radius * radians(table.number("opposite_deg").value_or(0));
    result_.racks.push_back(std::move(rack));
  }

  void read_loads() {
    each_in_list("forces", [&](const LinkageTable& table) { read_force(table, names_, result_); });
    each_in_list("moments", [&](const LinkageTable& table) { read_moment(table, names_, result_); });
    each_in_table("masses", [&](const NameAt& name, const toml::table& inner) {
      read_mass({inner, "masses.*", "masses." + name.name, complaints_}, name, names_, result_);
    });
    read_gravity(root_, result_);
  }

  void read_motion() {
    constexpr double shortest_motion = 1e-6;  // s; accelerations are counted by its square
    const toml::table* inner = root_.inner("motion");
    if (!inner) return;
    const LinkageTable table(*inner, "motion", "motion", complaints_);
    result_.steps = table.whole("steps", 1, 1000000).value_or(result_.steps);
    result_.duration = table.positive("duration_s", shortest_motion).value_or(result_.duration);
  }

  void read_guess() {
    const toml::table* inner = root_.inner("guess");
    if (!inner) return;
    const LinkageTable table(*inner, "guess", "guess", complaints_);
    for (const NameAt& name : table.keys()) {
      const auto at = table.point(name.name);
      if (names_.require_point(name, table.dotted(name.name)) && at)
        result_.guess.emplace_back(name.name, place(*at));
    }
  }

  void read_bounds() {
    each_in_table("bounds", [&](const NameAt& name, const toml::table& inner) {
      const LinkageTable table(inner, "bounds.*", "bounds." + name.name, complaints_);
      FileBound bound{name.name, {}, {}};
      const auto scaled = [&](std::string_view key, double by) {
        const auto range = table.range(key);
        return range ? std::optional(std::pair{range->first * by, range->second * by}) : std::nullopt;
      };
      if (names_.is_link(name.name)) {
        bound.angle = scaled("angle_deg", radians(1));
        if (table.has("x") || table.has("y"))
          table.refuse(table.has("x") ? "x" : "y", "a place of a link", "angle_deg");
      } else if (names_.require_point(name, "bounds." + name.name)) {
        bound.place = {scaled("x", result_.unit.in_mm), scaled("y", result_.unit.in_mm)};
        if (table.has("angle_deg")) table.refuse("angle_deg", "an angle of a point", "x and y");
      }
      result_.bounds.push_back(std::move(bound));
    });
  }

  void read_output() {
    const toml::table* inner = root_.inner("output");
    if (inner) {
      const LinkageTable table(*inner, "output", "output", complaints_);
      OutputWishes& output = result_.output;
      output.points = names_.points(table, "points");
      output.trace = names_.points(table, "trace");
      output.velocities = table.truth("velocities");
      output.accelerations = table.truth("accelerations");
      if (table.has("reactions")) output.reactions = table.truth("reactions");
      for (const NameAt& name : table.names("angles"))
        if (names_.require_link(name, table.dotted("angles"))) output.angles.push_back(name.name);
      for (const auto& list : table.name_lists("transmission")) read_transmission(table, list);
    }
    if (result_.output.points.empty())
      for (const std::string& name : result_.point_names())
        if (!names_.local_place(name, "ground")) result_.output.points.push_back(name);
  }

  void read_transmission(const LinkageTable& table, const std::vector<NameAt>& list) {
    if (list.size() != 3) return table.refuse("transmission", fmt::format("a list of {}", list.size()));
    for (const NameAt& name : list)
      if (!names_.require_point(name, table.dotted("transmission"))) return;
    result_.output.transmission.push_back({list[0].name, list[1].name, list[2].name});
  }

  LinkageFile result_;
  Complaints complaints_;
  Complaints scratch_{""};  ///< of tables whose keys are the user's own
  LinkageTable root_;
  LinkageNames names_;
};

}  // namespace

std::vector<std::string> LinkageFile::point_names() const {
  std::vector<std::string> result;
  std::set<std::string> seen;
  const auto add = [&](const std::string& point) {
    if (seen.insert(point).second) result.push_back(point);
  };
  for (const auto& [point, at] : ground) add(point);
  for (const FileLink& link : links)
    for (const auto& [point, at] : link.joints) add(point);
  for (const std::string& point : free_points) add(point);
  return result;
}

int LinkageFile::most_steps() const {
  return static_cast<int>(std::min<std::size_t>(
      1000000, most_places / std::max<std::size_t>(1, links.size() + free_points.size())));
}

tl::expected<LinkageFile, InputError> parse_linkage_file(std::string_view text,
                                                         const std::string& file_name) {
  const auto root = parse_toml(text, file_name);
  if (!root) return tl::unexpected(or_other_kind(root.error(), text, FileKind::linkage));
  return LinkageReader(*root, file_name).read().map_error([&](const InputError& faults) {
    return or_other_kind(faults, text, FileKind::linkage);
  });
}

tl::expected<LinkageFile, InputError> read_linkage_file(const std::string& path) {
  const auto text = read_text_file(path);
  if (!text) return tl::unexpected(text.error());
  return parse_linkage_file(*text, path);
}

}  // namespace kempe
