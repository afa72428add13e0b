#include "synthesis/paths/coupler_copy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/planar/path.hpp"
#include "synthesis/paths/driven_four_bar.hpp"
#include "synthesis/paths/slack.hpp"

namespace kempe {
namespace {

/// The driver's angles: `copy_places` equally spaced, and the path's own.
struct CopyAngles {
  std::vector<double> all;
  std::vector<std::size_t> own;  ///< which of them are the path's
};

CopyAngles copy_angles(const std::vector<double>& crank_angles, double offset) {
  CopyAngles angles;
  const double first = crank_angles.front(), last = crank_angles.back();
  std::size_t next = 0;
  const auto add_own = [&] {
    angles.own.push_back(angles.all.size());
    angles.all.push_back(crank_angles[next++] + offset);
  };
  for (std::size_t k = 0; k < copy_places; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(copy_places - 1);
    const double angle = first + (last - first) * share;
    while (next < crank_angles.size() && std::abs(crank_angles[next] - first) <= std::abs(angle - first))
      add_own();
    angles.all.push_back(angle + offset);
  }
  while (next < crank_angles.size()) add_own();
  return angles;
}

std::string_view words(CopyPole pole) {
  return pole == CopyPole::crank_pivot ? "crank's pivot" : "rocker's pivot";
}

/// The four-bar that carries the copy, and how it starts.
struct Carrier {
  CouplerFourBar bar;
  CognateDriver driver = CognateDriver::crank;
  double offset = 0,
         start = 0;  ///< rad: of the driver from the answer's crank; the crank's own angle at the first point
};

Carrier carrier_of(const PathAnswer& answer, std::optional<std::size_t> cognate) {
  Carrier carrier{answer.linkage, CognateDriver::crank, 0, answer.crank_angles.front()};
  if (!cognate) return carrier;
  const Cognate& other = answer.cognates.value()[*cognate];
  carrier.bar = other.linkage;
  carrier.driver = other.driver;
  carrier.offset = other.offset;
  // The first cognate's crank is parallel to A-P of the answer, the second turns with the answer's crank.
  carrier.start = other.driver == CognateDriver::crank
                      ? carrier.start + other.offset
                      : answer.coupler_angles.front() + std::arg(as_complex(answer.linkage.coupler_point));
  return carrier;
}

/// A six-bar at its start: the four-bar with the parallelogram that copies, arm and copier.
struct SixBar {
  DrivenFourBar driven;
  int arm, copier;  ///< bodies
};

bool is_by_crank(CopyPole pole) { return pole == CopyPole::crank_pivot; }

/// Where the copier's bars turn about the ground.
Complex pole_place(const CouplerFourBar& bar, CopyPole pole) {
  return as_complex(is_by_crank(pole) ? bar.crank_pivot : bar.rocker_pivot);
}

/// The pole's joint on the coupler, in the coupler's frame.
Complex pole_joint(const CouplerFourBar& bar, CopyPole pole) {
  return is_by_crank(pole) ? Complex(0) : Complex(bar.coupler);
}

/// The copy's links by their lengths; nothing of how they stand.
CouplerCopy copy_links(const Carrier& carrier, Complex s, CopyPole pole) {
  const CouplerFourBar& bar = carrier.bar;
  const Complex joint = pole_joint(bar, pole), to_point = as_complex(bar.coupler_point) - joint;
  CouplerCopy copy;
  copy.pole = pole;
  copy.linkage = bar;
  copy.driver = carrier.driver;
  copy.offset = carrier.offset;
  copy.coupler_joint = as_point(joint + s * to_point);
  copy.arm = std::abs(s * to_point);
  copy.link = is_by_crank(pole) ? bar.crank : bar.rocker;
  copy.copy_point = as_point(copy.link * s);
  return copy;
}

/// Adds the parallelogram where the four-bar stands, and to the copy the places of its joints.
SixBar with_parallelogram(DrivenFourBar driven, Complex s, CouplerCopy& copy) {
  const Complex O = pole_place(copy.linkage, copy.pole), P = as_complex(driven.place.P),
                J = as_complex(is_by_crank(copy.pole) ? driven.place.A : driven.place.B);
  const Complex Q = O + s * (P - J), C = J + s * (P - J);
  copy.Q = as_point(Q);
  copy.C = as_point(C);
  PlanarLinkage& linkage = driven.linkage;
  const int arm = linkage.add_body("arm"), copier = linkage.add_body("copier");
  linkage.add(Revolute{{0, as_point(O)}, {arm, {0, 0}}}, "O");
  linkage.add(Revolute{{arm, {copy.arm, 0}}, {copier, {0, 0}}}, "Q");
  linkage.add(Revolute{{copier, {copy.link, 0}}, {driven.coupler, copy.coupler_joint}}, "C");
  driven.guess.push_back({as_point(O), std::arg(Q - O)});
  driven.guess.push_back({copy.Q, std::arg(C - Q)});
  return {std::move(driven), arm, copier};
}

/// Drives the six-bar over the angles: the copy's places, its error and the parallelogram's least angle go to the copy; or the sentence
/// why not.
std::optional<std::string> drive_over(const SixBar& six_bar, const CopyAngles& angles, Complex s,
                                      CouplerCopy& copy) {
  auto path = PlanarPath::from(six_bar.driven.linkage, six_bar.driven.guess, {angles.all.front()});
  if (!path) return "the six-bar does not close";
  const Complex O = pole_place(copy.linkage, copy.pole);
  const BodyPoint at_P{six_bar.driven.coupler, copy.linkage.coupler_point},
      at_Y{six_bar.copier, copy.copy_point};
  copy.parallelogram_min = pi / 2;
  double side = 0, size = 0;
  for (std::size_t k = 0; k < angles.all.size(); ++k) {
    const auto flat = [&] {
      return fmt::format(
          "its parallelogram lies flat near {:.3f} degrees of the driver: a change point, "
          "where the copy may be lost",
          degrees(angles.all[k]));
    };
    if (!path->advance({angles.all[k]})) return flat();
    const Point Y = path->at(at_Y), wanted = as_point(O + s * (as_complex(path->at(at_P)) - O));
    copy.error_max = std::max(copy.error_max, (Y - wanted).norm());
    size = std::max(size, (wanted - as_point(O)).norm());
    const double opening = std::sin(path->angle(six_bar.arm) - path->angle(six_bar.copier));
    if (k == 0) side = opening;
    copy.parallelogram_min = std::min(copy.parallelogram_min, std::asin(std::min(1.0, std::abs(opening))));
    if (opening * side <= 0 || copy.parallelogram_min < slack::path_from_dead_points) return flat();
    if (std::find(angles.own.begin(), angles.own.end(), k) != angles.own.end()) copy.copied.push_back(Y);
  }
  if (!(copy.error_max <= slack::copied * std::max(size, copy.linkage.longest())))
    return fmt::format("the general solver finds the copy off by {:.3g} mm", copy.error_max);
  return std::nullopt;
}

tl::expected<CouplerCopy, std::string> copy_about(const Carrier& carrier, const PathAnswer& answer, Complex s,
                                                  CopyPole pole) {
  const CouplerFourBar& bar = carrier.bar;
  const auto why_not = [&](std::string_view words_of_it) {
    return tl::unexpected(fmt::format("about the {}: {}", words(pole), words_of_it));
  };
  if (std::abs(as_complex(bar.coupler_point) - pole_joint(bar, pole)) < slack::on_a_joint * bar.coupler)
    return why_not("the coupler point lies on the joint of that crank, and draws a circle");
  CouplerCopy copy = copy_links(carrier, s, pole);
  const CopyAngles angles = copy_angles(answer.crank_angles, carrier.offset);
  auto driven = driven_four_bar(bar, carrier.driver, angles.all.front(), carrier.start);
  if (!driven) return why_not("the four-bar does not close");
  const SixBar six_bar = with_parallelogram(std::move(*driven), s, copy);
  if (const auto fault = drive_over(six_bar, angles, s, copy)) return why_not(*fault);
  return copy;
}

}  // namespace

tl::expected<CouplerCopy, std::string> copy_on_coupler(const PathAnswer& answer,
                                                       std::optional<std::size_t> cognate,
                                                       const CopyTask& task) {
  const Complex s = std::polar(task.scale, task.rotation);
  if (std::abs(s - 1.0) < slack::copies_itself)
    return tl::unexpected(std::string("scale 1 without rotation is the curve itself"));
  const Carrier carrier = carrier_of(answer, cognate);
  if (task.pole) return copy_about(carrier, answer, s, *task.pole);
  auto by_crank = copy_about(carrier, answer, s, CopyPole::crank_pivot);
  auto by_rocker = copy_about(carrier, answer, s, CopyPole::rocker_pivot);
  if (!by_crank && !by_rocker) return tl::unexpected(by_crank.error() + "; " + by_rocker.error());
  if (!by_crank) return by_rocker;
  if (!by_rocker) return by_crank;
  return by_rocker->parallelogram_min > by_crank->parallelogram_min ? by_rocker : by_crank;
}

}  // namespace kempe
