#pragma once
// Every key of the spec with its kind, range and meaning, in one table: the reader checks by it, the schema
// and docs/spec.md are compared with it.

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kempe {

/// What the keys of a spec's lengths end in: "_mm", or with units = "in" at its top "_in".
enum class SpecUnit { mm, inch };

/// mm a unit.
double in_mm(SpecUnit unit);
/// "mm" or "in".
std::string_view name(SpecUnit unit);

/// What may stand after a key.
enum class KeyKind {
  number,         ///< a finite number within the range
  ratio,          ///< the same, or as text "a:b" (text/ratio.hpp)
  whole_number,   ///< an integer within the range
  truth,          ///< true or false
  choice,         ///< one of the words
  choices,        ///< a list of different words
  joint_choices,  ///< one of the words, or a table of them: default, V, A, B, C, X, Y
  text,           ///< any text, not empty
  numbers,        ///< a list of numbers, each within the range
  point,          ///< [x, y], each within the range
  sections,       ///< [[width, thickness], ...], each number within the range
  layer_range,    ///< [lowest, highest], whole numbers within the range, lowest <= highest
  link_layers,    ///< four whole numbers within the range, of VA, VB, ACX, BCY
  rings,          ///< a ring [[x, y], ...] or a list of rings
  rectangle,      ///< a table with the keys of "rectangle_mm", or [x, y, width, height]
  circle,         ///< a table with the keys of "circle_mm", or [x, y, radius]
  pairs           ///< [[[x, y], [x, y]], ...]: tracer, pen
};

/// The numbers allowed, in the key's own unit. Both ends belong to it unless left out.
struct KeyRange {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool without_lower = false, without_upper = false;

  bool contains(double value) const;
  /// "> 0 and <= 1000"; with `share` of both ends.
  std::string describe(double share = 1) const;
};

struct SpecKey {
  /// "copy"; empty for the keys at the top; the inline tables count as "rectangle_mm" and "circle_mm"
  std::string_view table;
  std::string_view name;  ///< "scale"; a length's ends in _mm, an angle's in _deg
  KeyKind kind;
  KeyRange range;
  std::string_view words;     ///< of choice, choices and joint_choices, separated by '|'
  bool required;              ///< once its table is there
  std::string_view fallback;  ///< the value if it is left out, as it would be written; empty: none
  std::string_view example;   ///< a value as it would be written
  std::string_view meaning;   ///< for a person, without a full stop
};

/// All keys, table by table in the order of the documentation.
std::span<const SpecKey> spec_keys();

/// The rule for a key, or null.
const SpecKey* find_spec_key(std::string_view table, std::string_view name);

/// The tables at the top level of a spec, in the order of the documentation.
std::span<const std::string_view> spec_tables();

std::vector<std::string_view> words_of(const SpecKey& key);

/// What may stand there, for a person: "a number > 0 and <= 1000 mm", of a spec in inches "a number > 0 and <= 39.3701 in".
std::string describe_allowed(const SpecKey& key, SpecUnit unit = SpecUnit::mm);
/// True of lengths and lists of them: the key's values are in the spec's unit.
bool is_length(const SpecKey& key);

/// Most layers a linkage may have.
inline constexpr int most_layers = 8;

}  // namespace kempe
