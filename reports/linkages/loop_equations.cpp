#include "reports/linkages/loop_equations.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "kinematics/overloaded.hpp"
#include "kinematics/planar/equations.hpp"
#include "reports/linkages/equation_numbers.hpp"
#include "reports/linkages/json.hpp"

namespace kempe {
namespace {

/// An expression twice: with the unknowns' names, and with their values.
struct Written {
  std::string symbols, numbers;

  Written operator+(const Written& other) const { return {symbols + other.symbols, numbers + other.numbers}; }
  bool is_sum() const { return symbols.find(' ') != std::string::npos; }
};

Written plain(const std::string& text) { return {text, text}; }

Written in_brackets(const Written& inner) { return plain("(") + inner + plain(")"); }

class EquationWriter {
 public:
  EquationWriter(const LinkageFile& file, const LinkageModel& model, const RunFrame& frame)
      : file_(file), model_(model), frame_(frame) {
    std::set<std::string> taken;
    names_.emplace_back();
    for (int body = 1; body < model.linkage.body_count(); ++body) {
      std::string name;
      for (const char c : model.linkage.body_name(body))
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      while (!taken.insert(name).second) name += "_";
      names_.push_back(name);
    }
  }

  std::vector<std::pair<std::string, double>> unknowns() const {
    std::vector<std::pair<std::string, double>> result;
    for (std::size_t body = 1; body < names_.size(); ++body) {
      const BodyPlacement& at = frame_.position[body];
      result.emplace_back("x_" + names_[body], in_unit(at.at.x()));
      result.emplace_back("y_" + names_[body], in_unit(at.at.y()));
      result.emplace_back("t_" + names_[body], degrees(at.angle));
    }
    return result;
  }

  std::vector<LoopEquation> equations() const {
    PlanarEquations system(model_.linkage);
    system.set_values(frame_.values);
    Eigen::VectorXd q(model_.linkage.unknown_count()), residual;
    for (Eigen::Index body = 1; body < static_cast<Eigen::Index>(names_.size()); ++body) {
      const BodyPlacement& at = frame_.position[static_cast<std::size_t>(body)];
      q.segment<3>(3 * body - 3) << at.at, at.angle;
    }
    Eigen::MatrixXd jacobian;
    system.residual_and_jacobian(q, residual, jacobian);
    std::vector<LoopEquation> result;
    for (int number = 0; number < static_cast<int>(model_.linkage.constraints().size()); ++number) {
      int row = system.row_of(number);
      for (LoopEquation equation : written(number)) {
        equation.of = constraint_label(model_, number);
        equation.slopes = slopes(jacobian.row(row++) / system.value_slope(number), above(number));
        result.push_back(std::move(equation));
      }
    }
    return result;
  }

 private:
  double in_unit(double length) const { return length / file_.unit.in_mm; }
  const Constraint& constraint(int number) const {
    return model_.linkage.constraints()[static_cast<std::size_t>(number)].constraint;
  }
  /// From what an equation is in, mm, rad or (of wheels) mm rad, to the file's unit and degrees.
  double above(int number) const {
    if (std::holds_alternative<RelativeAngle>(constraint(number))) return 180 / pi;
    if (std::holds_alternative<GearPair>(constraint(number))) return in_unit(180 / pi);
    return in_unit(1);
  }

  /// The value of a constraint: a driver's is that of the moment.
  double value_of(int number, double own) const {
    const auto& drivers = model_.linkage.drivers();
    for (std::size_t i = 0; i < drivers.size(); ++i)
      if (drivers[i] == number) return frame_.values[i];
    return own;
  }

  /// An unknown, "x" or "y" or "t", of a link that moves; of the ground all are 0.
  Written unknown(char kind, int body) const {
    if (body == PlanarLinkage::ground) return plain("0");
    const BodyPlacement& at = frame_.position[static_cast<std::size_t>(body)];
    const double value = kind == 't' ? degrees(at.angle) : in_unit(kind == 'x' ? at.at.x() : at.at.y());
    return {fmt::format("{}_{}", kind, names_[static_cast<std::size_t>(body)]), bracketed_digits(value)};
  }

