#include "synthesis/design/assemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "geometry/fixed_text.hpp"
#include "kinematics/parallel.hpp"
#include "specs/hardware.hpp"
#include "synthesis/design/allowed.hpp"
#include "synthesis/loads/assess_loads.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/mass.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/problem/obstacle_reach.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "synthesis/tolerance/corner_error.hpp"
#include "workspace/footprint.hpp"
#include "workspace/map/layer_choice.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// Over the region, or without one over the certified opening; where the region is not reached 0.
double smallest_transmission(const CopyingLinkage& linkage, const Region& region,
                             const OpeningInterval& certified) {
  const bool anywhere = region.empty() && !certified.empty();
  const auto openings = anywhere ? std::optional(certified) : openings_over(linkage, region);
  if (!openings) return 0;
  return std::min(linkage.transmission_angle(openings->lower), linkage.transmission_angle(openings->upper));
}

void measure_copy_error(Design& design) {
  if (!design.tolerance) return;
  const CopyTolerance tolerance = CopyTolerance::uniform(*design.tolerance);
  const ErrorPlaces places = error_places(design.region);
  const auto error = copy_error_over(design.linkage, tolerance, places);
  if (!error) return;
  design.quality.copy_error_worst = error->worst;
  design.quality.copy_error_rss = error->rss;
  design.quality.distortion_worst = error->distortion_worst;
  const auto corner = corner_error_over(design.linkage, tolerance, places.reach);
  if (corner && first_order_understates(error->worst, corner->worst))
    design.quality.copy_error_at_corner = corner->worst;
}

/// Nine digits: what is left after a system of equations is solved on any processor. Of a finite value; at least 0.
double with_nine_digits(double value) { return value > 0 ? with_digits(value, 9) : 0; }

/// Mass and loads; over the region alone.
void measure_loads(Design& design, const Spec& spec) {
  if (design.material) design.quality.mass = mass_of_links(design.linkage, spec);
  if (!design.material) return;
  const auto openings = openings_over(design.linkage, design.region);
  if (!openings) return;
  const SagConditions conditions = sag_conditions(spec, design.layers);
  if (design.load) {
    const CopyingLinkage& linkage = design.linkage;
    design.quality.loads = load_figures_over(spec, linkage, *openings);
    const BarLengths lengths{linkage.VA(), linkage.VB()};
    const LayeredErrorProfile profile(linkage.k(), linkage.grounding(), conditions,
                                      most_force_at_pen(*spec.load));
    design.quality.layered = profile.over(lengths, *openings);
    if (auto& layered = design.quality.layered) {
      const auto stresses = profile.stresses_over(
          lengths, *openings, widest_hole(spec.links.style, spec.links.hardware, spec.cutting));
      const auto rounded = [](const std::optional<double>& figure) {
        return figure ? std::optional(with_nine_digits(*figure)) : std::nullopt;
      };
      layered = LayeredFigures{.error_max = with_nine_digits(layered->error_max),
                               .rise_max = with_nine_digits(layered->rise_max),
                               .weight_error_max = rounded(layered->weight_error_max),
                               .weight_rise_max = rounded(layered->weight_rise_max)};
      if (stresses && std::isfinite(stresses->largest()))
        layered->stress_max = with_nine_digits(stresses->largest());
    }
  }
  const double sag = largest_sag(design.linkage, conditions, *openings).sag.most();
  if (std::isfinite(sag)) design.quality.sag = with_nine_digits(sag);
}

void measure_robustness(Design& design) {
  if (!design.tolerance || !design.tolerance->robust || design.region.empty()) return;
  const RobustCheck check = check_robust(map_task(design), CopyTolerance::uniform(*design.tolerance));
  design.quality.robust =
      Robustness{.holds = design.map.coverage.covered && check.keeps(design.limits.clearance),
                 .clearance = check.clearance,
                 .clearance_loss = design.quality.clearance_min - check.clearance};
}

/// rad: half turns either way that differ by no more are one.
constexpr double same_turn = 1e-12;

/// With stock lengths k may be off: the design then states what it attains, and what was wanted beside it.
void note_ratio(Design& design, const Copy& copy) {
  constexpr double exact = 1e-12;  // share of the ratio: what rounding leaves of one that is kept
  const double error = std::abs(design.linkage.k() - copy.k());
  if (error <= exact * std::abs(copy.k())) return;
  design.wanted = WantedCopy{copy.scale(), copy.rotation(), error};
  design.scale = std::abs(design.linkage.k());
  design.rotation = std::arg(design.linkage.k());
  if (design.rotation <= -pi + same_turn) design.rotation = pi;  // by rounding alone it is not +180 degrees
}

