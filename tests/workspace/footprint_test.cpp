// The swept area against a plain count of the cells that the bars pass over, pose by pose.
#include "workspace/footprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/geometry/random_rings.hpp"
#include "tests/workspace/sampled_mechanism.hpp"
#include "workspace/sweep/region_bearings.hpp"

namespace kempe {
namespace {

using test::Z;

constexpr LinkStyle style{6, 3, 4, PlateStyle::bent};
constexpr double cell = 1;  // mm

/// Cells of a square about the origin whose middle some bar passes over.
class Raster {
 public:
  void add_bar(Z from, Z to) {
    const double half = style.width / 2;
    const auto first = [&](double a, double b) { return std::lround((std::min(a, b) - half) / cell); };
    const auto last = [&](double a, double b) { return std::lround((std::max(a, b) + half) / cell); };
    for (long x = first(from.real(), to.real()); x <= last(from.real(), to.real()); ++x)
      for (long y = first(from.imag(), to.imag()); y <= last(from.imag(), to.imag()); ++y) {
        const Z middle(static_cast<double>(x) * cell, static_cast<double>(y) * cell);
        if (test::point_to_segment(middle, from, to) > half) continue;
        cells_.at(static_cast<std::size_t>((x + reach) * 2 * reach + y + reach)) = true;
      }
  }
  double area() const {
    return static_cast<double>(std::count(cells_.begin(), cells_.end(), true)) * cell * cell;
  }

