#include "reports/linkages/forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "kinematics/overloaded.hpp"
#include "reports/linkages/json.hpp"

namespace kempe {
namespace {

using Part = ForceColumn::Part;

/// A name made of letters, digits and underscores only.
std::string column_word(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return text;
}

/// Collects columns, each under a name of its own.
class ForceColumns {
 public:
  explicit ForceColumns(const LinkageModel& model) : model_(model) {}

  void add_driver(int driver) {
    const int number = model_.linkage.drivers()[static_cast<std::size_t>(driver)];
    const bool turns = std::holds_alternative<RelativeAngle>(constraint(number));
    add(number, "drive_" + model_.driver_label(driver), turns ? Part::moment : Part::along);
  }

  void add_constraint(int number) {
    const std::string& name = model_.linkage.constraints()[static_cast<std::size_t>(number)].name;
    std::visit(
        Overloaded{[&](const Revolute& c) { add_pair(number, name + "_on_" + body(c.b.body)); },
                   [&](const Coordinate& c) { add_pair(number, name + "_from_" + body(c.origin.body)); },
                   [&](const Distance&) { add(number, name, Part::tension); },
                   [&](const RelativeAngle& c) { add_angle(number, name, c); },
                   [&](const GearPair&) { add(number, name, Part::along); },
                   [&](const RackAndPinion&) { add(number, name, Part::along); }},
        constraint(number));
  }

  std::vector<ForceColumn> all;

 private:
  const Constraint& constraint(int number) const {
    return model_.linkage.constraints()[static_cast<std::size_t>(number)].constraint;
  }
  const std::string& body(int number) const { return model_.linkage.body_name(number); }

  /// A fixed angle; of a link that slides without turning, what its guide bears. A point of no link bears no moment.
  void add_angle(int number, const std::string& name, const RelativeAngle& angle) {
    if (model_.linkage.is_particle(angle.body)) return;
    const bool slides = name == body(angle.body) + " does not turn";
    add(number, slides ? body(angle.body) + "_from_" + body(angle.reference) : name, Part::moment);
  }

  void add_pair(int number, const std::string& name) {
    add(number, name, Part::x);
    add(number, name, Part::y);
  }

  void add(int number, const std::string& name, Part part) {
    const char* suffix = part == Part::x        ? "_x_N"
                         : part == Part::y      ? "_y_N"
                         : part == Part::moment ? "_N_m"
                                                : "_N";
    const std::string word = column_word(name);
    std::string unique = word + suffix;
    for (int i = 2; !names_.insert(unique).second; ++i) unique = fmt::format("{}_{}{}", word, i, suffix);
    all.push_back({std::move(unique), number, part});
  }

  const LinkageModel& model_;
  std::set<std::string> names_;
};

/// The last columns of a table, which are the forces.
struct ForceTable {
  ForceTable(const LinkageFile& file, const LinkageModel& the_model, const SolveTable& the_table)
      : model(the_model), table(the_table), columns(force_columns(file, the_model)),
        first(the_table.columns.size() - columns.size()) {}

  const std::optional<double>& value(std::size_t row, std::size_t column) const {
    return table.rows[row][first + column];
  }
  double step(std::size_t row) const { return table.rows[row][0].value_or(0); }
  bool is_driver(std::size_t column) const { return model.linkage.is_driver(columns[column].constraint); }

