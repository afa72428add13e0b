#include "specs/region_reader.hpp"

#include <fmt/format.h>

#include "geometry/regions/region_growth.hpp"
#include "specs/drawings/region_file.hpp"
#include "specs/shape_reader.hpp"
#include "specs/spec_keys.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

std::string known_extensions() {
  std::vector<std::string_view> extensions;
  for (const RegionFileKind& kind : region_file_kinds()) extensions.push_back(kind.extension);
  return fmt::format("a file that ends in {}", fmt::join(extensions, ", "));
}

/// region.units as mm; nothing if the file is to say it.
std::optional<double> unit_of(const TableView& table) {
  std::string units;
  table.set("units", units);
  if (units == "mm") return 1;
  if (units == "cm") return 10;
  if (units == "m") return 1000;
  if (units == "inch") return 25.4;
  if (units == "foot") return 304.8;
  return std::nullopt;
}

RegionFileOptions read_options(const TableView& table) {
  RegionFileOptions options;
  std::string cover = "hull";
  table.set("cover", cover);
  table.set("margin_mm", options.margin);
  options.cover = cover == "outline" ? Cover::outline : cover == "strokes" ? Cover::strokes : Cover::hull;
  options.unit = unit_of(table);
  return options;
}

std::optional<Region> read_file_region(const TableView& table, const std::filesystem::path& folder,
                                       Complaints& complaints) {
  std::string name;
  table.set("file", name);
  const auto refuse = [&](std::string_view key, std::string found, std::string allowed) {
    complaints.add(table.line_of_key(key), table.dotted(key), std::move(found), std::move(allowed));
    return std::nullopt;
  };
  const RegionFileKind* kind = region_file_kind(name);
  if (!kind) return refuse("file", fmt::format("\"{}\"", printable(name, 80)), known_extensions());
  if (table.has("cover") && !kind->takes_cover) {
    return refuse("cover", "it beside a " + std::string(kind->extension) + " file",
                  "it with a drawing of strokes");
  }
  const std::filesystem::path path = folder / name;
  const auto contents = read_text_file(path);
  if (!contents) {
    return refuse("file", contents.error().found + ": " + printable(path.string(), 200),
                  contents.error().allowed);
  }
  auto region = kind->read(*contents, path.string(), read_options(table));
  if (region) return std::move(*region);
  complaints.add(region.error());
  return std::nullopt;
}

std::optional<Region> grow_as_asked(const TableView& table, const Region& region, Complaints& complaints) {
  double margin = 0;
  table.set("margin_mm", margin);
  auto result = grown(region, margin);
  if (result) return std::move(*result);
  complaints.add(table.line_of_key("margin_mm"), table.dotted("margin_mm"), result.error(),
                 "a simpler region, or 0");
  return std::nullopt;
}

}  // namespace

std::optional<Region> read_region(const TableView& table, const std::filesystem::path& folder,
                                  Complaints& complaints) {
  const auto key = exactly_one_of(table, {"polygon_mm", "rectangle_mm", "circle_mm", "file"}, complaints);
  if (!key) return std::nullopt;
  if (table.has("holes_mm") && *key == "file") {
    complaints.add(table.line_of_key("holes_mm"), "region.holes_mm", "it beside file",
                   "holes drawn in the file");
  }
  if (table.has("cover") && *key != "file") {
    complaints.add(table.line_of_key("cover"), "region.cover", "it without a file",
                   "it with a .svg or .dxf file");
  }
  if (!complaints.none_about("region")) return std::nullopt;
  if (*key == "file") return read_file_region(table, folder, complaints);
  auto region = read_shape(table, *key, complaints);
  return region ? grow_as_asked(table, *region, complaints) : std::nullopt;
}

PoleSpec read_pole(const TableView& table, const Point& natural, Complaints& complaints) {
  if (!table.present()) return {natural};
  const auto key = exactly_one_of(table, {"at_mm", "within_mm"}, complaints);
  if (key == "at_mm") {
    Point at = Point::Zero();
    table.set("at_mm", at);
    return {at};
  }
  if (key == "within_mm") {
    if (auto region = read_shape(table, "within_mm", complaints)) return {std::move(*region)};
  }
  return {natural};
}

}  // namespace kempe