 private:
  static constexpr long reach = 800;
  std::vector<bool> cells_ = std::vector<bool>(4 * reach * reach);
};

void add_pose(Raster& raster, const CopyingLinkage& linkage, Z tracer) {
  const auto at = test::joints_with_tracer_at(linkage, tracer);
  ASSERT_TRUE(at) << tracer;
  for (const auto& [from, to] : {std::pair{at->V, at->A},
                                 {at->V, at->B},
                                 {at->A, at->C},
                                 {at->A, at->X},
                                 {at->B, at->C},
                                 {at->B, at->Y}})
    raster.add_bar(from, to);
}

/// A disc of many corners, one of them exactly in direction 0 from its centre.
Ring disc_at(Z centre, double radius, bool clockwise = false) {
  constexpr int corners = 360;
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(as_point(centre + std::polar(radius, (clockwise ? -2 : 2) * pi * i / corners)));
  return ring;
}

struct Specimen {
  CopyingLinkage linkage;
  double radius;  ///< mm, from the pole: well within what the tracer reaches
};

std::vector<Specimen> specimens(const Point& pole) {
  std::vector<Specimen> all;
  for (const Grounding grounding : {Grounding::pole, Grounding::tracer, Grounding::pen})
    for (const Complex k : {Complex(0, 1.4), Complex(0.5, 0.2), Complex(-0.8, 0)}) {
      const CopyingLinkage linkage = *CopyingLinkage::make(k, grounding, 60, 45, 0, pole);
      all.push_back({linkage, linkage.radius_at(linkage.assembly_mode().openings.middle())});
    }
  return all;
}

TEST(Footprint, IsNotToldWhereItWasStopped) {
  const auto [linkage, radius] = specimens({3, -8}).front();
  const Region region{{{disc_at(as_complex(linkage.pole()) + radius, 0.1 * radius), {}}}};
  const StopFlag stopped([] { return true; });
  EXPECT_FALSE(footprint_unless(stopped, linkage, style, region));
  const auto whole = footprint_unless({}, linkage, style, region);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->area, footprint(linkage, style, region).area);
}

TEST(Footprint, IsWhatTheBarsPassOver) {
  const Point pole(3, -8);
  for (const auto& [linkage, radius] : specimens(pole))
    for (const double bearing : {0.0, pi, 2.0}) {
      const double size = 0.1 * radius;
      const Z centre = as_complex(pole) + std::polar(radius, bearing);
      Raster raster;
      for (int ring = 0; ring <= 4; ++ring)
        for (int i = 0; i < 48; ++i)
          add_pose(raster, linkage, centre + std::polar(size * ring / 4, i * pi / 24));
      const double area = footprint(linkage, style, Region{{{disc_at(centre, size), {}}}}).area;
      EXPECT_GT(area, 0.99 * raster.area());
      EXPECT_LT(area, 1.06 * raster.area()) << "bearing " << bearing << " of " << linkage.k();
    }
}

TEST(Footprint, OfARegionAroundThePoleIsAWholeTurn) {
  const Point pole(3, -8);
  for (const auto& [linkage, radius] : specimens(pole)) {
    Raster raster;
    for (const double at : {0.95 * radius, radius, 1.05 * radius})
      for (int i = 0; i < 450; ++i)
        add_pose(raster, linkage, as_complex(pole) + std::polar(at, 2 * pi * i / 450));
    const Polygon ring{disc_at(as_complex(pole), 1.05 * radius),
                       {disc_at(as_complex(pole), 0.95 * radius, true)}};
    const double area = footprint(linkage, style, Region{{ring}}).area;
    EXPECT_GT(area, 0.99 * raster.area());
    EXPECT_LT(area, 1.06 * raster.area()) << linkage.k();
  }
}

// Of a polygon's edges only those count that come as near: boxes around slanted ones do long before.
TEST(RegionBearings, AreThoseOfPlacesAtTheDistances) {
  const sweep::RegionBearings slanted(Region{{{{{40, 158}, {158, 40}, {99.5, 99.5}}, {}}}}, Point::Zero());
  EXPECT_TRUE(slanted.between(60, 62).empty());
  std::mt19937_64 random(11);
  for (int i = 0; i < 300; ++i) {
    Ring ring = star_ring(random, 3 + i % 9, 50);
    const double right = uniform(random, 20, 90), up = uniform(random, -40, 40);
    for (Point& corner : ring) corner += Point(right, up);
    const Region region{{{ring, {}}}};
    const double inner = uniform(random, 5, 100), outer = inner + uniform(random, 0.1, 10);
    const auto seen = sweep::RegionBearings(region, Point::Zero()).between(inner, outer);
    const auto is_seen = [&](double bearing) {
      return std::any_of(seen.begin(), seen.end(), [&](const sweep::Bearings& some) {
        const double after = std::remainder(bearing - 0.5 * (some.from + some.to), 2 * pi);
        return std::abs(after) <= 0.5 * (some.to - some.from) + 1e-9;
      });
    };
    const auto has_place = [&](double bearing) {
      for (int share = 0; share <= 40; ++share)
        if (contains(region, as_point(std::polar(inner + (outer - inner) * share / 40, bearing))))
          return true;
      return false;
    };
    constexpr int steps = 2000;
    double sampled = 0, widths = 0;
    for (int step = 0; step < steps; ++step) {
      const double bearing = 2 * pi * step / steps;
      if (!has_place(bearing)) continue;
      EXPECT_TRUE(is_seen(bearing)) << i << ": " << bearing;
      sampled += 2 * pi / steps;
    }
    for (const sweep::Bearings& some : seen) widths += some.to - some.from;
    EXPECT_LT(widths, sampled + 0.02) << i;
  }
}

TEST(Footprint, NextToTheFoldedDeadPointIsWhatTheBarsPassOver) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0.5, 0}, Grounding::pole, 100, 50, 0, Point::Zero());
  for (const double nearest : {1e-2, 1e-5, 1e-8}) {
    const Region region{{{{{nearest, -1}, {20, -1}, {20, 1}, {nearest, 1}}, {}}}};
    Raster raster;
    for (int x = 0; x <= 80; ++x)
      for (int y = 0; y <= 8; ++y)
        add_pose(raster, linkage, {nearest + (20 - nearest) * x / 80, -1 + y / 4.0});
    const double area = footprint(linkage, style, region).area;
    EXPECT_GT(area, 0.97 * raster.area()) << nearest;
    EXPECT_LT(area, 1.2 * raster.area()) << nearest;
  }
}

}  // namespace
}  // namespace kempe
