// read_obstacles(), read_bodies() and read_table_edge() of region_reader.hpp.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "geometry/orientation.hpp"
#include "geometry/regions/region_checks.hpp"
#include "geometry/regions/ring_loops.hpp"
#include "kinematics/grounding.hpp"
#include "kinematics/links.hpp"
#include "specs/region_reader.hpp"
#include "specs/shape_reader.hpp"
#include "specs/spec_keys.hpp"
#include "specs/text/printable.hpp"

namespace kempe {
namespace {

/// One table with an outline and layers: of [[obstacles]] or of [[bodies]].
class OutlineReader {
 public:
  /// `name` is that of an outline that has none, for messages too.
  OutlineReader(const TableView& table, std::string name, Complaints& complaints)
      : table_(table), complaints_(complaints), name_(std::move(name)) {
    table_.set("name", name_);
    name_ = printable(name_);  // it stands in sentences
    const toml::node* value = table_.find("layers");
    const toml::array* list = value ? value->as_array() : nullptr;
    if (!list || list->size() != 2) return;
    lowest_layer_ = (*list)[0].value_or(lowest_layer_);
    highest_layer_ = (*list)[1].value_or(highest_layer_);
  }

  const std::string& name() const { return name_; }

  /// The key of the shape; a complaint and nothing unless there is exactly one.
  std::optional<std::string_view> shape_key() {
    const auto key = exactly_one_of(table_, {"polygon_mm", "rectangle_mm", "circle_mm"}, complaints_);
    if (key) key_ = *key;
    return key;
  }

  /// Simple rings that cover what the key's rings wind around.
  std::vector<Ring> rings() {
    std::vector<Ring> result;
    if (key_ != "polygon_mm") {
      add_loops(read_figure(table_, key_), result);
    } else if (const auto given = read_rings(table_, key_, complaints_)) {
      for (const Ring& ring : *given) add_loops(ring, result);
    }
    return result;
  }

  void refuse(const std::string& found, std::string allowed) {
    complaints_.add(table_.line_of_key(key_), table_.dotted(key_), name_ + ": " + found, std::move(allowed));
  }

  /// Obstacle or body with this table's name and layers.
  template <typename Thing>
  Thing thing() const {
    Thing one;
    one.lowest_layer = lowest_layer_;
    one.highest_layer = highest_layer_;
    one.name = name_;
    return one;
  }

 private:
  void add_loops(const Ring& given, std::vector<Ring>& result) {
    const Ring ring = without_repeated_corners(given);
    if (const auto fault = shape_fault(ring)) return refuse(fault->found, fault->allowed);
    const auto loops = simple_loops(ring);
    if (!loops) return refuse("a ring that crosses itself too often to be repaired", "simple rings");
    result.insert(result.end(), loops->begin(), loops->end());
  }

