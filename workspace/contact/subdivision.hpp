#pragma once
// Cutting the two angles into cells that are certainly free, certainly in contact, or still open.

#include <functional>
#include <vector>

#include "kinematics/stop_flag.hpp"
#include "workspace/angle_grid.hpp"
#include "workspace/contact/contact_scene.hpp"

namespace kempe {

/// A tree node of an obstacle that may decide about a piece within a cell. Items of one piece and obstacle
/// are neighbours.
struct ContactItem {
  std::uint32_t node;
  Encounter between;
};

/// How a cell lies to the region that the tracer must cover.
enum class RegionSide : std::uint8_t { outside, crossing, inside };

/// A cell with its decision.
struct FreeCell {
  GridCell cell;
  bool meets_region;
};
struct ContactCell {
  GridCell cell;
  Encounter between;  ///< the first pair found to be in contact all over the cell
  bool meets_region;
};
struct OpenCell {
  GridCell cell;
  RegionSide side;
  bool split_opening;          ///< across which side the next cut should go
  std::uint32_t first, count;  ///< its items
  std::uint32_t tightest;      ///< the item, counted from `first`, whose gap came out smallest
  bool all_decided;            ///< false: only the tightest was looked at, the others are the parent's
  std::uint32_t region_first, region_count;
};

/// For Subdivision::split: every cell, until the work shall end. `stop` must outlive it.
inline auto unless(const StopFlag& stop) {
  return [&stop](const OpenCell&) { return !stop(); };
}

/// The joints over openings in each frame, as FramedJoints has them over rectangles.
using FramedOpenings = std::array<OpeningJoints, scene_frames>;

struct SubdivisionMode {
  bool contacts_stay_open = false;  ///< cells in contact are cut further instead of decided
  bool region_only = false;         ///< cells that do not meet the region are dropped
};

/// Invariant (but for dropped cells): free, contact and open cells tile the grid; a free cell keeps the
/// clearance to every obstacle at each of its points and a contact cell at none.
class Subdivision {
 public:
  /// Decides about these encounters of the scene. `region` has the pole at the origin and may be empty. All arguments but
  /// the grid must outlive the object.
  Subdivision(const ContactScene& scene, const Encounters& encounters, const EdgeTree& region,
              const AngleGrid& grid, double clearance, SubdivisionMode mode = {});

  const std::vector<FreeCell>& free() const { return free_; }
  const std::vector<ContactCell>& contact() const { return contact_; }
  const std::vector<OpenCell>& open() const { return lists_.open; }
  const AngleGrid& grid() const { return grid_; }
  double free_area() const { return free_area_; }  ///< mm^2
  double open_area() const { return open_area_; }  ///< mm^2

  /// Cuts every open cell that `wanted` accepts into halves, unless it is as small as can be; true if any was
  /// cut.
  bool split(const std::function<bool(const OpenCell&)>& wanted);

  /// From now on cells are decided against this clearance (mm). Not more than before.
  void lower_clearance(double clearance) { clearance_ = clearance; }
  /// From now on only cells that meet the region matter; those already open and outside are dropped.
  void look_at_region_only();

  /// A point of the region within the cell, table frame; nothing if they do not meet. Exact up to rounding.
  std::optional<Point> region_point_in(const OpenCell& cell) const;

  /// Where a contact cell was first found to meet the region.
  const std::optional<std::pair<ContactCell, Point>>& region_in_contact() const { return region_in_contact_; }

 private:
  /// Open cells with their items.
  struct Lists {
    std::vector<OpenCell> open;
    std::vector<ContactItem> items;
    std::vector<std::uint32_t> region_items;
  };
  struct Decision;
  struct Meeting;
  /// What cells with the same openings share.
  struct Row {
    std::uint32_t y, height;  ///< 0 high: none yet
    FramedOpenings over;
    double area_per_bearing;  ///< mm^2/rad
  };
  /// What cells with the same bearings share.
  struct Column {
    double middle = -1;  ///< in grid units
    Complex turn;        ///< exp(i bearing) of the middle
  };

  void add_roots();
  FramedOpenings over_openings(double opening, double half_opening) const;
  FramedJoints joints_over(const FramedOpenings& over, Complex turn, double half_bearing) const;
  const Row& row_of(const GridCell& cell);
  Complex turn_of(const GridCell& cell);
  void classify(const GridCell& cell, const OpenCell& parent, const ContactItem* items,
                const std::uint32_t* region_items, Lists& next);
  Meeting meeting_of(const Encounter& between, const FramedJoints& joints, const HalfSides& half) const;
  bool decide_tightest(const OpenCell& parent, const ContactItem* items, const FramedJoints& joints,
                       const HalfSides& half, Decision& decision, Lists& next) const;
  bool decide_group(const ContactItem*& item, const ContactItem* end, const FramedJoints& joints,
                    const HalfSides& half, Decision& decision, Lists& next) const;
  void decide_node(std::uint32_t node, const Meeting& meeting, Decision& decision, Lists& next) const;
  RegionSide side_of(const MovingJoint& tracer, const std::uint32_t* items, std::size_t count,
                     Lists& next) const;
  std::optional<Point> region_point(const GridCell& cell, RegionSide side, const std::uint32_t* items,
                                    std::size_t count) const;

  const ContactScene& scene_;
  const Encounters& encounters_;
  const EdgeTree& region_;
  AngleGrid grid_;
  double clearance_;
  SubdivisionMode mode_;
  std::vector<FreeCell> free_;
  std::vector<ContactCell> contact_;
  Lists lists_, spare_;  // spare_: the last cut's, for its memory
  double free_area_ = 0, open_area_ = 0;
  // Direct-mapped caches of rows and columns.
  std::vector<Row> rows_;
  std::vector<Column> columns_;
  std::optional<std::pair<ContactCell, Point>> region_in_contact_;
};

}  // namespace kempe
