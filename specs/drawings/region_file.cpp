#include "specs/drawings/region_file.hpp"

#include <algorithm>
#include <cctype>

#include "geometry/regions/region_growth.hpp"
#include "specs/drawings/dxf_reader.hpp"
#include "specs/drawings/geojson_reader.hpp"
#include "specs/drawings/svg_reader.hpp"

namespace kempe {
namespace {

constexpr RegionFileKind kinds[] = {
    {".geojson", read_geojson_region, false},
    {".svg", read_svg_region, true},
    {".dxf", read_dxf_region, true},
};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::span<const RegionFileKind> region_file_kinds() { return kinds; }

const RegionFileKind* region_file_kind(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  const auto found = std::find_if(std::begin(kinds), std::end(kinds),
                                  [&](const RegionFileKind& kind) { return kind.extension == extension; });
  return found == std::end(kinds) ? nullptr : found;
}

tl::expected<Region, InputError> grown_region(const Region& region, double margin,
                                              const std::string& file_name) {
  auto result = grown(region, margin);
  if (result) return std::move(*result);
  return tl::unexpected(InputError{file_name, 0, "", result.error(), "a simpler drawing, or margin_mm = 0"});
}

}  // namespace kempe
