#include "kinematics/planar/instant_centres.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "kinematics/planar/rates.hpp"
#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

/// A point or a line of the projective plane, of length 1: (x, y, w), lengths in sizes from the linkage's
/// middle.
using Projective = Eigen::Vector3d;

struct Frame {
  Point middle;
  double size;

  Projective finite(const Point& point) const {
    const Point p = (point - middle) / size;
    return Projective(p.x(), p.y(), 1).normalized();
  }
  static Projective at_infinity(const Point& direction) {
    return Projective(direction.x(), direction.y(), 0).normalized();
  }
};

using Pair = std::pair<int, int>;
Pair pair_of(int i, int j) { return {std::min(i, j), std::max(i, j)}; }

struct KnownLine {
  Projective line;
  CentreLine source;
};

class Centres {
 public:
  Centres(const PlanarLinkage& linkage, const PlanarPosition& position, const Eigen::VectorXd& rate)
      : linkage_(linkage), position_(position), rate_(rate), frame_{middle(), linkage.size()} {
    for (int body = 0; body < linkage.body_count(); ++body)
      if (!linkage.is_particle(body)) links_.push_back(body);
  }

  std::vector<InstantCentre> all() {
    for (int i = 0; i < static_cast<int>(linkage_.constraints().size()); ++i)
      if (!linkage_.is_driver(i)) read_joint(i);
    read_sliding_pairs();
    read_wheels();
    while (known_.size() < pair_count()) {
      if (add_best_crossing()) continue;
      if (!add_from_rates()) break;
    }
    std::vector<InstantCentre> result;
    for (std::size_t i = 0; i < links_.size(); ++i)
      for (std::size_t j = i + 1; j < links_.size(); ++j)
        result.push_back(described(pair_of(links_[i], links_[j])));
    return result;
  }

 private:
  struct Known {
    Projective at;
    InstantCentre::Source source;
    std::optional<int> constraint{};
    std::optional<std::array<CentreLine, 2>> lines{};
  };

  std::size_t pair_count() const { return links_.size() * (links_.size() - 1) / 2; }

  Point middle() const {
    Point sum = Point::Zero();
    double count = 0;
    for (const auto& [name, constraint] : linkage_.constraints())
      for (const BodyPoint& point : points_of(constraint)) {
        sum += place(position_, point);
        ++count;
      }
    return count > 0 ? Point(sum / count) : sum;
  }

  bool is_link(int body) const { return !linkage_.is_particle(body); }

  const Constraint& constraint(int number) const {
    return linkage_.constraints()[static_cast<std::size_t>(number)].constraint;
  }

  static KnownLine known_line(const Projective& line, CentreLine source) {
    const Point along(-line.y(), line.x());
    const bool finite = along.norm() > slack::distinct * line.norm();
    source.direction = finite ? along.normalized() : Point::Zero().eval();
    return {line.normalized(), source};
  }

  void set(const Pair& pair, const Projective& at, InstantCentre::Source source, std::optional<int> number) {
    known_.try_emplace(pair, Known{at, source, number});
  }

  void read_joint(int number) {
    if (const auto* joint = std::get_if<Revolute>(&constraint(number))) {
      if (!is_link(joint->a.body) || !is_link(joint->b.body)) return;
      set(pair_of(joint->a.body, joint->b.body), frame_.finite(place(position_, joint->a)),
          InstantCentre::Source::primary, number);
    } else if (const auto* slot = std::get_if<Coordinate>(&constraint(number))) {
      if (!is_link(slot->point.body) || !is_link(slot->origin.body)) return;
      const Projective pin = frame_.finite(place(position_, slot->point));
      const Projective normal = Frame::at_infinity(turned(position_, slot->origin.body, slot->direction));
      lines_[pair_of(slot->point.body, slot->origin.body)].push_back(
          known_line(pin.cross(normal), {.from = CentreLine::From::slider, .constraint = number}));
    } else if (const auto* angle = std::get_if<RelativeAngle>(&constraint(number))) {
      if (!is_link(angle->body) || !is_link(angle->reference)) return;
      lines_[pair_of(angle->body, angle->reference)].push_back(
          known_line(Projective(0, 0, 1), {.from = CentreLine::From::no_turning, .constraint = number}));
    }
  }

