// Copy error of one linkage at places of the table and over a region: what a similarity absorbs and what it
// leaves.

#include <algorithm>
#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "synthesis/tolerance/slack.hpp"

namespace kempe {
namespace {

/// Where the tracer stands inside the mechanism: the opening, and the direction of bar VA.
struct Stance {
  double opening;
  Complex VA_direction;
};

tl::expected<Stance, Unreachable> stance_at(const CopyingLinkage& linkage, const Point& tracer) {
  const Complex reach = as_complex(tracer - linkage.pole());
  return linkage.opening_at(std::abs(reach)).map([&](double opening) {
    const Complex factor = chain_per_tracer(linkage.k(), linkage.grounding());
    const Complex chain = factor * reach;  // X - V = p + q/s
    const Complex p = chain / (linkage.VA() + std::polar(linkage.VB(), opening) / linkage.shape());
    return Stance{opening, p / std::abs(p)};
  });
}

/// A sensitivity's field over the places: the similarity alpha + beta (z - centre) nearest to it, and its
/// value there.
struct AbsorbedField {
  Complex alpha{}, beta{};
  Complex at(Complex from_centre) const { return alpha + beta * from_centre; }
};

class Fit {
 public:
  explicit Fit(const std::vector<Point>& places) {
    for (const Point& place : places) centre_ += as_complex(place) / static_cast<double>(places.size());
    for (const Point& place : places) spread_ += std::norm(as_complex(place) - centre_);
    count_ = static_cast<double>(places.size());
  }
  Complex from_centre(const Point& place) const { return as_complex(place) - centre_; }

  std::array<AbsorbedField, 8> absorbed(const std::vector<Point>& places,
                                        const std::vector<Sensitivities>& fields) const {
    std::array<AbsorbedField, 8> result{};
    for (std::size_t n = 0; n < places.size(); ++n)
      for (std::size_t j = 0; j < 8; ++j) {
        result[j].alpha += fields[n].length[j] / count_;
        if (spread_ > 0) result[j].beta += std::conj(from_centre(places[n])) * fields[n].length[j] / spread_;
      }
    return result;
  }