  const TableView& table_;
  Complaints& complaints_;
  std::string name_;
  std::string_view key_;
  int lowest_layer_ = 1, highest_layer_ = most_layers;
};

std::vector<Body> read_body(const TableView& table, std::size_t number, Complaints& complaints) {
  OutlineReader reader(table, fmt::format("body {}", number), complaints);
  const auto key = reader.shape_key();
  if (!key) return {};
  Body body = reader.thing<Body>();
  std::string carrier;
  table.set("at", carrier);
  body.at = carrier == "tracer" ? Carrier::tracer : Carrier::pen;
  std::string link;
  table.set("turns_with", link);
  const auto named =
      std::find_if(all_links.begin(), all_links.end(), [&](const Link& each) { return name(each) == link; });
  if (named != all_links.end()) body.turns_with = *named;
  std::vector<Body> bodies;
  if (*key == "circle_mm") {
    body.shape = read_disc(table);
    bodies.push_back(body);
    return bodies;
  }
  for (Ring& ring : reader.rings()) {
    body.shape = Polygon{std::move(ring), {}};
    bodies.push_back(body);
  }
  return bodies;
}

/// Where bodies meet others in more corners than this, the map takes more than a gigabyte.
constexpr std::size_t most_corners_met = 4'000'000;

/// What an outline is in a Minkowski difference.
struct OutlineSize {
  std::size_t corners, parts;  ///< parts: an upper bound of its convex ones (convex_parts.hpp)
};

OutlineSize size_of(const Ring& ring) {
  std::size_t reflex = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    reflex += orientation(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) < 0;
  return {ring.size(), 1 + 2 * reflex};
}

/// True if the link has the joint that carries the body.
bool carries(Link link, Carrier at, Grounding grounding) {
  const JointRoles roles = roles_of(grounding);
  return has_joint(link, at == Carrier::tracer ? roles.tracer : roles.pen);
}

/// "VA or VB (a link that holds the pen with the pen at the vertex)"
std::string links_that_carry(Carrier at, const std::vector<Grounding>& groundings) {
  std::string names;
  for (const Link link : all_links)
    if (std::any_of(groundings.begin(), groundings.end(),
                    [&](Grounding each) { return carries(link, at, each); }))
      names += (names.empty() ? "" : " or ") + std::string(name(link));
  std::string vertices;
  for (const Grounding each : groundings)
    vertices += (vertices.empty() ? "" : " or ") + std::string(name(each));
  return fmt::format("{} (a link that holds the {} with the {} at the vertex)", names,
                     at == Carrier::tracer ? "tracer" : "pen", vertices);
}

}  // namespace

std::vector<Grounding> groundings_with_links_of(const toml::array& tables, std::vector<Grounding> groundings,
                                                Complaints& complaints) {
  for (const toml::node& node : tables) {
    const TableView table(*node.as_table(), "bodies");
    std::string link, carrier;
    table.set("turns_with", link);
    table.set("at", carrier);
    const auto turns_with = std::find_if(all_links.begin(), all_links.end(),
                                         [&](const Link& each) { return name(each) == link; });
    if (turns_with == all_links.end()) continue;
    const Carrier at = carrier == "tracer" ? Carrier::tracer : Carrier::pen;
    std::vector<Grounding> kept;
    for (const Grounding grounding : groundings)
      if (carries(*turns_with, at, grounding)) kept.push_back(grounding);
    if (kept.empty()) {
      complaints.add(table.line_of_key("turns_with"), table.dotted("turns_with"), link,
                     links_that_carry(at, groundings));
      return {};
    }
    groundings = std::move(kept);
  }
  return groundings;
}

std::vector<Obstacle> read_obstacles(const toml::array& tables, Complaints& complaints) {
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const TableView table(*tables[i].as_table(), "obstacles");
    OutlineReader reader(table, fmt::format("obstacle {}", i + 1), complaints);
    if (!reader.shape_key()) continue;
    for (Ring& ring : reader.rings()) {
      obstacles.push_back(reader.thing<Obstacle>());
      obstacles.back().shape.outer = std::move(ring);
    }
  }
  return obstacles;
}

std::vector<Body> read_bodies(const toml::array& tables, Complaints& complaints) {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const TableView table(*tables[i].as_table(), "bodies");
    for (Body& body : read_body(table, i + 1, complaints)) bodies.push_back(std::move(body));
  }
  return bodies;
}

void check_body_outlines(const Spec& spec, Complaints& complaints) {
  std::vector<OutlineSize> met;
  for (const Obstacle& obstacle : spec.obstacles) met.push_back(size_of(obstacle.shape.outer));
  if (spec.table) met.push_back(size_of(spec.table->outer));
  std::size_t corners = 0;
  for (const Body& body : spec.bodies) {
    const auto* polygon = std::get_if<Polygon>(&body.shape);
    const OutlineSize own = polygon ? size_of(polygon->outer) : OutlineSize{1, 1};
    for (const OutlineSize& other : met)  // one that turns is met triangle by triangle, as it stands
      corners += body.turns_with ? own.corners : own.parts * other.corners + other.parts * own.corners;
    met.push_back(own);
    if (corners > most_corners_met)
      return complaints.add(
          0, "bodies", fmt::format("outlines that meet others in {} or more corners", corners),
          fmt::format("at most {}: simpler outlines of bodies and obstacles", most_corners_met));
  }
}

std::optional<Polygon> read_table_edge(const TableView& table, Complaints& complaints) {
  OutlineReader reader(table, "the table", complaints);
  if (!reader.shape_key()) return std::nullopt;
  std::vector<Ring> rings = reader.rings();
  if (rings.size() == 1) return Polygon{std::move(rings.front()), {}};
  if (!rings.empty())
    reader.refuse("several rings, or one that crosses itself", "one ring that does not cross itself");
  return std::nullopt;
}

}  // namespace kempe
