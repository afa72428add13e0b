#include "reports/drawings/step_writer.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string_view>

#include "geometry/fixed_text.hpp"

namespace kempe {
namespace {

using Point3 = Eigen::Vector3d;

constexpr double accuracy = 1e-7;  // mm, as the file states it

Point3 at_height(const Point& at, double z) { return {at.x(), at.y(), z}; }
const Point3 up = Point3::UnitZ();

/// A length, mm, a hundred times as exact as the file's accuracy.
constexpr int decimals_of_lengths = 9;
/// A share of a direction: so that a point 10 km away stays within the accuracy.
constexpr int decimals_of_directions = 15;

std::string real(double value, int with = decimals_of_lengths) {
  std::string text = short_text(value, with);
  if (text.find('.') == std::string::npos) text += '.';
  return text;
}

std::string triple(const Point3& of, int with) {
  return fmt::format("({},{},{})", real(of.x(), with), real(of.y(), with), real(of.z(), with));
}

/// A STEP string: quotes and backslashes are doubled, what is not printable ASCII becomes '_'.
std::string step_string(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += c;
    out += c >= ' ' && c <= '~' ? c : '_';
  }
  return out + "'";
}

/// An entity of the file by its number.
struct Entity {
  int number = 0;
};

std::string list(const std::vector<Entity>& entities) {
  std::string out = "(";
  for (const Entity& one : entities)
    fmt::format_to(std::back_inserter(out), "{}#{}", out.size() > 1 ? "," : "", one.number);
  return out + ")";
}

/// The data section, one entity after the other.
class Entities {
 public:
  template <class... Values>
  Entity add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), "#{}=", ++count_);
    fmt::format_to(std::back_inserter(out_), format, std::forward<Values>(values)...);
    out_ += ";\n";
    return {count_};
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
  int count_ = 0;
};

}  // namespace
}  // namespace kempe

template <>
struct fmt::formatter<kempe::Entity> {
  constexpr auto parse(format_parse_context& context) { return context.begin(); }
  auto format(const kempe::Entity& entity, format_context& context) const {
    return fmt::format_to(context.out(), "#{}", entity.number);
  }
};

namespace kempe {
namespace {

Entity point(Entities& to, const Point3& at) {
  return to.add("CARTESIAN_POINT('',{})", triple(at, decimals_of_lengths));
}
Entity direction(Entities& to, const Point3& along) {
  return to.add("DIRECTION('',{})", triple(along, decimals_of_directions));
}

/// A frame: its origin, z axis and x axis.
Entity placement(Entities& to, const Point3& at, const Point3& z, const Point3& x) {
  const Entity origin = point(to, at), axis = direction(to, z), across = direction(to, x);
  return to.add("AXIS2_PLACEMENT_3D('',{},{},{})", origin, axis, across);
}

/// A corner with the entity that stands for it.
struct Vertex {
  Point3 at;
  Entity entity;
};
Vertex vertex(Entities& to, const Point3& at) {
  const Entity where = point(to, at);
  return {at, to.add("VERTEX_POINT('',{})", where)};
}

/// From one corner to the other, straight.
Entity line(Entities& to, const Vertex& from, const Vertex& end) {
  const Entity start = point(to, from.at), along = direction(to, (end.at - from.at).normalized());
  const Entity vector = to.add("VECTOR('',{},1.)", along), curve = to.add("LINE('',{},{})", start, vector);
  return to.add("EDGE_CURVE('',{},{},{},.T.)", from.entity, end.entity, curve);
}

/// From one corner to the other on a circle, counter-clockwise about `axis`.
Entity arc(Entities& to, const Vertex& from, const Vertex& end, const Point3& centre, double radius,
           const Point3& axis) {
  const Entity frame = placement(to, centre, axis, (from.at - centre).normalized());
  const Entity curve = to.add("CIRCLE('',{},{})", frame, real(radius));
  return to.add("EDGE_CURVE('',{},{},{},.T.)", from.entity, end.entity, curve);
}

/// An edge as a boundary runs along it: as it was made, or back.
struct Run {
  Entity edge;
  bool forward;
};
Entity loop(Entities& to, const std::vector<Run>& runs) {
  std::vector<Entity> oriented;
  for (const Run& run : runs)
    oriented.push_back(to.add("ORIENTED_EDGE('',*,*,{},{})", run.edge, run.forward ? ".T." : ".F."));
  return to.add("EDGE_LOOP('',{})", list(oriented));
}

/// A face between loops, the first one its outer bound: seen from outside, material lies to the left of each. `outward`: whether the
/// surface's own normal looks out of the material.
Entity face(Entities& to, Entity surface, const std::vector<Entity>& loops, bool outward = true) {
  std::vector<Entity> bounds;
  for (const Entity& one : loops)
    bounds.push_back(to.add("{}('',{},.T.)", bounds.empty() ? "FACE_OUTER_BOUND" : "FACE_BOUND", one));
  return to.add("ADVANCED_FACE('',{},{},{})", list(bounds), surface, outward ? ".T." : ".F.");
}

/// An upright solid under construction: its walls, and the loops that bottom and top have from them.
class Prism {
 public:
  Prism(Entities& to, double bottom, double top) : to_(to), bottom_(bottom), top_(top) {}

