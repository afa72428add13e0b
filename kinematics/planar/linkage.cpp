#include "kinematics/planar/linkage.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/overloaded.hpp"
#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

double stated_value(const Constraint& constraint) {
  return std::visit(
      [](const auto& c) {
        if constexpr (requires { c.value; })
          return c.value;
        else
          return 0.0;
      },
      constraint);
}

bool is_unit(const Point& direction) { return std::abs(direction.norm() - 1) < slack::unit_length; }

std::string fault_of(const Constraint& constraint) {
  if (!std::isfinite(stated_value(constraint))) return "a value that is not finite";
  for (const BodyPoint& point : points_of(constraint))
    if (!point.local.allFinite()) return "a point that is not finite";
  std::vector<int> bodies = bodies_of(constraint);
  bodies.resize(std::min<std::size_t>(bodies.size(), 2));
  if (bodies[0] == bodies[1]) return "both sides lie on the same body";
  return std::visit(
      Overloaded{
          [](const Revolute&) { return std::string(); },
          [](const Coordinate& c) {
            return std::string(is_unit(c.direction) ? "" : "a direction that is no unit vector");
          },
          [](const Distance& c) { return std::string(c.value > 0 ? "" : "a distance that is not positive"); },
          [](const RelativeAngle&) { return std::string(); },
          [](const GearPair& c) {
            const bool good = std::isfinite(c.first_radius) && std::isfinite(c.second_radius) &&
                              c.first_radius != 0 && c.second_radius != 0;
            return std::string(good ? "" : "a wheel of radius zero");
          },
          [](const RackAndPinion& c) {
            if (!is_unit(c.direction)) return std::string("a direction that is no unit vector");
            return std::string(std::isfinite(c.radius) && c.radius != 0 ? "" : "a pinion of radius zero");
          }},
      constraint);
}

}  // namespace

std::vector<BodyPoint> points_of(const Constraint& constraint) {
  return std::visit(Overloaded{[](const Revolute& c) {
                                 return std::vector{c.a, c.b};
                               },
                               [](const Coordinate& c) {
                                 return std::vector{c.point, c.origin};
                               },
                               [](const Distance& c) {
                                 return std::vector{c.a, c.b};
                               },
                               [](const RelativeAngle&) { return std::vector<BodyPoint>{}; },
                               [](const GearPair&) { return std::vector<BodyPoint>{}; },
                               [](const RackAndPinion& c) {
                                 return std::vector{c.centre, c.rack_origin};
                               }},
                    constraint);
}

int equation_count(const Constraint& constraint) {
  return std::holds_alternative<Revolute>(constraint) ? 2 : 1;
}

std::vector<int> bodies_of(const Constraint& constraint) {
  if (const auto* angle = std::get_if<RelativeAngle>(&constraint)) return {angle->body, angle->reference};
  if (const auto* gears = std::get_if<GearPair>(&constraint))
    return {gears->first, gears->second, gears->carrier};
  std::vector<int> bodies;
  for (const BodyPoint& point : points_of(constraint)) bodies.push_back(point.body);
  return bodies;
}

Point turned(const PlanarPosition& position, int body, const Point& local) {
  const double angle = position[static_cast<std::size_t>(body)].angle, c = std::cos(angle),
               s = std::sin(angle);
  return {c * local.x() - s * local.y(), s * local.x() + c * local.y()};
}

Point place(const PlanarPosition& position, const BodyPoint& point) {
  return position[static_cast<std::size_t>(point.body)].at + turned(position, point.body, point.local);
}

int PlanarLinkage::add_body(std::string name) {
  bodies_.push_back(std::move(name));
  is_particle_.push_back(false);
  jointed_.emplace_back();
  return body_count() - 1;
}

int PlanarLinkage::add_particle(const std::string& name) {
  const int body = add_body(name);
  is_particle_.back() = true;
  add(RelativeAngle{body, ground, 0}, name + " does not turn");
  return body;
}

int PlanarLinkage::append(const Constraint& constraint, std::string name) {
  constraints_.push_back({std::move(name), constraint});
  return static_cast<int>(constraints_.size()) - 1;
}

int PlanarLinkage::add(const Constraint& constraint, std::string name) {
  measure(constraint);
  return append(constraint, std::move(name));
}

void PlanarLinkage::measure(const Constraint& constraint) {
  for (const BodyPoint& point : points_of(constraint)) {
    std::vector<Point>& known = jointed_[static_cast<std::size_t>(point.body)];
    if (std::find(known.begin(), known.end(), point.local) != known.end()) continue;
    for (const Point& other : known) size_ = std::max(size_, (point.local - other).norm());
    known.push_back(point.local);
  }
  if (const auto* distance = std::get_if<Distance>(&constraint)) size_ = std::max(size_, distance->value);
}

int PlanarLinkage::drive(const Constraint& constraint, std::string name) {
  drivers_.push_back(append(constraint, std::move(name)));
  return static_cast<int>(drivers_.size()) - 1;
}

int PlanarLinkage::drive_point(const BodyPoint& point, const std::string& name) {
  const BodyPoint table{ground, Point::Zero()};
  const int first = drive(Coordinate{point, table, Point(1, 0), 0}, name);
  drive(Coordinate{point, table, Point(0, 1), 0}, name);
  return first;
}

int PlanarLinkage::particle_count() const {
  return static_cast<int>(std::count(is_particle_.begin(), is_particle_.end(), true));
}

bool PlanarLinkage::is_driver(int constraint) const {
  return std::find(drivers_.begin(), drivers_.end(), constraint) != drivers_.end();
}

std::vector<double> PlanarLinkage::driver_values() const {
  std::vector<double> values;
  for (const int driver : drivers_)
    values.push_back(stated_value(constraints_[static_cast<std::size_t>(driver)].constraint));
  return values;
}

int PlanarLinkage::equation_count() const {
  int count = 0;
  for (const auto& named : constraints_) count += kempe::equation_count(named.constraint);
  return count;
}

PlanarLinkage PlanarLinkage::undriven() const {
  PlanarLinkage result;
  result.bodies_ = bodies_;
  result.is_particle_ = is_particle_;
  result.jointed_ = jointed_;
  result.travel_ = travel_;
  result.size_ = size_;
  for (std::size_t i = 0; i < constraints_.size(); ++i)
    if (!is_driver(static_cast<int>(i))) result.constraints_.push_back(constraints_[i]);
  return result;
}

std::string PlanarLinkage::fault() const {
  for (const auto& [name, constraint] : constraints_)
    if (const std::string fault = fault_of(constraint); !fault.empty()) return name + ": " + fault;
  return {};
}

}  // namespace kempe
