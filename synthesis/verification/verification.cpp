// Steps: bodies from lengths - a first position near the middle of the opening - drive to the region - follow its rings
// and hatch its inside - compare the pen with k - fit a similarity - check the limits.

#include "synthesis/verification/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/fixed_text.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/verification/bodies.hpp"
#include "synthesis/verification/drive.hpp"
#include "synthesis/verification/obstacles.hpp"
#include "synthesis/verification/slack.hpp"
#include "synthesis/verification/stations.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// Complex least squares of pen = m * tracer + t over what was driven; m alone is wanted.
class SimilarityFit {
 public:
  void add(Complex tracer, Complex pen) { pairs_.emplace_back(tracer, pen); }

  Complex ratio() const {
    Complex tracer_mean = 0, pen_mean = 0;
    const double count = static_cast<double>(pairs_.size());
    for (const auto& [tracer, pen] : pairs_) {
      tracer_mean += tracer / count;
      pen_mean += pen / count;
    }
    Complex moment = 0;
    double spread = 0;
    for (const auto& [tracer, pen] : pairs_) {
      moment += std::conj(tracer - tracer_mean) * (pen - pen_mean);
      spread += std::norm(tracer - tracer_mean);
    }
    return spread > 0 ? moment / spread : 0;
  }

 private:
  std::vector<std::pair<Complex, Complex>> pairs_;
};

/// The checks of one task while it is driven; remembers the first failure.
class Checks {
 public:
  Checks(const VerificationTask& task, double size, double copy_error_allowed)
      : task_(task), size_(size), copy_error_allowed_(copy_error_allowed) {
    const DrawnMechanism& drawn = task.mechanism;
    const auto grounding = grounding_with({drawn.pole, drawn.tracer, drawn.pen}).value_or(Grounding::pen);
    const auto linkage = CopyingLinkage::make(task.k, grounding, drawn.lengths.VA, drawn.lengths.VB, 0);
    if (linkage) {
      pairs_ = contact_pairs(*linkage, task.layers);
      shape_ = linkage->shape();
      watch_.emplace(*linkage, task);
      bodies_.emplace(*linkage, task);
    }
    check_lengths();
  }

  /// `pose` as seen from the pole.
  void see(const Pose& pose, double residual) {
    ++result_.samples;
    const Point& tracer = pose[task_.mechanism.tracer];
    const Point& pen = pose[task_.mechanism.pen];
    const Complex reach = as_complex(tracer);
    const double copy_error = std::abs(as_complex(pen) - task_.k * reach);
    result_.copy_error_max = std::max(result_.copy_error_max, copy_error);
    result_.loop_residual_max = std::max(result_.loop_residual_max, residual);
    fit_.add(reach, as_complex(pen));
    if (!(residual <= slack::loop_residual_share * size_))
      fail({"mechanism.lengths_mm", residual, slack::loop_residual_share * size_, tracer,
            fmt::format("the loop residual is {:.3g} mm", residual)});
    if (!(copy_error <= copy_error_allowed_))
      fail({"copy", copy_error, copy_error_allowed_, tracer,
            fmt::format("the pen is {:.3g} mm from where the ratio puts it", copy_error)});
    check_assembly_mode(pose, tracer);
    check_transmission(pose, tracer);
    check_clearance(pose, tracer);
    check_obstacles(pose, tracer);
    check_bodies(pose, tracer);
  }

  /// Remembers the first breach of each limit, and the first of all as the failure.
  /// `where` as seen from the pole.
  void fail(BrokenLimit breach) {
    if (breach.where) {
      *breach.where += task_.mechanism.pole_position;
      breach.sentence +=
          fmt::format(" with the tracer at ({:.10g}, {:.10g})", breach.where->x(), breach.where->y());
    }
    if (result_.failure.empty()) result_.failure = breach.sentence;
    const bool known = std::any_of(result_.broken.begin(), result_.broken.end(),
                                   [&](const BrokenLimit& one) { return one.limit == breach.limit; });
    if (!known) result_.broken.push_back(std::move(breach));
  }

  bool has_driven() const { return result_.samples > 0 || !result_.failure.empty(); }
  void is_over_workspace() { result_.over_workspace = true; }

  Verification result() {
    const Complex ratio = fit_.ratio();
    result_.scale = std::abs(ratio);
    result_.rotation = std::arg(ratio);
    if (result_.samples < 3) fail({.limit = "region", .sentence = "the tracer could not be driven anywhere"});
    const double ratio_allowed = slack::ratio_share * (1 + std::abs(task_.k));
    if (result_.samples >= 3 && std::abs(ratio - task_.k) > ratio_allowed)
      fail({.limit = "copy",
            .attained = std::abs(ratio - task_.k),
            .allowed = ratio_allowed,
            .sentence = fmt::format("the driven pairs give scale {:.9g} and rotation {:.9g} degrees",
                                    result_.scale, degrees(result_.rotation))});
    result_.holds = result_.failure.empty();
    return result_;
  }

