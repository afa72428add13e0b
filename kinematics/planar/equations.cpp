#include "kinematics/planar/equations.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/overloaded.hpp"

namespace kempe {
namespace {

/// Where a constraint keeps its value; nothing for a revolute joint.
double* value_in(Constraint& constraint) {
  return std::visit(
      [](auto& c) -> double* {
        if constexpr (requires { c.value; })
          return &c.value;
        else
          return nullptr;
      },
      constraint);
}

double value_of(const Constraint& constraint) { return *value_in(const_cast<Constraint&>(constraint)); }

constexpr bool moves(int body) { return body != PlanarLinkage::ground; }

/// How far the places of two bodies may part within the step control's ball of radius 1/2, in reaches.
constexpr double drift = 1.0;

/// The factor that makes a row a length: of a distance its inverse; see Entry.
double scale_of(const Constraint& constraint, double size) {
  if (const auto* distance = std::get_if<Distance>(&constraint)) return distance->value;
  if (const auto* gears = std::get_if<GearPair>(&constraint))
    return size / std::max(std::abs(gears->first_radius), std::abs(gears->second_radius));
  return 0;
}

/// The arm of each body: how far its angle moves the points that constraints hold; the size where lines on it or other
/// angles hold the angle.
std::vector<double> arms_of(const PlanarLinkage& linkage) {
  std::vector<double> arms(static_cast<std::size_t>(linkage.body_count()), 0);
  const auto reach = [&](int body, double arm) {
    double& longest = arms[static_cast<std::size_t>(body)];
    longest = std::max(longest, arm);
  };
  for (const auto& [name, constraint] : linkage.constraints()) {
    for (const BodyPoint& point : points_of(constraint)) reach(point.body, point.local.norm());
    if (const auto* line = std::get_if<Coordinate>(&constraint)) reach(line->origin.body, linkage.size());
    if (const auto* rack = std::get_if<RackAndPinion>(&constraint)) {
      reach(rack->centre.body, std::abs(rack->radius));
      reach(rack->rack_origin.body, linkage.size());
    }
    if (points_of(constraint).empty())
      for (const int body : bodies_of(constraint)) reach(body, linkage.size());
  }
  for (double& arm : arms)
    if (!(arm > 0)) arm = linkage.size();
  return arms;
}

}  // namespace

PlanarEquations::PlanarEquations(const PlanarLinkage& linkage)
    : values_(linkage.driver_values()), angle_bends_(static_cast<std::size_t>(linkage.body_count()), false),
      place_bends_(static_cast<std::size_t>(linkage.body_count()), false), arms_(arms_of(linkage)),
      directions_(static_cast<std::size_t>(linkage.body_count()), Point(1, 0)),
      unknowns_(linkage.unknown_count()), rows_(0), size_(linkage.size()), reach_(linkage.reach()) {
  for (const auto& [name, constraint] : linkage.constraints()) {
    const bool two = equation_count(constraint) == 2;
    entries_.push_back({constraint, rows_, two ? rows_ + 1 : -1, scale_of(constraint, size_)});
    rows_ += two ? 2 : 1;
    mark_bends(constraint);
  }
  driver_entries_ = linkage.drivers();
  for (std::size_t driver = 0; driver < driver_entries_.size(); ++driver)
    has_distance_driver_ |= is_distance(static_cast<int>(driver));
}

bool PlanarEquations::is_distance(int driver) const {
  const auto entry = static_cast<std::size_t>(driver_entries_[static_cast<std::size_t>(driver)]);
  return std::holds_alternative<Distance>(entries_[entry].constraint);
}

void PlanarEquations::mark_bends(const Constraint& constraint) {
  const auto mark_arm = [&](const BodyPoint& point) {
    if (point.local != Point::Zero()) angle_bends_[static_cast<std::size_t>(point.body)] = true;
  };
  const auto mark_line = [&](const BodyPoint& point, const BodyPoint& origin) {
    mark_arm(point);
    if (!moves(origin.body)) return;
    angle_bends_[static_cast<std::size_t>(origin.body)] = true;
    for (const int body : {point.body, origin.body}) place_bends_[static_cast<std::size_t>(body)] = true;
  };
  std::visit(Overloaded{[&](const Revolute& c) { mark_arm(c.a), mark_arm(c.b); },
                        [&](const Coordinate& c) { mark_line(c.point, c.origin); },
                        [&](const Distance& c) {
                          for (const BodyPoint& point : {c.a, c.b}) {
                            mark_arm(point);
                            place_bends_[static_cast<std::size_t>(point.body)] = true;
                          }
                        },
                        [&](const RelativeAngle&) {}, [&](const GearPair&) {},
                        [&](const RackAndPinion& c) { mark_line(c.centre, c.rack_origin); }},
             constraint);
}

void PlanarEquations::reorder(const std::vector<int>& place_of_row) {
  for (Entry& entry : entries_) {
    entry.row = place_of_row[static_cast<std::size_t>(entry.row)];
    if (entry.second_row >= 0) entry.second_row = place_of_row[static_cast<std::size_t>(entry.second_row)];
  }
}

void PlanarEquations::set_values(const std::vector<double>& values) {
  values_ = values;
  for (std::size_t i = 0; i < driver_entries_.size(); ++i)
    *value_in(entries_[static_cast<std::size_t>(driver_entries_[i])].constraint) = values[i];
}

int PlanarEquations::driver_row(int driver) const {
  return entries_[static_cast<std::size_t>(driver_entries_[static_cast<std::size_t>(driver)])].row;
}

double PlanarEquations::driver_slope(int driver) const {
  return value_slope(driver_entries_[static_cast<std::size_t>(driver)]);
}

double PlanarEquations::value_slope(int constraint) const {
  const Entry& entry = entries_[static_cast<std::size_t>(constraint)];
  if (std::holds_alternative<Distance>(entry.constraint)) return value_of(entry.constraint) / entry.scale;
  if (std::holds_alternative<GearPair>(entry.constraint)) return entry.scale;
  return std::holds_alternative<RelativeAngle>(entry.constraint) ? size_ : 1;
}

double PlanarEquations::driver_bend(int driver, double speed) const {
  const Entry& entry = entries_[static_cast<std::size_t>(driver_entries_[static_cast<std::size_t>(driver)])];
  return is_distance(driver) ? speed * speed / entry.scale : 0;
}

bool PlanarEquations::rescale_distances() {
  bool rescaled = false;
  for (const int driver : driver_entries_) {
    Entry& entry = entries_[static_cast<std::size_t>(driver)];
    const auto* distance = std::get_if<Distance>(&entry.constraint);
    if (!distance || (distance->value < 2 * entry.scale && entry.scale < 2 * distance->value)) continue;
    entry.scale = distance->value;
    rescaled = true;
  }
  return rescaled;
}

Eigen::MatrixXd PlanarEquations::dimensionless(Eigen::MatrixXd jacobian) const {
  for (std::size_t body = 1; body < arms_.size(); ++body)
    jacobian.col(3 * static_cast<Eigen::Index>(body) - 1) /= arms_[body];
  for (Eigen::Index row = 0; row < jacobian.rows(); ++row)
    if (const double largest = jacobian.row(row).lpNorm<Eigen::Infinity>(); largest > 0)
      jacobian.row(row) /= largest;
  return jacobian;
}

void PlanarEquations::turn_bodies(const Eigen::VectorXd& q) {
  for (std::size_t body = 1; body < directions_.size(); ++body) {
    const double angle = q[3 * static_cast<Eigen::Index>(body) - 1];
    directions_[body] = {std::cos(angle), std::sin(angle)};
  }
}

inline Point PlanarEquations::turned(int body, const Point& local) const {
  const Point& d = directions_[static_cast<std::size_t>(body)];
  return {d.x() * local.x() - d.y() * local.y(), d.y() * local.x() + d.x() * local.y()};
}

inline PlanarEquations::Arm PlanarEquations::arm(const Eigen::VectorXd& q, const BodyPoint& point) const {
  const Point r = turned(point.body, point.local);
  if (!moves(point.body)) return {point.body, r, r};
  const Eigen::Index x = 3 * point.body - 3;
  return {point.body, r, Point(q[x] + r.x(), q[x + 1] + r.y())};
}

void PlanarEquations::add_angle(Eigen::MatrixXd& jacobian, int row, int body, double slope) const {
  if (moves(body)) jacobian(row, 3 * body - 1) += slope;
}

/// Adds the derivative of along . P to a row.
void PlanarEquations::add_point(Eigen::MatrixXd& jacobian, int row, const Arm& arm,
                                const Point& along) const {
  if (!moves(arm.body)) return;
  const Eigen::Index x = 3 * arm.body - 3;
  jacobian(row, x) += along.x();
  jacobian(row, x + 1) += along.y();
  jacobian(row, x + 2) += along.dot(left_of(arm.turned));
}

/// Adds the derivative of +-P to both rows of a joint.
inline void PlanarEquations::add_joint(Eigen::MatrixXd& jacobian, const Entry& entry, const Arm& arm,
                                       double sign) {
  if (!moves(arm.body)) return;
  const Eigen::Index x = 3 * arm.body - 3;
  jacobian(entry.row, x) += sign;
  jacobian(entry.row, x + 2) -= sign * arm.turned.y();
  jacobian(entry.second_row, x + 1) += sign;
  jacobian(entry.second_row, x + 2) += sign * arm.turned.x();
}

/// Writes F(q), and dF/dq unless that is null, a constraint at a time.
class PlanarEquations::Evaluation {
 public:
  Evaluation(const PlanarEquations& equations, const Eigen::VectorXd& q, Eigen::VectorXd& f,
             Eigen::MatrixXd* jacobian)
      : equations_(equations), q_(q), f_(f), jacobian_(jacobian) {}

