#pragma once
// The moving part of the verification: the mechanism as bodies and joints.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/planar/path.hpp"
#include "synthesis/verification/verification.hpp"

namespace kempe {

/// A drawn mechanism in the general solver: four bodies, four joints, the pole pinned at the origin, the tracer driven.
/// It moves in certified steps from where it stands and never jumps. All places are as seen from the pole.
class Drive {
 public:
  /// Closes the loops near the middle of the certified opening, the tracer in the direction of `towards` from the
  /// pole. The error is a sentence: why the drawing is no closed mechanism.
  static tl::expected<Drive, std::string> make(const DrawnMechanism& mechanism, const Point& towards);

  /// Moves the tracer there, straight if that is possible, else around the pole. The error says what stopped it; the
  /// mechanism then stands where it stood before.
  tl::expected<void, std::string> go_to(const Point& tracer);

  Pose pose() const;
  double residual() const { return path_.residual(); }  ///< largest open loop, mm

 private:
  struct Points {
    BodyPoint V, A, B, C, X, Y;
  };
  Drive(PlanarPath path, const Points& points, double turning_radius)
      : path_(std::move(path)), points_(points), turning_radius_(turning_radius) {}
  tl::expected<void, std::string> around_the_pole(const Point& tracer);

  PlanarPath path_;
  Points points_;
  double turning_radius_;  // mm from the pole: where the opening is in its middle
};

}  // namespace kempe
