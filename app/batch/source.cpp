// A sweep is a spec with axes, each a key of the spec and the values that it takes:
//
//   {"spec": {"copy": {"rotation_deg": 90}, ...}, "axes": [{"key": "copy.scale", "values": [0.5, 1.4, 2]}, ...]}
//
// Its cells are numbered like the digits of a number whose last axis counts the units: cell i has, of an axis with n values
// before which axes with m values in all combinations count, the value (i / m) mod n. So any cell is made from its number alone.

#include "app/batch/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "specs/text/json_text.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The names of a folder's specs; their texts stay on the disk.
class FolderSource : public BatchSource {
 public:
  explicit FolderSource(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_, error))
      if (entry.path().extension() == ".toml") names_.push_back(entry.path().filename().string());
    std::sort(names_.begin(), names_.end());
  }

  std::int64_t size() const override { return std::ssize(names_); }

  BatchTask task(std::int64_t number) override {
    const std::string& name = names_[static_cast<std::size_t>(number)];
    const fs::path file = folder_ / name;
    return {name, read_text_file(file), file.string(), folder_.string(), false};
  }

  std::optional<BatchTask> named(const std::string& name) override {
    const auto place = std::lower_bound(names_.begin(), names_.end(), name);
    if (place == names_.end() || *place != name) return std::nullopt;
    return task(place - names_.begin());
  }

  std::vector<fs::path> inputs() const override {
    std::vector<fs::path> files;
    for (const std::string& name : names_) files.push_back(folder_ / name);
    return files;
  }

 private:
  fs::path folder_;
  std::vector<std::string> names_;
};

/// The lines of a file, read on from the one handed out last.
class LineSource : public BatchSource {
 public:
  explicit LineSource(fs::path file) : file_(std::move(file)) {
    rewind();
    while (read_on()) ++size_;
    rewind();
  }

  std::int64_t size() const override { return size_; }

  BatchTask task(std::int64_t number) override {
    if (number < next_) rewind();
    bool is_there = true;
    while (is_there && next_ <= number) is_there = read_on();
    const std::string folder = file_.parent_path().string();
    if (is_there) return {fmt::format("line-{}", line_number_), line_, file_.string(), folder, true};
    const InputError shorter{file_.string(), 0, "", "a file that became shorter meanwhile", "one that stays"};
    return {fmt::format("task-{}", number + 1), tl::unexpected(shorter), file_.string(), folder, true};
  }

  std::optional<BatchTask> named(const std::string& name) override {
    for (std::int64_t number = 0; number < size_; ++number)
      if (BatchTask one = task(number); one.name == name) return one;
    return std::nullopt;
  }

  std::vector<fs::path> inputs() const override { return {file_}; }

 private:
  void rewind() {
    stream_ = std::ifstream(file_, std::ios::binary);
    line_number_ = next_ = 0;
  }

  /// The next line that is not empty.
  bool read_on() {
    while (std::getline(stream_, line_)) {
      ++line_number_;
      if (line_.find_first_not_of(" \t\r") == std::string::npos) continue;
      ++next_;
      return true;
    }
    return false;
  }

  fs::path file_;
  std::ifstream stream_;
  std::string line_;
  std::int64_t line_number_ = 0;  ///< of `line_`, from 1
  std::int64_t next_ = 0;         ///< the task after `line_`
  std::int64_t size_ = 0;
};

struct Axis {
  std::string key;
  std::vector<std::string> path;  ///< the key's words
  Json values;
};

/// Every combination of the values of some axes, put into one spec.
class SweepSource : public BatchSource {
 public:
  SweepSource(fs::path file, Json spec, std::vector<Axis> axes, std::int64_t size)
      : file_(std::move(file)), spec_(std::move(spec)), axes_(std::move(axes)), size_(size) {}

  std::int64_t size() const override { return size_; }

  BatchTask task(std::int64_t number) override {
    Json spec = spec_;
    std::string name;
    for (auto axis = axes_.rbegin(); axis != axes_.rend(); ++axis) {
      const auto count = static_cast<std::int64_t>(axis->values.size());
      const auto place = static_cast<std::size_t>(number % count);
      number /= count;
      Json* at = &spec;
      for (const std::string& word : axis->path) at = &(*at)[word];
      *at = axis->values[place];
      name.insert(0, fmt::format("-{}", place + 1));
    }
    return {"cell" + name, spec.dump(), file_.string(), file_.parent_path().string(), true};
  }

