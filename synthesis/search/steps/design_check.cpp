#include "synthesis/search/steps/design_check.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/regions/region_algebra.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/mass.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/search/steps/slack.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

double distance_from_place(const PoleSpec& pole, const Point& place) {
  return pole.is_fixed() ? (place - std::get<Point>(pole.place)).norm()
                         : distance(std::get<Region>(pole.place), place);
}

void measure_lengths(const CopyingLinkage& linkage, Attained& attained) {
  const auto lengths = linkage.lengths().values();
  attained.size = linkage.size();
  attained.shortest = *std::min_element(lengths.begin(), lengths.end());
  attained.longest = *std::max_element(lengths.begin(), lengths.end());
}

void measure_over_openings(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers,
                           const OpeningInterval& needed, Attained& attained, double& load_error_of_links) {
  attained.transmission =
      std::min(linkage.transmission_angle(needed.lower), linkage.transmission_angle(needed.upper));
  attained.clearance = smallest_gap_over(linkage, spec.links.style, layers, needed).gap;
  if (spec.tolerance)
    attained.copy_error =
        copy_error_profile(linkage, CopyTolerance::uniform(*spec.tolerance)).largest(needed).worst.worst;
  if (spec.load && spec.material) {
    load_error_of_links = load_error_profile(spec, linkage.k(), linkage.grounding())
                              .worst_over({linkage.VA(), linkage.VB()}, needed);
    attained.load_error =
        spec.limits.load_error_in_all ? give_in_all(spec, linkage, layers, needed) : load_error_of_links;
  }
  if (spec.limits.sag && spec.material)
    attained.sag = largest_sag(linkage, sag_conditions(spec, layers), needed).sag.most();
}

double copy_gap(const Spec& spec, const CopyingLinkage& linkage) {
  const auto nearest = nearest_places(spec.region, similar_image(spec.region, linkage.k(), linkage.pole()));
  return nearest ? nearest->distance : 0;
}

/// The contact-free interval that holds the openings needed; empty if there is none.
OpeningInterval certified_opening(const Spec& spec, const Requirements& limits, const CopyingLinkage& linkage,
                                  const LayerAssignment& layers, const OpeningInterval& needed) {
  for (const FreeOpenings& free :
       contact_free_openings(linkage, spec.links.style, layers, limits.clearance,
                             linkage.openings_with_transmission(limits.transmission)))
    if (free.interval.contains(needed)) return free.interval;
  return {};
}

std::optional<Goal> first_broken(const Spec& spec, const Requirements& limits, const CopyingLinkage& linkage,
                                 const DesignCheck& check) {
  const Attained& has = check.attained;
  // What is not a number keeps no limit, and an infinite figure breaks every finite one.
  const auto below = [](double value, double least) {
    if (!std::isfinite(least)) return !(value >= least);
    return !(value >= least - slack::limit_rounding * std::abs(least));
  };
  if (below(has.shortest, limits.shortest)) return Goal::shortest;
  if (below(limits.longest, has.longest)) return Goal::longest;
  if (below(limits.pole_margin + slack::pole_rounding * has.size, has.pole_margin)) return Goal::pole_margin;
  if (check.needed.empty() || below(has.transmission, limits.transmission)) return Goal::transmission;
  if (!(has.clearance >= limits.clearance) || check.opening.empty()) return Goal::clearance;
  if (limits.copy_error && below(*limits.copy_error, has.copy_error)) return Goal::copy_error;
  if (limits.load_error && below(*limits.load_error, has.load_error)) return Goal::load_error;
  if (limits.mass && below(*limits.mass, has.mass)) return Goal::mass;
  if (limits.sag && below(*limits.sag, has.sag)) return Goal::sag;
  if (limits.size && below(*limits.size, has.size)) return Goal::size;
  if (limits.copy_gap &&
      !are_apart(spec.region, similar_image(spec.region, linkage.k(), linkage.pole()), *limits.copy_gap))
    return Goal::copy_gap;
  return std::nullopt;
}

}  // namespace

DesignCheck check_design(const Spec& spec, const Requirements& limits, const CopyingLinkage& linkage,
                         const LayerAssignment& layers) {
  DesignCheck check;
  measure_lengths(linkage, check.attained);
  if (spec.material) check.attained.mass = mass_of_links(linkage, spec);
  check.attained.pole_margin = distance_from_place(spec.pole, linkage.pole());
  if (limits.copy_gap) check.attained.copy_gap = copy_gap(spec, linkage);
  if (const auto needed = openings_over(linkage, spec.region)) {
    check.needed = *needed;
    measure_over_openings(spec, linkage, layers, *needed, check.attained, check.load_error_of_links);
    check.opening = certified_opening(spec, limits, linkage, layers, *needed);
  }
  check.broken = first_broken(spec, limits, linkage, check);
  check.feasible = !check.broken;
  return check;
}

bool keeps_stock_lengths(const CopyingLinkage& linkage, const StockLengths& stock_lengths) {
  const auto are_one = [](double a, double b) {
    return std::abs(a - b) <= slack::same_length * std::max(a, b);
  };
  const auto is_in_stock = [&](double length) {
    const auto& [grid, stock, locked] = stock_lengths;
    if (grid && !are_one(length, std::max(1.0, std::round(length / *grid)) * *grid)) return false;
    return stock.empty() ||
           std::any_of(stock.begin(), stock.end(), [&](double one) { return are_one(length, one); });
  };
  const LinkLengths lengths = linkage.lengths();
  const auto values = lengths.values();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (stock_lengths.locked[i] && !are_one(values[i], *stock_lengths.locked[i])) return false;
  return is_in_stock(lengths.VA) && is_in_stock(lengths.VB) && is_in_stock(lengths.AX) &&
         is_in_stock(lengths.BY);
}

}  // namespace kempe
