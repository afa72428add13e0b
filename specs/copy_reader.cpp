#include "specs/copy_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/similarity_fit.hpp"
#include "specs/mirror_words.hpp"
#include "specs/spec_keys.hpp"
#include "specs/text/ratio.hpp"
#include "specs/unit_words.hpp"

namespace kempe {
namespace {

/// Ratios nearer to 1 than this need links a million times as long as the copy is large.
constexpr double nearest_to_one = 1e-6;

/// Into (-180, 180], without rounding.
double within_one_turn(double degrees_given) {
  const double turned = std::remainder(degrees_given, 360.0);
  return turned == -180 ? 180 : turned + 0.0;
}

std::optional<PointPair> read_pair(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list || list->size() != 2) return std::nullopt;
  const auto tracer = finite_point((*list)[0]), pen = finite_point((*list)[1]);
  const KeyRange& range = find_spec_key("copy", "pairs_mm")->range;
  const auto in_range = [&](const Point& point) {
    return range.contains(point.x()) && range.contains(point.y());
  };
  if (!tracer || !pen || !in_range(*tracer) || !in_range(*pen)) return std::nullopt;
  return PointPair{*tracer, *pen};
}

std::vector<PointPair> read_pairs(const toml::array& list, Complaints& complaints) {
  std::vector<PointPair> pairs;
  for (const toml::node& node : list) {
    const auto pair = read_pair(node);
    if (!pair) {
      complaints.add(line_of(node), "copy.pairs_mm",
                     fmt::format("pair {}: {}", pairs.size() + 1, describe(node)),
                     describe_allowed(*find_spec_key("copy", "pairs_mm"), complaints.unit()));
      return {};
    }
    pairs.push_back(*pair);
  }
  return pairs;
}

struct FaultText {
  std::string_view found, allowed;
};
FaultText text_of(PairFault fault) {
  switch (fault) {
    case PairFault::too_few: return {"fewer than two different tracer points", "at least two"};
    case PairFault::one_pen_point:
      return {"all pen points in one place", "at least two different pen points"};
    case PairFault::mirrored:
      return {"pairs that mirror: a reflection fits them clearly better than any rotation", no_mirror};
    case PairFault::no_similarity:
      return {"pairs that no scale and rotation carries into each other, even roughly",
              "pairs [tracer, pen] of one similarity"};
  }
  return {"", ""};
}

CopyReading read_copy_from_pairs(const TableView& table, Complaints& complaints) {
  const toml::node& node = *table.find("pairs_mm");
  const std::vector<PointPair> pairs = read_pairs(*node.as_array(), complaints);
  if (!complaints.none_about("copy")) return {};
  const auto fit = fit_similarity(pairs);
  if (!fit) {
    const FaultText text = text_of(fit.error());
    complaints.add(line_of(node), "copy.pairs_mm", std::string(text.found), std::string(text.allowed));
    return {};
  }
  const PairFit quality{pairs.size(), fit->residual_rms, fit->residual_largest, fit->translation};
  return {Copy::fitted(fit->k, quality), fit->fixed_point()};
}

/// 1.5, or "3:2".
std::optional<double> scale_of(const toml::node& node) {
  return node.is_string() ? parse_ratio(node.value_or(std::string())) : finite_number(node);
}

CopyReading read_copy_given(const TableView& table) {
  double scale = 1, rotation_degrees = 0;
  if (const toml::node* node = table.find("scale")) scale = scale_of(*node).value_or(scale);
  table.set("rotation_deg", rotation_degrees);
  return {Copy::of(scale, radians(within_one_turn(rotation_degrees))), std::nullopt};
}

void check_ratio(const TableView& table, const Copy& copy, const char* key, Complaints& complaints) {
  const KeyRange& range = find_spec_key("copy", "scale")->range;
  if (!range.contains(copy.scale())) {
    complaints.add(table.line_of_key(key), table.dotted(key), fmt::format("a scale of {}", copy.scale()),
                   "a scale " + range.describe());
  }
  if (std::abs(copy.k() - 1.0) >= nearest_to_one) return;
  complaints.add(table.line_of_key(key), table.dotted(key),
                 fmt::format("scale {} without rotation: a translation, which has no pole", copy.scale()),
                 "a scale other than 1 or a rotation");
}

}  // namespace

CopyReading read_copy(const TableView& table, Complaints& complaints) {
  const bool has_pairs = table.has("pairs_mm");
  const bool has_ratio = table.has("scale") || table.has("rotation_deg");
  if (has_pairs == has_ratio) {
    const std::string pairs = name_in(complaints.unit(), "pairs_mm");
    complaints.add(table.line(), "copy", has_pairs ? pairs + " beside scale or rotation_deg" : "nothing",
                   "scale and rotation_deg, or " + pairs);
    return {};
  }
  CopyReading reading = has_pairs ? read_copy_from_pairs(table, complaints) : read_copy_given(table);
  const char* key = has_pairs ? "pairs_mm" : table.has("scale") ? "scale" : "rotation_deg";
  if (complaints.none_about("copy")) check_ratio(table, reading.copy, key, complaints);
  return reading;
}

}  // namespace kempe
