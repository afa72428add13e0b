#include "tests/fuzz/degenerate_linkages.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "kinematics/planar/instant_centres.hpp"
#include "kinematics/planar/mobility.hpp"
#include "specs/linkages/model.hpp"
#include "tests/fuzz/choices.hpp"

namespace kempe::fuzz {
namespace {

/// Draws lengths, ordinary and almost none, all in one size.
class Lengths {
 public:
  explicit Lengths(Choices& choices) : choices_(choices) {
    const double decade = choices.between(-6, 6);
    size_ = choices.upto(2) == 0 ? 1 : std::pow(10, decade);
  }

  double ordinary() { return size_ * choices_.between(0.5, 3); }
  /// Nothing, or next to nothing, of either sign.
  double slight() {
    const double share = choices_.between(0.5, 2), decade = choices_.between(-12, -3);
    const int kind = choices_.upto(4);
    return kind == 0 ? 0 : size_ * share * std::pow(10, kind == 1 ? -5 : decade) * (kind == 2 ? -1 : 1);
  }
  double ordinary_or_short() {
    const double usual = ordinary(), shortened = std::abs(slight());
    return choices_.upto(3) == 0 && shortened > 0 ? shortened : usual;
  }
  double size() const { return size_; }

 private:
  Choices& choices_;
  double size_ = 1;
};

std::string turn_driver(Choices& choices, const std::string& link) {
  const double from = choices.between(-180, 180), turn = choices.between(-400, 400);
  return fmt::format("[[drivers]]\nangle = \"{}\"\nfrom_deg = {}\nto_deg = {}\n", link, from, from + turn);
}

std::string four_bar(Choices& choices, Lengths& l) {
  const double d = l.ordinary_or_short(), a = l.ordinary_or_short(), b = l.ordinary_or_short(),
               c = l.ordinary_or_short();
  const std::string driver = turn_driver(choices, "crank");
  return fmt::format(R"([ground]
A = [0, 0]
D = [{}, 0]
[links]
crank = {{ joints = ["A", "B"], A-B = {} }}
rod = {{ joints = ["B", "C"], B-C = {} }}
rocker = {{ joints = ["D", "C"], D-C = {} }}
)",
                     d, a, b, c) +
         driver;
}

/// A point on two lines that may be almost one.
std::string crossing(Choices& choices, Lengths& l) {
  const double qx = l.slight(), qy = l.ordinary_or_short(), arm = l.ordinary();
  const double slope = choices.between(-1e-3, 1e-3), tilt = choices.upto(2) == 0 ? 0 : slope;
  const std::string driver = turn_driver(choices, "arm");
  return fmt::format(R"(points = ["P"]
[ground]
O = [0, 0]
Q = [{}, {}]
[links]
arm = {{ joints = ["O", "A"], O-A = {} }}
[[sliders]]
point = "P"
on = "ground"
through = "Q"
direction_deg = {}
[[sliders]]
point = "P"
on = "arm"
through = "O"
towards = "A"
)",
                     qx, qy, arm, tilt) +
         driver;
}

/// Two blocks on lines that nearly coincide, held by a bar.
std::string blocks(Choices& choices, Lengths& l) {
  const double apart = l.slight(), bar = l.ordinary_or_short(), tilt = choices.between(-1e-3, 1e-3);
  const double way = l.size() * choices.between(-100, 100);
  return fmt::format(R"([ground]
O = [0, 0]
Q = [0, {}]
[links]
p = {{ at = {{ P = [0, 0] }} }}
q = {{ at = {{ R = [0, 0] }} }}
bar = {{ joints = ["P", "R"], P-R = {} }}
[[sliders]]
link = "p"
on = "ground"
through = "O"
direction_deg = 0
[[sliders]]
link = "q"
on = "ground"
through = [0, {}]
direction_deg = {}
[[drivers]]
slide = "p"
from = 0
to = {}
)",
                     apart == 0 ? l.size() : apart, bar, apart, tilt, way);
}

std::string geared(Choices& choices, Lengths& l) {
  const double d = l.ordinary(), a = l.ordinary_or_short(), b = l.ordinary_or_short();
  const double left = 2 * l.ordinary(), right = 2 * l.ordinary();
  const std::string driver = turn_driver(choices, "first");
  const int teeth = 1 + choices.upto(400), more = 1 + choices.upto(400);
  return fmt::format(R"([ground]
O = [0, 0]
D = [{}, 0]
[links]
first = {{ joints = ["O", "A"], O-A = {} }}
second = {{ joints = ["D", "B"], D-B = {} }}
left = {{ joints = ["A", "P"], A-P = {} }}
right = {{ joints = ["P", "B"], P-B = {} }}
[[gears]]
wheels = ["first", "second"]
teeth = [{}, {}]
)",
                     d, a, b, left, right, teeth, more) +
         driver;
}

void require(bool condition, const std::string& name, const std::string& what, const std::string& text) {
  if (condition) return;
  std::fprintf(stderr, "%s: %s\n%s", name.c_str(), what.c_str(), text.c_str());
  std::abort();
}

}  // namespace

std::string linkage_from_choices(std::string_view input) {
  Choices choices(input);
  const int kind = choices.upto(4), unit = choices.upto(4);
  Lengths lengths(choices);
  const std::string parts = kind == 0   ? four_bar(choices, lengths)
                            : kind == 1 ? crossing(choices, lengths)
                            : kind == 2 ? blocks(choices, lengths)
                                        : geared(choices, lengths);
  constexpr std::array names{"mm", "cm", "m", "in"};
  return fmt::format("unit = \"{}\"\n{}", names[static_cast<std::size_t>(unit)], parts);
}

Motion move_linkage_from_choices(std::string_view input, const std::string& name) {
  const std::string text = linkage_from_choices(input);
  const auto file = parse_linkage_file(text, name);
  require(file.has_value(), name, file ? "" : file.error().message(), text);
  const LinkageModel model = linkage_model(*file);
  AssemblySearch search;
  search.starts = 8;
  const auto assembly_modes = start_assembly_modes(*file, model, search);
  if (!assembly_modes) return Motion::does_not_start;
  const Mobility mobility = mobility_of(model.linkage, assembly_modes->front());
  const auto run = run_motion(model.linkage, assembly_modes->front(), model.schedule, 12, {{}, 3000});
  if (!run) return Motion::does_not_start;
  for (const RunFrame& frame : run->frames) {
    const ClosureError error = closure_error(model.linkage, frame.position, frame.values);
    require(error.largest <= 1e3 * closing_tolerance(model.linkage, frame.position), name,
            "a position that is shown is not closed", text);
  }
  if (!run->stop && mobility.rank_here == mobility.rank)
    require(mobility.mobility == 1, name, "a motion of one driver runs on a mobility that is not 1", text);
  (void)instant_centres(model.linkage, run->frames[0].position, run->frames[0].rate);
  return run->stop ? Motion::stops : Motion::runs;
}

}  // namespace kempe::fuzz
