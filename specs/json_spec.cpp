#include "specs/json_spec.hpp"

#include <nlohmann/json.hpp>

#include "specs/text/json_text.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

tl::expected<void, std::string> append_toml(std::string& text, const Json& value) {
  if (value.is_boolean() || value.is_number()) {
    text += value.dump();
  } else if (value.is_string()) {
    text += value.dump(-1, ' ', true);  // JSON's escapes are TOML's
  } else if (value.is_array()) {
    text += "[";
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i > 0) text += ", ";
      if (auto done = append_toml(text, value[i]); !done) return done;
    }
    text += "]";
  } else if (value.is_object()) {
    text += "{";
    bool first = true;
    for (const auto& [key, entry] : value.items()) {
      text += first ? "" : ", ";
      first = false;
      text += Json(key).dump(-1, ' ', true) + " = ";
      if (auto done = append_toml(text, entry); !done) return done;
    }
    text += "}";
  } else {
    return tl::unexpected(std::string("null"));
  }
  return {};
}

}  // namespace

tl::expected<std::string, InputError> toml_from_json(const std::string& json, const std::string& name) {
  if (const auto sound = parse_json(json, name); !sound) return tl::unexpected(sound.error());
  const Json object = Json::parse(json, nullptr, false);  // once more, in the order of its keys
  if (!object.is_object())
    return tl::unexpected(
        InputError{name, 0, "", "JSON that is not an object", "a spec's tables, as one JSON object"});
  std::string text;
  for (const auto& [key, value] : object.items()) {
    text += Json(key).dump(-1, ' ', true) + " = ";
    if (const auto done = append_toml(text, value); !done)
      return tl::unexpected(
          InputError{name, 0, key, done.error(), "numbers, texts, truth values, lists and objects"});
    text += "\n";
  }
  return text;
}

}  // namespace kempe