  /// cos and sin of a link's direction with their factors, " + 12 cos(t_rod) - 3 sin(t_rod)"; nothing where a factor is 0.
  Written turned(double by_cos, double by_sin, int body) const {
    const double least = 1e-12 * std::max(std::abs(by_cos), std::abs(by_sin));
    const BodyPlacement& at = frame_.position[static_cast<std::size_t>(body)];
    Written result;
    for (const auto& [factor, function] : {std::pair{by_cos, "cos("}, std::pair{by_sin, "sin("}}) {
      if (std::abs(factor) <= least) continue;
      result = result + plain(factor < 0 ? " - " : " + ");
      if (std::abs(factor) != 1) result = result + plain(digits(std::abs(factor)) + " ");
      result = result + plain(function) +
               Written{"t_" + names_[static_cast<std::size_t>(body)], digits(degrees(at.angle))} + plain(")");
    }
    return result;
  }

  /// The same where nothing stands before it.
  Written turned_alone(double by_cos, double by_sin, int body) const {
    Written result = turned(by_cos, by_sin, body);
    for (std::string* text : {&result.symbols, &result.numbers})
      *text = text->starts_with(" - ") ? "-" + text->substr(3) : text->substr(3);
    return result;
  }

  /// A coordinate of a point in the table's frame, axis 0 or 1.
  Written coordinate(const BodyPoint& point, int axis) const {
    const double u = in_unit(point.local.x()), v = in_unit(point.local.y());
    if (point.body == PlanarLinkage::ground) return plain(bracketed_digits(axis == 0 ? u : v));
    return unknown(axis == 0 ? 'x' : 'y', point.body) +
           (axis == 0 ? turned(u, -v, point.body) : turned(v, u, point.body));
  }

  Written difference(const BodyPoint& to, const BodyPoint& from, int axis) const {
    const Written less = coordinate(from, axis);
    return coordinate(to, axis) + plain(" - ") + (less.is_sum() ? in_brackets(less) : less);
  }

  /// direction . (point - origin), the direction turning with the origin's link.
  Written along(const BodyPoint& point, const BodyPoint& origin, const Point& direction) const {
    const double u = direction.x(), v = direction.y();
    if (origin.body != PlanarLinkage::ground)
      return in_brackets(turned_alone(u, -v, origin.body)) + plain(" * ") +
             in_brackets(difference(point, origin, 0)) + plain(" + ") +
             in_brackets(turned_alone(v, u, origin.body)) + plain(" * ") +
             in_brackets(difference(point, origin, 1));
    Written sum;
    for (const int axis : {0, 1}) {
      if (direction[axis] == 0) continue;
      if (!sum.symbols.empty()) sum = sum + plain(" + ");
      const Written way = difference(point, origin, axis);
      sum =
          sum +
          (direction[axis] == 1 ? way : plain(bracketed_digits(direction[axis]) + " * ") + in_brackets(way));
    }
    return sum;
  }

  LoopEquation equals(const Written& left, double right) const {
    const std::string end = " = " + digits(right);
    return {{}, left.symbols + end, left.numbers + end, {}};
  }

  std::vector<LoopEquation> written(int number) const {
    return std::visit(
        Overloaded{
            [&](const Revolute& c) {
              return std::vector{equals(difference(c.a, c.b, 0), 0), equals(difference(c.a, c.b, 1), 0)};
            },
            [&](const Coordinate& c) {
              return std::vector{
                  equals(along(c.point, c.origin, c.direction), in_unit(value_of(number, c.value)))};
            },
            [&](const Distance& c) {
              return std::vector{equals(plain("sqrt((") + difference(c.a, c.b, 0) + plain(")^2 + (") +
                                            difference(c.a, c.b, 1) + plain(")^2)"),
                                        in_unit(value_of(number, c.value)))};
            },
            [&](const RelativeAngle& c) {
              return std::vector{equals(unknown('t', c.body) + plain(" - ") + unknown('t', c.reference),
                                        degrees(value_of(number, c.value)))};
            },
            [&](const GearPair& c) {
              const auto wheel = [&](double radius, int body) {
                return plain(digits(in_unit(radius)) + " * (") + unknown('t', body) + plain(" - ") +
                       unknown('t', c.carrier) + plain(")");
              };
              return std::vector{
                  equals(wheel(c.first_radius, c.first) + plain(" + ") + wheel(c.second_radius, c.second),
                         degrees(in_unit(value_of(number, c.value))))};
            },
            [&](const RackAndPinion& c) {
              return std::vector{
                  equals(along(c.centre, c.rack_origin, c.direction) +
                             plain(fmt::format("{} * (", signed_number(in_unit(c.radius) * pi / 180))) +
                             unknown('t', c.centre.body) + plain(" - ") + unknown('t', c.rack_origin.body) +
                             plain(")"),
                         in_unit(value_of(number, c.value)))};
            }},
        constraint(number));
  }

