#pragma once
// Obstacles as the verification sees them: plain distances from the joints' places, without the map's scene,
// trees or intervals.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/verification/verification.hpp"

namespace kempe {

/// The parts of a linkage that share a layer with an obstacle, ready to be measured in any pose as seen from the
/// pole.
class ObstacleWatch {
 public:
  /// `linkage` says which joints are pole, tracer and pen, and the plates' shape; its lengths are not used.
  ObstacleWatch(const CopyingLinkage& linkage, const VerificationTask& task);

  struct Near {
    double gap;  ///< mm; a part that overlaps an obstacle has at most minus its half width
    std::string part, obstacle;
  };
  /// The part and obstacle that come nearest to each other in a pose; nothing if none are nearer than
  /// `within`, mm.
  std::optional<Near> nearest(const Pose& pose, double within) const;

 private:
  struct Piece {
    JointHull hull;
    double half_width;
    std::string part;
  };
  struct Meeting {
    std::size_t piece, obstacle;
  };
  struct Solid {
    std::string name;
    Polygon shape;
    Box box;
  };
  std::vector<Piece> pieces_;
  std::vector<Solid> obstacles_;
  std::vector<Meeting> meetings_;
};

}  // namespace kempe
