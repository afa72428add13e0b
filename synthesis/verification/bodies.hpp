#pragma once
// Bodies and the table's edge as the verification sees them: polygons and discs put at the joints' places, measured edge by edge.
// No Minkowski difference and no frame that travels has a part in it; where a body turns with a link, the places of the link's joints
// alone say how it stands.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/verification/plain_distance.hpp"
#include "synthesis/verification/verification.hpp"

namespace kempe {

/// The bodies and the table of a task, ready to be measured in any pose as seen from the pole.
class BodyWatch {
 public:
  /// `linkage` says which joints are pole, tracer and pen, and the plates' shape; its lengths are not used.
  BodyWatch(const CopyingLinkage& linkage, const VerificationTask& task);

  struct Near {
    std::string key;  ///< "bodies" or "table"
    double gap;       ///< mm; of overlapping sets at most minus their half widths
    std::string one, other;
  };
  /// Calls `use` for everything nearer than `within`, mm, to a body, or to the table's edge.
  void for_each_near(const Pose& pose, double within, const std::function<void(Near)>& use) const;

 private:
  /// What takes room: a part's piece, an obstacle, a body.
  struct Thing {
    plain::Corners corners;  ///< of a body as seen from its point, else in place
    double around;           ///< mm: it is what lies within this of them
    int lowest_layer, highest_layer;
    std::string name;
  };
  struct Piece {
    Part part;
    JointHull hull;
    Thing thing;
  };
  struct CarriedThing {
    Joint by;
    std::optional<Link> turns_with;
    Thing thing;
  };
  static plain::Corners corners_of(const CarriedThing& body, const Pose& pose);
  std::vector<Piece> pieces_;
  std::vector<Thing> obstacles_;
  std::vector<CarriedThing> bodies_;
  plain::Corners table_;
};

}  // namespace kempe