  void write(const Entry& entry) {
    std::visit([&](const auto& constraint) { write(constraint, entry); }, entry.constraint);
  }

 private:
  Arm arm(const BodyPoint& point) const { return equations_.arm(q_, point); }
  double angle(int body) const { return moves(body) ? q_[3 * body - 1] : 0.0; }

  void add_angle(int row, int body, double slope) { equations_.add_angle(*jacobian_, row, body, slope); }
  void add_point(int row, const Arm& arm, const Point& along) {
    equations_.add_point(*jacobian_, row, arm, along);
  }

  /// u . (P - O), u turning with O's body; its derivative goes to the row.
  double along_line(int row, const BodyPoint& point, const BodyPoint& origin, const Point& direction) {
    const Arm p = arm(point), o = arm(origin);
    const Point u = equations_.turned(origin.body, direction), d = p.at - o.at;
    if (jacobian_) {
      add_point(row, p, u);
      add_point(row, o, -u);
      add_angle(row, origin.body, left_of(u).dot(d));
    }
    return u.dot(d);
  }

  void write(const Revolute& c, const Entry& entry) {
    const Arm a = arm(c.a), b = arm(c.b);
    f_[entry.row] = a.at.x() - b.at.x();
    f_[entry.second_row] = a.at.y() - b.at.y();
    if (!jacobian_) return;
    add_joint(*jacobian_, entry, a, 1);
    add_joint(*jacobian_, entry, b, -1);
  }

