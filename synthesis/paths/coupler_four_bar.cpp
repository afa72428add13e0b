#include "synthesis/paths/coupler_four_bar.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/planar/path.hpp"
#include "synthesis/paths/driven_four_bar.hpp"
#include "synthesis/paths/slack.hpp"

namespace kempe {
namespace {

double direction_of(const Point& v) { return std::arg(as_complex(v)); }

/// The four-bar whose joints stand at these places.
CouplerFourBar four_bar_at(const Point& A0, const Point& A, const Point& B, const Point& B0, const Point& P) {
  CouplerFourBar bar;
  bar.crank_pivot = A0;
  bar.rocker_pivot = B0;
  bar.crank = (A - A0).norm();
  bar.coupler = (B - A).norm();
  bar.rocker = (B - B0).norm();
  const Complex along = as_complex(B - A) / bar.coupler;
  bar.coupler_point = as_point(as_complex(P - A) / along);
  // FourBar's first branch has B clockwise of A as B0 sees them.
  bar.branch = cross(A - B0, B - B0) < 0 ? FourBarBranch::first : FourBarBranch::second;
  return bar;
}

}  // namespace

std::optional<CouplerFourBar::Place> CouplerFourBar::at(double crank_angle) const {
  const double base = direction_of(rocker_pivot - crank_pivot);
  const auto output = links().output_angle(crank_angle - base);
  if (!output) return std::nullopt;
  Place place;
  place.A = crank_pivot + as_point(std::polar(crank, crank_angle));
  place.B = rocker_pivot + as_point(std::polar(rocker, *output + base));
  const Complex along = as_complex(place.B - place.A) / coupler;
  place.P = place.A + as_point(as_complex(coupler_point) * along);
  return place;
}

std::optional<double> CouplerFourBar::least_transmission_angle(double first, double last) const {
  const double base = direction_of(rocker_pivot - crank_pivot);
  return links().least_transmission_angle(first - base, last - base);
}

double CouplerFourBar::longest() const {
  return std::max(
      {ground(), crank, coupler, rocker, coupler_point.norm(), (coupler_point - Point(coupler, 0)).norm()});
}

std::optional<std::array<Cognate, 2>> cognates_of(const CouplerFourBar& bar, double crank_angle) {
  const auto place = bar.at(crank_angle);
  if (!place) return std::nullopt;
  const Complex k = as_complex(bar.coupler_point) / bar.coupler;
  if (std::abs(k) < slack::on_a_joint || std::abs(k - 1.0) < slack::on_a_joint) return std::nullopt;
  const Complex A0 = as_complex(bar.crank_pivot), B0 = as_complex(bar.rocker_pivot), A = as_complex(place->A),
                B = as_complex(place->B), P = as_complex(place->P);
  const Complex C0 = A0 + k * (B0 - A0);
  const Complex A1 = A0 + P - A, C1 = A0 + k * (B - A0);
  const Complex B1 = B0 + P - B, C2 = B0 + (1.0 - k) * (A - B0);
  const auto made = [&](Complex pivot, Complex joint, Complex other, Complex other_pivot) {
    return four_bar_at(as_point(pivot), as_point(joint), as_point(other), as_point(other_pivot), place->P);
  };
  // C1 - A1 = k (A - A0), C2 - C0 = (1 - k) (A - A0): they turn with the crank.
  return std::array<Cognate, 2>{Cognate{made(A0, A1, C1, C0), CognateDriver::coupler, std::arg(k)},
                                Cognate{made(C0, C2, B1, B0), CognateDriver::crank, std::arg(1.0 - k)}};
}

std::optional<DrivenFourBar> driven_four_bar(const CouplerFourBar& bar, CognateDriver driver, double angle,
                                             double start) {
  const auto place = bar.at(start);
  if (!place) return std::nullopt;
  DrivenFourBar driven;
  driven.place = *place;
  PlanarLinkage& linkage = driven.linkage;
  driven.crank = linkage.add_body("crank");
  driven.coupler = linkage.add_body("coupler");
  driven.rocker = linkage.add_body("rocker");
  linkage.add(Revolute{{0, bar.crank_pivot}, {driven.crank, {0, 0}}}, "A0");
  linkage.add(Revolute{{driven.crank, {bar.crank, 0}}, {driven.coupler, {0, 0}}}, "A");
  linkage.add(Revolute{{driven.coupler, {bar.coupler, 0}}, {driven.rocker, {bar.rocker, 0}}}, "B");
  linkage.add(Revolute{{0, bar.rocker_pivot}, {driven.rocker, {0, 0}}}, "B0");
  const bool by_crank = driver == CognateDriver::crank;
  linkage.drive(RelativeAngle{by_crank ? driven.crank : driven.coupler, PlanarLinkage::ground, angle},
                "driver");
  // A guess may lie whole turns away from the driver's value, which a continuous angle does not.
  const auto near = [](double turned, double to) {
    return turned + 2 * pi * std::round((to - turned) / (2 * pi));
  };
  driven.guess = PlanarPosition(4);
  const auto at = [&](int body) -> BodyPlacement& { return driven.guess[static_cast<std::size_t>(body)]; };
  at(driven.crank) = {bar.crank_pivot, by_crank ? angle : direction_of(place->A - bar.crank_pivot)};
  const double along = direction_of(place->B - place->A);
  at(driven.coupler) = {place->A, by_crank ? along : near(along, angle)};
  at(driven.rocker) = {bar.rocker_pivot, direction_of(place->B - bar.rocker_pivot)};
  return driven;
}

std::optional<CertifiedPath> certified_path(const CouplerFourBar& bar, CognateDriver driver,
                                            const std::vector<double>& angles, double start) {
  if (angles.empty()) return std::nullopt;
  const auto driven = driven_four_bar(bar, driver, angles.front(), start);
  if (!driven) return std::nullopt;
  const BodyPoint P{driven->coupler, bar.coupler_point};
  auto path = PlanarPath::from(driven->linkage, driven->guess, {angles.front()});
  if (!path) return std::nullopt;
  CertifiedPath motion;
  for (const double angle : angles) {
    if (!path->advance({angle})) return std::nullopt;
    motion.reached.push_back(path->at(P));
    motion.coupler_angle.push_back(path->angle(driven->coupler));
  }
  return motion;
}

}  // namespace kempe
