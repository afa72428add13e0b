#include "specs/linkages/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/overloaded.hpp"

namespace kempe {
namespace {

Point direction_of(double angle) { return {std::cos(angle), std::sin(angle)}; }
Point normal_of(double angle) { return {-std::sin(angle), std::cos(angle)}; }

class ModelBuilder {
 public:
  explicit ModelBuilder(const LinkageFile& file) : file_(file) {}

  LinkageModel build() {
    add_bodies();
    for (const FileLink& link : file_.links)
      for (const auto& [name, place] : link.joints) add_joint(name, {model_.body(link.name), place});
    for (const FileSlider& slider : file_.sliders) add_slider(slider);
    for (const FileAngle& angle : file_.angles)
      fix_angle(model_.body(angle.to), model_.body(angle.from), angle.angle,
                fmt::format("angle from {} to {}", angle.from, angle.to));
    for (const FileBar& bar : file_.bars)
      model_.linkage.add(Distance{model_.point(bar.a), model_.point(bar.b), bar.length},
                         fmt::format("bar {}-{}", bar.a, bar.b));
    for (const FileGears& gears : file_.gears)
      model_.linkage.add(
          GearPair{model_.body(gears.first), model_.body(gears.second), model_.body(gears.carrier),
                   gears.first_radius, gears.second_radius, gears.value},
          fmt::format("gears {} and {}", gears.first, gears.second));
    for (const FileRack& rack : file_.racks) add_rack(rack);
    for (const FileDriver& driver : file_.drivers) add_driver(driver);
    add_loads();
    model_.schedule.duration = file_.duration;
    model_.linkage.set_travel(travel());
    return std::move(model_);
  }

 private:
  /// angle(body) - angle(reference) = angle, for good. Where fixed angles close a loop, whole turns do not count: the
  /// same direction may be said as 350 and as -10 degrees.
  void fix_angle(int body, int reference, double angle, std::string name) {
    const auto [root, at] = fixed_to(body);
    const auto [other_root, other_at] = fixed_to(reference);
    if (root == other_root)
      angle = at - other_at + std::remainder(angle - (at - other_at), 2 * pi);
    else
      fixed_[root] = {other_root, angle + other_at - at};
    model_.linkage.add(RelativeAngle{body, reference, angle}, std::move(name));
  }

  /// The body that this one's angle is fixed to, and the angle against it.
  std::pair<int, double> fixed_to(int body) const {
    double angle = 0;
    for (auto found = fixed_.find(body); found != fixed_.end(); found = fixed_.find(body)) {
      angle += found->second.second;
      body = found->second.first;
    }
    return {body, angle};
  }

  /// How far the drivers move a point.
  double travel() const {
    double farthest = 0;
    for (const FileDriver& driver : file_.drivers) {
      if (const auto* path = std::get_if<DriverPath>(&driver.motion))
        farthest = std::max(farthest, path->extent());
      else if (const auto& range = std::get<DriverRange>(driver.motion);
               !std::holds_alternative<DrivenAngle>(driver.what))
        farthest = std::max(farthest, std::abs(range.to - range.from));
    }
    return farthest;
  }

  void define_point(const std::string& name, const BodyPoint& place) {
    if (model_.point_numbers.try_emplace(name, model_.points.size()).second)
      model_.points.push_back({name, place});
  }

  void add_bodies() {
    model_.bodies["ground"] = PlanarLinkage::ground;
    for (const auto& [name, place] : file_.ground) define_point(name, {PlanarLinkage::ground, place});
    for (const FileLink& link : file_.links) {
      const int body = model_.bodies[link.name] = model_.linkage.add_body(link.name);
      for (const auto& [name, place] : link.joints) define_point(name, {body, place});
    }
    for (const std::string& name : file_.free_points)
      define_point(name, {model_.linkage.add_particle(name), Point::Zero()});
  }

  /// A point's first body is its home; every further one turns about it there.
  void add_joint(const std::string& name, const BodyPoint& here) {
    const BodyPoint& home = model_.point(name);
    if (home.body == here.body) return;
    model_.linkage.add(Revolute{home, here}, name);
  }

  BodyPoint line_point(const FileLine& line) const { return {model_.body(line.link), line.through}; }

  void add_slider(const FileSlider& slider) {
    const Point normal = normal_of(slider.line.direction);
    if (slider.point.empty()) {
      const int body = model_.body(slider.link);
      model_.linkage.add(Coordinate{{body, Point::Zero()}, line_point(slider.line), normal, 0}, slider.link);
      fix_angle(body, model_.body(slider.line.link), slider.line.direction, slider.link + " does not turn");
    } else {
      model_.linkage.add(Coordinate{model_.point(slider.point), line_point(slider.line), normal, 0},
                         slider.point);
    }
  }

