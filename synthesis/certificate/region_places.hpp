#pragma once
// Places of a region by polygon, ring, corner and share, as a proof log names them.

#include <vector>

#include "geometry/region_reach.hpp"
#include "synthesis/certificate/proof_log.hpp"

namespace kempe::certificate {

struct KnownPlace {
  Place place;
  Point at = Point::Zero();  ///< mm
};

class RegionPlaces {
 public:
  /// Keeps a reference to the region.
  explicit RegionPlaces(const Region& region);

  /// The place of the region nearest to a point: the point itself inside, else a point of the boundary.
  KnownPlace nearest(const Point& to) const;
  /// The corner farthest from a point.
  KnownPlace farthest(const Point& from) const;
  /// About `about` places, spread over boundary and inside; the same every time.
  const std::vector<KnownPlace>& spread() const { return spread_; }
  /// One more of them.
  void add(const KnownPlace& place) { spread_.push_back(place); }
  /// Some two thousand more closely spread, for a look at single designs; found when they are first asked for, by one thread at a time.
  const std::vector<KnownPlace>& many() const;

 private:
  EdgePlace edge_place(std::size_t edge, double share) const;
  void spread_out(const Region& region, int about);

  const Region& region_;
  RegionReach reach_;
  std::vector<EdgePlace> start_of_;     // of the edges of reach_
  std::vector<std::size_t> corner_of_;  // of the hull's corners: an edge that begins there
  std::vector<KnownPlace> spread_;
  mutable std::vector<KnownPlace> many_;
};

}  // namespace kempe::certificate
