#include "reports/linkages/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> names_of(const LinkageModel& model, const std::vector<int>& set) {
  std::vector<std::string> names;
  for (const int number : set) names.push_back(constraint_label(model, number));
  return names;
}

std::string counted(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string describe_redundancy(const LinkageModel& model, const std::vector<int>& set) {
  return fmt::format("one of these equations is redundant: {}", fmt::join(names_of(model, set), "; "));
}

/// The count and the truth, and why they differ: mobility - count = redundant equations - shaky freedoms.
std::string compared_with_count(const Mobility& m) {
  const int redundant = static_cast<int>(m.redundant.size()), shaky = m.shaky_freedoms();
  const std::string equations =
      redundant == 1 ? "1 equation is redundant" : fmt::format("{} equations are redundant", redundant);
  const std::string freedoms = counted(shaky, "freedom is shaky", "freedoms are shaky");
  const std::string why = redundant == 0 ? freedoms : shaky == 0 ? equations : equations + ", " + freedoms;
  if (m.mobility != m.gruebler)
    return fmt::format("Gruebler counts {}, the true mobility is {}: {}", m.gruebler, m.mobility, why);
  const std::string agree = fmt::format("Gruebler's count and the true mobility agree: {}", m.mobility);
  return redundant == 0 ? agree : fmt::format("{}, by chance: {}", agree, why);
}

/// What the count cannot see; empty where nothing is redundant.
std::string blindness_of_the_count(const Mobility& m) {
  if (m.redundant.empty()) return {};
  return "the count knows how many links and joints there are, not their lengths and places: it takes every "
         "equation "
         "for a new demand, but a redundant one is met already wherever the others are";
}

std::string driver_sentence(const LinkageModel& model, const Mobility& m) {
  const int drivers = static_cast<int>(model.linkage.drivers().size());
  if (drivers == m.mobility || drivers == 0) return {};
  return fmt::format(
      "{} for {}: {}", counted(drivers, "driven value", "driven values"),
      counted(m.mobility, "freedom", "freedoms"),
      drivers < m.mobility ? "the motion is not determined" : "more than can be chosen independently");
}

/// Without what is rounding only, against a size: 1e-16 becomes 0.
double tidy(double value, double size) { return std::abs(value) < 1e-14 * size ? 0 : value; }

std::string kind_of(InstantCentre::Kind kind) {
  if (kind == InstantCentre::Kind::finite) return "finite";
  return kind == InstantCentre::Kind::at_infinity ? "infinity" : "undetermined";
}

std::string kind_of(InstantCentre::Source source) {
  switch (source) {
    case InstantCentre::Source::primary: return "primary";
    case InstantCentre::Source::lines: return "aronhold-kennedy";
    case InstantCentre::Source::rates: return "velocities";
    case InstantCentre::Source::none: return "none";
  }
  return {};
}

Json line_json(const LinkageModel& model, const InstantCentre& centre, const CentreLine& line) {
  const auto& link = [&](int body) { return model.linkage.body_name(body); };
  if (line.from != CentreLine::From::kennedy)
    return {
        {"from", line.from == CentreLine::From::slider ? "square to the slider" : "no turning: at infinity"},
        {"joint", constraint_label(model, *line.constraint)}};
  return {{"from", "aronhold-kennedy"},
          {"through", Json::array({Json::array({link(centre.first), link(*line.via)}),
                                   Json::array({link(*line.via), link(centre.second)})})}};
}

Json centre_json(const LinkageFile& file, const LinkageModel& model, const InstantCentre& centre) {
  Json object{{"links", {model.linkage.body_name(centre.first), model.linkage.body_name(centre.second)}},
              {"kind", kind_of(centre.kind)},
              {"source", kind_of(centre.source)}};
  if (centre.kind == InstantCentre::Kind::finite) {
    object["x_" + file.unit.name] = tidy(centre.at.x(), model.linkage.size()) / file.unit.in_mm;
    object["y_" + file.unit.name] = tidy(centre.at.y(), model.linkage.size()) / file.unit.in_mm;
  } else if (centre.kind == InstantCentre::Kind::at_infinity) {
    object["direction_deg"] = degrees(std::atan2(centre.direction.y(), centre.direction.x()));
  }
  if (centre.constraint) object["joint"] = constraint_label(model, *centre.constraint);
  if (centre.lines)
    object["lines"] = {line_json(model, centre, (*centre.lines)[0]),
                       line_json(model, centre, (*centre.lines)[1])};
  if (centre.source != InstantCentre::Source::none) object["velocity_error"] = centre.velocity_error;
  return object;
}

}  // namespace