  /// A round wall, solid inside (a pin) or outside (a hole); one face with a seam. The first wall is the outer one.
  void add_round(const Point& centre, double radius, bool is_hole) {
    const Point3 low = at_height(centre, bottom_), high = at_height(centre, top_),
                 out = radius * Point3::UnitX();
    const Vertex below = vertex(to_, low + out), above = vertex(to_, high + out);
    const Entity foot = arc(to_, below, below, low, radius, up),
                 head = arc(to_, above, above, high, radius, up);
    const Entity seam = line(to_, below, above);
    const Entity bound = loop(to_, {{foot, !is_hole}, {seam, true}, {head, is_hole}, {seam, false}});
    faces_.push_back(face(to_, cylinder(low, radius), {bound}, !is_hole));
    bottom_loops_.push_back(loop(to_, {{foot, is_hole}}));
    top_loops_.push_back(loop(to_, {{head, !is_hole}}));
  }

  /// The walls over an outline, counter-clockwise.
  void add_outline(const ArcRing& ring) {
    const std::size_t n = ring.size();
    std::vector<Vertex> low, high;
    for (const ArcVertex& corner : ring) {
      low.push_back(vertex(to_, at_height(corner.at, bottom_)));
      high.push_back(vertex(to_, at_height(corner.at, top_)));
    }
    std::vector<Entity> posts;
    for (std::size_t i = 0; i < n; ++i) posts.push_back(line(to_, low[i], high[i]));
    std::vector<Run> foot, head;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      const Wall wall = between(ring[i], ring[next], {low[i], low[next]}, {high[i], high[next]});
      const Entity bound =
          loop(to_, {{wall.foot, true}, {posts[next], true}, {wall.head, false}, {posts[i], false}});
      faces_.push_back(face(to_, wall.surface, {bound}, wall.outward));
      foot.insert(foot.begin(), {wall.foot, false});
      head.push_back({wall.head, true});
    }
    bottom_loops_.push_back(loop(to_, foot));
    top_loops_.push_back(loop(to_, head));
  }

  Entity solid() {
    faces_.push_back(face(to_, plane({0, 0, bottom_}, -up, Point3::UnitX()), bottom_loops_));
    faces_.push_back(face(to_, plane({0, 0, top_}, up, Point3::UnitX()), top_loops_));
    const Entity shell = to_.add("CLOSED_SHELL('',{})", list(faces_));
    return to_.add("MANIFOLD_SOLID_BREP('',{})", shell);
  }

 private:
  struct Wall {
    Entity foot, head, surface;
    bool outward = true;
  };
  struct Ends {
    const Vertex &from, &to;
  };