  void write(const Coordinate& c, const Entry& entry) {
    f_[entry.row] = along_line(entry.row, c.point, c.origin, c.direction) - c.value;
  }

  void write(const Distance& c, const Entry& entry) {
    const Arm a = arm(c.a), b = arm(c.b);
    const Point d = a.at - b.at;
    f_[entry.row] = (d.norm() - c.value) * (d.norm() + c.value) / (2 * entry.scale);
    if (!jacobian_) return;
    add_point(entry.row, a, d / entry.scale);
    add_point(entry.row, b, -d / entry.scale);
  }

  void write(const RelativeAngle& c, const Entry& entry) {
    const double size = equations_.size_;
    f_[entry.row] = size * (angle(c.body) - angle(c.reference) - c.value);
    if (!jacobian_) return;
    add_angle(entry.row, c.body, size);
    add_angle(entry.row, c.reference, -size);
  }

  void write(const GearPair& c, const Entry& entry) {
    const double a = entry.scale * c.first_radius, b = entry.scale * c.second_radius;
    f_[entry.row] = a * (angle(c.first) - angle(c.carrier)) + b * (angle(c.second) - angle(c.carrier)) -
                    entry.scale * c.value;
    if (!jacobian_) return;
    add_angle(entry.row, c.first, a);
    add_angle(entry.row, c.second, b);
    add_angle(entry.row, c.carrier, -a - b);
  }

  void write(const RackAndPinion& c, const Entry& entry) {
    const int pinion = c.centre.body, rack = c.rack_origin.body;
    f_[entry.row] = along_line(entry.row, c.centre, c.rack_origin, c.direction) +
                    c.radius * (angle(pinion) - angle(rack)) - c.value;
    if (!jacobian_) return;
    add_angle(entry.row, pinion, c.radius);
    add_angle(entry.row, rack, -c.radius);
  }