  /// Two links with a slot and no turning between them: a sliding pair, whose centre is primary.
  void read_sliding_pairs() {
    for (const auto& [pair, lines] : lines_) {
      if (lines.size() < 2) continue;
      const Projective at = lines[0].line.cross(lines[1].line);
      if (at.norm() > slack::distinct)
        set(pair, at.normalized(), InstantCentre::Source::primary, lines[0].source.constraint);
    }
  }

  std::optional<Point> pivot(int body, int carrier) const {
    for (const auto& [name, constraint] : linkage_.constraints())
      if (const auto* joint = std::get_if<Revolute>(&constraint))
        if (pair_of(joint->a.body, joint->b.body) == pair_of(body, carrier))
          return place(position_, joint->a);
    return std::nullopt;
  }

  /// Pitch points of gear pairs and of racks.
  void read_wheels() {
    for (int i = 0; i < static_cast<int>(linkage_.constraints().size()); ++i) {
      if (linkage_.is_driver(i)) continue;
      if (const auto* gears = std::get_if<GearPair>(&constraint(i))) {
        const auto first = pivot(gears->first, gears->carrier), second = pivot(gears->second, gears->carrier);
        if (!first || !second) continue;
        const double a = gears->first_radius, b = gears->second_radius;
        const Point weighted = b * (*first - frame_.middle) + a * (*second - frame_.middle);
        const Projective at =
            Projective(weighted.x() / frame_.size, weighted.y() / frame_.size, a + b).normalized();
        set(pair_of(gears->first, gears->second), at, InstantCentre::Source::primary, i);
      } else if (const auto* rack = std::get_if<RackAndPinion>(&constraint(i))) {
        const Point along = turned(position_, rack->rack_origin.body, rack->direction);
        const Point contact = place(position_, rack->centre) - rack->radius * left_of(along);
        set(pair_of(rack->centre.body, rack->rack_origin.body), frame_.finite(contact),
            InstantCentre::Source::primary, i);
      }
    }
  }

  /// All lines on which the centre of a pair is known to lie.
  std::vector<KnownLine> lines_for(const Pair& pair) const {
    std::vector<KnownLine> result;
    if (const auto found = lines_.find(pair); found != lines_.end()) result = found->second;
    for (const int via : links_) {
      if (via == pair.first || via == pair.second) continue;
      const auto a = known_.find(pair_of(pair.first, via)), b = known_.find(pair_of(via, pair.second));
      if (a == known_.end() || b == known_.end()) continue;
      const Projective line = a->second.at.cross(b->second.at);
      if (line.norm() > slack::distinct)
        result.push_back(known_line(line, {.from = CentreLine::From::kennedy, .via = via}));
    }
    return result;
  }

  /// Adds the unknown centre whose two lines cross at the largest angle; false if no two lines cross.
  bool add_best_crossing() {
    double best = slack::worthwhile_crossing;
    std::optional<Pair> found;
    Known centre{Projective::Zero(), InstantCentre::Source::none};
    for (std::size_t i = 0; i < links_.size(); ++i)
      for (std::size_t j = i + 1; j < links_.size(); ++j) {
        const Pair pair = pair_of(links_[i], links_[j]);
        if (known_.contains(pair)) continue;
        const std::vector<KnownLine> lines = lines_for(pair);
        for (std::size_t a = 0; a < lines.size(); ++a)
          for (std::size_t b = a + 1; b < lines.size(); ++b) {
            const Projective at = lines[a].line.cross(lines[b].line);
            if (at.norm() <= best) continue;
            best = at.norm();
            found = pair;
            centre = {at.normalized(), InstantCentre::Source::lines, std::nullopt,
                      std::array{lines[a].source, lines[b].source}};
          }
      }
    if (found) known_.emplace(*found, centre);
    return found.has_value();
  }

