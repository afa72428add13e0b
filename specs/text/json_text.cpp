#include "specs/text/json_text.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

namespace kempe {
namespace {

using nlohmann::json;

/// Reads over the text once and stops at the first fault.
class FaultFinder : public json::json_sax_t {
 public:
  struct Fault {
    std::size_t place;  ///< byte from 1; 0: unknown
    std::string found, allowed;
  };
  const std::optional<Fault>& fault() const { return fault_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool number_float(double, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(json::binary_t&) override { return true; }

  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool start_object(std::size_t) override {
    keys_.emplace_back();
    return enter();
  }
  bool end_object() override {
    keys_.pop_back();
    return leave();
  }
  bool key(std::string& name) override {
    return keys_.back().insert(name).second ||
           refuse(0, "the key \"" + name + "\" twice in one object", "it once");
  }
  bool parse_error(std::size_t place, const std::string&, const nlohmann::detail::exception& error) override {
    return refuse(place, cause_of(error), "JSON");
  }

 private:
  static constexpr int deepest = 64;

  bool enter() {
    return ++depth_ <= deepest || refuse(0, "values nested deeper than 64", "at most 64 levels");
  }
  bool leave() {
    --depth_;
    return true;
  }
  bool refuse(std::size_t place, std::string found, std::string allowed) {
    if (!fault_) fault_ = Fault{place, std::move(found), std::move(allowed)};
    return false;
  }
  /// The library's sentence without its "[json.exception...] parse error at line ...: " in front.
  static std::string cause_of(const std::exception& error) {
    const std::string sentence = error.what();
    const std::size_t bracket = sentence.find("] "), colon = sentence.find(": ");
    const std::size_t start = colon != std::string::npos ? colon : bracket;
    return start == std::string::npos ? sentence : sentence.substr(start + 2, 200);
  }

  std::vector<std::set<std::string>> keys_;
  int depth_ = 0;
  std::optional<Fault> fault_;
};

int line_of_place(std::string_view text, std::size_t place) {
  if (place == 0) return 0;
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(place - 1, text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

}  // namespace

tl::expected<nlohmann::json, InputError> parse_json(std::string_view text, const std::string& file_name) {
  if (text.empty()) return tl::unexpected(InputError{file_name, 0, "", "an empty file", "JSON"});
  FaultFinder finder;
  if (!json::sax_parse(text.begin(), text.end(), &finder)) {
    const auto fault = finder.fault().value_or(FaultFinder::Fault{0, "a text that cannot be parsed", "JSON"});
    return tl::unexpected(
        InputError{file_name, line_of_place(text, fault.place), "", fault.found, fault.allowed});
  }
  return json::parse(text.begin(), text.end(), nullptr, false);
}

}  // namespace kempe
