#include <fmt/format.h>

#include <cmath>

#include "reports/data/stored/parts.hpp"
#include "reports/data/stored/values.hpp"
#include "specs/hardware.hpp"

namespace kempe::stored {
namespace {

OpeningInterval opening(const JsonField& field) {
  const auto ends = field.elements(2, 2);
  if (ends.size() != 2) return {};
  const OpeningInterval result{radians(ends[0].number(-180, 180)), radians(ends[1].number(-180, 180))};
  if (result.empty()) field.refuse("[lower, upper] with lower <= upper, degrees");
  return result;
}

LinkLengths lengths(const JsonField& field) {
  const auto at = [&](std::size_t i) { return length(field[LinkLengths::names[i]]); };
  return {
      .VA = at(0), .VB = at(1), .AC = at(2), .BC = at(3), .AX = at(4), .CX = at(5), .BY = at(6), .CY = at(7)};
}

LoopSides loop_sides(const JsonField& field) {
  const auto side = [](const JsonField& one) { return static_cast<Side>(one.integer(-1, 1)); };
  const LoopSides result{side(field["parallelogram"]), side(field["plate_ACX"]), side(field["plate_BCY"])};
  if (result.parallelogram == Side::on_line) field["parallelogram"].refuse("1 or -1");
  return result;
}

void require_joint(const JsonField& field, Joint expected) {
  if (joint(field) != expected) field.refuse(fmt::format("\"{}\" with this vertex", letter(expected)));
}

void require_roles(const JsonField& field, const JointRoles& roles) {
  require_joint(field["pole"], roles.pole);
  require_joint(field["tracer"], roles.tracer);
  require_joint(field["pen"], roles.pen);
}

DrawnMechanism drawn_mechanism(const JsonField& field, const JointRoles& roles) {
  return {.lengths = lengths(field["lengths_mm"]),
          .sides = loop_sides(field["orientation"]),
          .pole = roles.pole,
          .tracer = roles.tracer,
          .pen = roles.pen,
          .pole_position = point(field["pole_position_mm"]),
          .opening = field["opening_deg"].is_null() ? OpeningInterval{} : opening(field["opening_deg"])};
}

/// The link's layer; its name and joints must be those of the mechanism.
void read_link(const JsonField& field, Link expected, StoredDesign& design) {
  const LinkJoints joints = joints_of(expected);
  if (field["name"].text() != name(expected)) field["name"].refuse(fmt::format("\"{}\"", name(expected)));
  const auto count = static_cast<std::size_t>(joints.count);
  const auto stored = field["joints"].elements(count, count);
  for (std::size_t i = 0; i < stored.size(); ++i)
    if (joint(stored[i]) != joints.joints[i])
      stored[i].refuse(fmt::format("\"{}\"", letter(joints.joints[i])));
  design.layers.of[static_cast<std::size_t>(expected)] = static_cast<int>(field["layer"].integer(1, 100));
  if (joints.count == 2 && field["shape"].text() != "bar") field["shape"].refuse("\"bar\"");
  if (joints.count == 3) {
    const PlateStyle plate =
        one_of<PlateStyle>(field["shape"], {{"bent", PlateStyle::bent}, {"triangle", PlateStyle::triangle}});
    if (expected == Link::BCY && plate != design.style.plate)
      field["shape"].refuse("the shape of plate ACX: both are made alike");
    design.style.plate = plate;
  }
}

void read_links(const JsonField& field, StoredDesign& design) {
  const auto links = field.elements(all_links.size(), all_links.size());
  for (std::size_t i = 0; i < links.size(); ++i) read_link(links[i], all_links[i], design);
}

std::string hardware_name(const JsonField& field) {
  std::string name = field.text();
  if (hardware_named(name) == nullptr) field.refuse("a name of docs/hardware.md");
  return name;
}

/// A name, or an object of names by joint.
JointHardware joint_hardware(const JsonField& field) {
  if (!field.is_object()) return hardware_name(field);
  JointHardware hardware;
  if (const auto every = field.find("default")) hardware.every = hardware_name(*every);
  for (const Joint joint : all_joints)
    if (const auto own = field.find(std::string(1, letter(joint))))
      hardware.at[static_cast<std::size_t>(joint)] = hardware_name(*own);
  return hardware;
}

}  // namespace

void read_mechanism(const JsonField& field, StoredDesign& design) {
  const std::size_t before = field.faults();
  design.grounding = grounding(field["vertex"]);
  const JointRoles roles = roles_of(design.grounding);
  if (field.faults() == before) require_roles(field, roles);
  design.mechanism = drawn_mechanism(field, roles);
  if (const auto assembly_mode = field.find("assembly"))
    design.assembly_mode = static_cast<int>(assembly_mode->integer(0, 3));
  const auto [real, imaginary] = field["shape"].pair();
  design.shape = {real, imaginary};
  read_links(field["links"], design);
  design.style.width = length(field["link_width_mm"]);
  design.style.pin_diameter = length(field["pin_diameter_mm"]);
  if (const auto hardware = field.find("hardware")) design.hardware = joint_hardware(*hardware);
  design.style.thickness = length(field["thickness_mm"]);
}

void read_copy(const JsonField& field, StoredDesign& design) {
  design.scale = field["scale"].positive();
  design.rotation = radians(field["rotation_deg"].number(-360, 360));
  design.k = copy_ratio(design.scale, design.rotation);
  if (std::abs(design.k - 1.0) < 1e-12)
    field.refuse("a ratio other than 1 without rotation, which is no similarity with a pole");
  if (!field.find("wanted_scale") && !field.find("wanted_rotation_deg")) return;
  design.wanted =
      WantedCopy{field["wanted_scale"].positive(), radians(field["wanted_rotation_deg"].number(-3600, 3600)),
                 field["ratio_error"].number(0, largest_coordinate)};
}

}  // namespace kempe::stored
