#include "specs/shape_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/regions/region_checks.hpp"
#include "geometry/regions/region_growth.hpp"
#include "specs/spec_keys.hpp"
#include "specs/unit_words.hpp"

namespace kempe {
namespace {

/// A list whose first element is no list: as it stands in a ring, a point.
bool looks_like_point(const toml::node& node) {
  const toml::array* list = node.as_array();
  return list && !list->empty() && !(*list)[0].is_array();
}

/// One key's rings while they are read.
class RingsReader {
 public:
  RingsReader(std::string key, Complaints& complaints) : key_(std::move(key)), complaints_(complaints) {}

  std::optional<std::vector<Ring>> read(const toml::array& list) {
    std::vector<Ring> rings;
    if (list.empty()) return refuse(list, "an empty list");
    if (looks_like_point(list[0])) {
      auto ring = read_ring(list);
      if (!ring) return std::nullopt;
      rings.push_back(std::move(*ring));
      return rings;
    }
    for (const toml::node& node : list) {
      const toml::array* corners = node.as_array();
      if (!corners) return refuse(node, fmt::format("ring {}: {}", rings.size() + 1, describe(node)));
      auto ring = read_ring(*corners);
      if (!ring) return std::nullopt;
      rings.push_back(std::move(*ring));
    }
    return rings;
  }

 private:
  std::optional<Ring> read_ring(const toml::array& list) {
    Ring ring;
    ring.reserve(list.size());
    for (const toml::node& node : list) {
      const auto corner = finite_point(node);
      if (!corner) {
        refuse(node, fmt::format("corner {}: {}", ring.size() + 1, describe(node)));
        return std::nullopt;
      }
      ring.push_back(*corner);
    }
    return ring;
  }

  std::nullopt_t refuse(const toml::node& node, std::string found) {
    complaints_.add(line_of(node), key_, std::move(found),
                    "a ring [[x, y], [x, y], [x, y], ...] of finite numbers or a list of such rings");
    return std::nullopt;
  }

  std::string key_;
  Complaints& complaints_;
};

/// The numbers of a short form, [x, y, width, height] or [x, y, radius].
std::vector<double> numbers_of(const toml::array& list) {
  std::vector<double> numbers;
  for (const toml::node& node : list) numbers.push_back(finite_number(node).value_or(0));
  return numbers;
}

Ring ring_of_rectangle(const Point& at, const Point& size) {
  return Region::rectangle(at, size).polygons.front().outer;
}

Ring ring_of_circle(const Point& centre, double radius) {
  return Region::circle(centre, radius).polygons.front().outer;
}

Ring read_rectangle(const TableView& table) {
  Point at = Point::Zero(), size = Point::Zero();
  table.set("at", at);
  table.set("size", size);
  return ring_of_rectangle(at, size);
}

Ring read_short_rectangle(const toml::array& list) {
  const std::vector<double> numbers = numbers_of(list);
  if (numbers.size() != 4) return {};
  return ring_of_rectangle({numbers[0], numbers[1]}, {numbers[2], numbers[3]});
}

/// Where a ring of a key stands: the element of the list of rings, or the whole value.
int line_of_ring(const TableView& table, std::string_view key, std::size_t ring) {
  const toml::node* value = table.find(key);
  const toml::array* list = value ? value->as_array() : nullptr;
  if (list && ring < list->size() && !looks_like_point((*list)[0])) return line_of((*list)[ring]);
  return table.line_of_key(key);
}

}  // namespace

std::optional<std::vector<Ring>> read_rings(const TableView& table, std::string_view key,
                                            Complaints& complaints) {
  const toml::node* value = table.find(key);
  if (!value) return std::vector<Ring>{};
  const toml::array* list = value->as_array();
  return list ? RingsReader(table.dotted(key), complaints).read(*list) : std::nullopt;
}

std::optional<std::string_view> exactly_one_of(const TableView& table,
                                               const std::vector<std::string_view>& keys,
                                               Complaints& complaints) {
  std::vector<std::string_view> present;
  std::vector<std::string> found, allowed;  // as the file names them
  for (const std::string_view key : keys) {
    allowed.push_back(name_in(complaints.unit(), key));
    if (!table.has(key)) continue;
    present.push_back(key);
    found.push_back(allowed.back());
  }
  if (present.size() == 1) return present[0];
  const int line = present.empty() ? table.line() : table.line_of_key(present[1]);
  complaints.add(line, table.path(),
                 present.empty() ? "none of them" : fmt::format("{}", fmt::join(found, " and ")),
                 fmt::format("exactly one of {}", fmt::join(allowed, ", ")));
  return std::nullopt;
}

Disc read_disc(const TableView& table) {
  Disc disc;
  const toml::node* value = table.find("circle_mm");
  if (const toml::array* list = value ? value->as_array() : nullptr) {
    if (const std::vector<double> numbers = numbers_of(*list); numbers.size() == 3)
      disc = {{numbers[0], numbers[1]}, numbers[2]};
  } else if (value && value->is_table()) {
    const TableView figure(*value->as_table(), table.dotted("circle_mm"));
    figure.set("centre", disc.centre);
    figure.set("radius", disc.radius);
  }
  return disc;
}

Ring read_figure(const TableView& table, std::string_view key) {
  if (key == "circle_mm") {
    const Disc disc = read_disc(table);
    return disc.radius > 0 ? ring_of_circle(disc.centre, disc.radius) : Ring{};
  }
  const toml::node* value = table.find(key);
  if (value && value->is_array()) return read_short_rectangle(*value->as_array());
  if (!value || !value->is_table()) return {};
  return read_rectangle(TableView(*value->as_table(), table.dotted(key)));
}

std::optional<Region> read_shape(const TableView& table, std::string_view key, Complaints& complaints) {
  const bool is_figure = key == "rectangle_mm" || key == "circle_mm";
  const auto outers = is_figure ? std::optional(std::vector<Ring>{read_figure(table, key)})
                                : read_rings(table, key, complaints);
  const auto holes = read_rings(table, "holes_mm", complaints);
  if (!outers || !holes) return std::nullopt;
  auto region = assemble_united_region(*outers, *holes);
  if (region) return std::move(*region);
  const RingFault& fault = region.error();
  const std::string_view at_fault = fault.is_hole ? "holes_mm" : key;
  complaints.add(line_of_ring(table, at_fault, fault.ring), table.dotted(at_fault), fault.found,
                 fault.allowed);
  return std::nullopt;
}

}  // namespace kempe