  void add_rack(const FileRack& rack) {
    const BodyPoint centre{model_.body(rack.pinion), local_place(rack.centre, rack.pinion)};
    model_.linkage.add(RackAndPinion{centre, line_point(rack.line), direction_of(rack.line.direction),
                                     rack.radius, rack.value},
                       fmt::format("rack and pinion {}", rack.pinion));
  }

  Point local_place(const std::string& point, const std::string& link) const {
    for (const FileLink& each : file_.links)
      if (each.name == link)
        for (const auto& [name, place] : each.joints)
          if (name == point) return place;
    return Point::Zero();
  }

  void add_driver(const FileDriver& driver) {
    const BodyPoint table{PlanarLinkage::ground, Point::Zero()};
    std::visit(
        Overloaded{[&](const DrivenCoordinate& what) {
                     const Point axis = what.axis == 0 ? Point(1, 0) : Point(0, 1);
                     model_.linkage.drive(Coordinate{model_.point(what.point), table, axis, 0}, what.point);
                   },
                   [&](const DrivenAngle& what) {
                     model_.linkage.drive(
                         RelativeAngle{model_.body(what.link), model_.body(what.reference), 0},
                         "angle of " + what.link);
                   },
                   [&](const DrivenDistance& what) {
                     const double first = std::get<DriverRange>(driver.motion).from;
                     model_.linkage.drive(Distance{model_.point(what.a), model_.point(what.b), first},
                                          fmt::format("distance {}-{}", what.a, what.b));
                   },
                   [&](const DrivenSlide& what) { drive_slide(file_.sliders[what.slider]); },
                   [&](const DrivenPoint& what) { drive_point(what.point); }},
        driver.what);
    model_.schedule.motions.push_back(driver.motion);
  }

  BodyPoint bearer(const FileForce& force) const {
    return force.link.empty() ? model_.point(force.at)
                              : BodyPoint{model_.body(force.link), local_place(force.at, force.link)};
  }

  void add_loads() {
    PlanarLoads& loads = model_.loads;
    for (const FileForce& force : file_.loads.forces)
      loads.forces.push_back({bearer(force), force.newton, model_.body(force.turns_with)});
    for (const FilePairForce& pair : file_.loads.pairs)
      loads.pairs.push_back({model_.point(pair.a), model_.point(pair.b), pair.newton});
    for (const FileMoment& moment : file_.loads.moments)
      loads.moments.push_back({model_.body(moment.on), model_.body(moment.against), moment.moment});
    for (const FileMass& mass : file_.loads.masses) {
      const BodyPoint at =
          mass.link.empty() ? model_.point(mass.point) : BodyPoint{model_.body(mass.link), mass.centre};
      loads.masses.push_back({at.body, mass.kg, at.local, mass.inertia});
    }
    loads.gravity = file_.loads.gravity;
  }

  void drive_slide(const FileSlider& slider) {
    const BodyPoint moved = slider.point.empty() ? BodyPoint{model_.body(slider.link), Point::Zero()}
                                                 : model_.point(slider.point);
    model_.linkage.drive(Coordinate{moved, line_point(slider.line), direction_of(slider.line.direction), 0},
                         slider.name());
  }

  void drive_point(const std::string& name) {
    const BodyPoint table{PlanarLinkage::ground, Point::Zero()};
    model_.linkage.drive(Coordinate{model_.point(name), table, Point(1, 0), 0}, name);
    model_.linkage.drive(Coordinate{model_.point(name), table, Point(0, 1), 0}, name);
  }

