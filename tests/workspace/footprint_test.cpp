// The swept area against a plain count of the cells that the bars pass over, pose by pose.
#include "workspace/footprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/workspace/sampled_mechanism.hpp"

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

}  // namespace
}  // namespace kempe
