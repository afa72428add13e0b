#include "workspace/contact/copy_contact.hpp"

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

/// The region as a place of tracer or pen goes over it, seen in a frame.
struct Image {
  Complex times;
  Point origin;  ///< where the pole is
  Region region;
  Box box;

  /// The tracer's place from a point of the image.
  Point tracer_at(const Point& point, const Point& pole) const {
    return pole + as_point(as_complex(point - origin) / times);
  }
};

/// Each made once.
class Images {
 public:
  explicit Images(const MapTask& task) : task_(task) {
    for (const Polygon& polygon : task.region.polygons) {
      Polygon& moved = from_pole_.polygons.emplace_back(polygon);
      const auto shift = [&](Ring& ring) {
        for (Point& corner : ring) corner -= task.linkage.pole();
      };
      shift(moved.outer);
      for (Ring& hole : moved.holes) shift(hole);
    }
  }

  const Image& of(Complex times, SceneFrame frame) {
    const Point origin = frame == SceneFrame::table ? task_.linkage.pole() : Point(Point::Zero());
    for (const Image& known : images_)
      if (known.times == times && known.origin == origin) return known;
    Region region = frame == SceneFrame::table ? similar_image(task_.region, times, origin)
                                               : similar_image(from_pole_, times, origin);
    const Box box = bounding_box(region);
    return images_.emplace_back(Image{times, origin, std::move(region), box});
  }

 private:
  const MapTask& task_;
  Region from_pole_;
  std::vector<Image> images_;
};

}  // namespace

CopyContacts copy_contacts(const MapTask& task, const ContactScene& scene, const Encounters& encounters,
                           double below) {
  CopyContacts contacts;
  Images images(task);
  std::vector<Obstruction> obstructions;  // made where the first is asked for
  for (const Encounter& between : encounters.pairs) {
    const ScenePiece& piece = scene.pieces[between.piece];
    const SceneObstacle& obstacle = scene.obstacles[between.obstacle];
    const auto times = times_the_tracers(piece, obstacle.frame, task.linkage);
    if (!times) {
      contacts.others.add(between, obstacle.frame);
      continue;
    }
    if (obstructions.empty()) obstructions = obstructions_of(task.obstacles, task.bodies, task.table);
    const Region& shape = obstructions[obstacle.number].shape;
    const Image& image = images.of(*times, obstacle.frame);
    const double around = piece.half_width + obstacle.grown;
    const double least = contacts.smallest ? contacts.smallest->gap : below;
    if (distance(image.box, bounding_box(shape)) - around >= least) continue;
    const auto nearest = nearest_places(image.region, shape);
    if (const double gap = nearest->distance - around; gap < least)
      contacts.smallest = CopyGap{gap, between, image.tracer_at(nearest->on_one, task.linkage.pole())};
  }
  return contacts;
}

}  // namespace kempe