/// The search's certificate holds where the map's was stopped.
void cover_as_searched(Design& design, const StopFlag& stop) {
  if (!stop() || !design.map.coverage.uncertain) return;
  design.map.coverage = {};
  design.map.coverage.covered = true;
}

/// An infinite area where it was stopped.
void measure_footprint(Design& design, const StopFlag& stop) {
  auto swept = footprint_unless(stop, design.linkage, design.style, design.region);
  design.quality.footprint = swept ? swept->area : HUGE_VAL;
  if (swept) design.footprint = std::move(swept->outline);
}

enum class From { search, spec };

/// All of a design that needs no map.
Design unmapped(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers) {
  Design design{.linkage = linkage,
                .title = spec.title,
                .scale = spec.copy.scale(),
                .rotation = spec.copy.rotation(),
                .region = spec.region,
                .style = spec.links.style,
                .layers = layers,
                .limits = spec.limits,
                .tolerance = spec.tolerance,
                .obstacles = spec.obstacles,
                .bodies = spec.bodies,
                .table = spec.table,
                .tool = tool_advice(spec.tool, std::abs(linkage.k())),
                .cutting = spec.cutting,
                .hardware = spec.links.hardware,
                .material = spec.material,
                .load = spec.load};
  note_ratio(design, spec.copy);
  return design;
}

using Job = std::function<void()>;

/// Maps and measures a design; what needs no map is worked out beside it, the longest first. `beside` is more of that kind: on one thread it
/// comes last, for where time is short the design's own figures are wanted first.
void map_and_measure(Design& design, const Spec& spec, const MapOptions& options, Detail detail, From from,
                     int threads = 1, const Job& why_layers = {}, const Job& beside = {}) {
  MapOptions on_threads = options;
  on_threads.threads = threads;
  std::vector<Job> jobs{[&] {
                          design.map = map_workspace(map_task(design), on_threads);
                          if (from == From::search) cover_as_searched(design, options.stop);
                        },
                        [&] {
                          if (detail == Detail::full) measure_footprint(design, options.stop);
                        },
                        why_layers,
                        [&] {
                          measure_copy_error(design);
                          measure_loads(design, spec);
                        }};
  jobs.insert(threads > 1 ? jobs.begin() + 1 : jobs.end(), beside);
  run_parallel(jobs.size(), threads, [&](std::size_t i) {
    if (jobs[i]) jobs[i]();
  });
  design.opening = design.map.certified_opening;
  design.quality.size = design.linkage.size();
  design.quality.transmission_min = smallest_transmission(design.linkage, design.region, design.opening);
  design.quality.clearance_min = design.map.clearance_min;
  measure_robustness(design);
}

/// Every assignment compared by its gap over the region, obstacles included. `likely`: what may be the best of them.
LayerChoice layer_choice(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& likely,
                         int most_layers, const StopFlag& stop) {
  return choose_layers(map_task(linkage, likely, spec), most_layers, stop);
}

InputError no_mechanism(const std::string& file) {
  return {file, 0, "mechanism", "no such table",
          "[mechanism] with vertex, VA_mm, VB_mm and assembly; kempe synthesize finds one"};
}

}  // namespace

tl::expected<CopyingLinkage, InputError> given_linkage(const Spec& spec, const std::string& file) {
  if (!spec.mechanism) return tl::unexpected(no_mechanism(file));
  if (!spec.pole.is_fixed())
    return tl::unexpected(
        InputError{file, 0, "pole.within_mm", "an area", "at_mm: a given mechanism stands at one place"});
  const MechanismSpec& given = *spec.mechanism;
  const auto linkage = CopyingLinkage::make(spec.copy.k(), given.grounding, given.VA, given.VB,
                                            given.assembly_mode, std::get<Point>(spec.pole.place));
  if (linkage) return *linkage;
  const std::size_t count = assembly_modes(shape_of(spec.copy.k(), given.grounding)).size();
  return tl::unexpected(InputError{file, 0, "mechanism", std::string(name(linkage.error())),
                                   fmt::format("positive lengths and an assembly mode below {}", count)});
}

/// What keeps joints apart, if a bearing or bush is wider than the thickest pin.
std::optional<double> seat_of(const Spec& spec) {
  const LinkSpec& links = spec.links;
  if (widest_seat(links.hardware) <= links.style.pin_diameter) return std::nullopt;
  return widest_hole(links.style, links.hardware, spec.cutting);
}

