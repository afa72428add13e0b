// The module kempe._core: the library's values and functions as they are. What a person writes is python/kempe/*.py.

#include <pybind11/complex.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "kempe/kempe.hpp"
#include "python/arrays.hpp"
#include "python/at_work.hpp"
#include "python/faults.hpp"
#include "python/linkages.hpp"

namespace kempe::python {
namespace {

namespace py = pybind11;
using namespace pybind11::literals;

/// How to work, as Python says it.
struct Wishes {
  std::uint64_t seed;
  int threads;
  std::optional<double> time_limit;
  bool diagnose;
  double map_tolerance;
  bool largest_sheets;
};

Options options_of(const Wishes& wishes, Hooks& hooks) {
  Options options;
  options.seed = wishes.seed;
  options.threads = wishes.threads;
  options.time_limit = wishes.time_limit;
  options.diagnose = wishes.diagnose;
  options.map_tolerance = wishes.map_tolerance;
  options.largest_sheets = wishes.largest_sheets;
  options.stop = [&hooks] { return hooks.stopped(); };
  options.progress = [&hooks](double share, std::string_view what) { hooks.tell(share, what); };
  return options;
}

using Search = Outcome (*)(const Spec&, const Options&);

Outcome outcome_of(Search search, const Spec& spec, const Wishes& wishes, const py::object& progress) {
  return at_work(progress, [&](Hooks& hooks) { return search(spec, options_of(wishes, hooks)); });
}

Objective objective_of(const std::string& word) {
  if (const auto known = objective_named(word)) return *known;
  throw py::value_error(
      "an objective is one of size, transmission, copy_error, footprint, load_error, mass; found " + word);
}

/// (complete, list of (first, second, design, first, second)), or an Outcome; the values as files have them, then as the library has.
py::object front_of(const Spec& spec, const std::string& first, const std::string& second, int points,
                    const Wishes& wishes, const py::object& progress) {
  const Objective one = objective_of(first), other = objective_of(second);
  const auto found = at_work(
      progress, [&](Hooks& hooks) { return front(spec, one, other, points, options_of(wishes, hooks)); });
  if (const auto* outcome = std::get_if<Outcome>(&found)) return py::cast(*outcome);
  const auto in_file_unit = [](Objective objective, double value) {
    return objective == Objective::transmission ? degrees(value) : value;
  };
  py::list list;
  for (const FrontPoint& point : std::get<Front>(found).points)
    list.append(py::make_tuple(in_file_unit(one, point.first), in_file_unit(other, point.second),
                               point.design, point.first, point.second));
  return py::make_tuple(std::get<Front>(found).complete, list);
}

const char* name_of(Outcome::Kind kind) {
  switch (kind) {
    case Outcome::Kind::design: return "design";
    case Outcome::Kind::no_design: return "no_design";
    case Outcome::Kind::stopped: return "stopped";
    case Outcome::Kind::bad_spec: return "bad_spec";
  }
  throw std::logic_error("an outcome of no kind");
}

constexpr std::array all_joints{Joint::V, Joint::A, Joint::B, Joint::C, Joint::X, Joint::Y};

/// The pen's joint, by what stands at V.
Joint pen_of(Grounding grounding) { return grounding == Grounding::pen ? Joint::V : Joint::Y; }

/// For each tracer the places of some joints, NaN where there is no pose.
template <std::size_t count>
void pose_all(const FinishedDesign& design, const Points& tracers, const std::array<Joint, count>& joints,
              double* out) {
  const py::gil_scoped_release others_may_run;
  for (py::ssize_t i = 0; i < tracers.size(); ++i) {
    const auto found = design.pose_with_tracer_at(tracers[i]);
    const auto* pose = std::get_if<Pose>(&found);
    for (const Joint joint : joints) {
      *out++ = pose ? (*pose)[joint].x() : not_there;
      *out++ = pose ? (*pose)[joint].y() : not_there;
    }
  }
}

Numbers pens(const FinishedDesign& design, const Numbers& tracers) {
  const Points points(tracers);
  Numbers found({points.size(), py::ssize_t{2}});
  pose_all(design, points, std::array{pen_of(design.grounding())}, found.mutable_data());
  return found;
}

Numbers joints(const FinishedDesign& design, const Numbers& tracers) {
  const Points points(tracers);
  Numbers found({points.size(), py::ssize_t{6}, py::ssize_t{2}});
  pose_all(design, points, all_joints, found.mutable_data());
  return found;
}

py::dict lengths_of(const FinishedDesign& design) {
  py::dict lengths;
  const std::array<double, 8> values = design.lengths().values();
  for (std::size_t i = 0; i < values.size(); ++i)
    lengths[py::str(std::string(LinkLengths::names[i]))] = values[i];
  return lengths;
}

py::list list_of(const std::vector<BrokenLimit>& broken) {
  py::list list;
  for (const BrokenLimit& one : broken)
    list.append(
        py::make_tuple(one.limit, one.attained, one.allowed,
                       one.where ? py::object(py::make_tuple(one.where->x(), one.where->y())) : py::none(),
                       text_of(one.sentence)));
  return list;
}

py::dict dict_of(const Verification& found) {
  return py::dict("holds"_a = found.holds, "samples"_a = found.samples,
                  "copy_error_max_mm"_a = found.copy_error_max,
                  "loop_residual_max_mm"_a = found.loop_residual_max, "scale"_a = found.scale,
                  "rotation_deg"_a = degrees(found.rotation), "flips"_a = found.flips,
                  "over_workspace"_a = found.over_workspace, "failure"_a = found.failure,
                  "broken"_a = list_of(found.broken));
}

py::dict verified(const FinishedDesign& design) {
  return dict_of(at_work(py::none(), [&](Hooks&) { return verify(design); }));
}

/// (holds, broken), or faults.
py::object audited(const std::filesystem::path& file) {
  const auto found = at_work(py::none(), [&](Hooks&) { return verify(file); });
  if (const auto* fault = std::get_if<InputError>(&found)) return faults_of(*fault);
  const auto& audit = std::get<Audit>(found);
  return py::make_tuple(audit.holds, list_of(audit.broken));
}

/// (which of the lines, points) of each.
py::list list_of(const std::vector<CopiedLine>& lines) {
  py::list list;
  for (const CopiedLine& line : lines) list.append(py::make_tuple(line.original, array_of(line.points)));
  return list;
}

py::dict dict_of(const CopiedDrawing& copy) {
  return py::dict("drawn"_a = list_of(copy.drawn), "missing"_a = list_of(copy.missing),
                  "drawn_length_mm"_a = copy.drawn_length, "missing_length_mm"_a = copy.missing_length,
                  "poses"_a = copy.poses, "poses_missed"_a = copy.poses_missed,
                  "departure_mm"_a = copy.departure);
}

py::object traced(const FinishedDesign& design, const std::vector<Numbers>& lines, double step) {
  std::vector<Polyline> originals;
  originals.reserve(lines.size());
  for (const Numbers& line : lines) originals.push_back(points_of(line));
  const auto found = at_work(py::none(), [&](Hooks& hooks) {
    return trace(design, originals, step, [&hooks] { return hooks.stopped(); });
  });
  if (const auto* fault = std::get_if<InputError>(&found)) return faults_of(*fault);
  return dict_of(std::get<CopiedDrawing>(found));
}

DrawingOptions with_stop(DrawingOptions options, const Hooks& hooks) {
  options.stop = [&hooks] { return hooks.stopped(); };
  return options;
}

/// As traced(), with what the command writes; or faults. `copy(options)` makes it.
template <typename Copy>
py::object drawing_traced(const DrawingOptions& options, const Copy& copy) {
  const auto found = at_work(py::none(), [&](Hooks& hooks) { return copy(with_stop(options, hooks)); });
  if (const auto* fault = std::get_if<InputError>(&found)) return faults_of(*fault);
  const auto& traced = std::get<TracedDrawing>(found);
  py::dict told = dict_of(traced.copy);
  told["json"] = traced.json;
  told["svg"] = text_of(traced.svg);
  told["joints_csv"] = traced.joints_csv;
  told["forces_csv"] = traced.forces_csv;
  return told;
}

Paper paper_named(const std::string& word) {
  if (word == "A4") return Paper::A4;
  if (word == "A3") return Paper::A3;
  throw py::value_error("paper is A4 or A3; found " + word);
}

/// (files, what is left out, why nothing was written).
template <typename Write>
py::tuple written(const Write& work) {
  const Written found = at_work(py::none(), [&](Hooks&) { return work(); });
  py::list left_out;
  for (const std::string& sentence : found.left_out) left_out.append(text_of(sentence));
  return py::make_tuple(found.files, left_out, text_of(found.reason));
}

py::tuple design_written(const FinishedDesign& design, const std::filesystem::path& folder,
                         const std::string& title, const std::string& paper, const std::string& studio) {
  const WriteOptions options{title, paper_named(paper), studio};
  return written([&] { return write(design, folder, options); });
}

/// Of points as front() has them.
py::tuple front_written(const std::string& first, const std::string& second,
                        const std::vector<std::tuple<double, double, FinishedDesign>>& points,
                        const std::filesystem::path& folder, const std::string& title,
                        const std::string& paper) {
  Front front{{}, true, objective_of(first), objective_of(second)};
  for (const auto& [a, b, design] : points) front.points.push_back({a, b, design});
  const WriteOptions options{title, paper_named(paper), {}};
  return written([&] { return write(front, folder, options); });
}

/// The log, or faults, or the sentence why there is none as a tuple of one.
py::object log_of_none(const Spec& spec) {
  const auto found = at_work(
      py::none(), [&](Hooks& hooks) { return proof_of_none(spec, [&hooks] { return hooks.stopped(); }); });
  if (const auto* fault = std::get_if<InputError>(&found)) return faults_of(*fault);
  if (const auto* none = std::get_if<NoProof>(&found)) return py::make_tuple(none->sentence);
  return py::str(std::get<std::string>(found));
}

/// A design from its text, computed anew; coarser where `time_limit` (s) is over.
py::object restored(const std::string& json, const std::string& name, bool is_own,
                    std::optional<double> time_limit) {
  using Clock = std::chrono::steady_clock;
  const ClaimedBound bound = is_own ? ClaimedBound::keep : ClaimedBound::prove;
  const Clock::time_point start = Clock::now();
  const auto is_over = [&] {
    return time_limit && std::chrono::duration<double>(Clock::now() - start).count() >= *time_limit;
  };
  return value_or_faults(at_work(py::none(), [&](Hooks& hooks) {
    return restore(json, name, bound, [&] { return hooks.stopped() || is_over(); });
  }));
}

py::array_t<bool> are_free(const Map& map, const Numbers& tracers) {
  const Points points(tracers);
  py::array_t<bool> found(points.size());
  bool* out = found.mutable_data();
  const py::gil_scoped_release others_may_run;
  for (py::ssize_t i = 0; i < points.size(); ++i) out[i] = map.at(points[i]).free;
  return found;
}

py::tuple verdict_at(const Map& map, double x, double y) {
  const PointVerdict verdict = map.at({x, y});
  return py::make_tuple(verdict.free, verdict.uncertain, verdict.sentence);
}

py::list losses_of(const Map& map) {
  py::list list;
  for (const Loss& loss : map.losses()) list.append(py::make_tuple(loss.cause, loss.parts, loss.area));
  return list;
}

py::list sheets_of(const Map& map) {
  py::list list;
  for (const SheetThatFits& sheet : map.largest_sheets())
    list.append(py::make_tuple(sheet.name, sheet.width, sheet.height,
                               py::make_tuple(sheet.centre.x(), sheet.centre.y()), degrees(sheet.turn)));
  return list;
}

void add_specs(py::module_& module) {
  py::class_<Spec>(module, "Spec")
      .def("toml", &toml_text)
      .def_property_readonly("title", [](const Spec& spec) { return spec.title; })
      .def_property_readonly("copy", [](const Spec& spec) { return spec.copy.k(); })
      .def_property_readonly("region", [](const Spec& spec) { return polygons_of(spec.region); })
      .def_property_readonly("objective",
                             [](const Spec& spec) { return std::string(name(spec.objective.objective)); });
  module.def(
      "parse",
      [](const std::string& text, const std::string& name, const std::filesystem::path& folder) {
        return value_or_faults(parse(text, name, folder));
      },
      "text"_a, "name"_a, "folder"_a);
  module.def(
      "load", [](const std::filesystem::path& file) { return value_or_faults(load(file)); }, "file"_a);
  module.def("templates", [] {
    py::list all;
    for (const SpecTemplate& one : spec_templates())
      all.append(py::make_tuple(one.name, one.purpose, one.spec));
    return all;
  });
  module.def(
      "studio_page",
      [](const std::string& page, const std::string& spec, const std::string& name,
         const std::filesystem::path& folder) {
        return value_or_faults(studio_page(page, spec, name, folder));
      },
      "page"_a, "spec"_a, "name"_a, "folder"_a);
}

void add_maps(py::module_& module) {
  py::class_<Map>(module, "Map")
      .def_property_readonly("covers_region", &Map::covers_region)
      .def_property_readonly("why_not_covered", &Map::why_not_covered)
      .def_property_readonly("reachable_area", &Map::reachable_area)
      .def_property_readonly("usable_area", &Map::usable_area)
      .def_property_readonly("collision_free_area", &Map::collision_free_area)
      .def_property_readonly("uncertain_area", &Map::uncertain_area)
      .def_property_readonly("complete", &Map::complete)
      .def(
          "reachable", [](const Map& map, double tolerance) { return polygons_of(map.reachable(tolerance)); },
          "tolerance"_a)
      .def(
          "collision_free",
          [](const Map& map, double tolerance) { return polygons_of(map.collision_free(tolerance)); },
          "tolerance"_a)
      .def("losses", &losses_of)
      .def("largest_sheets", &sheets_of)
      .def("at", &verdict_at, "x"_a, "y"_a)
      .def("are_free", &are_free, "tracers"_a);
}

void add_drawing_options(py::module_& module) {
  py::class_<DrawingOptions>(module, "DrawingOptions")
      .def(py::init([](const std::optional<std::array<double, 2>>& at, std::optional<double> scale, bool fit,
                       std::optional<double> tolerance, std::optional<double> step,
                       std::optional<std::uint64_t> instrument, bool load, bool joints, bool forces) {
             std::optional<Point> place;
             if (at) place = Point((*at)[0], (*at)[1]);
             return DrawingOptions{place, scale, fit, tolerance, step, instrument, load, joints, forces};
           }),
           "at"_a, "scale"_a, "fit"_a, "tolerance"_a, "step"_a, "instrument"_a, "load"_a, "joints"_a,
           "forces"_a);
}

using DesignClass = py::class_<FinishedDesign>;

/// What the linkage is.
void add_linkage_of(DesignClass& type) {
  type.def_property_readonly("copy", [](const FinishedDesign& design) { return design.copy().k(); })
      .def_property_readonly("scale", [](const FinishedDesign& design) { return design.copy().scale(); })
      .def_property_readonly("rotation",
                             [](const FinishedDesign& design) { return design.copy().rotation(); })
      .def_property_readonly(
          "grounding", [](const FinishedDesign& design) { return std::string(name(design.grounding())); })
      .def_property_readonly("assembly_mode", &FinishedDesign::assembly_mode)
      .def_property_readonly("pole",
                             [](const FinishedDesign& design) {
                               const Point pole = design.pole();
                               return py::make_tuple(pole.x(), pole.y());
                             })
      .def_property_readonly("lengths", &lengths_of)
      .def_property_readonly(
          "layers", [](const FinishedDesign& design) { return py::tuple(py::cast(design.layers())); })
      .def_property_readonly("opening", [](const FinishedDesign& design) {
        const OpeningInterval opening = design.opening();
        return py::make_tuple(opening.lower, opening.upper);
      });
}

/// What is measured of it.
void add_figures(DesignClass& type) {
  type.def_property_readonly("size", &FinishedDesign::size)
      .def_property_readonly("transmission_min", &FinishedDesign::transmission_min)
      .def_property_readonly("clearance_min", &FinishedDesign::clearance_min)
      .def_property_readonly("footprint", &FinishedDesign::footprint)
      .def_property_readonly("copy_error", &FinishedDesign::copy_error)
      .def_property_readonly("load_error", &FinishedDesign::load_error)
      .def_property_readonly("load_error_layered", &FinishedDesign::load_error_layered)
      .def_property_readonly("load_rise", &FinishedDesign::load_rise)
      .def_property_readonly("weight_error", &FinishedDesign::weight_error)
      .def_property_readonly("weight_error_layered", &FinishedDesign::weight_error_layered)
      .def_property_readonly("weight_rise", &FinishedDesign::weight_rise)
      .def_property_readonly("stress", &FinishedDesign::stress)
      .def_property_readonly("stress_layered", &FinishedDesign::stress_layered)
      .def_property_readonly("sag", &FinishedDesign::sag)
      .def_property_readonly("mass", &FinishedDesign::mass)
      .def_property_readonly("section",
                             [](const FinishedDesign& design) {
                               const LinkSection section = design.section();
                               return py::make_tuple(section.width, section.thickness);
                             })
      .def_property_readonly("robust_clearance", &FinishedDesign::robust_clearance)
      .def_property_readonly(
          "objective", [](const FinishedDesign& design) { return std::string(name(design.objective())); })
      .def_property_readonly("value", &FinishedDesign::value)
      .def_property_readonly("proven_bound", &FinishedDesign::proven_bound)
      .def_property_readonly("complete", &FinishedDesign::complete)
      .def_property_readonly("map", &FinishedDesign::map);
}

/// What it can do.
void add_actions(DesignClass& type) {
  type.def("json",
           [](const FinishedDesign& design) {
             return at_work(py::none(), [&](Hooks&) { return verified_json(design); });
           })
      .def("error_budget", &FinishedDesign::error_budget_json, py::call_guard<py::gil_scoped_release>())
      .def("feel", &FinishedDesign::feel_json, py::call_guard<py::gil_scoped_release>())
      .def("pens", &pens, "tracers"_a)
      .def("joints", &joints, "tracers"_a)
      .def("verify", &verified)
      .def("trace", &traced, "lines"_a, "step"_a)
      .def(
          "trace_svg",
          [](const FinishedDesign& design, const std::string& drawing, const DrawingOptions& options) {
            return drawing_traced(options,
                                  [&](const DrawingOptions& how) { return trace_svg(design, drawing, how); });
          },
          "drawing"_a, "options"_a)
      .def(
          "trace_svg_file",
          [](const FinishedDesign& design, const std::filesystem::path& drawing,
             const DrawingOptions& options) {
            return drawing_traced(
                options, [&](const DrawingOptions& how) { return trace_svg_file(design, drawing, how); });
          },
          "drawing"_a, "options"_a)
      .def("write", &design_written, "folder"_a, "title"_a, "paper"_a, "studio"_a)
      .def("report", &report, "title"_a, py::call_guard<py::gil_scoped_release>())
      .def("drawing", &drawing, py::call_guard<py::gil_scoped_release>());
}

void add_designs(py::module_& module) {
  DesignClass type(module, "Design");
  add_linkage_of(type);
  add_figures(type);
  add_actions(type);
  module.def("restore", &restored, "json"_a, "name"_a, "is_own"_a, "time_limit"_a);
  module.def("write_front", &front_written, "first"_a, "second"_a, "points"_a, "folder"_a, "title"_a,
             "paper"_a);
  module.def("proof_of_none", &log_of_none, "spec"_a);
  module.def("verify", &audited, "file"_a);
}

/// The options, ended by Ctrl-C.
CalibrationOptions stopping(CalibrationOptions options, Hooks& hooks) {
  options.stop = [&hooks] { return hooks.stopped(); };
  return options;
}

void add_calibration(py::module_& module) {
  const auto answer = [](const auto& work) { return value_or_faults(at_work(py::none(), work)); };
  module.def(
      "calibrate",
      [answer](const std::filesystem::path& file) { return answer([&](Hooks&) { return calibrate(file); }); },
      "file"_a);
  module.def(
      "calibrate_text",
      [answer](const std::string& text, const std::filesystem::path& folder) {
        return answer([&](Hooks&) { return calibrate_text(text, "", folder); });
      },
      "text"_a, "folder"_a);
  py::class_<CalibrationOptions>(module, "CalibrationOptions")
      .def(py::init([](std::optional<double> target, const std::string& method,
                       const std::vector<std::string>& ratios, bool plan, std::optional<int> plan_readings,
                       bool simulate, std::uint64_t seed, bool equations) {
             return CalibrationOptions{target,   method, ratios,    plan, plan_readings,
                                       simulate, seed,   equations, {}};
           }),
           "target"_a, "method"_a, "ratios"_a, "plan"_a, "plan_readings"_a, "simulate"_a, "seed"_a,
           "equations"_a);
  py::class_<CalibratedInstrument>(module, "CalibratedInstrument")
      .def_property_readonly("json", [](const CalibratedInstrument& found) { return text_of(found.json); })
      .def_property_readonly("text", [](const CalibratedInstrument& found) { return text_of(found.text); })
      .def_property_readonly("page", [](const CalibratedInstrument& found) { return text_of(found.page); })
      .def_property_readonly("simulated",
                             [](const CalibratedInstrument& found) { return text_of(found.simulated); });
  module.def(
      "write_calibration",
      [](const std::string& json, const std::string& page, const std::string& simulated,
         const std::filesystem::path& folder) {
        return written([&] { return write(CalibratedInstrument{json, {}, page, simulated}, folder); });
      },
      "json"_a, "page"_a, "simulated"_a, "folder"_a);
  module.def(
      "calibrate_with",
      [answer](const CalibrationOptions& options, const std::string& text,
               const std::filesystem::path& folder) {
        return answer(
            [&](Hooks& hooks) { return calibrate_with(stopping(options, hooks), text, "", folder); });
      },
      "options"_a, "text"_a, "folder"_a);
  module.def(
      "calibrate_file_with",
      [answer](const CalibrationOptions& options, const std::filesystem::path& file) {
        return answer([&](Hooks& hooks) { return calibrate_file_with(stopping(options, hooks), file); });
      },
      "options"_a, "file"_a);
}

void add_searches(py::module_& module) {
  py::class_<Wishes>(module, "Wishes")
      .def(py::init<std::uint64_t, int, std::optional<double>, bool, double, bool>(), "seed"_a, "threads"_a,
           "time_limit"_a, "diagnose"_a, "map_tolerance"_a, "largest_sheets"_a);
  py::class_<Outcome>(module, "Outcome")
      .def_property_readonly("kind", [](const Outcome& outcome) { return name_of(outcome.kind()); })
      .def_property_readonly("design",
                             [](const Outcome& outcome) -> std::optional<FinishedDesign> {
                               if (outcome) return *outcome;
                               return std::nullopt;
                             })
      .def_property_readonly("reason", &Outcome::reason)
      .def_property_readonly("proven", &Outcome::proven)
      .def_property_readonly("changes",
                             [](const Outcome& outcome) {
                               py::list changes;
                               for (const PossibleChange& change : outcome.changes())
                                 changes.append(py::make_tuple(change.key, change.sentence));
                               return changes;
                             })
      .def_property_readonly("proven_bound", &Outcome::proven_bound)
      .def_property_readonly("faults", [](const Outcome& outcome) {
        return outcome.fault() ? faults_of(*outcome.fault()) : py::list();
      });
  module.def(
      "design",
      [](const Spec& spec, const Wishes& wishes, const py::object& progress) {
        return outcome_of(&design, spec, wishes, progress);
      },
      "spec"_a, "wishes"_a, "progress"_a);
  module.def("front", &front_of, "spec"_a, "first"_a, "second"_a, "points"_a, "wishes"_a, "progress"_a);
  module.def(
      "map",
      [](const Spec& spec, const Wishes& wishes, const py::object& progress) {
        return outcome_of(&map, spec, wishes, progress);
      },
      "spec"_a, "wishes"_a, "progress"_a);
}

}  // namespace
}  // namespace kempe::python

PYBIND11_MODULE(_core, module) {
  module.attr("version") = KEMPE_VERSION;
  kempe::python::add_specs(module);
  kempe::python::add_maps(module);
  kempe::python::add_drawing_options(module);
  kempe::python::add_designs(module);
  kempe::python::add_searches(module);
  kempe::python::add_calibration(module);
  kempe::python::add_linkages(module);
}