  const LinkageModel& model;
  const SolveTable& table;
  std::vector<ForceColumn> columns;
  std::size_t first;
};

std::string with_unit(double value, const ForceColumn& column) {
  return fmt::format("{:.6g} {}", value, column.kind() == ColumnKind::moment ? "N m" : "N");
}

/// "driver P.y: 12.3 N at step 0, largest -45.6 N at step 8"; "..., its largest" where that is the first.
std::string driver_force_sentence(const ForceTable& forces, std::size_t column, int driver) {
  std::optional<std::size_t> first, most;
  for (std::size_t row = 0; row < forces.table.rows.size(); ++row) {
    const auto& value = forces.value(row, column);
    if (!value) continue;
    if (!first) first = row;
    if (!most || std::abs(*value) > std::abs(*forces.value(*most, column))) most = row;
  }
  const std::string label = "driver " + forces.model.driver_label(driver);
  if (!first) return label + ": no force balances the loads where the motion stops";
  const ForceColumn& what = forces.columns[column];
  const std::string at_first = fmt::format(
      "{}: {} at step {:.6g}", label, with_unit(*forces.value(*first, column), what), forces.step(*first));
  if (most == first) return at_first + ", its largest";
  return fmt::format("{}, largest {} at step {:.6g}", at_first, with_unit(*forces.value(*most, column), what),
                     forces.step(*most));
}

/// The largest force in a joint or guide over the motion.
std::optional<std::string> largest_reaction(const ForceTable& forces) {
  double most = -1;
  std::size_t row_of_most = 0, column_of_most = 0;
  for (std::size_t row = 0; row < forces.table.rows.size(); ++row)
    for (std::size_t column = 0; column < forces.columns.size(); ++column) {
      const auto& x = forces.value(row, column);
      if (forces.is_driver(column) || !x || forces.columns[column].kind() == ColumnKind::moment) continue;
      const bool pair = forces.columns[column].part == Part::x;
      const double force = pair ? std::hypot(*x, forces.value(row, column + 1).value_or(0)) : std::abs(*x);
      if (!(force > most)) continue;
      most = force;
      row_of_most = row;
      column_of_most = column;
    }
  if (most < 0) return std::nullopt;
  return fmt::format(
      "largest reaction: {} in {} at step {:.6g}", with_unit(most, forces.columns[column_of_most]),
      constraint_label(forces.model, forces.columns[column_of_most].constraint), forces.step(row_of_most));
}

}  // namespace

std::optional<double> ForceColumn::value(const Reaction& reaction) const {
  if (!reaction.determined) return std::nullopt;
  switch (part) {
    case Part::x: return reaction.force.x();
    case Part::y: return reaction.force.y();
    case Part::along: return reaction.along;
    case Part::tension: return -reaction.along;
    case Part::moment: return reaction.along / moment_unit;
  }
  return std::nullopt;
}

std::vector<ForceColumn> force_columns(const LinkageFile& file, const LinkageModel& model) {
  if (model.loads.empty()) return {};
  ForceColumns columns(model);
  for (int driver = 0; driver < static_cast<int>(model.linkage.drivers().size()); ++driver)
    columns.add_driver(driver);
  if (file.output.reactions)
    for (int i = 0; i < static_cast<int>(model.linkage.constraints().size()); ++i)
      if (!model.linkage.is_driver(i)) columns.add_constraint(i);
  return std::move(columns.all);
}

std::optional<std::vector<Reaction>> ForceFinder::at(const RunFrame& frame) {
  if (frame.rate.size() == 0) return std::nullopt;
  return solver_.at(frame.position, frame.values,
                    inertia_forces(model_.loads, frame.position, frame.rate, frame.second) -
                        applied_forces(model_.loads, frame.position));
}

std::vector<std::string> force_sentences(const LinkageFile& file, const LinkageModel& model,
                                         const SolveTable& table) {
  const ForceTable forces(file, model, table);
  if (forces.columns.empty()) return {};
  std::vector<std::string> sentences;
  for (std::size_t driver = 0; driver < model.linkage.drivers().size(); ++driver)
    sentences.push_back(driver_force_sentence(forces, driver, static_cast<int>(driver)));
  if (auto sentence = largest_reaction(forces)) sentences.push_back(std::move(*sentence));
  if (const auto labels = undetermined_reactions(file, model, table); !labels.empty())
    sentences.push_back(fmt::format(
        "not determined: {}; rigid links do not say how these share the loads ({})", fmt::join(labels, ", "),
        ReactionSolver(model.linkage).has_gears_without_bearings()
            ? "the wheels have no joints with their carrier"
            : "the linkage is over-constrained"));
  return sentences;
}

std::vector<std::string> undetermined_reactions(const LinkageFile& file, const LinkageModel& model,
                                                const SolveTable& table) {
  const ForceTable forces(file, model, table);
  std::vector<std::string> labels;
  for (std::size_t column = 0; column < forces.columns.size(); ++column) {
    const auto left_out = [&](std::size_t row) {
      return forces.value(row, 0).has_value() && !forces.value(row, column).has_value();
    };
    bool any = false;
    for (std::size_t row = 0; row < table.rows.size(); ++row) any |= left_out(row);
    if (!any) continue;
    std::string label = constraint_label(model, forces.columns[column].constraint);
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(std::move(label));
  }
  return labels;
}

}  // namespace kempe