  std::optional<BatchTask> named(const std::string& name) override {
    std::int64_t number = 0;
    std::string_view rest = name;
    for (const Axis& axis : axes_) {
      rest.remove_prefix(std::min(rest.size(), rest.find('-') + 1));
      std::size_t place = 0;
      std::from_chars(rest.data(), rest.data() + rest.size(), place);
      if (place < 1 || place > axis.values.size()) return std::nullopt;
      number = number * std::ssize(axis.values) + static_cast<std::int64_t>(place) - 1;
    }
    BatchTask one = task(number);
    return one.name == name ? std::optional(std::move(one)) : std::nullopt;
  }

  std::vector<fs::path> inputs() const override { return {file_}; }

 private:
  fs::path file_;
  Json spec_;
  std::vector<Axis> axes_;
  std::int64_t size_;
};

/// Reads a sweep's file; stops at its first fault.
class SweepReader {
 public:
  explicit SweepReader(std::string file) : file_(std::move(file)) {}

  tl::expected<std::unique_ptr<BatchSource>, InputError> read() const {
    const auto text = read_text_file(file_);
    if (!text) return tl::unexpected(text.error());
    if (const auto sound = parse_json(*text, file_); !sound) return tl::unexpected(sound.error());
    const Json sweep = Json::parse(*text);  // once more, in the order of its keys
    if (!sweep.is_object() || !sweep.contains("spec") || !sweep["spec"].is_object() ||
        !sweep.contains("axes") || !sweep["axes"].is_array() || sweep.size() != 2)
      return fault("", "no sweep",
                   "an object with \"spec\" (an object) and \"axes\" (a list) alone; specs a line stand in a "
                   ".jsonl file");
    std::vector<Axis> axes;
    std::int64_t size = 1;
    for (const Json& entry : sweep["axes"]) {
      const auto axis = read_axis(entry, sweep["spec"], axes, fmt::format("axes[{}]", axes.size() + 1));
      if (!axis) return tl::unexpected(axis.error());
      axes.push_back(*axis);
      const auto count = static_cast<std::int64_t>(axis->values.size());
      if (count > most / size) return fault("axes", fmt::format("more than {} cells", most), "fewer");
      size *= count;
    }
    return std::make_unique<SweepSource>(file_, sweep["spec"], axes, size);
  }

 private:
  static constexpr std::int64_t most = 1'000'000'000;

  tl::unexpected<InputError> fault(const std::string& key, const std::string& found,
                                   const std::string& allowed) const {
    return tl::unexpected(InputError{file_, 0, key, found, allowed});
  }

  tl::expected<Axis, InputError> read_axis(const Json& entry, const Json& spec,
                                           const std::vector<Axis>& before, const std::string& where) const {
    if (!entry.is_object() || entry.size() != 2 || !entry.contains("key") || !entry["key"].is_string() ||
        !entry.contains("values") || !entry["values"].is_array() || entry["values"].empty())
      return fault(where, "no axis",
                   "an object with \"key\" (a text) and \"values\" (a list, not empty) alone");
    Axis axis{entry["key"], words_of(entry["key"]), entry["values"]};
    if (std::find(axis.path.begin(), axis.path.end(), "") != axis.path.end())
      return fault(where + ".key", '"' + axis.key + '"', "a key of the spec, as in \"copy.scale\"");
    for (const Axis& other : before)
      if ((axis.key + ".").starts_with(other.key + ".") || (other.key + ".").starts_with(axis.key + "."))
        return fault(where + ".key", '"' + axis.key + "\" besides \"" + other.key + '"',
                     "keys none of which holds another");
    const Json* at = &spec;
    for (std::size_t i = 0; i + 1 < axis.path.size() && at->contains(axis.path[i]); ++i) {
      at = &(*at)[axis.path[i]];
      if (!at->is_object())
        return fault(where + ".key", '"' + axis.key + "\" where \"" + axis.path[i] + "\" is no table",
                     "a key of the spec");
    }
    return axis;
  }

  static std::vector<std::string> words_of(const std::string& key) {
    std::vector<std::string> words(1);
    for (const char c : key)
      if (c == '.')
        words.emplace_back();
      else
        words.back() += c;
    return words;
  }

  std::string file_;
};

}  // namespace

tl::expected<std::unique_ptr<BatchSource>, InputError> BatchSource::open(const std::string& source) {
  std::error_code error;
  if (fs::is_directory(source, error)) return std::make_unique<FolderSource>(source);
  if (!fs::is_regular_file(source, error))
    return tl::unexpected(InputError{source, 0, "--batch", "neither a folder nor a file",
                                     "a folder of *.toml, a .jsonl file, or a sweep (.json)"});
  if (fs::path(source).extension() == ".json") return SweepReader(source).read();
  return std::make_unique<LineSource>(source);
}

}  // namespace kempe::app
