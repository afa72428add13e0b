#include "specs/drawings/drawing_cover.hpp"

#include <algorithm>

#include "geometry/convex_hull.hpp"
#include "geometry/regions/region_checks.hpp"
#include "geometry/regions/region_growth.hpp"
#include "geometry/regions/ring_loops.hpp"
#include "geometry/regions/ring_sweep.hpp"
#include "specs/drawings/stroke_joining.hpp"

namespace kempe {
namespace {

constexpr double same_place = 1e-3;  ///< mm: ends this near each other are one corner

using Result = tl::expected<Region, InputError>;

/// Nothing to cover, said with what the drawing held instead.
class Refusal {
 public:
  Refusal(const std::string& file, const std::string& remark) : file_(file), remark_(remark) {}
  tl::unexpected<InputError> operator()(std::string found, std::string allowed) const {
    if (!remark_.empty()) found += " (" + remark_ + ")";
    return tl::unexpected(InputError{file_, 0, "", std::move(found), std::move(allowed)});
  }

 private:
  const std::string& file_;
  const std::string& remark_;
};

Result hull_region(const std::vector<DrawnStroke>& strokes, double margin, const std::string& file,
                   const Refusal& refuse) {
  std::vector<Point> points;
  for (const DrawnStroke& stroke : strokes)
    points.insert(points.end(), stroke.points.begin(), stroke.points.end());
  Ring hull = convex_hull(std::move(points));
  if (hull.size() < 3 || shape_fault(hull)) {
    if (margin == 0) return refuse("strokes on one line, whose hull has no area", "margin_mm above 0");
    auto swollen = grown(std::vector<Stroke>{std::move(hull)}, margin);
    if (!swollen) return refuse(swollen.error(), "a simpler drawing");
    return std::move(*swollen);
  }
  return grown_region(Region{{Polygon{std::move(hull), {}}}}, margin, file);
}

/// Closed strokes, those that open strokes form together included.
std::vector<Ring> closed_rings(const std::vector<DrawnStroke>& strokes) {
  std::vector<Ring> rings;
  for (const DrawnStroke& stroke : joined(strokes, same_place)) {
    if (!stroke.closed) continue;
    Ring ring = without_repeated_corners(stroke.points);
    if (!shape_fault(ring)) rings.push_back(std::move(ring));
  }
  return rings;
}

/// How many rings lie around each.
std::vector<int> depths(const RingNesting& nesting) {
  std::vector<int> result(nesting.parent.size(), 0);
  for (std::size_t i = 0; i < result.size(); ++i)
    for (auto parent = nesting.parent[i]; parent; parent = nesting.parent[*parent]) ++result[i];
  return result;
}

/// Even-odd filling of rings that nowhere meet.
Result even_odd(const std::vector<Ring>& rings, const RingNesting& nesting, const Refusal& refuse) {
  std::vector<Ring> outers, holes;
  const std::vector<int> depth = depths(nesting);
  for (std::size_t i = 0; i < rings.size(); ++i) (depth[i] % 2 == 0 ? outers : holes).push_back(rings[i]);
  auto region = assemble_region(outers, holes);
  if (!region) return refuse(region.error().found, region.error().allowed);
  return std::move(*region);
}

/// The rings and a small square about every corner.
std::vector<Ring> with_filled_corners(std::vector<Ring> rings) {
  constexpr double half = same_place;
  const std::size_t count = rings.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < rings[i].size(); ++j) {
      const Point at = rings[i][j];
      rings.push_back({at + Point(-half, -half), at + Point(half, -half), at + Point(half, half),
                       at + Point(-half, half)});
    }
  return rings;
}

/// All that rings which meet enclose together.
Result enclosed_by_any(const std::vector<Ring>& rings, const Refusal& refuse) {
  std::vector<Ring> simple;
  for (const Ring& ring : rings) {
    auto loops = simple_loops(ring);
    if (!loops)
      return refuse("an outline that crosses itself too often", "a simpler drawing, or cover = \"hull\"");
    std::move(loops->begin(), loops->end(), std::back_inserter(simple));
  }
  auto region = united(simple);
  // Outlines that touch in a point have a union that touches itself there: fill in the neighbourhood of
  // corners.
  if (!region) region = united(with_filled_corners(std::move(simple)));
  if (!region) return refuse(region.error(), "a simpler drawing, or cover = \"hull\"");
  return std::move(*region);
}

Result outline_region(const std::vector<DrawnStroke>& strokes, double margin, const std::string& file,
                      const Refusal& refuse) {
  const std::vector<Ring> rings = closed_rings(strokes);
  if (rings.empty())
    return refuse("no closed outline", "closed outlines, or cover = \"hull\" or \"strokes\"");
  const auto nesting = examine_rings(rings);
  return (nesting ? even_odd(rings, *nesting, refuse) : enclosed_by_any(rings, refuse))
      .and_then([&](const Region& region) { return grown_region(region, margin, file); });
}

Result stroke_region(const std::vector<DrawnStroke>& strokes, double margin, const Refusal& refuse) {
  if (margin == 0)
    return refuse("cover = \"strokes\" without a margin, which covers nothing", "margin_mm above 0");
  std::vector<Stroke> lines;
  for (const DrawnStroke& stroke : strokes) {
    lines.push_back(stroke.points);
    if (stroke.closed) lines.back().push_back(stroke.points.front());
  }
  auto region = grown(lines, margin);
  if (!region) return refuse(region.error(), "a simpler drawing, or cover = \"hull\"");
  return std::move(*region);
}

}  // namespace

tl::expected<Region, InputError> covered_region(const std::vector<DrawnStroke>& strokes,
                                                const std::string& remark, const std::string& file_name,
                                                const RegionFileOptions& options) {
  const Refusal refuse(file_name, remark);
  if (strokes.empty()) return refuse("a drawing without lines", "paths, lines or shapes");
  switch (options.cover) {
    case Cover::hull: return hull_region(strokes, options.margin, file_name, refuse);
    case Cover::outline: return outline_region(strokes, options.margin, file_name, refuse);
    case Cover::strokes: break;
  }
  return stroke_region(strokes, options.margin, refuse);
}

}  // namespace kempe