std::string constraint_label(const LinkageModel& model, int number) {
  const auto& named = model.linkage.constraints()[static_cast<std::size_t>(number)];
  const auto& constraint = named.constraint;
  const auto& drivers = model.linkage.drivers();
  if (const auto driver = std::find(drivers.begin(), drivers.end(), number); driver != drivers.end())
    return "driver " + model.driver_label(static_cast<int>(driver - drivers.begin()));
  const auto with_links = [&](std::string_view kind) {
    std::string links;
    for (const int body : bodies_of(constraint))
      links += (links.empty() ? "" : ", ") + model.linkage.body_name(body);
    return fmt::format("{} {} ({})", kind, named.name, links);
  };
  if (std::holds_alternative<Revolute>(constraint)) return with_links("joint");
  return std::holds_alternative<Coordinate>(constraint) ? with_links("slider") : named.name;
}

std::string gruebler_in_numbers(const Mobility& m) {
  const bool points = m.particles > 0;
  return fmt::format("3 (n - 1){} - 2 j1 - j2 = 3 ({} - 1){} - 2 * {} - {} = {}", points ? " + 2 p" : "",
                     m.links, points ? fmt::format(" + 2 * {}", m.particles) : "", m.full_joints,
                     m.half_joints, m.gruebler);
}

std::vector<std::string> mobility_sentences(const LinkageModel& model, const Mobility& m) {
  std::vector<std::string> sentences{compared_with_count(m)};
  if (const std::string blind = blindness_of_the_count(m); !blind.empty()) sentences.push_back(blind);
  for (const auto& set : m.redundant) sentences.push_back(describe_redundancy(model, set));
  if (m.shaky_freedoms() > 0)
    sentences.push_back(
        fmt::format("{} at first order that no motion follows: the linkage is shaky in every position; write "
                    "straight rows of points as links, not as bars",
                    counted(m.shaky_freedoms(), "freedom", "freedoms")));
  if (m.singular_here()) {
    std::string sentence =
        fmt::format("singular position: here the constraints leave {} at first order, next to it {}",
                    counted(m.unknowns - m.rank_here, "freedom", "freedoms"), m.unknowns - m.rank);
    for (const auto& set : m.dependent_here)
      if (std::find(m.redundant.begin(), m.redundant.end(), set) == m.redundant.end())
        sentence += fmt::format("; dependent here: {}", fmt::join(names_of(model, set), ", "));
    sentences.push_back(sentence);
  }
  if (const std::string sentence = driver_sentence(model, m); !sentence.empty())
    sentences.push_back(sentence);
  return sentences;
}

