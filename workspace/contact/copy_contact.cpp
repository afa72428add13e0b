#include "workspace/contact/copy_contact.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/regions/region_algebra.hpp"

namespace kempe {
namespace {

/// Of pole, tracer or pen, as a multiple of the tracer's place from the pole.
std::optional<Complex> times_the_tracers(std::size_t point, const CopyingLinkage& linkage) {
  if (point == static_cast<std::size_t>(linkage.pole_joint())) return 0;
  if (point == static_cast<std::size_t>(linkage.tracer_joint())) return 1;
  if (point == static_cast<std::size_t>(linkage.pen_joint())) return linkage.k();
  return std::nullopt;
}

/// The place of a piece in a frame in the same way; nothing where the lengths matter, or where it does not move.
std::optional<Complex> times_the_tracers(const ScenePiece& piece, SceneFrame frame,
                                         const CopyingLinkage& linkage) {
  if (piece.hull.count != 1 || is_of_link(frame)) return std::nullopt;
  auto times = times_the_tracers(piece.hull.points.front(), linkage);
  if (!times) return std::nullopt;
  if (frame == SceneFrame::tracer) *times -= 1;
  if (frame == SceneFrame::pen) *times -= linkage.k();
  return *times == 0.0 ? std::nullopt : times;
}

/// One corner of each ring, with `origin` as (0, 0).
std::vector<Point> ring_corners(const Region& region, const Point& origin) {
  std::vector<Point> corners;
  for (const Polygon& polygon : region.polygons) {
    corners.push_back(polygon.outer.front() - origin);
    for (const Ring& hole : polygon.holes) corners.push_back(hole.front() - origin);
  }
  return corners;
}

/// All that is asked of one of two sets of polygons where the other comes nearest.
struct Outline {
  const EdgeTree& edges;
  const std::vector<Point>& ring_corners;
};

/// The distance of two sets of polygons, and where it is on the first; nothing where they are no nearer than `enough`.
std::optional<std::pair<double, Point>> nearest(const Outline& one, const Outline& other, double enough) {
  if (!(distance(one.edges.node(0).box, other.edges.node(0).box) < enough)) return std::nullopt;
  for (const Point& corner : one.ring_corners)
    if (other.edges.winds_around(corner)) return std::pair(0.0, corner);
  for (const Point& corner : other.ring_corners)
    if (one.edges.winds_around(corner)) return std::pair(0.0, corner);
  const auto places = nearest_edges(one.edges, other.edges, enough);
  return places ? std::optional(std::pair(places->distance, places->on_one)) : std::nullopt;
}

/// The region as a place of tracer or pen goes over it, seen in a frame; the pole is its origin.
struct Image {
  Complex times;
  EdgeTree edges;
  std::vector<Point> ring_corners;
};

/// What is asked again for pieces of other widths is worked out once.
class Nearness {
 public:
  explicit Nearness(const PreparedTask& prepared) : prepared_(prepared) {}

  /// Of an image of the region and an obstacle: nothing where they are no nearer than `enough`.
  const std::optional<std::pair<double, Point>>& of(Complex times, std::uint32_t obstacle, double enough) {
    for (Known& known : known_)
      if (known.times == times && known.obstacle == obstacle) {
        if (!known.nearest && known.looked_within < enough) known = looked(times, obstacle, enough);
        return known.nearest;
      }
    return known_.emplace_back(looked(times, obstacle, enough)).nearest;
  }

 private:
  struct Known {
    Complex times;
    std::uint32_t obstacle;
    double looked_within;
    std::optional<std::pair<double, Point>> nearest;
  };

  Known looked(Complex times, std::uint32_t number, double enough) {
    const SceneObstacle& obstacle = prepared_.scene.obstacles[number];
    const MapTask& task = prepared_.task;
    if (obstructions_.empty()) obstructions_ = obstructions_of(task.obstacles, task.bodies, task.table);
    const Point origin = obstacle.frame == SceneFrame::table ? task.linkage.pole() : Point(Point::Zero());
    const std::vector<Point> corners = ring_corners(obstructions_[obstacle.number].shape, origin);
    const Image& image = image_of(times);
    return {times, number, enough,
            nearest({times == 1.0 ? prepared_.region : image.edges, image.ring_corners},
                    {obstacle.edges, corners}, enough)};
  }

  /// Without edges where it is the region itself.
  const Image& image_of(Complex times) {
    for (const Image& known : images_)
      if (known.times == times) return known;
    const Point& pole = prepared_.task.linkage.pole();
    const Region region = similar_image(prepared_.task.region, times, pole);
    return images_.emplace_back(
        Image{times, times == 1.0 ? EdgeTree() : EdgeTree(region, pole), ring_corners(region, pole)});
  }

  const PreparedTask& prepared_;
  std::vector<Image> images_;
  std::vector<Known> known_;
  std::vector<Obstruction> obstructions_;  // made where the first is asked for
};

}  // namespace

CopyContacts copy_contacts(const PreparedTask& prepared, const Encounters& encounters, double below,
                           double alike, const StopFlag& stop) {
  const ContactScene& scene = prepared.scene;
  const CopyingLinkage& linkage = prepared.task.linkage;
  CopyContacts contacts;
  Nearness nearness(prepared);
  double named = below;
  for (const Encounter& between : encounters.pairs) {
    const ScenePiece& piece = scene.pieces[between.piece];
    const SceneObstacle& obstacle = scene.obstacles[between.obstacle];
    const auto times = times_the_tracers(piece, obstacle.frame, linkage);
    if (!times || stop()) {
      contacts.others.add(between, obstacle.frame);
      continue;
    }
    const double around = piece.half_width + obstacle.grown;
    const double least = contacts.smallest ? contacts.smallest->gap : below;
    const auto& found = nearness.of(*times, between.obstacle, least + around);
    if (!found || found->first - around >= least) continue;
    const double gap = found->first - around;
    if (!contacts.smallest || gap < named - alike) {
      contacts.smallest =
          PointGap{gap, between, linkage.pole() + as_point(as_complex(found->second) / *times)};
      named = gap;
    }
    contacts.smallest->gap = gap;
  }
  return contacts;
}

}  // namespace kempe