  struct Relative {  ///< motion of the second link against the first: velocity at the frame's middle, spin
    Point velocity;
    double spin;
    double speed(double size) const { return velocity.norm() + std::abs(spin) * size; }
  };

  Relative relative(const Pair& pair) const {
    const auto at_middle = [&](int body) -> Point {
      if (body == PlanarLinkage::ground) return Point::Zero();
      const Point arm = frame_.middle - position_[static_cast<std::size_t>(body)].at;
      return rate_.segment<2>(3 * body - 3) + spin_of(rate_, body) * left_of(arm);
    };
    return {at_middle(pair.second) - at_middle(pair.first),
            spin_of(rate_, pair.second) - spin_of(rate_, pair.first)};
  }

  double fastest() const {
    double result = 0;
    for (const int body : links_)
      result = std::max(result, relative({PlanarLinkage::ground, body}).speed(frame_.size));
    return result;
  }

  /// v + w left(P - middle) = 0 gives P - middle = left(v) / w.
  std::optional<Projective> from_velocity(const Pair& pair) const {
    const Relative motion = relative(pair);
    if (motion.speed(frame_.size) <= slack::standing * fastest()) return std::nullopt;
    const Point over = left_of(motion.velocity) / frame_.size;
    return Projective(over.x(), over.y(), motion.spin).normalized();
  }

  bool add_from_rates() {
    for (const int i : links_)
      for (const int j : links_) {
        const Pair pair{i, j};
        if (i >= j || known_.contains(pair)) continue;
        if (const auto at = from_velocity(pair)) {
          known_.emplace(pair, Known{*at, InstantCentre::Source::rates});
          return true;
        }
      }
    return false;
  }

  InstantCentre described(const Pair& pair) const {
    InstantCentre result;
    result.first = pair.first;
    result.second = pair.second;
    const auto found = known_.find(pair);
    if (found == known_.end()) return result;
    const Known& centre = found->second;
    result.source = centre.source;
    result.constraint = centre.constraint;
    result.lines = centre.lines;
    const Point over = centre.at.head<2>();
    if (std::abs(centre.at.z()) > slack::at_infinity * over.norm()) {
      result.kind = InstantCentre::Kind::finite;
      result.at = frame_.middle + frame_.size * over / centre.at.z();
    } else {
      result.kind = InstantCentre::Kind::at_infinity;
      result.direction = over.normalized();
      if (result.direction.y() < 0 || (result.direction.y() == 0 && result.direction.x() < 0))
        result.direction *= -1;
    }
    result.velocity_error = velocity_error(pair, centre.at);
    return result;
  }

  /// |w v + spin left(over)| of the homogeneous point: zero where both links move alike.
  double velocity_error(const Pair& pair, const Projective& at) const {
    const Relative motion = relative(pair);
    const double speed = motion.speed(frame_.size);
    if (speed <= slack::standing * fastest()) return 0;
    const Point unlike = at.z() * motion.velocity + motion.spin * frame_.size * left_of(at.head<2>());
    return unlike.norm() / speed;
  }

  const PlanarLinkage& linkage_;
  const PlanarPosition& position_;
  const Eigen::VectorXd& rate_;
  Frame frame_;
  std::vector<int> links_;
  std::map<Pair, Known> known_;
  std::map<Pair, std::vector<KnownLine>> lines_;
};

}  // namespace

std::vector<InstantCentre> instant_centres(const PlanarLinkage& linkage, const PlanarPosition& position,
                                           const Eigen::VectorXd& rate) {
  return Centres(linkage, position, rate).all();
}

}  // namespace kempe
