#include "specs/drawings/geojson_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/regions/region_checks.hpp"
#include "geometry/regions/region_growth.hpp"
#include "specs/text/json_text.hpp"

namespace kempe {
namespace {

using nlohmann::json;

constexpr const char* allowed_types =
    "FeatureCollection, Feature, GeometryCollection, Polygon or MultiPolygon";

/// "a string", "[...]" cut short: a value for an error message.
std::string describe_json(const json& value) {
  if (value.is_structured())
    return value.is_array() ? fmt::format("a list of {}", value.size()) : "an object";
  return value.dump(-1, ' ', true, json::error_handler_t::replace).substr(0, 60);
}

class GeoJsonReader {
 public:
  explicit GeoJsonReader(std::string file_name) : file_name_(std::move(file_name)) {}

  tl::expected<Region, InputError> read(const json& root) {
    read_object(root, "");
    if (error_) return tl::unexpected(*error_);
    if (outers_.empty())
      return tl::unexpected(InputError{file_name_, 0, "", "no polygon", "at least one polygon"});
    auto region = assemble_united_region(outers_, holes_);
    if (region) return std::move(*region);
    const RingFault& fault = region.error();
    const auto& paths = fault.is_hole ? hole_paths_ : outer_paths_;
    return tl::unexpected(InputError{file_name_, 0, paths.at(fault.ring), fault.found, fault.allowed});
  }

 private:
  void refuse(const std::string& path, std::string found, std::string allowed) {
    if (!error_) error_ = InputError{file_name_, 0, path, std::move(found), std::move(allowed)};
  }

  static std::string join(const std::string& path, std::string_view name) {
    return path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
  }

  /// The list under `name`, or a complaint and null.
  const json* list_in(const json& object, std::string_view name, const std::string& path) {
    const auto found = object.find(name);
    if (found != object.end() && found->is_array()) return &*found;
    refuse(join(path, name), found == object.end() ? "nothing" : describe_json(*found), "a list");
    return nullptr;
  }

  void read_object(const json& object, const std::string& path) {
    if (!object.is_object()) return refuse(path, describe_json(object), "an object with a type");
    const auto type = object.find("type");
    const std::string name = type != object.end() && type->is_string() ? type->get<std::string>() : "";
    if (name == "FeatureCollection") return read_all(object, "features", path);
    if (name == "GeometryCollection") return read_all(object, "geometries", path);
    if (name == "Feature") return read_feature(object, path);
    if (name == "Polygon" || name == "MultiPolygon") return read_geometry(object, name, path);
    refuse(join(path, "type"), type == object.end() ? "nothing" : describe_json(*type), allowed_types);
  }

  void read_all(const json& object, std::string_view name, const std::string& path) {
    const json* members = list_in(object, name, path);
    if (!members) return;
    for (std::size_t i = 0; i < members->size() && !error_; ++i) {
      read_object((*members)[i], fmt::format("{}[{}]", join(path, name), i));
    }
  }

  void read_feature(const json& feature, const std::string& path) {
    const auto geometry = feature.find("geometry");
    if (geometry == feature.end()) return refuse(join(path, "geometry"), "nothing", "a geometry or null");
    if (!geometry->is_null()) read_object(*geometry, join(path, "geometry"));
  }

  void read_geometry(const json& object, std::string_view name, const std::string& path) {
    const json* coordinates = list_in(object, "coordinates", path);
    if (!coordinates) return;
    const std::string here = join(path, "coordinates");
    if (name == "Polygon") return read_polygon(*coordinates, here);
    for (std::size_t i = 0; i < coordinates->size() && !error_; ++i) {
      read_polygon((*coordinates)[i], fmt::format("{}[{}]", here, i));
    }
  }

  void read_polygon(const json& rings, const std::string& path) {
    if (!rings.is_array() || rings.empty()) return refuse(path, describe_json(rings), "a list of rings");
    for (std::size_t i = 0; i < rings.size() && !error_; ++i) {
      const std::string here = fmt::format("{}[{}]", path, i);
      (i == 0 ? outers_ : holes_).push_back(read_ring(rings[i], here));
      (i == 0 ? outer_paths_ : hole_paths_).push_back(here);
    }
  }

  Ring read_ring(const json& corners, const std::string& path) {
    Ring ring;
    if (!corners.is_array())
      refuse(path, describe_json(corners), "a list of positions");
    else
      ring.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size() && !error_; ++i) {
      if (const auto corner = position(corners[i])) {
        ring.push_back(*corner);
      } else {
        refuse(fmt::format("{}[{}]", path, i), describe_json(corners[i]), "a position [x, y] of two numbers");
      }
    }
    return ring;
  }

  static std::optional<Point> position(const json& value) {
    if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number())
      return std::nullopt;
    return Point(value[0].get<double>(), value[1].get<double>());
  }

  std::string file_name_;
  std::optional<InputError> error_;
  std::vector<Ring> outers_, holes_;
  std::vector<std::string> outer_paths_, hole_paths_;
};

}  // namespace

tl::expected<Region, InputError> read_geojson_region(std::string_view contents, const std::string& file_name,
                                                     const RegionFileOptions& options) {
  const auto root = parse_json(contents, file_name);
  if (!root) return tl::unexpected(root.error());
  auto region = GeoJsonReader(file_name).read(*root);
  if (!region) return region;
  return grown_region(*region, options.margin, file_name);
}

}  // namespace kempe