std::string mobility_json(const LinkageFile& file, const LinkageModel& model, const Mobility& m) {
  Json object{{"linkage", file.name},
              {"links", m.links},
              {"free_points", m.particles},
              {"full_joints", m.full_joints},
              {"sliding_pairs", m.sliding_pairs},
              {"half_joints", m.half_joints},
              {"gruebler", m.gruebler},
              {"gruebler_in_numbers", gruebler_in_numbers(m)},
              {"unknowns", m.unknowns},
              {"equations", m.equations},
              {"rank", m.rank},
              {"rank_here", m.rank_here},
              {"mobility", m.mobility},
              {"drivers", model.linkage.drivers().size()},
              {"singular_position", m.singular_here()}};
  object["redundant"] = Json::array();
  for (const auto& set : m.redundant) object["redundant"].push_back(names_of(model, set));
  object["sentences"] = mobility_sentences(model, m);
  if (!file.notes.empty()) object["notes"] = file.notes;
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string why_no_chain(int links, int freedoms, const NumberSynthesis& synthesis) {
  if (synthesis.joints == 0)
    return fmt::format("3 ({} - 1) - {} is not a positive even number: no joints fit", links, freedoms);
  if (synthesis.loops == 0)
    return fmt::format("{} joints are fewer than {} links: no loop closes", synthesis.joints, links);
  return {};
}

std::string number_synthesis_json(int links, int freedoms, const NumberSynthesis& synthesis) {
  const auto list = [](const std::vector<LinkAssortment>& assortments) {
    Json array = Json::array();
    for (const LinkAssortment& assortment : assortments) {
      Json object = Json::object();
      for (std::size_t i = 0; i < std::max<std::size_t>(3, assortment.count.size()); ++i)
        object[fmt::format("n{}", i + 2)] = i < assortment.count.size() ? assortment.count[i] : 0;
      array.push_back(object);
    }
    return array;
  };
  Json object{{"links", links},
              {"freedoms", freedoms},
              {"joints", synthesis.joints},
              {"loops", synthesis.loops},
              {"largest_link", synthesis.largest_link},
              {"assortments", list(synthesis.assortments)},
              {"with_too_large_a_link", list(synthesis.too_large)},
              {"with_a_stiff_part", list(synthesis.stiff)}};
  if (const std::string why = why_no_chain(links, freedoms, synthesis); !why.empty())
    object["sentence"] = why;
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string source_of(const LinkageModel& model, const InstantCentre& centre) {
  const auto line = [&](const CentreLine& each) {
    if (each.from == CentreLine::From::slider)
      return "the normal of " + constraint_label(model, *each.constraint);
    if (each.from == CentreLine::From::no_turning) return std::string("the line at infinity");
    const auto pair = [&](int a, int b) {
      return fmt::format("({}, {})", model.linkage.body_name(a), model.linkage.body_name(b));
    };
    return fmt::format("{}-{}", pair(centre.first, *each.via), pair(*each.via, centre.second));
  };
  if (centre.source == InstantCentre::Source::primary) return constraint_label(model, *centre.constraint);
  if (centre.source == InstantCentre::Source::rates) return "the velocities that the drivers give";
  if (centre.lines) return fmt::format("{} and {}", line((*centre.lines)[0]), line((*centre.lines)[1]));
  return "nothing: the links do not move against each other";
}

std::string centres_json(const LinkageFile& file, const LinkageModel& model, double step,
                         const RunFrame& frame, const std::vector<double>& speeds,
                         const std::vector<InstantCentre>& centres) {
  Json object{{"linkage", file.name}, {"step", step}, {"time_s", frame.share * file.duration}};
  object["drivers"] = Json::array();
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const Constraint& constraint =
        model.linkage.constraints()[static_cast<std::size_t>(model.linkage.drivers()[i])].constraint;
    const bool is_angle = std::holds_alternative<RelativeAngle>(constraint);
    const double scale = is_angle ? 1 : file.unit.in_mm;
    object["drivers"].push_back(
        {{"drives", model.driver_label(static_cast<int>(i))},
         {is_angle ? "value_rad" : "value_" + file.unit.name, frame.values[i] / scale},
         {is_angle ? "rate_rad_per_s" : "rate_" + file.unit.name + "_per_s", speeds[i] / scale}});
  }
  object["count"] = centres.size();
  object["centres"] = Json::array();
  for (const InstantCentre& centre : centres) object["centres"].push_back(centre_json(file, model, centre));
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kempe