 private:
  void check_lengths() {
    const auto values = task_.mechanism.lengths.values();
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const bool short_ = values[i] < task_.shortest * (1 - slack::length_slack);
          short_ || values[i] > task_.longest * (1 + slack::length_slack))
        fail({.limit = short_ ? "links.shortest_mm" : "links.longest_mm",
              .attained = values[i],
              .allowed = short_ ? task_.shortest : task_.longest,
              .sentence = fmt::format("{} = {:.6g} mm lies outside {:.6g} .. {:.6g} mm",
                                      LinkLengths::names[i], values[i], task_.shortest, task_.longest)});
  }

  void check_assembly_mode(const Pose& pose, const Point& tracer) {
    const std::array<Side, 2> sides{side_of(cross(pose.A - pose.V, pose.B - pose.V)),
                                    side_of(cross(pose.A - pose.V, pose.X - pose.A))};
    if (result_.samples > 1 && sides != sides_) {
      ++result_.flips;
      fail({"mechanism.assembly", std::nullopt, std::nullopt, tracer,
            "the linkage changed its assembly mode"});
    }
    sides_ = sides;
    const OpeningInterval& allowed = task_.mechanism.opening;
    double opening = std::arg(as_complex(pose.B - pose.V) / as_complex(pose.A - pose.V));
    opening -= 2 * pi * std::round((opening - allowed.middle()) / (2 * pi));
    if (opening < allowed.lower - slack::opening_slack || opening > allowed.upper + slack::opening_slack)
      fail({"mechanism.opening_deg", degrees(opening),
            degrees(opening < allowed.lower ? allowed.lower : allowed.upper), tracer,
            fmt::format("the opening {} degrees leaves {} .. {}", fixed_text(degrees(opening), 6),
                        fixed_text(degrees(allowed.lower), 6), fixed_text(degrees(allowed.upper), 6))});
  }

  void check_transmission(const Pose& pose, const Point& tracer) {
    const auto angle = [](const Point& a, const Point& b) {
      return std::atan2(std::abs(cross(a, b)), std::abs(a.dot(b)));
    };
    if (!task_.limits) return;
    const double seen =
        std::min(angle(pose.V - pose.A, pose.X - pose.A), angle(pose.A - pose.V, pose.B - pose.V));
    if (seen < task_.limits->transmission - slack::transmission_slack)
      fail({"limits.transmission_deg", degrees(seen), degrees(task_.limits->transmission), tracer,
            fmt::format("the transmission angle is {:.6f} degrees, less than {:.6f}", degrees(seen),
                        degrees(task_.limits->transmission))});
  }

  void check_clearance(const Pose& pose, const Point& tracer) {
    if (!task_.limits) return;
    for (const ContactPair& pair : pairs_) {
      const double free = gap(pair, pose, shape_, task_.style);
      if (free < task_.limits->clearance - slack::clearance_share * size_)
        fail({"limits.clearance_mm", free, task_.limits->clearance, tracer,
              fmt::format("{} are {:.6g} mm apart, less than {:.6g}", name(pair), free,
                          task_.limits->clearance)});
    }
  }

  void check_obstacles(const Pose& pose, const Point& tracer) {
    if (!task_.limits || !watch_) return;
    const auto near = watch_->nearest(pose, task_.limits->clearance - slack::clearance_share * size_);
    if (near)
      fail({"obstacles", near->gap, task_.limits->clearance, tracer,
            fmt::format("{} and {} are {:.6g} mm apart, less than {:.6g}", near->part, near->obstacle,
                        near->gap, task_.limits->clearance)});
  }

  void check_bodies(const Pose& pose, const Point& tracer) {
    if (!task_.limits || !bodies_) return;
    bodies_->for_each_near(pose, task_.limits->clearance - slack::clearance_share * size_,
                           [&](const BodyWatch::Near& near) {
                             fail({near.key, near.gap, task_.limits->clearance, tracer,
                                   fmt::format("{} and {} are {:.6g} mm apart, less than {:.6g}", near.one,
                                               near.other, near.gap, task_.limits->clearance)});
                           });
  }

  const VerificationTask& task_;
  double size_, copy_error_allowed_;
  std::vector<ContactPair> pairs_;
  Complex shape_{};
  std::array<Side, 2> sides_{};
  std::optional<ObstacleWatch> watch_;
  std::optional<BodyWatch> bodies_;
  SimilarityFit fit_;
  Verification result_;
};

double sum_of_lengths(const LinkLengths& lengths) {
  double sum = 0;
  for (const double length : lengths.values()) sum += length;
  return sum;
}

/// Of the stations that are left when it is stopped so many are driven to, evenly spread.
constexpr std::size_t last_stations = 16;

