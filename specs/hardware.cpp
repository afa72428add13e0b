// Sizes from the standards named in the header, as manufacturers' tables give them. Shoulder screws whose shoulder the trade
// and the standard make differently (M5: 6 and 6.5 mm, M10: 12 and 13 mm) are left out.
#include "specs/hardware.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "kinematics/grounding.hpp"

namespace kempe {
namespace {

using enum HardwareKind;

constexpr ThreadSizes threads[] = {
    {"M3", 3, 0.5, 2.4, 6.01, 0.5, 7, 3, 5.5, 5, 30},
    {"M4", 4, 0.7, 3.2, 7.66, 0.8, 9, 4, 7, 6, 40},
    {"M5", 5, 0.8, 4.7, 8.79, 1, 10, 5, 8.5, 8, 50},
    {"M6", 6, 1, 5.2, 11.05, 1.6, 12, 6, 10, 10, 60},
    {"M8", 8, 1.25, 6.8, 14.38, 1.6, 16, 8, 13, 12, 80},
    {"M10", 10, 1.5, 8.4, 17.77, 2, 20, 10, 16, 16, 100},
    {"M12", 12, 1.75, 10.8, 20.03, 2.5, 24, 12, 18, 20, 120},
    {"M16", 16, 2, 14.8, 26.75, 3, 30, 16, 24, 25, 160},  // its washers fill up shoulders of 16 mm
};

constexpr Hardware named_hardware[] = {
    {.name = "M3 bolt", .kind = bolt, .pin = 3, .thread = "M3"},
    {.name = "M4 bolt", .kind = bolt, .pin = 4, .thread = "M4"},
    {.name = "M5 bolt", .kind = bolt, .pin = 5, .thread = "M5"},
    {.name = "M6 bolt", .kind = bolt, .pin = 6, .thread = "M6"},
    {.name = "M8 bolt", .kind = bolt, .pin = 8, .thread = "M8"},
    {.name = "M10 bolt", .kind = bolt, .pin = 10, .thread = "M10"},
    {.name = "M12 bolt", .kind = bolt, .pin = 12, .thread = "M12"},
    {"M6 shoulder bolt", shoulder_screw, 8, 0, 0, "M6", 5.5, 13, 16, 100, 11.25},
    {"M8 shoulder bolt", shoulder_screw, 10, 0, 0, "M8", 7, 16, 16, 100, 13.25},
    {"M12 shoulder bolt", shoulder_screw, 16, 0, 0, "M12", 11, 24, 25, 100, 18.4},
    {.name = "623 bearing", .kind = bearing, .pin = 3, .seat = 10, .seat_width = 4, .thread = "M3"},
    {.name = "624 bearing", .kind = bearing, .pin = 4, .seat = 13, .seat_width = 5, .thread = "M4"},
    {.name = "625 bearing", .kind = bearing, .pin = 5, .seat = 16, .seat_width = 5, .thread = "M5"},
    {.name = "626 bearing", .kind = bearing, .pin = 6, .seat = 19, .seat_width = 6, .thread = "M6"},
    {.name = "608 bearing", .kind = bearing, .pin = 8, .seat = 22, .seat_width = 7, .thread = "M8"},
    {.name = "6000 bearing", .kind = bearing, .pin = 10, .seat = 26, .seat_width = 8, .thread = "M10"},
    {.name = "3 mm dowel", .kind = dowel, .pin = 3, .shortest = 8, .longest = 30},
    {.name = "4 mm dowel", .kind = dowel, .pin = 4, .shortest = 10, .longest = 40},
    {.name = "5 mm dowel", .kind = dowel, .pin = 5, .shortest = 12, .longest = 50},
    {.name = "6 mm dowel", .kind = dowel, .pin = 6, .shortest = 14, .longest = 60},
    {.name = "8 mm dowel", .kind = dowel, .pin = 8, .shortest = 18, .longest = 80},
    {.name = "10 mm dowel", .kind = dowel, .pin = 10, .shortest = 22, .longest = 100},
    {.name = "3 mm dowel and bush", .kind = bush, .pin = 3, .seat = 4.5, .shortest = 8, .longest = 30},
    {.name = "4 mm dowel and bush", .kind = bush, .pin = 4, .seat = 5.5, .shortest = 10, .longest = 40},
    {.name = "5 mm dowel and bush", .kind = bush, .pin = 5, .seat = 7, .shortest = 12, .longest = 50},
    {.name = "6 mm dowel and bush", .kind = bush, .pin = 6, .seat = 8, .shortest = 14, .longest = 60},
    {.name = "8 mm dowel and bush", .kind = bush, .pin = 8, .seat = 10, .shortest = 18, .longest = 80},
    {.name = "10 mm dowel and bush", .kind = bush, .pin = 10, .seat = 12, .shortest = 22, .longest = 100},
};

constexpr double screw_lengths[] = {5,  6,  8,  10, 12, 16, 20, 25, 30,  35,  40,
                                    45, 50, 55, 60, 65, 70, 80, 90, 100, 110, 120};
constexpr double shoulder_lengths[] = {16, 20, 25, 30, 40, 50, 60, 70, 80, 90, 100};
constexpr double pin_lengths[] = {8,  10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 35,
                                  40, 45, 50, 55, 60, 65, 70, 75, 80, 85, 90, 95, 100};

std::optional<double> least_of(std::span<const double> lengths, double needed, double shortest,
                               double longest) {
  for (const double length : lengths)
    if (length >= std::max(needed, shortest) && length <= longest) return length;
  return std::nullopt;
}

}  // namespace

std::span<const Hardware> all_hardware() { return named_hardware; }

const Hardware* hardware_named(std::string_view name) {
  const auto* found = std::find_if(std::begin(named_hardware), std::end(named_hardware),
                                   [&](const Hardware& each) { return each.name == name; });
  return found == std::end(named_hardware) ? nullptr : found;
}

const ThreadSizes* thread_of(const Hardware& of) {
  const auto* found = std::find_if(std::begin(threads), std::end(threads),
                                   [&](const ThreadSizes& each) { return each.name == of.thread; });
  return found == std::end(threads) ? nullptr : found;
}

std::string_view standards_of(HardwareKind kind) {
  switch (kind) {
    case bolt: return "ISO 4762, ISO 7089, ISO 4032";
    case shoulder_screw: return "ISO 7379, ISO 7089, ISO 4032";
    case bearing: return "ISO 15, ISO 4762, ISO 7089, ISO 4032";
    case dowel: return "ISO 8734";
    case bush: break;
  }
  return "ISO 3547, ISO 8734";
}

double pin_at(const LinkStyle& style, const JointHardware& hardware, Joint joint) {
  const Hardware* of = hardware_named(hardware[joint]);
  return of != nullptr ? of->pin : style.pin_diameter;
}

std::array<double, 6> pin_diameters(const LinkStyle& style, const JointHardware& hardware) {
  std::array<double, 6> pins{};
  for (const Joint joint : all_joints) pins[static_cast<std::size_t>(joint)] = pin_at(style, hardware, joint);
  return pins;
}

double rubbing_radius(const LinkStyle& style, const JointHardware& hardware, Joint joint) {
  const Hardware* of = hardware_named(hardware[joint]);
  const double pin = pin_at(style, hardware, joint);
  return of != nullptr && of->kind == bearing ? 0.25 * (pin + of->seat) : 0.5 * pin;
}

double bored_for(const LinkStyle& style, const JointHardware& hardware, Joint joint) {
  const Hardware* of = hardware_named(hardware[joint]);
  return of != nullptr && of->seat > 0 ? of->seat : pin_at(style, hardware, joint);
}

double hole_diameter(const LinkStyle& style, const JointHardware& hardware, Joint joint,
                     const CuttingSpec& cutting) {
  const Hardware* of = hardware_named(hardware[joint]);
  return of != nullptr && of->seat > 0 ? of->seat : pin_at(style, hardware, joint) + cutting.hole_fit;
}

double widest_hole(const LinkStyle& style, const JointHardware& hardware, const CuttingSpec& cutting) {
  double widest = hole_diameter(style, hardware, Joint::V, cutting);
  for (const Joint joint : all_joints)
    widest = std::max(widest, hole_diameter(style, hardware, joint, cutting));
  return widest;
}

double thickest_pin(const JointHardware& hardware) {
  double thickest = 0;
  for (const Joint joint : all_joints)
    if (const Hardware* of = hardware_named(hardware[joint])) thickest = std::max(thickest, of->pin);
  return thickest;
}

double widest_seat(const JointHardware& hardware) {
  double widest = 0;
  for (const Joint joint : all_joints)
    if (const Hardware* of = hardware_named(hardware[joint])) widest = std::max(widest, of->seat);
  return widest;
}

std::string words(const JointHardware& hardware) {
  std::string text = hardware.every.empty() && hardware.differs() ? "plain pins" : hardware.every;
  for (const Joint joint : all_joints)
    if (const std::string& own = hardware.at[static_cast<std::size_t>(joint)]; !own.empty())
      text += fmt::format(", at {} {}", letter(joint), own);
  return text;
}

std::string by_joint(const std::array<double, 6>& figures, const std::function<std::string(double)>& text) {
  std::string all;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (std::find(figures.begin(), figures.begin() + static_cast<std::ptrdiff_t>(i), figures[i]) !=
        figures.begin() + static_cast<std::ptrdiff_t>(i))
      continue;
    std::string joints;
    for (std::size_t j = i; j < figures.size(); ++j)
      if (figures[j] == figures[i]) joints += fmt::format(" {}", letter(all_joints[j]));
    all += (all.empty() ? "" : ", ") + text(figures[i]);
    if (joints.size() < 2 * figures.size()) all += " at" + joints;
  }
  return all;
}

std::optional<double> screw_length(const ThreadSizes& thread, double needed) {
  return least_of(screw_lengths, needed, thread.screw_shortest, thread.screw_longest);
}

std::optional<double> shoulder_or_pin_length(const Hardware& of, double needed) {
  const bool is_shoulder = of.kind == shoulder_screw;
  return least_of(
      is_shoulder ? std::span<const double>(shoulder_lengths) : std::span<const double>(pin_lengths), needed,
      of.shortest, of.longest);
}

}  // namespace kempe