  const PlanarEquations& equations_;
  const Eigen::VectorXd& q_;
  Eigen::VectorXd& f_;
  Eigen::MatrixXd* jacobian_;
};

void PlanarEquations::evaluate(const Eigen::VectorXd& q, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian) {
  turn_bodies(q);
  if (jacobian) jacobian->setZero(rows_, unknowns_);
  f.resize(rows_);
  Evaluation evaluation(*this, q, f, jacobian);
  for (const Entry& entry : entries_) evaluation.write(entry);
}

void PlanarEquations::residual(const Eigen::VectorXd& q, Eigen::VectorXd& f) { evaluate(q, f, nullptr); }

void PlanarEquations::residual_and_jacobian(const Eigen::VectorXd& q, Eigen::VectorXd& f,
                                            Eigen::MatrixXd& jacobian) {
  evaluate(q, f, &jacobian);
}

void PlanarEquations::second_derivative(const Eigen::VectorXd& q, const Eigen::VectorXd& rate,
                                        Eigen::VectorXd& f) {
  turn_bodies(q);
  f.setZero(rows_);
  const auto spin = [&](int body) { return moves(body) ? rate[3 * body - 1] : 0.0; };
  /// Velocity of a point, and the part of its acceleration that the rates cause (centripetal).
  const auto velocity = [&](const Arm& a) -> Point {
    if (!moves(a.body)) return Point::Zero();
    return rate.segment<2>(3 * a.body - 3) + spin(a.body) * left_of(a.turned);
  };
  const auto centripetal = [&](const Arm& a) -> Point { return -spin(a.body) * spin(a.body) * a.turned; };
  const auto along_line = [&](const BodyPoint& point, const BodyPoint& origin, const Point& direction) {
    const Arm p = arm(q, point), o = arm(q, origin);
    const Point u = turned(origin.body, direction);
    const double w = spin(origin.body);
    return u.dot(centripetal(p) - centripetal(o)) + 2 * w * left_of(u).dot(velocity(p) - velocity(o)) -
           w * w * u.dot(p.at - o.at);
  };
  for (const Entry& entry : entries_) {
    const int row = entry.row;
    std::visit(
        Overloaded{
            [&](const Revolute& c) {
              const Point bend = centripetal(arm(q, c.a)) - centripetal(arm(q, c.b));
              f[row] = bend.x();
              f[entry.second_row] = bend.y();
            },
            [&](const Coordinate& c) { f[row] = along_line(c.point, c.origin, c.direction); },
            [&](const Distance& c) {
              const Arm a = arm(q, c.a), b = arm(q, c.b);
              const Point relative = velocity(a) - velocity(b);
              f[row] =
                  (relative.squaredNorm() + (a.at - b.at).dot(centripetal(a) - centripetal(b))) / entry.scale;
            },
            [&](const RelativeAngle&) {}, [&](const GearPair&) {},
            [&](const RackAndPinion& c) { f[row] = along_line(c.centre, c.rack_origin, c.direction); }},
        entry.constraint);
  }
}

void PlanarEquations::bends(const Eigen::VectorXd& q, std::vector<Bend>& result) {
  turn_bodies(q);
  result.clear();
  const auto reach = [](const BodyPoint& point) { return moves(point.body) ? point.local.norm() : 0.0; };
  const auto bound_along_line = [&](const BodyPoint& point, const BodyPoint& origin) {
    if (!moves(origin.body)) return reach(point);
    const Point other = moves(point.body) ? Point(q.segment<2>(3 * point.body - 3)) : point.local;
    const Point between = other - q.segment<2>(3 * origin.body - 3);
    const double bodies = moves(point.body) ? 2 : 1;
    const double local = point.local.norm() * (moves(point.body) ? 4 : 0);
    return between.norm() + drift * reach_ + 2 * bodies * reach_ + local;
  };
  for (const Entry& entry : entries_) {
    const auto add = [&](double bound, int body = 0) {
      if (bound > 0) result.push_back({entry.row, entry.second_row, body, bound});
    };
    std::visit(Overloaded{[&](const Revolute& c) { add(reach(c.a), c.a.body), add(reach(c.b), c.b.body); },
                          [&](const Coordinate& c) {
                            add(bound_along_line(c.point, c.origin), moves(c.origin.body) ? 0 : c.point.body);
                          },
                          [&](const Distance& c) {
                            const auto speed = [&](const BodyPoint& p) {
                              return moves(p.body) ? reach_ + reach(p) : 0.0;
                            };
                            const double s = speed(c.a) + speed(c.b);
                            const double d = (arm(q, c.a).at - arm(q, c.b).at).norm() + 0.5 * s;
                            add((s * s + d * (reach(c.a) + reach(c.b))) / entry.scale);
                          },
                          [&](const RelativeAngle&) {}, [&](const GearPair&) {},
                          [&](const RackAndPinion& c) { add(bound_along_line(c.centre, c.rack_origin)); }},
               entry.constraint);
  }
}

std::vector<PlanarEquations::Joint> PlanarEquations::joints() const {
  std::vector<Joint> joints;
  for (const Entry& entry : entries_) {
    const auto* joint = std::get_if<Revolute>(&entry.constraint);
    if (joint && joint->a.body != joint->b.body && std::max(entry.row, entry.second_row) < unknowns_)
      joints.push_back({entry.row, entry.second_row, joint->a.body, joint->b.body});
  }
  return joints;
}

std::vector<std::vector<int>> PlanarEquations::columns_by_row() const {
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(rows_));
  for (const Entry& entry : entries_) {
    std::vector<int> bodies = bodies_of(entry.constraint);
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    const bool joint = entry.second_row >= 0;
    for (const int body : bodies) {
      if (!moves(body)) continue;
      const int x = 3 * body - 3;
      auto& first = columns[static_cast<std::size_t>(entry.row)];
      first.insert(first.end(), {x, x + 2});
      auto& last = joint ? columns[static_cast<std::size_t>(entry.second_row)] : first;
      if (joint) last.push_back(x + 2);
      last.push_back(x + 1);
    }
  }
  return columns;
}

