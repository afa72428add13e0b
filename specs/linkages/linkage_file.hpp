#pragma once
// The linkage file as a plain value: any planar linkage, its drivers and what is wanted of it, already
// checked, in millimetre and radian. docs/linkage-file.md describes the file.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/point.hpp"
#include "kempe/input_error.hpp"
#include "kinematics/planar/driver_motion.hpp"

namespace kempe {

/// The unit of all lengths in a linkage file and in the tables made from it.
struct LengthUnit {
  std::string name = "mm";  ///< "mm", "cm", "m" or "in"
  double in_mm = 1;         ///< mm a unit
  bool operator==(const LengthUnit&) const = default;
};

using NamedPoint = std::pair<std::string, Point>;

/// A rigid link: its joints in its own frame. The frame's origin is the first joint and its x axis points to
/// the second, unless the file gives coordinates. The link's angle is the direction of its x axis.
struct FileLink {
  std::string name;
  std::vector<NamedPoint> joints;
};

/// A straight line on a link ("ground" included), in the link's frame.
struct FileLine {
  std::string link;
  Point through = Point::Zero();
  double direction = 0;  ///< rad
};

/// A point that stays on a line, or a whole link that slides along one without turning.
struct FileSlider {
  std::string point;  ///< empty if a link slides
  std::string link;   ///< empty if a point slides
  FileLine line;
  const std::string& name() const { return point.empty() ? link : point; }
};

/// angle(to) - angle(from) = angle.
struct FileAngle {
  std::string from, to;
  double angle = 0;  ///< rad
};

/// Two points a fixed distance apart.
struct FileBar {
  std::string a, b;
  double length = 1;  ///< mm, > 0
};

/// Two wheels that mesh, their centres held by the carrier.
struct FileGears {
  std::string first, second, carrier;
  double first_radius = 1, second_radius = 1;  ///< mm; negative for inner teeth
  double value = 0;                            ///< mm: what GearPair keeps constant
};

/// A pinion that rolls on a line of a link.
struct FileRack {
  std::string pinion, centre;
  FileLine line;
  double radius = 1;  ///< mm; positive with the pinion on the left of the line's direction
  double value = 0;   ///< mm: what RackAndPinion keeps constant
};

/// What a driver moves.
struct DrivenCoordinate {
  std::string point;
  int axis = 0;  ///< 0 x, 1 y
};
struct DrivenAngle {
  std::string link, reference;
};
struct DrivenDistance {
  std::string a, b;
};
struct DrivenSlide {
  std::size_t slider = 0;  ///< number in `sliders`
};
struct DrivenPoint {
  std::string point;
};

struct FileDriver {
  std::variant<DrivenCoordinate, DrivenAngle, DrivenDistance, DrivenSlide, DrivenPoint> what;
  std::variant<DriverRange, DriverPath> motion;  ///< DriverPath for DrivenPoint only
  int line = 0;                                  ///< in the file
};

/// Where a point or a link's angle must be at the start: mm and rad.
struct FileBound {
  std::string name;                                               ///< a point's or a link's
  std::array<std::optional<std::pair<double, double>>, 2> place;  ///< x, y of a point
  std::optional<std::pair<double, double>> angle;                 ///< of a link
};

/// A force at a point, on one link that holds it.
struct FileForce {
  std::string at, link;  ///< link: empty: the first that holds the point
  Point newton = Point::Zero();
  std::string turns_with = "ground";  ///< a link: the direction is given in its frame
};

/// Two equal and opposite forces between two points; > 0 pushes them apart.
struct FilePairForce {
  std::string a, b;
  double newton = 0;
};

/// A moment on a link; `against` bears the opposite one.
struct FileMoment {
  std::string on, against;
  double moment = 0;  ///< N mm
};

/// The mass of a link, or of a point.
struct FileMass {
  std::string link, point;  ///< one of them is empty
  double kg = 0;
  Point centre = Point::Zero();  ///< of a link's mass, in its frame, mm
  double inertia = 0;            ///< about the centre of mass, kg mm^2
};

/// What acts on the linkage, and what its motion moves.
struct FileLoads {
  std::vector<FileForce> forces;
  std::vector<FilePairForce> pairs;
  std::vector<FileMoment> moments;
  std::vector<FileMass> masses;
  Point gravity = Point::Zero();  ///< m/s^2

  std::size_t count() const { return forces.size() + pairs.size() + moments.size() + masses.size(); }
};

struct OutputWishes {
  std::vector<std::string> points;  ///< empty in the file: every point that is not on the ground
  bool velocities = false, accelerations = false;
  std::vector<std::string> angles;  ///< links whose angle (and rates) are wanted
  /// Points a, b, c: the angle between ba and bc, folded to 0..90 degrees.
  std::vector<std::array<std::string, 3>> transmission;
  std::vector<std::string> trace;  ///< points whose curve is drawn
  bool reactions = true;           ///< the forces in joints and guides, where there are loads
};

struct LinkageFile {
  std::string file;  ///< as the user named it
  std::string name;  ///< for people; the file's stem if it gives none
  LengthUnit unit;
  std::vector<NamedPoint> ground;
  std::vector<FileLink> links;
  std::vector<std::string> free_points;  ///< belong to no link
  std::vector<FileSlider> sliders;
  std::vector<FileAngle> angles;
  std::vector<FileBar> bars;
  std::vector<FileGears> gears;
  std::vector<FileRack> racks;
  std::vector<FileDriver> drivers;
  FileLoads loads;
  int steps = 36;       ///< the motion is shown at steps + 1 places
  double duration = 1;  ///< s, of the whole motion: what rates refer to
  std::vector<NamedPoint> guess;
  std::vector<FileBound> bounds;
  OutputWishes output;
  std::vector<std::string> notes;  ///< what the reader understood otherwise than it was written, for people

  /// The largest number of steps that a table of this linkage can be kept for.
  int most_steps() const;

  /// Every point's name: ground, links' joints in order, free points.
  std::vector<std::string> point_names() const;
};

/// Reads and checks a linkage file: every name defined, every number finite and in range, every link rigid.
/// The error names file, line and key.
tl::expected<LinkageFile, InputError> read_linkage_file(const std::string& path);

/// The same from text.
tl::expected<LinkageFile, InputError> parse_linkage_file(std::string_view text, const std::string& file_name);

}  // namespace kempe
