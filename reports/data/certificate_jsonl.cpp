#include "reports/data/certificate_jsonl.hpp"

#include <nlohmann/json.hpp>

#include "reports/data/geojson_geometry.hpp"
#include "reports/data/task_json.hpp"
#include "specs/objective_unit.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;
using namespace certificate;

Json as_json(const Place& place) {
  if (const auto* at = std::get_if<Point>(&place)) return position(*at);
  const auto& [polygon, ring, corner, share] = std::get<EdgePlace>(place);
  return Json::array({polygon, ring, corner, share});
}

Json as_json(const PartPoint& point) {
  constexpr int bars = 2, links = 4;
  Json values = Json::array({text(point.part)});
  if (point.part.number < links) values.push_back(point.t);
  if (point.part.number >= bars && point.part.number < links) values.push_back(point.u);
  return values;
}

Json as_json(const Requirement& one) {
  constexpr std::array<const char*, 4> names{"far", "near", "posts", "bound"};
  Json values = Json::array({names[static_cast<std::size_t>(one.kind)]});
  if (one.kind != Requirement::Kind::bound) values.push_back(as_json(one.place));
  values.push_back(one.weight);
  return values;
}

struct LineJson {
  Json operator()(const Split& line) const {
    constexpr std::array<const char*, 4> names{"a", "b", "x", "y"};
    return {{"split", names[static_cast<std::size_t>(line.variable)]}, {"at", line.at}};
  }
  Json operator()(const Share& line) const {
    const auto* part = std::get_if<PartName>(&line.other);
    const Json other = part ? Json(text(*part)) : Json(std::get<std::size_t>(line.other));
    return {{"share", Json::array({text(line.one), other})}};
  }
  Json operator()(const ContactCut& line) const {
    return {{"contact", Json::array({as_json(line.one), as_json(line.other)})}, {"u", line.u}};
  }
  Json operator()(const CopyErrorCut& line) const {
    return {{"copy_error", Json::array({line.far_cosine, line.near_cosine})}};
  }
  Json operator()(const SumLeaf& line) const {
    Json of = Json::array();
    for (const Requirement& one : line.of) of.push_back(as_json(one));
    return {{"leaf", "sum"}, {"of", std::move(of)}};
  }
  Json operator()(const CopyGapLeaf& line) const {
    return {{"leaf", "sheets"}, {"places", Json::array({as_json(line.one), as_json(line.other)})}};
  }
  Json operator()(const ObstacleLeaf& line) const {
    return {{"leaf", "obstacle"},
            {"obstacle", line.obstacle},
            {"edge", line.edge ? Json(*line.edge) : Json(nullptr)},
            {"place", as_json(line.place)},
            {"point", as_json(line.point)}};
  }
  Json operator()(const PoleLeaf&) const { return {{"leaf", "pole"}}; }
  Json operator()(const LayersLeaf&) const { return {{"leaf", "layers"}}; }
  Json operator()(const LengthsLeaf&) const { return {{"leaf", "lengths"}}; }
};

}  // namespace

std::string certificate_jsonl(const Spec& spec, const ProofLog& log) {
  const Json header{{"format", "kempe-certificate/1"},
                    {"claim", log.bound ? "bound" : "none"},
                    {"objective", name(log.objective)},
                    {"bound", log.bound ? Json(in_file_unit(log.objective, *log.bound)) : Json(nullptr)},
                    {"task", task_json(spec)}};
  const auto dumped = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  };
  std::string text = dumped(header);
  for (const Line& line : log.lines) text += dumped(std::visit(LineJson{}, line));
  return text;
}

}  // namespace kempe