Eigen::VectorXd unknowns_of(const PlanarPosition& position) {
  Eigen::VectorXd q(3 * static_cast<Eigen::Index>(position.size()) - 3);
  for (std::size_t body = 1; body < position.size(); ++body)
    q.segment<3>(3 * static_cast<Eigen::Index>(body) - 3) << position[body].at, position[body].angle;
  return q;
}

PlanarPosition position_of(const Eigen::VectorXd& q) {
  PlanarPosition position(static_cast<std::size_t>(q.size() / 3 + 1));
  for (std::size_t body = 1; body < position.size(); ++body) {
    const Eigen::Index x = 3 * static_cast<Eigen::Index>(body) - 3;
    position[body] = {Point(q[x], q[x + 1]), q[x + 2]};
  }
  return position;
}

double magnitude_of(const Eigen::VectorXd& q, double size) {
  constexpr double turns_per_rad = 1 / (2 * pi);
  double magnitude = size;
  for (Eigen::Index i = 0; i + 2 < q.size(); i += 3)
    magnitude =
        std::max({magnitude, std::abs(q[i]), std::abs(q[i + 1]), turns_per_rad * size * std::abs(q[i + 2])});
  return magnitude;
}

ConstraintGap gap_of(const Constraint& constraint, const PlanarPosition& position) {
  const auto along_line = [&](const BodyPoint& point, const BodyPoint& origin, const Point& direction) {
    return turned(position, origin.body, direction).dot(place(position, point) - place(position, origin));
  };
  const auto apart = [&](const BodyPoint& a, const BodyPoint& b) {
    return (place(position, a) - place(position, b)).norm();
  };
  const auto angle = [&](int a, int b) {
    return position[static_cast<std::size_t>(a)].angle - position[static_cast<std::size_t>(b)].angle;
  };
  const auto length = [](double error) { return ConstraintGap{std::abs(error), false}; };
  const auto turn = [](double error) { return ConstraintGap{std::abs(error), true}; };
  return std::visit(
      Overloaded{
          [&](const Revolute& c) { return length(apart(c.a, c.b)); },
          [&](const Coordinate& c) { return length(along_line(c.point, c.origin, c.direction) - c.value); },
          [&](const Distance& c) { return length(apart(c.a, c.b) - c.value); },
          [&](const RelativeAngle& c) { return turn(angle(c.body, c.reference) - c.value); },
          [&](const GearPair& c) {
            const double larger = std::max(std::abs(c.first_radius), std::abs(c.second_radius));
            return turn((c.first_radius * angle(c.first, c.carrier) +
                         c.second_radius * angle(c.second, c.carrier) - c.value) /
                        larger);
          },
          [&](const RackAndPinion& c) {
            return length(along_line(c.centre, c.rack_origin, c.direction) +
                          c.radius * angle(c.centre.body, c.rack_origin.body) - c.value);
          }},
      constraint);
}

ConstraintGap gap_of(const PlanarLinkage& linkage, int number, const PlanarPosition& position,
                     const std::vector<double>& driver_values) {
  Constraint constraint = linkage.constraints()[static_cast<std::size_t>(number)].constraint;
  for (std::size_t i = 0; i < driver_values.size(); ++i)
    if (linkage.drivers()[i] == number) *value_in(constraint) = driver_values[i];
  return gap_of(constraint, position);
}

ClosureError closure_error(const PlanarLinkage& linkage, const PlanarPosition& position,
                           const std::vector<double>& driver_values) {
  ClosureError result;
  for (int i = 0; i < static_cast<int>(linkage.constraints().size()); ++i) {
    const double error = gap_of(linkage, i, position, driver_values).as_length(linkage.size());
    if (!(error <= result.largest)) result = {error, i};
    if (std::isnan(error)) break;  // nothing is larger
  }
  return result;
}

}  // namespace kempe
