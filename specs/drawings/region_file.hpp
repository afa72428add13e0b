#pragma once
// Regions from drawings: one place where a file's extension chooses its reader.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "geometry/region.hpp"
#include "kempe/input_error.hpp"

namespace kempe {

/// What of a drawing the tracer must cover.
enum class Cover {
  hull,     ///< its convex hull
  outline,  ///< what its closed outlines enclose
  strokes   ///< its strokes, grown by the margin
};

struct RegionFileOptions {
  Cover cover = Cover::hull;
  double margin = 0;  ///< mm, >= 0: the region grows by this
  /// mm to a unit of the drawing, in place of what the file says or leaves open
  std::optional<double> unit = {};
};

/// Makes a region of a file's contents; `file_name` is for error messages. The result keeps the invariant of
/// Polygon and has been grown by the margin.
using RegionFileReader = tl::expected<Region, InputError> (*)(std::string_view contents,
                                                              const std::string& file_name,
                                                              const RegionFileOptions& options);

/// A kind of region file. To add one: write its reader and add a line to the table in region_file.cpp.
struct RegionFileKind {
  std::string_view extension;  ///< ".geojson", lower case
  RegionFileReader read;
  bool takes_cover;  ///< whether `cover` means anything for it
};
std::span<const RegionFileKind> region_file_kinds();

/// The kind for a path's extension (in any case), or null.
const RegionFileKind* region_file_kind(const std::filesystem::path& path);

/// grown() for a region that was read from a file, its error as InputError about region.margin_mm.
tl::expected<Region, InputError> grown_region(const Region& region, double margin,
                                              const std::string& file_name);

}  // namespace kempe
