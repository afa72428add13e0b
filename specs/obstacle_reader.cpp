// read_obstacles() of region_reader.hpp.

#include <fmt/format.h>

#include "geometry/regions/region_checks.hpp"
#include "geometry/regions/ring_loops.hpp"
#include "specs/region_reader.hpp"
#include "specs/shape_reader.hpp"
#include "specs/spec_keys.hpp"
#include "specs/text/printable.hpp"

namespace kempe {
namespace {

/// One [[obstacles]] table.
class ObstacleReader {
 public:
  ObstacleReader(const TableView& table, std::size_t number, Complaints& complaints)
      : table_(table), complaints_(complaints) {
    common_.name = fmt::format("obstacle {}", number);
    table_.set("name", common_.name);
    common_.name = printable(common_.name);  // it stands in sentences
    read_layers();
  }

  std::vector<Obstacle> read() {
    const auto key = exactly_one_of(table_, {"polygon_mm", "rectangle_mm", "circle_mm"}, complaints_);
    if (!key) return {};
    key_ = *key;
    if (*key != "polygon_mm") {
      add_ring(read_figure(table_, *key));
    } else if (const auto rings = read_rings(table_, *key, complaints_)) {
      for (const Ring& ring : *rings) add_ring(ring);
    }
    return std::move(obstacles_);
  }

 private:
  void read_layers() {
    common_.highest_layer = most_layers;
    const toml::node* value = table_.find("layers");
    const toml::array* list = value ? value->as_array() : nullptr;
    if (!list || list->size() != 2) return;
    common_.lowest_layer = (*list)[0].value_or(common_.lowest_layer);
    common_.highest_layer = (*list)[1].value_or(common_.highest_layer);
  }

  void refuse(const std::string& found, std::string allowed) {
    complaints_.add(table_.line_of_key(key_), table_.dotted(key_), common_.name + ": " + found,
                    std::move(allowed));
  }

  void add_ring(const Ring& given) {
    const Ring ring = without_repeated_corners(given);
    if (const auto fault = shape_fault(ring)) return refuse(fault->found, fault->allowed);
    const auto loops = simple_loops(ring);
    if (!loops) return refuse("a ring that crosses itself too often to be repaired", "simple rings");
    for (const Ring& loop : *loops) {
      obstacles_.push_back(common_);
      obstacles_.back().shape.outer = loop;
    }
  }

  const TableView& table_;
  Complaints& complaints_;
  std::string_view key_;
  Obstacle common_;
  std::vector<Obstacle> obstacles_;
};

}  // namespace

std::vector<Obstacle> read_obstacles(const toml::array& tables, Complaints& complaints) {
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const TableView table(*tables[i].as_table(), "obstacles");
    for (Obstacle& part : ObstacleReader(table, i + 1, complaints).read())
      obstacles.push_back(std::move(part));
  }
  return obstacles;
}

}  // namespace kempe
