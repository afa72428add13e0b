#pragma once
// What can be bought for a joint, by the name that a spec gives it: pins, screws, bearings, bushes, with their standard sizes.

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "kempe/spec.hpp"

namespace kempe {

/// How a joint is made.
enum class HardwareKind {
  bolt,  ///< socket head cap screw ISO 4762, a washer ISO 7089 at each end, nut ISO 4032; links turn on the screw
  shoulder_screw,  ///< ISO 7379: links turn on the ground shoulder, whose end the nut ISO 4032 and its washer are drawn against
  bearing,  ///< a deep groove ball bearing (ISO 15) in every link, on a bolt as above
  dowel,    ///< parallel pin ISO 8734; links turn on it
  bush      ///< a wrapped bush (ISO 3547) in every link, on a parallel pin ISO 8734
};

/// A metric thread with what stands on it; mm.
struct ThreadSizes {
  std::string_view name;                  ///< "M6"
  double diameter, pitch;                 ///< ISO 261
  double nut_height, nut_corners;         ///< ISO 4032: m max, e min
  double washer_height, washer_diameter;  ///< ISO 7089: h nominal, d2
  double screw_head_height, screw_head;   ///< ISO 4762: k max, d_k max of the plain head
  double screw_shortest, screw_longest;   ///< ISO 4762: commercial lengths
};

/// One kind of joint in one size; mm.
struct Hardware {
  std::string_view name;  ///< "M6 bolt", "608 bearing"
  HardwareKind kind;
  double pin;             ///< diameter of what passes the layers: contact is certified for it
  double seat = 0;        ///< outer diameter of the bearing or bush that is pressed into the link; 0: none
  double seat_width = 0;  ///< of a bearing, along its axis: a link is at least as thick; 0: no such need
  std::string_view thread = {};      ///< of the screw; empty: none
  double head_height = 0, head = 0;  ///< of a shoulder screw: k, d_k
  double shortest = 0, longest = 0;  ///< of a shoulder or a pin: commercial lengths
  double thread_length = 0;          ///< of a shoulder screw, beyond its shoulder: b max
};

/// All of them, those that a spec can name, in the order of the documentation.
std::span<const Hardware> all_hardware();
/// The one of this name, or null.
const Hardware* hardware_named(std::string_view name);
/// Its thread's sizes; null if it has none.
const ThreadSizes* thread_of(const Hardware& hardware);
/// The standards that its pieces are made by: "ISO 7379, ISO 7089, ISO 4032".
std::string_view standards_of(HardwareKind kind);

/// Diameter of the pin or post at a joint, mm.
double pin_at(const LinkStyle& style, const JointHardware& hardware, Joint joint);
/// The same at every joint, in the order of Joint, mm.
std::array<double, 6> pin_diameters(const LinkStyle& style, const JointHardware& hardware);
/// The radius at which a joint's links rub as they turn, mm: that of the pin; of a bearing the mean of bore and outer radius.
double rubbing_radius(const LinkStyle& style, const JointHardware& hardware, Joint joint);
/// What the links are bored for at a joint, mm: the pin's diameter, or that of the bearing or bush around it.
double bored_for(const LinkStyle& style, const JointHardware& hardware, Joint joint);
/// Diameter of a joint's holes as they are to be, kerf apart, mm. A bearing or bush is pressed in: the fit widens holes for pins
/// alone.
double hole_diameter(const LinkStyle& style, const JointHardware& hardware, Joint joint,
                     const CuttingSpec& cutting);
/// The largest of them.
double widest_hole(const LinkStyle& style, const JointHardware& hardware, const CuttingSpec& cutting);
/// Diameter of the thickest pin that is bought, mm; 0 where all are plain.
double thickest_pin(const JointHardware& hardware);
/// Diameter of the widest bearing or bush, mm; 0 where there is none.
double widest_seat(const JointHardware& hardware);

/// For a person: "M6 bolt", "M6 bolt, at V 608 bearing, at A M8 bolt".
std::string words(const JointHardware& hardware);
/// One figure a joint, V, A, B, C, X, Y, for a person: "8.1" where all are the same, else "22 at V, 8.1 at A B C X Y".
std::string by_joint(const std::array<double, 6>& figures, const std::function<std::string(double)>& text);

/// The least commercial length of a screw's shank, a shoulder or a pin that is at least `needed`, mm; nothing if none is made.
std::optional<double> screw_length(const ThreadSizes& thread, double needed);
std::optional<double> shoulder_or_pin_length(const Hardware& hardware, double needed);

}  // namespace kempe