  Wall between(const ArcVertex& from, const ArcVertex& to, const Ends& low, const Ends& high) {
    const double bulge = from.bulge;
    const Point chord = to.at - from.at, left(-chord.y(), chord.x());
    if (bulge == 0)
      return {line(to_, low.from, low.to), line(to_, high.from, high.to),
              plane(low.from.at, at_height(-left.normalized(), 0), at_height(chord.normalized(), 0))};
    const Point centre = 0.5 * (from.at + to.at) + left * ((1 - bulge * bulge) / (4 * bulge));
    const double radius = (from.at - centre).norm();
    const Point3 axis = bulge > 0 ? up : Point3(-up);
    return {arc(to_, low.from, low.to, at_height(centre, bottom_), radius, axis),
            arc(to_, high.from, high.to, at_height(centre, top_), radius, axis),
            cylinder(at_height(centre, bottom_), radius), bulge > 0};
  }

  Entity plane(const Point3& at, const Point3& normal, const Point3& across) {
    const Entity frame = placement(to_, at, normal, across);
    return to_.add("PLANE('',{})", frame);
  }
  Entity cylinder(const Point3& at, double radius) {
    const Entity frame = placement(to_, at, up, Point3::UnitX());
    return to_.add("CYLINDRICAL_SURFACE('',{},{})", frame, real(radius));
  }