  const LinkageFile& file_;
  LinkageModel model_;
  std::map<int, std::pair<int, double>>
      fixed_;  ///< of a body: one that its angle is fixed against, and the angle
};

using KnownPlaces = std::map<std::string, Point>;

/// A link laid on its known points: turned and moved by least squares.
BodyPlacement laid_on(const FileLink& link, const KnownPlaces& known, const Point& middle) {
  std::vector<std::pair<Complex, Complex>> pairs;  // local, table
  Complex local_mean = 0, table_mean = 0;
  for (const auto& [name, place] : link.joints)
    if (const auto found = known.find(name); found != known.end())
      pairs.emplace_back(as_complex(place), as_complex(found->second));
  if (pairs.empty()) return {middle, 0};
  for (const auto& [local, table] : pairs) local_mean += local, table_mean += table;
  local_mean /= static_cast<double>(pairs.size());
  table_mean /= static_cast<double>(pairs.size());
  Complex turn = 0;
  for (const auto& [local, table] : pairs) turn += (table - table_mean) * std::conj(local - local_mean);
  const double angle = turn == Complex(0) ? 0 : std::arg(turn);
  return {as_point(table_mean - std::polar(1.0, angle) * local_mean), angle};
}

bool within(double value, const std::optional<std::pair<double, double>>& range, double slack) {
  return !range || (range->first - slack <= value && value <= range->second + slack);
}

/// rad, and share of the linkage's size: a position so far outside a bound still meets it.
constexpr double bound_slack = 1e-9;

bool meets(const FileBound& bound, const LinkageModel& model, const PlanarPosition& position) {
  if (bound.angle) {
    const double angle = position[static_cast<std::size_t>(model.body(bound.name))].angle;
    const double turns = std::floor((angle - bound.angle->first) / (2 * pi));
    return within(angle - 2 * pi * turns, bound.angle, bound_slack) ||
           within(angle - 2 * pi * (turns + 1), bound.angle, bound_slack);
  }
  if (!model.point_numbers.contains(bound.name)) return true;
  const Point at = place(position, model.point(bound.name));
  const double slack = bound_slack * model.linkage.size();
  return within(at.x(), bound.place[0], slack) && within(at.y(), bound.place[1], slack);
}

double distance_to_guess(const LinkageFile& file, const LinkageModel& model, const PlanarPosition& position) {
  double sum = 0;
  for (const auto& [name, guessed] : file.guess)
    sum += (place(position, model.point(name)) - guessed).squaredNorm();
  return sum;
}

}  // namespace

const BodyPoint& LinkageModel::point(const std::string& name) const {
  return points[point_numbers.at(name)].place;
}
int LinkageModel::body(const std::string& name) const { return bodies.at(name); }

std::string LinkageModel::driver_label(int driver) const {
  const int number = linkage.drivers()[static_cast<std::size_t>(driver)];
  const auto& [name, constraint] = linkage.constraints()[static_cast<std::size_t>(number)];
  const auto* along = std::get_if<Coordinate>(&constraint);
  if (!along || along->origin != BodyPoint{}) return name;
  if (along->direction == Point(1, 0)) return name + ".x";
  return along->direction == Point(0, 1) ? name + ".y" : name;
}

LinkageModel linkage_model(const LinkageFile& file) { return ModelBuilder(file).build(); }

PlanarPosition guessed_position(const LinkageFile& file, const LinkageModel& model) {
  KnownPlaces known(file.ground.begin(), file.ground.end());
  for (const auto& [name, place] : file.guess) known[name] = place;
  Point middle = Point::Zero();
  for (const auto& [name, place] : known) middle += place / static_cast<double>(known.size());
  PlanarPosition position(static_cast<std::size_t>(model.linkage.body_count()));
  for (const FileLink& link : file.links)
    position[static_cast<std::size_t>(model.body(link.name))] = laid_on(link, known, middle);
  for (const std::string& name : file.free_points) {
    const auto found = known.find(name);
    position[static_cast<std::size_t>(model.point(name).body)].at =
        found == known.end() ? middle : found->second;
  }
  return position;
}

tl::expected<std::vector<PlanarPosition>, NoAssembly> start_assembly_modes(const LinkageFile& file,
                                                                           const LinkageModel& model,
                                                                           const AssemblySearch& search) {
  const PlanarPosition guess = guessed_position(file, model);
  const std::vector<double> values = model.schedule.values_at(0);
  const auto misses = [&](const PlanarPosition& position) {
    return std::count_if(file.bounds.begin(), file.bounds.end(),
                         [&](const FileBound& bound) { return !meets(bound, model, position); });
  };
  AssemblySearch bounded = search;
  bounded.wanted = [&](const PlanarPosition& position) { return misses(position) == 0; };
  AssembliesFound all = search_assembly_modes(model.linkage, guess, values, bounded);
  std::vector<PlanarPosition>& found = all.assembly_modes;
  NoAssembly none;
  none.closings = found.size();
  if (found.empty()) {
    if (all.nearest) none.missing = missing_at(model.linkage, *all.nearest, values);
    return tl::unexpected(none);
  }
  std::stable_sort(found.begin(), found.end(), [&](const PlanarPosition& a, const PlanarPosition& b) {
    const auto missed_a = misses(a), missed_b = misses(b);
    if (missed_a != missed_b) return missed_a < missed_b;
    return distance_to_guess(file, model, a) < distance_to_guess(file, model, b);
  });
  if (misses(found.front()) == 0) return std::move(found);
  for (const FileBound& bound : file.bounds)
    if (!meets(bound, model, found.front())) none.unmet.push_back(bound.name);
  return tl::unexpected(none);
}

}  // namespace kempe
