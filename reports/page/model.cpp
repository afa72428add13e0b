#include "reports/page/model.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/pictures/mechanism_picture.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/obstacle_names.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

Json point(const Point& at) { return Json::array({at.x(), at.y()}); }
Json complex(Complex z) { return Json::array({z.real(), z.imag()}); }
Json interval(const OpeningInterval& openings) { return Json::array({openings.lower, openings.upper}); }

/// Corners at least `detail` apart, rounded to a thousandth of a millimetre.
Json ring(const Ring& corners, double detail) {
  Json points = Json::array();
  for (const Point& at : thinned(corners, detail))
    points.push_back({std::round(at.x() * 1000) / 1000, std::round(at.y() * 1000) / 1000});
  return points;
}

Json rings(const Polygon& polygon, double detail) {
  Json all = Json::array({ring(polygon.outer, detail)});
  for (const Ring& hole : polygon.holes) all.push_back(ring(hole, detail));
  return all;
}

Json parts(const Design& design, const std::vector<Part>& of_linkage) {
  Json all = Json::array();
  for (const Part& part : of_linkage) {
    Json pieces = Json::array();
    for (const JointHull& hull : axis_of(part, design.linkage.shape(), design.style.plate)) {
      Json joints = Json::array();
      for (int i = 0; i < hull.count; ++i)
        joints.push_back(static_cast<int>(hull.joints[static_cast<std::size_t>(i)]));
      pieces.push_back(joints);
    }
    all.push_back({{"name", name(part)},
                   {"is_link", part.kind == Part::Kind::link},
                   {"layers", {part.lowest_layer, part.highest_layer}},
                   {"half_width", half_width(part, design.style)},
                   {"pieces", pieces}});
  }
  return all;
}

/// Pairs that may touch, as indices into the parts.
Json pairs(const Design& design, const std::vector<Part>& of_linkage) {
  const auto index = [&](const Part& part) {
    return std::find(of_linkage.begin(), of_linkage.end(), part) - of_linkage.begin();
  };
  Json all = Json::array();
  for (const ContactPair& pair : contact_pairs(design.linkage, design.layers))
    all.push_back({index(pair.first), index(pair.second)});
  return all;
}

/// How each link is drawn: the joints along its body, from the lowest layer upward.
Json bodies(const LayerAssignment& layers, const LinkStyle& style) {
  std::array<Link, 4> upward = all_links;
  std::stable_sort(upward.begin(), upward.end(), [&](Link a, Link b) { return layers[a] < layers[b]; });
  Json all = Json::array();
  for (const Link link : upward) {
    Json line = Json::array();
    for (const Joint joint : body_line(link)) line.push_back(static_cast<int>(joint));
    all.push_back({{"name", "link " + std::string(name(link))},
                   {"layer", layers.rank(link)},
                   {"line", line},
                   {"filled", style.plate == PlateStyle::triangle && line.size() == 3}});
  }
  return all;
}

Json obstacles(const Design& design, double detail) {
  Json all = Json::array();
  for (std::size_t i = 0; i < design.obstacles.size(); ++i) {
    const Obstacle& obstacle = design.obstacles[i];
    all.push_back({{"name", obstacle_name(design.obstacles, i)},
                   {"layers", {obstacle.lowest_layer, obstacle.highest_layer}},
                   {"rings", rings(obstacle.shape, detail)}});
  }
  return all;
}

/// Left, top, right, bottom, y upward.
Json box(const PictureBox& one) {
  return {one.lower().x(), one.upper().y(), one.upper().x(), one.lower().y()};
}

/// Bodies, the table's edge, and what one body's point must keep clear of for another's sake (obstructions.hpp): polygons in
/// the frame of a joint or of the table, and which parts may meet them.
Json other_obstructions(const Design& design, const std::vector<Part>& of_linkage, double detail) {
  const std::vector<Obstruction> all = obstructions_of(design.obstacles, design.bodies, design.table);
  Json others = Json::array();
  for (std::size_t i = design.obstacles.size(); i < all.size(); ++i) {
    const Obstruction& one = all[i];
    Json polygons = Json::array(), parts = Json::array();
    for (const Polygon& polygon : one.shape.polygons) polygons.push_back(rings(polygon, detail));
    for (std::size_t part = 0; part < of_linkage.size(); ++part)
      if (may_meet(of_linkage[part], one, design.linkage)) parts.push_back(part);
    const auto joint = [&](Carrier carrier) { return static_cast<int>(joint_of(carrier, design.linkage)); };
    others.push_back({{"name", one.name},
                      {"frame", one.frame ? Json(joint(*one.frame)) : Json(nullptr)},
                      {"grown", one.grown},
                      {"polygons", polygons},
                      {"parts", parts}});
    if (one.turns_with)
      others.back()["toward"] = static_cast<int>(nearest_to_end(*one.turns_with, design.linkage.shape()));
    for (const std::size_t body : one.turning) others.back()["turning"].push_back(body);
    if (one.met) others.back()["met"] = {{"joint", joint(one.met->by)}, {"name", one.met->name}};
  }
  return others;
}

