#include "specs/linkages/rigid_link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace kempe {
namespace {

constexpr double flat = 1e-9;  ///< of the longest side: a triangle this low is a straight line
constexpr double agreeing =
    1e-6;  ///< share of a length, and rad: what a file's rounded figures may differ by

class JointPlacing {
 public:
  explicit JointPlacing(const RigidLinkTask& task) : task_(task), places_(task.joints.size()) {}

  tl::expected<std::vector<Point>, NotRigid> place_all() {
    const auto base = length(0, 1);
    if (!base)
      return tl::unexpected(
          NotRigid{fmt::format("no length {}-{}", name(0), name(1)),
                   "the distance of the first two joints, and for each other joint two lengths and "
                   "the side, or a length and an angle"});
    places_[0] = Point::Zero();
    places_[1] = Point(*base, 0);
    for (std::size_t round = 2; round < places_.size(); ++round)
      if (auto fault = place_one()) return tl::unexpected(*fault);
    if (auto fault = check_all()) return tl::unexpected(*fault);
    std::vector<Point> result;
    for (const auto& place : places_) result.push_back(*place);
    return result;
  }

 private:
  const std::string& name(std::size_t joint) const { return task_.joints[joint]; }

  std::optional<double> length(std::size_t a, std::size_t b) const {
    for (const JointDistance& d : task_.lengths)
      if ((d.a == a && d.b == b) || (d.a == b && d.b == a)) return d.length;
    return std::nullopt;
  }

  /// Places the first joint that follows from the placed ones.
  std::optional<NotRigid> place_one() {
    for (std::size_t joint = 0; joint < places_.size(); ++joint)
      if (!places_[joint] && place_by_angle(joint)) return std::nullopt;
    for (std::size_t joint = 0; joint < places_.size(); ++joint) {
      if (places_[joint]) continue;
      std::optional<NotRigid> fault;
      if (place_by_lengths(joint, fault)) return fault;
    }
    const auto open = std::find(places_.begin(), places_.end(), std::nullopt) - places_.begin();
    return NotRigid{
        fmt::format("nothing that places {}", name(static_cast<std::size_t>(open))),
        "two lengths from it to placed joints (and the side), or a length and an angle at that joint"};
  }

  bool place_by_angle(std::size_t joint) {
    for (const JointAngle& angle : task_.angles) {
      const bool forward = angle.to == joint, backward = angle.from == joint;
      if (!forward && !backward) continue;
      const std::size_t arm = forward ? angle.from : angle.to;
      const auto away = length(angle.at, joint);
      if (!away || !places_[angle.at] || !places_[arm]) continue;
      const Point along = (*places_[arm] - *places_[angle.at]).normalized();
      const Complex turn = std::polar(*away, forward ? angle.angle : -angle.angle);
      places_[joint] = *places_[angle.at] + as_point(as_complex(along) * turn);
      return true;
    }
    return false;
  }

  /// True if two lengths to placed joints are known: then the joint is placed, or the fault says why not.
  bool place_by_lengths(std::size_t joint, std::optional<NotRigid>& fault) {
    for (std::size_t a = 0; a < places_.size(); ++a)
      for (std::size_t b = a + 1; b < places_.size(); ++b) {
        const auto from_a = length(a, joint), from_b = length(b, joint);
        if (!places_[a] || !places_[b] || !from_a || !from_b) continue;
        fault = meet(joint, a, *from_a, b, *from_b);
        return true;
      }
    return false;
  }

  std::optional<NotRigid> meet(std::size_t joint, std::size_t a, double from_a, std::size_t b,
                               double from_b) {
    const Point base = *places_[b] - *places_[a];
    const double between = base.norm(), longest = std::max({between, from_a, from_b});
    const double along = ((from_a - from_b) * (from_a + from_b) + between * between) / (2 * between);
    const double square = (from_a - along) * (from_a + along);
    if (square < -2 * flat * longest * longest)
      return NotRigid{
          fmt::format("lengths {}-{} = {:g}, {}-{} = {:g}, {}-{} = {:g} (mm) that close no triangle", name(a),
                      name(b), between, name(a), name(joint), from_a, name(b), name(joint), from_b),
          "the longest at most the sum of the others"};
    const Point foot = *places_[a] + base * (along / between);
    const Point up = Point(-base.y(), base.x()) / between;
    if (square < 2 * flat * longest * longest) {
      places_[joint] = foot;
      return std::nullopt;
    }
    const double height = std::sqrt(square);
    return choose_side(joint, foot + height * up, foot - height * up);
  }

  std::optional<NotRigid> choose_side(std::size_t joint, const Point& first, const Point& second) {
    const double longest = std::max(first.norm(), second.norm());
    for (const Point& place : {first, second}) {  // a superfluous length may decide
      const Point& other = &place == &first ? second : first;
      if (disagreement(joint, place) <= flat * longest && disagreement(joint, other) > flat * longest) {
        places_[joint] = place;
        return std::nullopt;
      }
    }
    const bool apart = (first.y() > 0) != (second.y() > 0);  // sides of the x axis
    if (!task_.side || !apart)
      return NotRigid{
          fmt::format("two places for {}", name(joint)),
          apart ? fmt::format("side = \"left\" or \"right\" (of the line from {} to {})", name(0), name(1))
                : fmt::format("an angle that places {}", name(joint))};
    places_[joint] = (first.y() > 0) == (*task_.side == Side::left) ? first : second;
    return std::nullopt;
  }

  /// How far the lengths to placed joints are off at a place.
  double disagreement(std::size_t joint, const Point& place) const {
    double worst = 0;
    for (std::size_t other = 0; other < places_.size(); ++other)
      if (const auto d = length(joint, other); d && other != joint && places_[other])
        worst = std::max(worst, std::abs((place - *places_[other]).norm() - *d));
    return worst;
  }

  std::optional<NotRigid> check_all() const {
    for (const JointDistance& d : task_.lengths) {
      const double is = (*places_[d.a] - *places_[d.b]).norm();
      if (std::abs(is - d.length) > agreeing * std::max(is, d.length))
        return NotRigid{fmt::format("{}-{} = {:g} mm where the other lengths and angles give {:g} mm",
                                    name(d.a), name(d.b), d.length, is),
                        "lengths and angles that agree"};
    }
    for (const JointAngle& angle : task_.angles) {
      const Complex from = as_complex(*places_[angle.from] - *places_[angle.at]);
      const Complex to = as_complex(*places_[angle.to] - *places_[angle.at]);
      const double is = std::arg(to / from);
      if (std::abs(std::remainder(is - angle.angle, 2 * pi)) > agreeing)
        return NotRigid{
            fmt::format("angle {}-{}-{} = {:g} degrees where the lengths give {:g}", name(angle.from),
                        name(angle.at), name(angle.to), degrees(angle.angle), degrees(is)),
            "lengths and angles that agree"};
    }
    for (std::size_t a = 0; a < places_.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (!((*places_[a] - *places_[b]).norm() > 0))
          return NotRigid{fmt::format("joints {} and {} at one place", name(b), name(a)), "joints apart"};
    return std::nullopt;
  }

  const RigidLinkTask& task_;
  std::vector<std::optional<Point>> places_;
};

}  // namespace

tl::expected<std::vector<Point>, NotRigid> place_joints(const RigidLinkTask& task) {
  return JointPlacing(task).place_all();
}

}  // namespace kempe