 private:
  Complex centre_{};
  double spread_ = 0, count_ = 1;
};

double play_alone(const std::array<Complex, 2>& pair, double radius) {
  // Largest singular value of the 2 x 2 matrix with these columns.
  const Complex x = pair[0], y = pair[1];
  return radius * 0.5 * (std::abs(x - Complex(0, 1) * y) + std::abs(x + Complex(0, 1) * y));
}

double root_sum_square(const Sensitivities& g, const CopyTolerance& tolerance) {
  double sum = 0;
  for (std::size_t j = 0; j < 8; ++j) sum += std::norm(tolerance.length[j] * g.length[j]);
  for (std::size_t j = 0; j < 5; ++j)
    sum +=
        0.5 * (std::norm(tolerance.of(8 + j) * g.play[j][0]) + std::norm(tolerance.of(8 + j) * g.play[j][1]));
  return std::sqrt(sum);
}

std::vector<SourceContribution> named_sources(const CopyTolerance& tolerance, bool flat) {
  std::vector<SourceContribution> sources;
  for (std::size_t j = 0; j < error_source_count; ++j)
    sources.push_back({error_source_name(j, flat), tolerance.of(j), 0, 0});
  return sources;
}

void keep_larger(double& kept, double value) { kept = std::max(kept, value); }

/// Adds what each source does at one place, alone.
void add_contributions(const Sensitivities& all, const Sensitivities& left, const CopyTolerance& tolerance,
                       std::vector<SourceContribution>& sources) {
  for (std::size_t j = 0; j < 8; ++j) {
    keep_larger(sources[j].worst, tolerance.length[j] * std::abs(all.length[j]));
    keep_larger(sources[j].distortion_worst, tolerance.length[j] * std::abs(left.length[j]));
  }
  for (std::size_t j = 0; j < 5; ++j) {
    const double alone = play_alone(all.play[j], tolerance.of(8 + j));
    keep_larger(sources[8 + j].worst, alone);
    keep_larger(sources[8 + j].distortion_worst, alone);
  }
}

/// The lattice's axis: along the longest edge, so that it follows the region however that is turned; of equal ones the first. Turned by
/// quarters towards x, which leaves the lattice as it is.
Complex lattice_axis(const std::vector<BoundaryEdge>& edges) {
  double longest = 0;
  Complex axis = 1;
  for (const BoundaryEdge& edge : edges) {
    const Complex along = as_complex(edge.to - edge.from);
    if (!(std::abs(along) > longest * (1 + slack::same_size))) continue;
    longest = std::abs(along);
    axis = along / longest;
  }
  if (std::abs(axis.imag()) > std::abs(axis.real())) axis *= -i_unit;
  return axis.real() < 0 ? -axis : axis;
}

/// How many steps go into a length; a count that is whole but for rounding is that count in every frame.
int whole_steps(double length, double step) {
  return static_cast<int>(length / step * (1 + slack::same_size));
}

/// Places at the middles of equal cells of the box along the lattice's axis, of those inside the region.
void append_lattice(const Region& region, const RegionReach& reach, std::size_t about,
                    std::vector<Point>& places) {
  constexpr double most = 100'000;  // cells: of a region of two specks far apart only a few lie in it
  const Complex axis = lattice_axis(reach.edges());
  Box box{Point::Constant(HUGE_VAL), Point::Constant(-HUGE_VAL)};
  for (const Point& corner : reach.hull()) {
    const Point seen = as_point(as_complex(corner) * std::conj(axis));
    box.lower = box.lower.cwiseMin(seen);
    box.upper = box.upper.cwiseMax(seen);
  }
  const Point size = box.upper - box.lower;
  const double step = std::max({std::sqrt(std::max(0.0, area(region)) / static_cast<double>(about)),
                                std::sqrt(size.x() * size.y() / most), size.maxCoeff() / most});
  if (!(step > 0)) return;
  const int columns = whole_steps(size.x(), step), rows = whole_steps(size.y(), step);
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const Point seen =
          box.lower + Point((column + 0.5) / (columns + 1) * size.x(), (row + 0.5) / (rows + 1) * size.y());
      const Point place = as_point(as_complex(seen) * axis);
      // What is on the boundary but for rounding would be in or out as the frame has it; the rings cover that.
      if (reach.nearest(place).distance < -slack::on_boundary * reach.diagonal()) places.push_back(place);
    }
}

/// Corners (all, or evenly chosen ones of very many) and places between them, about `about` in all.
void append_rings(const RegionReach& reach, std::size_t about, std::vector<Point>& places) {
  const auto& edges = reach.edges();
  double length = 0;
  for (const BoundaryEdge& edge : edges) length += (edge.to - edge.from).norm();
  const double step = length / static_cast<double>(about);
  const std::size_t stride = std::max<std::size_t>(1, edges.size() / about);
  for (std::size_t j = 0; j < edges.size(); j += stride) {
    const Point along = edges[j].to - edges[j].from;
    const int parts = std::clamp(whole_steps(along.norm(), step), 1, static_cast<int>(about));
    for (int n = 0; n < parts; ++n) places.push_back(edges[j].from + along * n / parts);
  }
}

/// The worst and the RSS deviation over every distance that the region has from the pole.
tl::expected<CopyErrorProfile::Largest, Unreachable> largest_over(const CopyingLinkage& linkage,
                                                                  const CopyErrorProfile& profile,
                                                                  const RegionReach& reach) {
  const DistanceRange range = reach.range(linkage.pole());
  const auto near = linkage.opening_at(range.nearest), far = linkage.opening_at(range.farthest);
  if (!near) return tl::unexpected(near.error());
  if (!far) return tl::unexpected(far.error());
  return profile.largest({std::min(*near, *far), std::max(*near, *far)});
}

/// The place whose distance from the pole is nearest to a radius.
Point place_at_radius(const CopyingLinkage& linkage, const ErrorPlaces& region, double radius) {
  std::vector<Point> candidates = region.places;
  candidates.push_back(region.reach.nearest(linkage.pole()).place);
  candidates.push_back(region.reach.hull()[region.reach.farthest(linkage.pole()).corner]);
  const auto miss = [&](const Point& place) { return std::abs((place - linkage.pole()).norm() - radius); };
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](const Point& a, const Point& b) { return miss(a) < miss(b); });
}

}  // namespace