Allowed allowed_by(const Spec& spec) {
  return {spec.pole,
          spec.links.layers,
          spec.links.shortest,
          spec.links.longest,
          spec.links.stock_lengths,
          spec.objective.groundings,
          least_wall(spec),
          seat_of(spec),
          spec.links.sections};
}

void allow(Spec& spec, const Allowed& allowed) {
  spec.pole = allowed.pole;
  spec.links.layers = allowed.layers;
  spec.links.shortest = allowed.shortest;
  spec.links.longest = allowed.longest;
  spec.links.stock_lengths = allowed.stock_lengths;
  spec.links.wall = allowed.wall;
  spec.links.sections = allowed.sections;
  spec.objective.groundings = allowed.groundings;
}

Spec spec_of(const Design& design) {
  Spec spec;
  spec.title = design.title;
  spec.copy = design.wanted ? Copy::of(design.wanted->scale, design.wanted->rotation)
                            : Copy::of(design.scale, design.rotation);
  spec.region = design.region;
  spec.links.style = design.style;
  spec.limits = design.limits;
  spec.tolerance = design.tolerance;
  spec.obstacles = design.obstacles;
  spec.bodies = design.bodies;
  spec.table = design.table;
  spec.cutting = design.cutting;
  spec.links.hardware = design.hardware;
  spec.material = design.material;
  spec.load = design.load;
  if (design.search) spec.objective.objective = design.search->objective;
  if (design.allowed) allow(spec, *design.allowed);
  return spec;
}

MapTask map_task(const Design& design) {
  return {.linkage = design.linkage,
          .style = design.style,
          .layers = design.layers,
          .limits = design.limits,
          .obstacles = design.obstacles,
          .bodies = design.bodies,
          .table = design.table,
          .region = design.region};
}

Design assemble_design(const Spec& asked, const FoundDesign& found, const MapOptions& options, Detail detail,
                       int threads, const BesideMap& beside) {
  Spec spec = asked;
  if (found.section) use_section(spec.links.style, *found.section);
  Design design = unmapped(spec, found.linkage, found.layers);
  design.search = SearchRecord{.objective = objective_of(found.goal).value_or(spec.objective.objective),
                               .value = found.value,
                               .solvers = found.solvers,
                               .evaluations = found.evaluations,
                               .seed = found.seed,
                               .complete = found.complete,
                               .obstacles_out_of_reach = names_out_of_reach(spec)};
  design.quality.proven_bound = found.proven_bound;
  design.allowed = allowed_by(spec);
  const auto ask_for_fewer_layers = [&] {
    if (detail != Detail::full || found.layers.highest() <= 2 || options.stop()) return;
    LayerChoice choice =
        layer_choice(spec, found.linkage, found.layers, found.layers.highest(), options.stop);
    if (!options.stop()) design.why_not_fewer_layers = std::move(choice.why_not_fewer);
  };
  const auto more = [&] {
    if (beside) beside(design);
  };
  map_and_measure(design, spec, options, detail, From::search, threads, ask_for_fewer_layers, more);
  if (design.quality.robust) design.quality.robust->nominal_value = found.nominal_value;
  return design;
}

tl::expected<Design, std::string> certified_design(const Spec& spec, const FoundDesign& found,
                                                   const MapOptions& options, Detail detail, int threads,
                                                   const BesideMap& beside) {
  if (!keeps_stock_lengths(found.linkage, spec.links.stock_lengths))
    return tl::unexpected(std::string("the design found has lengths that links does not allow"));
  Design design = assemble_design(spec, found, options, detail, threads, beside);
  const auto& robust = design.quality.robust;
  if (design.map.coverage.covered && robust && !robust->holds)
    return tl::unexpected(std::string("the design found is not proven to be robust"));
  if (design.map.coverage.covered) return design;
  return tl::unexpected("the map does not certify the design found: " + design.map.coverage.why_not);
}

Design assemble_given(const Spec& spec, const CopyingLinkage& linkage, const MapOptions& options) {
  LayerChoice choice;
  if (spec.mechanism && spec.mechanism->layers)
    choice.best = LayerAssignment{*spec.mechanism->layers};
  else
    choice = layer_choice(spec, linkage, {}, spec.links.layers, options.stop);
  Design design = unmapped(spec, linkage, choice.best);
  map_and_measure(design, spec, options, Detail::full, From::spec);
  design.why_not_fewer_layers = std::move(choice.why_not_fewer);
  return design;
}

}  // namespace kempe
