#pragma once
// Any planar linkage of a linkage file (docs/linkage-file.md): how it moves, its freedoms, its instant centres.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/export.hpp"
#include "kempe/input_error.hpp"
#include "kempe/point.hpp"

namespace kempe {

/// A place asked for, and the one that the linkage reaches. mm, rad, y upward.
struct PlaceAskedFor {
  Point at = Point::Zero();             ///< asked for, mm
  Point reached = Point::Zero();        ///< mm
  std::optional<double> angle;          ///< rad, direction of the body that carries the point; for poses only
  std::optional<double> reached_angle;  ///< rad; there where `angle` is
  double share = 0;                     ///< of the motion, 0 to 1, after which it is reached
};

struct LoadedLinkage;  // what is inside

/// Why a linkage that was read gives no answer.
struct NoMotion {
  std::string sentence;  ///< for a person
  bool stopped = false;  ///< by `stop`, or because the work allowed was spent: nothing is known
};

/// An answer; or what is wrong with the question; or why there is none.
template <typename Answer>
using LinkageAnswer = std::variant<Answer, InputError, NoMotion>;

/// How to look for the closed positions at the start.
struct AssemblyChoice {
  std::uint64_t seed = 1;           ///< of the random first guesses
  int number = 0;                   ///< which of assemblies() to start in
  std::function<bool()> stop = {};  ///< true ends the work; looked at every so often
};

/// A named place, mm, table frame.
struct PlacedPoint {
  std::string name;          ///< as in the file
  Point at = Point::Zero();  ///< mm
};

/// A point at the moments of a motion: mm, mm/s, mm/s^2, table frame. Nothing where rates do not exist: where the motion stopped.
struct MovedPoint {
  std::string name;                                 ///< as in the file
  std::vector<Point> places;                        ///< mm
  std::vector<std::optional<Point>> velocities;     ///< mm/s
  std::vector<std::optional<Point>> accelerations;  ///< mm/s^2
};

/// A link at the moments of a motion: rad (not folded), rad/s, rad/s^2. Nothing where a point has no rates.
struct MovedLink {
  std::string name;                                  ///< as in the file
  std::vector<double> angles;                        ///< rad, of the link's x axis
  std::vector<std::optional<double>> rates;          ///< rad/s
  std::vector<std::optional<double>> accelerations;  ///< rad/s^2
};

/// The force on a link in a joint, or on what a guide holds, at the moments: N, table frame. Nothing where it does not exist or
/// rigid links do not determine it.
struct JointReaction {
  std::string name;                          ///< "B_on_rod", "C_from_ground"
  std::vector<std::optional<Point>> forces;  ///< N
};

/// A column of the table of `kempe solve`.
struct MotionColumn {
  std::string name;                           ///< with its unit: "step", "P_x_m", "drive_P_y_N"
  std::vector<std::optional<double>> values;  ///< a moment each; nothing where it has no value
  bool is_force = false;                      ///< or moment
};

/// How a motion ended before its time.
struct MotionEnd {
  std::string kind;                    ///< "dead point", "change point", ...
  double step = 0;                     ///< where
  std::vector<std::string> sentences;  ///< which joints are in line, which links can still move
  std::string sentence;                ///< all of it
};

/// A linkage moved by its drivers.
struct DrivenMotion {
  std::vector<double> steps;             ///< 0, 1, ...; the last is a fraction where the motion ended early
  std::vector<double> times;             ///< s
  std::vector<MovedPoint> points;        ///< every point, those of the ground included
  std::vector<MovedLink> links;          ///< every link but the ground
  std::vector<JointReaction> reactions;  ///< where there are loads
  /// The table of `kempe solve` in the file's unit: the points, links and transmission angles that the file wants, with
  /// velocities and accelerations, and all forces.
  std::vector<MotionColumn> table;
  std::vector<std::string> force_sentences;  ///< what the forces come to
  std::vector<std::string> undetermined;     ///< joints whose reaction rigid links do not determine
  std::optional<MotionEnd> end;              ///< nothing: it went to its end
};

/// A linkage, read and checked. Immutable and cheap to copy; may be used from several threads.
class KEMPE_EXPORT Linkage {
 public:
  /// Of a file's text; `name` stands for the file in messages and names a linkage that has none. All faults in the error.
  static std::variant<Linkage, InputError> parse(std::string_view text, const std::string& name = "");
  /// Of a file.
  static std::variant<Linkage, InputError> read(const std::filesystem::path& file);

  const std::string& text() const;                ///< the file's
  const std::string& name() const;                ///< what it is called
  const std::string& unit() const;                ///< "mm", "cm", "m" or "in": of the file and the columns
  std::vector<std::string> points() const;        ///< names, those of the ground first
  std::vector<std::string> links() const;         ///< names, without the ground
  int steps() const;                              ///< equal parts of the motion that the file wants
  const std::vector<std::string>& notes() const;  ///< what was understood otherwise than it was written

  /// The closed positions at the start of the motion that a search finds, the chosen one first: every point's place. None is
  /// invented, one may be missed.
  LinkageAnswer<std::vector<std::vector<PlacedPoint>>> assemblies(const AssemblyChoice& choice = {}) const;

  /// The motion in `steps` equal parts; nothing: as many as the file wants. Faults: `steps` beyond what a table may hold, a
  /// number of an assembly mode that is not known, drivers that do not fit the mobility. Where the linkage locks on its way the
  /// motion ends there.
  LinkageAnswer<DrivenMotion> solve(std::optional<int> steps = std::nullopt,
                                    const AssemblyChoice& choice = {}) const;

  /// Gruebler's count and the true mobility: what `kempe mobility --json` prints.
  LinkageAnswer<std::string> mobility(const AssemblyChoice& choice = {}) const;

  /// Every instant centre at a step, whole or not, of the file's motion: what `kempe centres --json` prints.
  LinkageAnswer<std::string> centres(double step = 0, const AssemblyChoice& choice = {}) const;
  /// The same as a drawing (SVG).
  LinkageAnswer<std::string> centres_drawing(double step = 0, const AssemblyChoice& choice = {}) const;
  /// The same found step by step, a page (HTML) that loads nothing.
  LinkageAnswer<std::string> centres_page(double step = 0, const AssemblyChoice& choice = {}) const;

  /// The loop equations at a step with their numbers: what `kempe solve --equations --json` prints.
  LinkageAnswer<std::string> equations(double step = 0, const AssemblyChoice& choice = {}) const;

  /// What animation() makes.
  enum class AnimationFile {
    page,    ///< HTML with a slider
    drawing  ///< SVG that plays by itself
  };
  /// The linkage moving, one file without a network. `wanted`: places that its point P was asked for (GeneratedLinkage::wanted), shown
  /// with the deviations from them; the linkage must then have a point of that name.
  LinkageAnswer<std::string> animation(AnimationFile file, std::optional<int> steps = std::nullopt,
                                       const AssemblyChoice& choice = {},
                                       const std::vector<PlaceAskedFor>& wanted = {}) const;

 private:
  Linkage(std::shared_ptr<const LoadedLinkage> inside, std::string text);
  std::shared_ptr<const LoadedLinkage> inside_;
  std::string text_;
};

/// Number synthesis: the assortments of links of which a chain with these freedoms can be made, what `kempe mobility --links`
/// prints as JSON. `links` 2 to 40, `freedoms` 0 to 40, else a fault.
KEMPE_EXPORT std::variant<std::string, InputError> chains(int links, int freedoms = 1);

}  // namespace kempe