  Entities& to_;
  double bottom_, top_;
  std::vector<Entity> faces_, bottom_loops_, top_loops_;
};

/// The outline without corners that the file cannot tell from the one before.
ArcRing told_apart(const ArcRing& ring) {
  ArcRing out;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if ((ring[(i + 1) % ring.size()].at - ring[i].at).norm() > accuracy) out.push_back(ring[i]);
  return out;
}

std::optional<std::string> fault_of(const std::string& name, double bottom, double top) {
  if (!(top - bottom > accuracy) || !std::isfinite(top - bottom))
    return fmt::format("{} would reach from {:.6g} to {:.6g} mm above the table", name, bottom, top);
  return {};
}

std::optional<std::string> fault_of(const std::string& name, const Point& centre, double diameter) {
  if (diameter > accuracy && std::isfinite(diameter) && centre.allFinite()) return {};
  return fmt::format("{} has a round of {:.6g} mm at {:.6g}, {:.6g}", name, diameter, centre.x(), centre.y());
}

std::optional<std::string> fault_of(const StepPlate& plate) {
  if (auto fault = fault_of(plate.name, plate.bottom, plate.top)) return fault;
  for (const StepPlate::Hole& hole : plate.holes)
    if (auto fault = fault_of(plate.name, hole.centre, hole.diameter)) return fault;
  for (const ArcVertex& corner : plate.outline)
    if (!corner.at.allFinite() || !std::isfinite(corner.bulge))
      return plate.name + " has a corner that is no place";
  if (told_apart(plate.outline).size() < 2) return plate.name + " has no outline";
  return {};
}

std::optional<std::string> fault_of(const StepParts& parts) {
  for (const StepPlate& plate : parts.plates)
    if (auto fault = fault_of(plate)) return fault;
  for (const StepCylinder& one : parts.cylinders) {
    if (auto fault = fault_of(one.name, one.bottom, one.top)) return fault;
    if (auto fault = fault_of(one.name, one.centre, one.diameter)) return fault;
  }
  return {};
}

Entity solid(Entities& to, const StepPlate& plate) {
  Prism prism(to, plate.bottom, plate.top);
  prism.add_outline(told_apart(plate.outline));
  for (const StepPlate::Hole& hole : plate.holes) prism.add_round(hole.centre, 0.5 * hole.diameter, true);
  return prism.solid();
}

Entity solid(Entities& to, const StepCylinder& cylinder) {
  Prism prism(to, cylinder.bottom, cylinder.top);
  prism.add_round(cylinder.centre, 0.5 * cylinder.diameter, false);
  return prism.solid();
}

/// A product with its shape: what an assembly is made of, and the assembly.
struct Product {
  Entity definition, shape;
};

/// One assembly and its parts, as AP214 has them.
class Assembly {
 public:
  explicit Assembly(std::string name) : name_(std::move(name)) {
    const Entity application =
        to_.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
    to_.add("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{})",
            application);
    of_products_ = to_.add("PRODUCT_CONTEXT('',{},'mechanical')", application);
    of_definitions_ = to_.add("PRODUCT_DEFINITION_CONTEXT('part definition',{},'design')", application);
    const Entity length = to_.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const Entity angle = to_.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const Entity solid_angle = to_.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const Entity within =
        to_.add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),{},'distance_accuracy_value','')",
                real(accuracy), length);
    space_ = to_.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({}))"
        "GLOBAL_UNIT_ASSIGNED_CONTEXT(({},{},{}))REPRESENTATION_CONTEXT('',''))",
        within, length, angle, solid_angle);
    frame_ = placement(to_, Point3::Zero(), up, Point3::UnitX());
  }

  template <class Part>
  void add(const Part& part) {
    const Entity brep = solid(to_, part);
    const Entity shape = to_.add("ADVANCED_BREP_SHAPE_REPRESENTATION('',({},{}),{})", frame_, brep, space_);
    parts_.push_back({part.name, product(part.name, shape)});
  }

  /// The whole file; call it once, after all parts.
  std::string take() {
    const Entity shape = to_.add("SHAPE_REPRESENTATION('',({}),{})", frame_, space_);
    const Product whole = product(name_, shape);
    int number = 0;
    for (const Named& part : parts_) {
      const Entity use = to_.add("NEXT_ASSEMBLY_USAGE_OCCURRENCE('{}',{},'',{},{},$)", ++number,
                                 step_string(part.name), whole.definition, part.product.definition);
      const Entity use_shape = to_.add("PRODUCT_DEFINITION_SHAPE('','',{})", use);
      // Each part is drawn where it lies: its frame is the assembly's.
      const Entity moved = to_.add("ITEM_DEFINED_TRANSFORMATION('','',{0},{0})", frame_);
      const Entity related = to_.add(
          "(REPRESENTATION_RELATIONSHIP('','',{},{})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({})"
          "SHAPE_REPRESENTATION_RELATIONSHIP())",
          part.product.shape, whole.shape, moved);
      to_.add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({},{})", related, use_shape);
    }
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((" + step_string(name_) +
           "),'2;1');\nFILE_NAME('assembly.step','2000-01-01T00:00:00',(''),(''),'Kempe','Kempe','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
           to_.take() + "ENDSEC;\nEND-ISO-10303-21;\n";
  }

 private:
  struct Named {
    std::string name;
    Product product;
  };

  Product product(const std::string& name, Entity shape) {
    const Entity product = to_.add("PRODUCT({0},{0},'',({1}))", step_string(name), of_products_);
    to_.add("PRODUCT_RELATED_PRODUCT_CATEGORY('part','',({}))", product);
    const Entity version = to_.add("PRODUCT_DEFINITION_FORMATION('','',{})", product);
    const Entity definition = to_.add("PRODUCT_DEFINITION('design','',{},{})", version, of_definitions_);
    const Entity defined = to_.add("PRODUCT_DEFINITION_SHAPE('','',{})", definition);
    to_.add("SHAPE_DEFINITION_REPRESENTATION({},{})", defined, shape);
    return {definition, shape};
  }

  Entities to_;
  std::string name_;
  Entity of_products_, of_definitions_, space_, frame_;
  std::vector<Named> parts_;
};

}  // namespace

tl::expected<std::string, std::string> step_text(const StepParts& parts) {
  if (auto fault = fault_of(parts)) return tl::unexpected(std::move(*fault));
  Assembly assembly(parts.name);
  for (const StepPlate& plate : parts.plates) assembly.add(plate);
  for (const StepCylinder& cylinder : parts.cylinders) assembly.add(cylinder);
  return assembly.take();
}

}  // namespace kempe
