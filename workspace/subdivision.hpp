#pragma once
// Cutting the two angles into cells that are certainly free, certainly in contact, or still open.

#include <functional>
#include <vector>

#include "workspace/angle_grid.hpp"
#include "workspace/contact_scene.hpp"

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
  std::uint32_t region_first, region_count;
};

struct SubdivisionMode {
  bool contacts_stay_open = false;  ///< cells in contact are cut further instead of decided
  bool region_only = false;         ///< cells that do not meet the region are dropped
};

/// Invariant (but for dropped cells): free, contact and open cells tile the grid; a free cell keeps the
/// clearance to every obstacle at each of its points and a contact cell at none.
class Subdivision {
 public:
  /// `region` has the pole at the origin and may be empty. All arguments but the grid must outlive the
  /// object.
  Subdivision(const ContactScene& scene, const EdgeTree& region, const AngleGrid& grid, double clearance,
              SubdivisionMode mode = {});

  const std::vector<FreeCell>& free() const { return free_; }
  const std::vector<ContactCell>& contact() const { return contact_; }
  const std::vector<OpenCell>& open() const { return open_; }
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
  struct Lists {
    std::vector<OpenCell> open;
    std::vector<ContactItem> items;
    std::vector<std::uint32_t> region_items;
  };
  struct Decision;

  void add_roots();
  OpeningJoints over_openings_of(const GridCell& cell) const;
  void classify(const GridCell& cell, const OpeningJoints& over, RegionSide side, const ContactItem* items,
                std::size_t count, const std::uint32_t* region_items, std::size_t region_count, Lists& next);
  bool decide_group(const ContactItem*& item, const ContactItem* end, const MovingJoints& joints,
                    const HalfSides& half, Decision& decision, Lists& next) const;
  void decide_node(std::uint32_t node, const Encounter& between, const MovingJoints& joints,
                   const HalfSides& half, Decision& decision, Lists& next) const;
  RegionSide side_of(const MovingJoint& tracer, const std::uint32_t* items, std::size_t count,
                     Lists& next) const;
  std::optional<Point> region_point(const GridCell& cell, RegionSide side, const std::uint32_t* items,
                                    std::size_t count) const;

  const ContactScene& scene_;
  const EdgeTree& region_;
  AngleGrid grid_;
  double clearance_;
  SubdivisionMode mode_;
  std::vector<FreeCell> free_;
  std::vector<ContactCell> contact_;
  std::vector<OpenCell> open_;
  std::vector<ContactItem> items_;
  std::vector<std::uint32_t> region_items_;
  double free_area_ = 0, open_area_ = 0;
  std::optional<std::pair<ContactCell, Point>> region_in_contact_;
};

}  // namespace kempe
