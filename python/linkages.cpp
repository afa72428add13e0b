#include "python/linkages.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "kempe/generators.hpp"
#include "kempe/linkage.hpp"
#include "python/arrays.hpp"
#include "python/at_work.hpp"
#include "python/faults.hpp"

namespace kempe::python {
namespace {

namespace py = pybind11;
using namespace pybind11::literals;

/// What `ask(choice)` answers, as `shown` makes it; or faults, or a NoMotion.
template <typename Ask, typename Show>
py::object answered(std::uint64_t seed, int assembly, const Ask& ask, const Show& shown) {
  auto found = at_work(py::none(), [&](Hooks& hooks) {
    return ask(AssemblyChoice{seed, assembly, [&hooks] { return hooks.stopped(); }});
  });
  if (const auto* fault = std::get_if<InputError>(&found)) return faults_of(*fault);
  if (const auto* none = std::get_if<NoMotion>(&found)) return py::cast(*none);
  return shown(std::get<0>(found));
}

template <typename Ask>
py::object text_answered(std::uint64_t seed, int assembly, const Ask& ask) {
  return answered(seed, assembly, ask, [](const std::string& text) -> py::object { return text_of(text); });
}

/// What a linkage says about one step of its motion.
auto at_step(LinkageAnswer<std::string> (Linkage::*ask)(double, const AssemblyChoice&) const) {
  return [ask](const Linkage& linkage, double step, int assembly, std::uint64_t seed) {
    return text_answered(seed, assembly,
                         [&](const AssemblyChoice& choice) { return (linkage.*ask)(step, choice); });
  };
}

/// A tuple of dicts: each point's place.
py::object tuple_of(const std::vector<std::vector<PlacedPoint>>& assemblies) {
  py::tuple all(assemblies.size());
  for (std::size_t i = 0; i < assemblies.size(); ++i) {
    py::dict places;
    for (const PlacedPoint& point : assemblies[i])
      places[py::str(point.name)] = py::make_tuple(point.at.x(), point.at.y());
    all[i] = places;
  }
  return all;
}

py::object dict_of(const DrivenMotion& motion) {
  py::dict places, velocities, accelerations, angles, rates, changes, reactions, forces, table;
  for (const MovedPoint& point : motion.points) {
    const py::str name(point.name);
    places[name] = array_of(point.places);
    velocities[name] = array_of(point.velocities);
    accelerations[name] = array_of(point.accelerations);
  }
  for (const MovedLink& link : motion.links) {
    const py::str name(link.name);
    angles[name] = array_of(link.angles);
    rates[name] = array_of(link.rates);
    changes[name] = array_of(link.accelerations);
  }
  for (const JointReaction& reaction : motion.reactions)
    reactions[py::str(reaction.name)] = array_of(reaction.forces);
  for (const MotionColumn& column : motion.table) {
    table[py::str(column.name)] = array_of(column.values);
    if (column.is_force) forces[py::str(column.name)] = array_of(column.values);
  }
  py::object end = py::none();
  if (motion.end)
    end = py::make_tuple(motion.end->kind, motion.end->step, motion.end->sentences, motion.end->sentence);
  return py::dict("steps"_a = array_of(motion.steps), "times"_a = array_of(motion.times), "places"_a = places,
                  "velocities"_a = velocities, "accelerations"_a = accelerations, "angles"_a = angles,
                  "rates"_a = rates, "changes"_a = changes, "reactions"_a = reactions, "forces"_a = forces,
                  "table"_a = table, "force_sentences"_a = motion.force_sentences,
                  "undetermined"_a = motion.undetermined, "end"_a = end);
}

/// (x, y, x reached, y reached, direction or None, direction reached or None, share of the motion) of each; mm, rad.
py::tuple tuples_of(const std::vector<PlaceAskedFor>& places) {
  py::tuple all(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PlaceAskedFor& one = places[i];
    all[i] = py::make_tuple(one.at.x(), one.at.y(), one.reached.x(), one.reached.y(), one.angle,
                            one.reached_angle, one.share);
  }
  return all;
}

using PlaceTuple =
    std::tuple<double, double, double, double, std::optional<double>, std::optional<double>, double>;

std::vector<PlaceAskedFor> places_of(const std::vector<PlaceTuple>& tuples) {
  std::vector<PlaceAskedFor> places;
  for (const auto& [x, y, x_reached, y_reached, angle, reached_angle, share] : tuples)
    places.push_back({Point(x, y), Point(x_reached, y_reached), angle, reached_angle, share});
  return places;
}

/// With a time limit, s, and Ctrl-C.
Options limited(const std::optional<double>& time_limit, Hooks& hooks) {
  Options options;
  options.time_limit = time_limit;
  options.stop = [&hooks] { return hooks.stopped(); };
  return options;
}

/// (json, [(kind, linkage file, places asked for)], plot); or a NothingGenerated; or faults.
template <typename Generate>
py::object generated(const Generate& generate) {
  const auto found = at_work(py::none(), [&](Hooks& hooks) {
    if constexpr (std::is_invocable_v<Generate, Hooks&>)
      return generate(hooks);
    else
      return generate();
  });
  if (const auto* fault = std::get_if<InputError>(&found)) return faults_of(*fault);
  if (const auto* none = std::get_if<NothingGenerated>(&found)) return py::cast(*none);
  const auto& answer = std::get<Generated>(found);
  py::list linkages;
  for (const GeneratedLinkage& linkage : answer.linkages)
    linkages.append(py::make_tuple(linkage.kind, linkage.text, tuples_of(linkage.wanted)));
  return py::make_tuple(answer.json, linkages, answer.plot);
}

void add_reasons(py::module_& module) {
  py::class_<NoMotion>(module, "NoMotion")
      .def_property_readonly("sentence", [](const NoMotion& none) { return text_of(none.sentence); })
      .def_property_readonly("stopped", [](const NoMotion& none) { return none.stopped; });
  py::class_<NothingGenerated>(module, "NothingGenerated")
      .def_property_readonly("sentence", [](const NothingGenerated& none) { return text_of(none.sentence); })
      .def_property_readonly("proven", [](const NothingGenerated& none) { return none.proven; })
      .def_property_readonly("stopped", [](const NothingGenerated& none) { return none.stopped; });
}

using LinkageClass = py::class_<Linkage>;

/// What stands in its file.
void add_contents(LinkageClass& type) {
  type.def_property_readonly("text", &Linkage::text)
      .def_property_readonly("name", [](const Linkage& linkage) { return text_of(linkage.name()); })
      .def_property_readonly("unit", &Linkage::unit)
      .def_property_readonly("points", &Linkage::points)
      .def_property_readonly("links", &Linkage::links)
      .def_property_readonly("steps", &Linkage::steps)
      .def_property_readonly("notes", &Linkage::notes);
}

/// How it closes, moves and is free to.
void add_motions(LinkageClass& type) {
  type.def(
          "assemblies",
          [](const Linkage& linkage, std::uint64_t seed) {
            return answered(
                seed, 0, [&](const AssemblyChoice& choice) { return linkage.assemblies(choice); }, tuple_of);
          },
          "seed"_a)
      .def(
          "solve",
          [](const Linkage& linkage, std::optional<int> steps, int assembly, std::uint64_t seed) {
            return answered(
                seed, assembly, [&](const AssemblyChoice& choice) { return linkage.solve(steps, choice); },
                dict_of);
          },
          "steps"_a, "assembly"_a, "seed"_a)
      .def(
          "mobility",
          [](const Linkage& linkage, std::uint64_t seed) {
            return text_answered(seed, 0,
                                 [&](const AssemblyChoice& choice) { return linkage.mobility(choice); });
          },
          "seed"_a);
}

/// What is drawn and written of its motion.
void add_views(LinkageClass& type) {
  type.def("centres", at_step(&Linkage::centres), "step"_a, "assembly"_a, "seed"_a)
      .def("centres_drawing", at_step(&Linkage::centres_drawing), "step"_a, "assembly"_a, "seed"_a)
      .def("centres_page", at_step(&Linkage::centres_page), "step"_a, "assembly"_a, "seed"_a)
      .def("equations", at_step(&Linkage::equations), "step"_a, "assembly"_a, "seed"_a)
      .def(
          "animation",
          [](const Linkage& linkage, bool is_page, std::optional<int> steps, int assembly, std::uint64_t seed,
             const std::vector<PlaceTuple>& wanted) {
            const Linkage::AnimationFile file =
                is_page ? Linkage::AnimationFile::page : Linkage::AnimationFile::drawing;
            const std::vector<PlaceAskedFor> places = places_of(wanted);
            return text_answered(seed, assembly, [&](const AssemblyChoice& choice) {
              return linkage.animation(file, steps, choice, places);
            });
          },
          "is_page"_a, "steps"_a, "assembly"_a, "seed"_a, "wanted"_a);
}

void add_reading(py::module_& module) {
  module.def(
      "parse_linkage",
      [](const std::string& text, const std::string& name) {
        return value_or_faults(Linkage::parse(text, name));
      },
      "text"_a, "name"_a);
  module.def(
      "read_linkage", [](const std::filesystem::path& file) { return value_or_faults(Linkage::read(file)); },
      "file"_a);
  module.def(
      "chains",
      [](int links, int freedoms) {
        return value_or_faults(at_work(py::none(), [&](Hooks&) { return chains(links, freedoms); }));
      },
      "links"_a, "freedoms"_a);
}

void add_function_generator(py::module_& module) {
  module.def(
      "generate_function",
      [](const std::filesystem::path& file, const std::optional<double>& time_limit) {
        return generated([&](Hooks& hooks) { return generate_function(file, limited(time_limit, hooks)); });
      },
      "file"_a, "time_limit"_a);
  module.def(
      "generate_function_text",
      [](const std::string& spec, const std::optional<double>& time_limit) {
        return generated(
            [&](Hooks& hooks) { return generate_function_text(spec, "", limited(time_limit, hooks)); });
      },
      "spec"_a, "time_limit"_a);
}

void add_inversor(py::module_& module) {
  module.def(
      "generate_inversor",
      [](const std::filesystem::path& file) { return generated([&] { return generate_inversor(file); }); },
      "file"_a);
  module.def(
      "generate_inversor_text",
      [](const std::string& spec) { return generated([&] { return generate_inversor_text(spec); }); },
      "spec"_a);
}

void add_path_generator(py::module_& module) {
  py::class_<PlagiographOptions>(module, "PlagiographOptions")
      .def(py::init([](double scale, double rotation_deg, const std::string& pole, int cognate) {
             return PlagiographOptions{scale, radians(rotation_deg), pole, cognate};
           }),
           "scale"_a, "rotation_deg"_a, "pole"_a, "cognate"_a);
  module.def(
      "generate_path",
      [](const std::filesystem::path& file, const std::optional<PlagiographOptions>& copy) {
        return generated([&] { return generate_path(file, copy); });
      },
      "file"_a, "copy"_a);
  module.def(
      "generate_path_text",
      [](const std::string& spec, const std::optional<PlagiographOptions>& copy) {
        return generated([&] { return generate_path_text(spec, "", copy); });
      },
      "spec"_a, "copy"_a);
}

}  // namespace

void add_linkages(py::module_& module) {
  add_reasons(module);
  LinkageClass type(module, "Linkage");
  add_contents(type);
  add_motions(type);
  add_views(type);
  add_reading(module);
  add_function_generator(module);
  add_inversor(module);
  add_path_generator(module);
}

}  // namespace kempe::python