  /// A row of the Jacobian in the file's unit and degrees; `above` is the factor of the equation itself.
  std::vector<std::pair<std::string, double>> slopes(const Eigen::RowVectorXd& row, double above) const {
    std::vector<std::pair<std::string, double>> result;
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      const bool by_angle = i % 3 == 2;
      const double slope = row[i] * above / (by_angle ? 180 / pi : in_unit(1));
      if (std::abs(row[i]) > 1e-12 * (by_angle ? model_.linkage.size() : 1))
        result.emplace_back(fmt::format("{}_{}", "xyt"[i % 3], names_[static_cast<std::size_t>(i / 3 + 1)]),
                            slope);
    }
    return result;
  }

  const LinkageFile& file_;
  const LinkageModel& model_;
  const RunFrame& frame_;
  std::vector<std::string> names_;  ///< of links, fit for a symbol
};

}  // namespace

std::vector<LoopEquation> loop_equations(const LinkageFile& file, const LinkageModel& model,
                                         const RunFrame& frame) {
  return EquationWriter(file, model, frame).equations();
}

std::vector<std::pair<std::string, double>> unknowns_at(const LinkageFile& file, const LinkageModel& model,
                                                        const RunFrame& frame) {
  return EquationWriter(file, model, frame).unknowns();
}

std::string loop_equations_text(const LinkageFile& file, const LinkageModel& model, double step,
                                const RunFrame& frame) {
  std::string text = fmt::format(
      "{}, step {:g}: each link's own origin at (x, y), {} from the table's, turned by t "
      "degrees\n\nunknowns\n",
      file.name, step, file.unit.name);
  const auto unknowns = unknowns_at(file, model, frame);
  for (const auto& [name, value] : unknowns) text += fmt::format("  {} = {}\n", name, digits(value));
  text += "\nequations, the same with numbers, and the derivatives of left less right\n";
  std::string last;
  const auto equations = loop_equations(file, model, frame);
  for (const LoopEquation& equation : equations) {
    if (equation.of != last) text += equation.of + "\n";
    last = equation.of;
    text += fmt::format("  {}\n  {}\n", equation.symbols, equation.numbers);
    std::string row;
    for (const auto& [name, slope] : equation.slopes)
      row += fmt::format("{}by {} {}", row.empty() ? "" : ", ", name, digits(slope));
    text += "    " + row + "\n";
  }
  const std::size_t drivers = model.linkage.drivers().size();
  return text + fmt::format("\n{} unknowns, {} equations, {} of them {}\n", unknowns.size(), equations.size(),
                            drivers, drivers == 1 ? "a driver's" : "drivers'");
}

std::string loop_equations_json(const LinkageFile& file, const LinkageModel& model, double step,
                                const RunFrame& frame) {
  using Json = nlohmann::ordered_json;
  Json unknowns = Json::object(), equations = Json::array();
  for (const auto& [name, value] : unknowns_at(file, model, frame)) unknowns[name] = value;
  for (const LoopEquation& equation : loop_equations(file, model, frame)) {
    Json slopes = Json::object();
    for (const auto& [name, slope] : equation.slopes) slopes[name] = slope;
    equations.push_back({{"of", equation.of},
                         {"symbols", equation.symbols},
                         {"numbers", equation.numbers},
                         {"derivatives", std::move(slopes)}});
  }
  return Json{{"linkage", file.name},
              {"unit", file.unit.name},
              {"step", step},
              {"unknowns", std::move(unknowns)},
              {"equations", std::move(equations)}}
             .dump() +
         "\n";
}

}  // namespace kempe
