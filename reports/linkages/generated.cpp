#include "reports/linkages/generated.hpp"

#include <fmt/format.h>

#include <cmath>

#include "specs/text/printable.hpp"

namespace kempe {
namespace {

/// A place as TOML, each number to its last digit.
std::string toml_place(const Point& p) { return fmt::format("[{}, {}]", p.x() + 0.0, p.y() + 0.0); }

struct NamedPlace {
  const char* name;
  Point at;
};

std::string guess_table(std::initializer_list<NamedPlace> places) {
  std::string text = "\n[guess]\n";
  for (const NamedPlace& place : places) text += fmt::format("{} = {}\n", place.name, toml_place(place.at));
  return text;
}

/// What all three have: the head, and the drive of the object's point along the scale line.
std::string inversor_head(const InversorTask& task, std::string_view title, std::string_view side) {
  return fmt::format(
      "# {} inversor for a lens of focal length {} mm, magnification m = {} to {}, by kempe inversor.\n"
      "# O: focus; P: object at x = f/m; Q: image at x' = f m, on {} of O; x x' = f^2.\n"
      "name = \"{} inversor, f = {:.6g} mm\"\n",
      title, task.focal_length, task.magnification_lower, task.magnification_upper, side, title,
      task.focal_length);
}

std::string inversor_drive(const InversorTask& task) {
  return fmt::format(
      "\n[[drivers]]\ncoordinate = \"P.x\"\nfrom = {}\nto = {}\n\n[motion]\nsteps = 60\n\n"
      "[output]\npoints = [\"P\", \"Q\"]\ntrace = [\"P\", \"Q\"]\n",
      task.focal_length / task.magnification_lower, task.focal_length / task.magnification_upper);
}

constexpr std::string_view object_slides =
    "\n[[sliders]]                            # the object stays on the scale line\n"
    "point = \"P\"\non = \"ground\"\nthrough = \"O\"\ndirection_deg = 0\n";

std::string peaucellier_linkage(const InversorTask& task, const InversorDesign& design) {
  const double arm = design.lengths[0].value, side = design.lengths[1].value;
  const double x = task.focal_length / task.magnification_lower,
               image = task.focal_length * task.magnification_lower;
  const double middle = 0.5 * (x + image), spread = std::sqrt(side * side - 0.25 * (image - x) * (image - x));
  std::string text = inversor_head(task, "Peaucellier-Lipkin", "the same side");
  text += "\n[ground]\nO = [0, 0]\n\n[links]\n";
  for (const char* link : {"OA", "OB"})
    text += fmt::format("{0} = {{ joints = [\"O\", \"{1}\"], O-{1} = {2} }}\n", link, link[1], arm);
  for (const char* link : {"AP", "PB", "AQ", "QB"})
    text +=
        fmt::format("{0} = {{ joints = [\"{1}\", \"{2}\"], {1}-{2} = {3} }}\n", link, link[0], link[1], side);
  text += object_slides;
  text += inversor_drive(task);
  return text +
         guess_table({{"A", {middle, spread}}, {"B", {middle, -spread}}, {"P", {x, 0}}, {"Q", {image, 0}}});
}

/// The antiparallelogram with bars AB = CD = a, AD = CB = b; O, P and Q cut AB, AD and CB at the share u from A, A and C. B-D and
/// A-C are parallel to the scale line, as long as x/u and x'/(1 - u).
std::string hart_linkage(const InversorTask& task, const InversorDesign& design) {
  const double a = design.lengths[0].value, b = design.lengths[1].value, u = design.point_share;
  const double x = task.focal_length / task.magnification_lower, BD = x / u;
  const double along = (a * a - b * b + BD * BD) / (2 * BD), height = std::sqrt(a * a - along * along);
  const Point O = u * Point(-along, height);
  const Point A = -O, B = Point(-along, height) - O, D = Point(BD - along, height) - O,
              C = Point(BD - 2 * along, 0) - O;  // A mirrored in the line that bisects B-D
  std::string text = inversor_head(task, "Hart", "the other side");
  text += "\n[ground]\nO = [0, 0]\n\n[links]\n";
  text += fmt::format("AB = {{ joints = [\"A\", \"O\", \"B\"], along = [0, {}, {}] }}\n", u * a, a);
  text += fmt::format("AD = {{ joints = [\"A\", \"P\", \"D\"], along = [0, {}, {}] }}\n", u * b, b);
  text += fmt::format("CB = {{ joints = [\"C\", \"Q\", \"B\"], along = [0, {}, {}] }}\n", u * b, b);
  text += fmt::format("CD = {{ joints = [\"C\", \"D\"], C-D = {} }}\n", a);
  text += object_slides;
  text += inversor_drive(task);
  return text + guess_table({{"A", A}, {"B", B}, {"C", C}, {"D", D}, {"P", {x, 0}}, {"Q", C + u * (B - C)}});
}

std::string right_angle_linkage(const InversorTask& task, const InversorDesign& design) {
  const double f = task.focal_length, x = f / task.magnification_lower;
  const double object_arm = design.lengths[1].value, image_arm = design.lengths[2].value;
  const Point along_object = Point(x, -f).normalized();
  std::string text = inversor_head(task, "Right-angle", "the other side");
  text += "points = [\"P\", \"Q\"]                    # where the arms cut the scale line\n";
  text += fmt::format("\n[ground]\nO = [0, 0]\nF = [0, {}]\n\n[links]\n", f);
  text +=
      fmt::format("square = {{ at = {{ F = [0, 0], U = [{}, 0], W = [0, {}] }} }}\n", object_arm, -image_arm);
  for (const char* point : {"P", "Q"})
    text += fmt::format(
        "\n[[sliders]]\npoint = \"{0}\"\non = \"ground\"\nthrough = \"O\"\ndirection_deg = 0\n"
        "\n[[sliders]]\npoint = \"{0}\"\non = \"square\"\nthrough = \"F\"\ndirection_deg = {1}\n",
        point, point[0] == 'P' ? 0 : 90);
  text += inversor_drive(task);
  return text + guess_table({{"P", {x, 0}},
                             {"Q", {-f * task.magnification_lower, 0}},
                             {"U", Point(0, f) + object_arm * along_object}});
}

}  // namespace

std::string inversor_linkage(const InversorTask& task, const InversorDesign& design) {
  switch (design.kind) {
    case InversorKind::peaucellier: return peaucellier_linkage(task, design);
    case InversorKind::hart: return hart_linkage(task, design);
    case InversorKind::right_angle: break;
  }
  return right_angle_linkage(task, design);
}

std::string function_linkage(const FunctionTask& task, const FunctionDesign& design,
                             const std::string& wanted) {
  const FourBar& bar = design.linkage;
  const double first = design.input_start, last = first + task.input_range;
  const Point A = as_point(std::polar(bar.input, first));
  const double output = bar.output_angle(first).value_or(design.output_start);
  const Point B = Point(bar.ground, 0) + as_point(std::polar(bar.output, output));
  std::string text = fmt::format("# Four-bar that generates {}, by kempe function.\n", printable(wanted));
  text += fmt::format("# x = {} + {} * (angle of input - {}) / {}\n", task.x_lower,
                      task.x_upper - task.x_lower, degrees(first), degrees(task.input_range));
  text +=
      fmt::format("# y = {} + {} * (angle of output - {}) / {}\n", design.y_lower,
                  design.y_upper - design.y_lower, degrees(design.output_start), degrees(task.output_range));
  text += fmt::format(
      "name = \"Function generator\"\n\n[ground]\nO = [0, 0]\nD = [{}, 0]\n\n[links]\n"
      "input = {{ joints = [\"O\", \"A\"], O-A = {} }}\n"
      "coupler = {{ joints = [\"A\", \"B\"], A-B = {} }}\n"
      "output = {{ joints = [\"D\", \"B\"], D-B = {} }}\n",
      bar.ground, bar.input, bar.coupler, bar.output);
  text +=
      fmt::format("\n[[drivers]]\nangle = \"input\"\nfrom_deg = {}\nto_deg = {}\n\n[motion]\nsteps = 60\n",
                  degrees(first), degrees(last));
  text +=
      "\n[output]\nangles = [\"input\", \"output\"]\ntransmission = [[\"A\", \"B\", \"D\"]]\n"
      "trace = [\"A\", \"B\"]\n";
  return text + guess_table({{"A", A}, {"B", B}});
}

namespace {

/// A four-bar with its driver's angle at the first point, and what stands on it.
struct DrivenBar {
  CouplerFourBar bar;
  CognateDriver driver = CognateDriver::crank;
  double offset = 0;
};

std::string path_linkage_text(const PathAnswer& answer, const DrivenBar& driven, const std::string& title,
                              const CouplerCopy* copy) {
  const CouplerFourBar& bar = driven.bar;
  const bool by_crank = driven.driver == CognateDriver::crank;
  const double first = answer.crank_angles.front() + driven.offset,
               last = answer.crank_angles.back() + driven.offset;
  const Point P = answer.reached.front();
  Point A = P, B = P;  // where the first place has them; a guess for the solver
  if (by_crank) {
    if (const auto place = bar.at(first)) A = place->A, B = place->B;
  } else {
    A = P - as_point(as_complex(bar.coupler_point) * std::polar(1.0, first));
    B = A + as_point(std::polar(bar.coupler, first));
  }
  const char* driver = by_crank ? "crank" : "coupler";
  std::string text = title + fmt::format("# {} degrees at each place:", driver);
  for (const double angle : answer.crank_angles) text += fmt::format(" {}", degrees(angle + driven.offset));
  text += fmt::format(
      "\nname = \"{} by kempe path\"\n\n[ground]\nO = {}\nD = {}\n\n[links]\n"
      "crank = {{ joints = [\"O\", \"A\"], O-A = {} }}\n"
      "coupler = {{ at = {{ A = [0, 0], B = [{}, 0], P = {}{} }} }}\n"
      "rocker = {{ joints = [\"D\", \"B\"], D-B = {} }}\n",
      copy != nullptr ? "Plagiograph on a four-bar" : "Four-bar", toml_place(bar.crank_pivot),
      toml_place(bar.rocker_pivot), bar.crank, bar.coupler, toml_place(bar.coupler_point),
      copy != nullptr ? fmt::format(", C = {}", toml_place(copy->coupler_joint)) : "", bar.rocker);
  if (copy != nullptr)
    text += fmt::format(
        "arm = {{ joints = [\"{0}\", \"Q\"], {0}-Q = {1} }}\n"
        "copier = {{ at = {{ Q = [0, 0], C = [{2}, 0], Y = {3} }} }}\n",
        copy->pole == CopyPole::crank_pivot ? "O" : "D", copy->arm, copy->link, toml_place(copy->copy_point));
  text += fmt::format("\n[[drivers]]\nangle = \"{}\"\nfrom_deg = {}\nto_deg = {}\n\n[motion]\nsteps = 60\n",
                      driver, degrees(first), degrees(last));
  text += fmt::format(
      "\n[output]\npoints = [\"P\"{0}]\nangles = [\"crank\", \"coupler\", \"rocker\"]\n"
      "transmission = [[\"A\", \"B\", \"D\"]]\ntrace = [\"P\"{0}]\n",
      copy != nullptr ? ", \"Y\"" : "");
  if (copy == nullptr) return text + guess_table({{"A", A}, {"B", B}, {"P", P}});
  return text +
         guess_table(
             {{"A", A}, {"B", B}, {"P", P}, {"Q", copy->Q}, {"C", copy->C}, {"Y", copy->copied.front()}});
}

}  // namespace

std::string path_linkage(const PathAnswer& answer, std::optional<std::size_t> cognate) {
  DrivenBar driven{answer.linkage};
  if (cognate) {
    const Cognate& other = answer.cognates.value()[*cognate];
    driven = {other.linkage, other.driver, other.offset};
  }
  return path_linkage_text(
      answer, driven,
      fmt::format("# Four-bar{} whose coupler point P passes {} given places, by kempe path.\n",
                  cognate ? fmt::format(", cognate {},", *cognate + 1) : "", answer.crank_angles.size()),
      nullptr);
}

std::string copy_linkage(const PathAnswer& answer, const CopyTask& task, const CouplerCopy& copy) {
  const bool by_crank = copy.pole == CopyPole::crank_pivot;
  return path_linkage_text(answer, {copy.linkage, copy.driver, copy.offset},
                           fmt::format("# Six-bar by kempe path: the coupler point P passes {} given places, "
                                       "and the plagiograph {}-{}-C-Q copies its\n"
                                       "# curve at Y, {} times as large and turned by {} degrees about {}.\n",
                                       answer.crank_angles.size(), by_crank ? "O" : "D", by_crank ? "A" : "B",
                                       task.scale, degrees(task.rotation), by_crank ? "O" : "D"),
                           &copy);
}

}  // namespace kempe
