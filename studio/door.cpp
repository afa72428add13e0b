#include "studio/door.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "kempe/kempe.hpp"
#include "library/workings.hpp"
#include "reports/page/model.hpp"
#include "reports/pictures/map_picture.hpp"
#include "specs/materials.hpp"
#include "specs/spec_reader.hpp"
#include "studio/enclosure.hpp"
#include "synthesis/search/search_faults.hpp"
#include "synthesis/search/sketch.hpp"

namespace kempe::studio {

struct Door::Memory {
  std::optional<FinishedDesign> design;
  std::optional<SketchedDesign> sketch;
};

namespace {

using Json = nlohmann::ordered_json;

/// Where drawings that a spec names are put, and where the files of a design are written.
constexpr const char* spec_folder = "/spec";
constexpr const char* files_folder = "/files";
/// Corners of outlines that a page draws lie at least this share of the outline's extent apart.
constexpr double detail = 1e-3;

Json point(const Point& at) { return Json::array({at.x(), at.y()}); }

Json ring(const Ring& corners) {
  Point lower = corners.front(), upper = lower;
  for (const Point& at : corners) lower = lower.cwiseMin(at), upper = upper.cwiseMax(at);
  Json points = Json::array();
  for (const Point& at : thinned(corners, detail * (upper - lower).norm())) points.push_back(point(at));
  return points;
}

Json rings(const Region& region) {
  Json all = Json::array();
  for (const Polygon& polygon : region.polygons) {
    all.push_back(ring(polygon.outer));
    for (const Ring& hole : polygon.holes) all.push_back(ring(hole));
  }
  return all;
}

/// Every corner, as a spec would name them.
Json whole(const Region& region) {
  Json polygons = Json::array();
  const auto corners = [](const Ring& ring) {
    Json points = Json::array();
    for (const Point& at : ring) points.push_back(point(at));
    return points;
  };
  for (const Polygon& polygon : region.polygons) {
    Json rings = Json::array({corners(polygon.outer)});
    for (const Ring& hole : polygon.holes) rings.push_back(corners(hole));
    polygons.push_back(std::move(rings));
  }
  return polygons;
}

Json optional_number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// Of a drawing, its name; the spec itself has none here.
Json file_of(const InputError& error) {
  return error.file.empty() ? Json() : Json(std::filesystem::path(error.file).filename().string());
}

Json fault(const InputError& error) {
  return {{"file", file_of(error)},
          {"line", error.line > 0 ? Json(error.line) : Json()},
          {"key", error.key},
          {"found", error.found},
          {"allowed", error.allowed}};
}

Json faults(const InputError& error) {
  Json all = Json::array({fault(error)});
  for (const InputError& other : error.others) all.push_back(fault(other));
  return {{"kind", "faults"}, {"faults", all}};
}

/// What a page draws of a spec, and the limits that its figures are held against.
Json task(const Spec& spec) {
  Json obstacles = Json::array();
  for (const Obstacle& obstacle : spec.obstacles)
    obstacles.push_back({{"name", obstacle.name},
                         {"layers", {obstacle.lowest_layer, obstacle.highest_layer}},
                         {"rings", Json::array({ring(obstacle.shape.outer)})}});
  Json pole = {{"at", nullptr}, {"within", nullptr}};
  if (spec.pole.is_fixed())
    pole["at"] = point(std::get<Point>(spec.pole.place));
  else
    pole["within"] = rings(std::get<Region>(spec.pole.place));
  return {{"k", {spec.copy.k().real(), spec.copy.k().imag()}},
          {"scale", spec.copy.scale()},
          {"rotation", spec.copy.rotation()},
          {"region", rings(spec.region)},
          {"pole", pole},
          {"obstacles", obstacles},
          {"table", spec.table ? Json(ring(spec.table->outer)) : Json(nullptr)},
          {"clearance", spec.limits.clearance},
          {"transmission", spec.limits.transmission},
          {"sheets_gap", optional_number(spec.limits.copy_gap)},
          {"longest", largest_joint_distance(spec)},
          {"longest_strip", optional_number(spec.limits.longest_strip)},
          {"shortest", spec.links.shortest},
          {"load_error", optional_number(spec.limits.load_error)},
          {"sag", optional_number(spec.limits.sag)},
          {"objective", name(spec.objective.objective)},
          {"mechanism", spec.mechanism.has_value()}};
}

Json lengths(const LinkLengths& of) {
  Json all = Json::object();
  const auto values = of.values();
  for (std::size_t i = 0; i < values.size(); ++i) all[std::string(LinkLengths::names[i])] = values[i];
  return all;
}

double longest(const LinkLengths& of) {
  const auto values = of.values();
  return *std::max_element(values.begin(), values.end());
}

Json found(const FoundDesign& design, const std::optional<double>& bound, const LinkStyle& style) {
  const LinkLengths of = design.linkage.lengths();
  return {{"kind", "sketch"},
          {"figures",
           {{"size", design.linkage.size()},
            {"value", design.value},
            {"bound", optional_number(bound)},
            {"transmission", design.attained.transmission},
            {"longest", longest(of)},
            {"longest_strip", longest(of) + style.width}}},
          {"lengths", lengths(of)},
          {"model", Json::parse(linkage_model(design.linkage, design.layers, style))}};
}

/// What a sketch elsewhere begins with: "from" of the question "sketch".
Json handover(const Design& design) {
  return {{"k", {design.linkage.k().real(), design.linkage.k().imag()}},
          {"grounding", static_cast<int>(design.linkage.grounding())},
          {"VA", design.linkage.VA()},
          {"VB", design.linkage.VB()},
          {"assembly_mode", design.linkage.assembly_mode().number},
          {"pole", point(design.linkage.pole())},
          {"layers", design.layers.of},
          {"value", design.search ? Json(design.search->value) : Json()},
          {"opening", {design.opening.lower, design.opening.upper}},
          {"size", design.quality.size},
          {"transmission", design.quality.transmission_min},
          {"bound", optional_number(design.quality.proven_bound)}};
}

Point point_of(const Json& at) { return {at.at(0).get<double>(), at.at(1).get<double>()}; }

/// The sketch that the design of another door is; nothing if it is none.
std::optional<SketchedDesign> handed_over(const Json& from, const Spec& spec) {
  const Point k = point_of(from.at("k")), opening = point_of(from.at("opening"));
  const int grounding = from.at("grounding").get<int>();
  const auto linkage =
      grounding < 0 || grounding > 2
          ? tl::unexpected(LinkageFault::no_such_assembly_mode)
          : CopyingLinkage::make(as_complex(k), static_cast<Grounding>(grounding),
                                 from.at("VA").get<double>(), from.at("VB").get<double>(),
                                 from.at("assembly_mode").get<int>(), point_of(from.at("pole")));
  if (!linkage || from.at("value").is_null()) return std::nullopt;
  FoundDesign found{.linkage = *linkage,
                    .layers = LayerAssignment{from.at("layers").get<std::array<int, 4>>()}};
  found.goal = goal_of(spec.objective.objective);
  found.value = from.at("value").get<double>();
  found.opening = {opening.x(), opening.y()};
  found.attained.size = from.at("size").get<double>();
  found.attained.transmission = from.at("transmission").get<double>();
  if (const Json& bound = from.at("bound"); !bound.is_null()) found.proven_bound = bound.get<double>();
  return sketch_of(found);
}

/// What is told of a finished design: figures, the report's picture and what its scripts know.
Json found(const FinishedDesign& design) {
  const Design& inside = Workings::inside(design);
  const MapPicture picture = map_picture(inside);
  Json losses = Json::array(), sheets = Json::array();
  for (const Loss& loss : design.map().losses())
    losses.push_back({{"cause", loss.cause}, {"parts", loss.parts}, {"area", loss.area}});
  for (const SheetThatFits& sheet : design.map().largest_sheets())
    sheets.push_back({{"name", sheet.name}, {"width", sheet.width}, {"height", sheet.height}});
  const LinkLengths of = design.lengths();
  return {{"kind", "design"},
          {"figures",
           {{"size", design.size()},
            {"value", optional_number(design.value())},
            {"objective", name(design.objective())},
            {"bound", optional_number(design.proven_bound())},
            {"transmission", design.transmission_min()},
            {"clearance", optional_number(design.clearance_min())},
            {"free_area", design.map().collision_free_area()},
            {"longest", longest(of)},
            {"longest_strip", longest(of) + design.section().width},
            {"footprint", design.footprint()},
            {"load_error", optional_number(design.load_error())},
            {"sag", optional_number(design.sag())},
            {"mass", optional_number(design.mass())},
            {"complete", design.complete()},
            {"covers", design.map().covers_region()},
            {"why_not_covered", design.map().why_not_covered()}}},
          {"lengths", lengths(of)},
          {"handover", handover(inside)},
          {"losses", losses},
          {"sheets", sheets},
          {"design", Json::parse(design.json())},
          {"model", Json::parse(report_model(inside, picture))},
          {"picture", picture.svg}};
}

Json none(const Outcome& outcome) {
  Json changes = Json::array();
  for (const PossibleChange& change : outcome.changes())
    changes.push_back({{"key", change.key}, {"sentence", change.sentence}});
  return {{"kind", "none"},
          {"reason", outcome.reason()},
          {"proven", outcome.proven()},
          {"stopped", outcome.kind() == Outcome::Kind::stopped},
          {"bound", optional_number(outcome.proven_bound())},
          {"changes", changes}};
}

Json names_of_materials() {
  Json names = Json::array();
  for (const KnownMaterial& material : known_materials()) names.push_back(material.name);
  return names;
}

/// The drawings that came along, where the reader looks for them. A name is that of a file, not of a place elsewhere.
void put_files(const Json& question) {
  std::error_code ignored;
  std::filesystem::create_directories(spec_folder, ignored);
  const auto files = question.find("files");
  if (files == question.end()) return;
  for (const Json& file : *files) {
    const auto name = std::filesystem::path(file.at("name").get<std::string>()).filename();
    std::ofstream(std::filesystem::path(spec_folder) / name, std::ios::binary)
        << file.at("text").get<std::string>();
  }
}

tl::expected<Spec, InputError> spec_of(const Json& question) {
  put_files(question);
  return read_spec(question.at("text").get<std::string>(), "", spec_folder);
}

}  // namespace

Door::Door() : memory_(std::make_unique<Memory>()) {}
Door::~Door() = default;

namespace {

Json answer_to_sketch(const Spec& spec, const Json& asked, std::optional<SketchedDesign>& last) {
  if (const auto from = asked.find("from"); from != asked.end() && !from->is_null())
    last = handed_over(*from, spec);
  if (!last) return {{"kind", "none"}, {"proven", false}};
  last = sketched(spec, *last);
  if (last->design) return found(*last->design, last->bound, spec.links.style);
  return {{"kind", "none"}, {"proven", last->proven_none}};
}

Json answer_to_files(const FinishedDesign& design, const std::string& title) {
  std::error_code ignored;
  std::filesystem::remove_all(files_folder, ignored);
  const Written written = write(design, files_folder, {.title = title});
  if (!written) return {{"reason", written.reason}};
  return {{"files", written.files}, {"left_out", written.left_out}};
}

}  // namespace

std::string Door::ask(std::string_view question, const std::string& argument, const Progress& progress) {
  const auto answer = [&]() -> Json {
    if (question == "version") return {{"version", KEMPE_VERSION}};
    if (question == "check") return {{"holds", intervals_hold()}};
    if (question == "materials") return {{"names", names_of_materials()}};
    const Json asked = Json::parse(argument);
    if (question == "files") {
      if (!memory_->design) return {{"reason", "there is no design yet"}};
      return answer_to_files(*memory_->design, asked.value("title", "design"));
    }
    const auto spec = spec_of(asked);
    if (!spec) return faults(spec.error());
    if (question == "validate") return {{"kind", "task"}, {"task", task(*spec)}};
    if (question == "region") return {{"kind", "region"}, {"polygons", whole(spec->region)}};
    if (question == "sketch" && search_fault(*spec)) return faults(*search_fault(*spec));
    if (question == "sketch") return answer_to_sketch(*spec, asked, memory_->sketch);
    if (question != "design" && question != "map") return {{"error", "no such question"}};
    Options options;
    options.progress = progress;
    const Outcome outcome = question == "map" ? map(*spec, options) : design(*spec, options);
    if (outcome.fault()) return faults(*outcome.fault());
    if (!outcome) return none(outcome);
    memory_->design = *outcome;
    return found(*outcome);
  };
  try {
    return answer().dump(-1, ' ', false, Json::error_handler_t::replace);
  } catch (const std::exception& fault) {
    return Json{{"error", fault.what()}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

}  // namespace kempe::studio