/// Drives over all stations, until it is stopped: of the region all must be reached, of the workspace those that rounding
/// lets it reach. True if none was left out.
bool drive_over(const std::vector<Point>& stations, const VerificationTask& task, const StopFlag& stop,
                Checks& checks) {
  auto drive = Drive::make(task.mechanism, stations.front());
  if (!drive) {
    checks.fail({.limit = "mechanism.lengths_mm", .sentence = drive.error()});
    return true;
  }
  std::size_t step = 1;
  for (std::size_t i = 0; i < stations.size(); i += step) {
    if (step == 1 && stop()) step = 1 + (stations.size() - i) / last_stations;
    if (const auto arrived = drive->go_to(stations[i]))
      checks.see(drive->pose(), drive->residual());
    else if (task.region_covered) {
      checks.fail({"region", std::nullopt, std::nullopt, stations[i], arrived.error()});
      break;
    } else if (step > 1)
      break;  // the way to where it cannot get is the longest
  }
  return step == 1;
}

/// What is free at the certified opening; else all of that opening, or what is usable where none is certified.
ArcRegion parts_to_drive_over(const MapTask& task, const WorkspaceMap& map) {
  if (map.certified_opening.empty()) return map.collision_free.empty() ? map.usable : map.collision_free;
  const Annulus held = annulus_over(task.linkage, map.certified_opening);
  const double rounding = slack::length_slack * held.outer;
  ArcRegion free = map.collision_free;
  std::erase_if(free, [&](const ArcPolygon& part) {
    return std::any_of(part.outer.begin(), part.outer.end(), [&](const ArcVertex& vertex) {
      const double radius = (vertex.at - held.centre).norm();
      return radius < held.inner - rounding || radius > held.outer + rounding;
    });
  });
  return free.empty() ? as_region(held) : free;
}

/// The largest of some parts, its arcs as chords within it, off by at most `tolerance` (mm).
Region largest_of(const ArcRegion& parts, double tolerance) {
  const auto largest = std::max_element(
      parts.begin(), parts.end(), [](const ArcPolygon& a, const ArcPolygon& b) { return area(a) < area(b); });
  if (largest == parts.end()) return {};
  return {{flattened(*largest, tolerance, Flatten::shrinks)}};
}

/// Where no opening keeps the limits: what the assembly mode reaches away from its dead and change points.
Region reach_without_limits(const CopyingLinkage& linkage) {
  constexpr double margin = 0.1, share = 0.1;  // of the mode's openings, at each end; of the ring's width
  const OpeningInterval& all = linkage.assembly_mode().openings;
  const Annulus ring = annulus_over(linkage, shrink(all, margin * all.width()));
  return largest_of(as_region(ring), share * (ring.outer - ring.inner));
}

}  // namespace

Region part_to_drive_over(const MapTask& task, const WorkspaceMap& map) {
  return largest_of(parts_to_drive_over(task, map), slack::fine_outline * chain_annulus(task.linkage).outer);
}

VerificationTask verification_task(const Design& design) {
  const CopyingLinkage& l = design.linkage;
  VerificationTask task;
  task.mechanism = {l.lengths(), l.assembly_mode().sides, l.pole_joint(), l.tracer_joint(), l.pen_joint(),
                    l.pole(),    design.opening,          l.shape()};
  task.k = l.k();
  task.region = design.region;
  task.region_covered = design.map.coverage.covered;
  if (task.region.empty() || !task.region_covered)
    task.workspace = part_to_drive_over(map_task(design), design.map);
  if (design.opening.empty()) {  // no opening keeps the limits: what is left to show is that it copies
    task.mechanism.opening = l.openings_with_transmission(design.limits.transmission);
    if (task.mechanism.opening.empty()) {
      task.mechanism.opening = l.assembly_mode().openings;
      task.workspace = reach_without_limits(l);
    }
    task.region_covered = false;
  }
  task.style = design.style;
  task.layers = design.layers;
  if (task.region_covered) {
    task.limits = design.limits;
    task.obstacles = design.obstacles;
    task.bodies = design.bodies;
    task.table = design.table;
  }
  return task;
}

Verification verify(const VerificationTask& task, const VerificationOptions& options) {
  return run_verification(task, options).found;
}

VerificationRun run_verification(const VerificationTask& task, const VerificationOptions& options) {
  const double size = sum_of_lengths(task.mechanism.lengths);
  Checks checks(task, size, options.copy_error_share * size);
  const Point& pole = task.mechanism.pole_position;
  // A region that is not covered asks for positions beyond the certified opening.
  bool complete = true;
  if (!task.region.empty() && (task.region_covered || task.workspace.empty()))
    complete = drive_over(stations_over(task.region, pole, options), task, options.stop, checks);
  if (checks.has_driven() || task.workspace.empty()) return {checks.result(), complete};
  checks.is_over_workspace();
  complete = drive_over(stations_over(task.workspace, pole, options), task, options.stop, checks);
  return {checks.result(), complete};
}

}  // namespace kempe