tl::expected<Sensitivities, Unreachable> copy_sensitivities_at(const CopyingLinkage& linkage,
                                                               const Point& tracer) {
  const CopyErrorProfile profile = copy_error_profile(linkage, {});
  return stance_at(linkage, tracer).map([&](const Stance& stance) {
    return profile.sensitivities(stance.opening).turned(stance.VA_direction);
  });
}

tl::expected<CopyErrorAt, Unreachable> copy_error_at(const CopyingLinkage& linkage,
                                                     const CopyTolerance& tolerance, const Point& tracer) {
  const CopyErrorProfile profile = copy_error_profile(linkage, tolerance);
  return stance_at(linkage, tracer).map([&](const Stance& stance) {
    CopyErrorAt error = profile.at(stance.opening);
    error.direction *= stance.VA_direction;
    return error;
  });
}

ErrorPlaces error_places(const Region& region, std::size_t about) {
  ErrorPlaces result{RegionReach(region), {}};
  append_rings(result.reach, about / 2, result.places);
  append_lattice(region, result.reach, about - about / 2, result.places);
  return result;
}

tl::expected<CopyErrorOver, Unreachable> copy_error_over(const CopyingLinkage& linkage,
                                                         const CopyTolerance& tolerance,
                                                         const ErrorPlaces& region) {
  const CopyErrorProfile profile = copy_error_profile(linkage, tolerance);
  const auto largest = largest_over(linkage, profile, region.reach);
  if (!largest) return tl::unexpected(largest.error());
  std::vector<Sensitivities> fields;
  for (const Point& place : region.places) {
    const auto stance = stance_at(linkage, place);
    if (!stance) return tl::unexpected(stance.error());
    fields.push_back(profile.sensitivities(stance->opening).turned(stance->VA_direction));
  }
  const Fit fit(region.places);
  const std::array<AbsorbedField, 8> absorbed = fit.absorbed(region.places, fields);

  CopyErrorOver over;
  over.worst = largest->worst.worst;
  over.rss = largest->rss.rss;
  over.worst_at = place_at_radius(linkage, region, linkage.radius_at(largest->worst_opening));
  over.sources = named_sources(tolerance, profile.flat());
  for (std::size_t j = 0; j < 8; ++j) {
    const Complex ratio = absorbed[j].beta / linkage.k();
    over.scale_worst += tolerance.length[j] * std::abs(ratio.real());
    over.rotation_worst += tolerance.length[j] * std::abs(ratio.imag());
  }
  const CopyTolerance lengths_alone{tolerance.length, {}};
  for (std::size_t n = 0; n < region.places.size(); ++n) {
    Sensitivities left = fields[n], taken = fields[n];
    for (std::size_t j = 0; j < 8; ++j) {
      taken.length[j] = absorbed[j].at(fit.from_centre(region.places[n]));
      left.length[j] -= taken.length[j];
    }
    const double distortion = longest_deviation(left, tolerance).length;
    if (distortion > over.distortion_worst) {
      over.distortion_worst = distortion;
      over.distortion_at = region.places[n];
    }
    keep_larger(over.distortion_rss, root_sum_square(left, tolerance));
    keep_larger(over.absorbed_worst, longest_deviation(taken, lengths_alone).length);
    add_contributions(fields[n], left, tolerance, over.sources);
  }
  return over;
}

tl::expected<CopyErrorOver, Unreachable> copy_error_over(const CopyingLinkage& linkage,
                                                         const CopyTolerance& tolerance,
                                                         const Region& region) {
  return copy_error_over(linkage, tolerance, error_places(region));
}

}  // namespace kempe