/// The bodies' names, in their order.
Json carried(const Design& design) {
  Json names = Json::array();
  for (std::size_t i = 0; i < design.bodies.size(); ++i) names.push_back(body_name(design.bodies, i));
  return names;
}

/// Of each body that turns with a link, else null: the joint that carries it, that to which its x axis runs, and its pieces.
Json turning(const Design& design) {
  Json all = Json::array();
  for (std::size_t i = 0; i < design.bodies.size(); ++i) {
    const Body& body = design.bodies[i];
    if (!body.turns_with) {
      all.push_back(nullptr);
      continue;
    }
    const BodyPieces covered = pieces_of(body);
    Json pieces = Json::array();
    for (const ConvexPart& piece : covered.pieces) {
      Json corners = Json::array();
      for (const Complex& corner : piece) corners.push_back(complex(corner));
      pieces.push_back(corners);
    }
    all.push_back({{"name", body_name(design.bodies, i)},
                   {"half_width", covered.grown},
                   {"joint", static_cast<int>(joint_of(body.at, design.linkage))},
                   {"toward", static_cast<int>(nearest_to_end(*body.turns_with, design.linkage.shape()))},
                   {"places", pieces}});
  }
  return all;
}

/// [opening, worst, rss] over the assembly mode but for its ends, where the error grows beyond all bounds.
Json copy_errors(const Design& design) {
  Json rows = Json::array();
  if (!design.tolerance) return rows;
  const CopyErrorProfile profile =
      copy_error_profile(design.linkage, CopyTolerance::uniform(*design.tolerance));
  const OpeningInterval openings = shrink(design.linkage.assembly_mode().openings, radians(2));
  constexpr int steps = 240;
  for (int i = 0; i <= steps && !openings.empty(); ++i) {
    const double opening = openings.lower + openings.width() * i / steps;
    const CopyErrorAt error = profile.at(opening);
    if (std::isfinite(error.worst) && std::isfinite(error.rss))
      rows.push_back({opening, error.worst, error.rss});
  }
  return rows;
}

/// What the kinematics need.
Json linkage_fields(const CopyingLinkage& linkage) {
  return {{"k", complex(linkage.k())},
          {"s", complex(linkage.shape())},
          {"vertex", name(linkage.grounding())},
          {"VA", linkage.VA()},
          {"VB", linkage.VB()},
          {"pole", point(linkage.pole())},
          {"assembly", interval(linkage.assembly_mode().openings)},
          {"joints",
           {{"pole", static_cast<int>(linkage.pole_joint())},
            {"tracer", static_cast<int>(linkage.tracer_joint())},
            {"pen", static_cast<int>(linkage.pen_joint())}}}};
}

}  // namespace

std::string linkage_model(const CopyingLinkage& linkage, const LayerAssignment& layers,
                          const LinkStyle& style) {
  Json model = linkage_fields(linkage);
  model["width"] = style.width;
  model["pin_radius"] = style.pin_diameter / 2;
  model["bodies"] = bodies(layers, style);
  return model.dump();
}

std::string report_model(const Design& design, const MapPicture& picture) {
  const CopyingLinkage& linkage = design.linkage;
  const std::vector<Part> of_linkage = parts_of(linkage, design.layers);
  const PictureView& view = picture.view;
  const double detail = picture.detail;
  Json region = Json::array();
  for (const Polygon& polygon : design.region.polygons)
    for (const Json& one : rings(polygon, detail)) region.push_back(one);
  Json model = linkage_fields(linkage);
  const Json rest = {{"transmission", design.limits.transmission},
                     {"clearance", design.limits.clearance},
                     {"width", design.style.width},
                     {"pin_radius", design.style.pin_diameter / 2},
                     {"bodies", bodies(design.layers, design.style)},
                     {"parts", parts(design, of_linkage)},
                     {"pairs", pairs(design, of_linkage)},
                     {"obstacles", obstacles(design, detail)},
                     {"copy_errors", copy_errors(design)},
                     {"region", region},
                     {"tracer", point(picture.tracer)},
                     {"view",
                      {{"left", view.left},
                       {"top", view.top},
                       {"width", view.width},
                       {"height", view.height},
                       {"unit", view.unit}}},
                     {"job", box(picture.job)},
                     {"whole", box(picture.whole)}};
  model.update(rest);
  if (!design.bodies.empty() || design.table) {
    model["others"] = other_obstructions(design, of_linkage, detail);
    model["carried"] = carried(design);
    model["turning"] = turning(design);
  }
  return model.dump();
}

}  // namespace kempe
