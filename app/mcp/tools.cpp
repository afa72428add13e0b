#include "app/mcp/tools.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>

#include "specs/json_spec.hpp"
#include "specs/key_checks.hpp"
#include "specs/measurements.hpp"
#include "specs/spec_keys.hpp"
#include "specs/spec_reader.hpp"
#include "specs/spec_schema.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

using Json = nlohmann::ordered_json;
using Kind = ToolArgument::Kind;

constexpr const char* limit_name = "time_limit_s";
constexpr std::string_view a_spec = "The spec's tables and keys, as in docs/spec.md";
constexpr std::string_view a_given_mechanism =
    "The spec's tables and keys, those of the tool design, with a mechanism";
constexpr std::string_view a_spec_file = "The same as a file (TOML; see docs/spec.md)";

const std::vector<Tool>& all_tools() {
  static const std::vector<Tool> all{
      {"design",
       "Design a copying linkage",
       "synthesize",
       "",
       "The answer has lengths, layers, figures and the proven bound; without a design it says whether it is "
       "proven that none "
       "exists, what is in the way, and the least change of each single limit that is enough.",
       {{"spec", Kind::spec, "SPEC", false, "spec", a_spec},
        {"spec_file", Kind::input, "SPEC", false, "spec", a_spec_file},
        {"folder", Kind::output_folder, "--output", true},
        {"seed", Kind::whole_number, "--seed"},
        {"map_tolerance", Kind::number, "--map-tolerance"}},
       true,
       true,
       true,
       false},
      {"map",
       "Map a given mechanism",
       "workspace",
       "",
       "The answer says whether the tracer covers the region without contact, and if not, which parts are in "
       "the way.",
       {{"spec", Kind::spec, "SPEC", false, "spec", a_given_mechanism},
        {"spec_file", Kind::input, "SPEC", false, "spec", a_spec_file},
        {"folder", Kind::output_folder, "--output", true},
        {"map_tolerance", Kind::number, "--map-tolerance"}},
       true,
       true,
       false,
       false},
      {"explain",
       "Explain one place",
       "workspace",
       "Say why the tracer can or cannot stand at a place",
       "The answer names the limit, the figures and the two parts that decide. The mechanism is that of a "
       "spec, or of the "
       "design.json that design and map write. No file is written.",
       {{"spec", Kind::spec, "SPEC", false, "spec", a_given_mechanism},
        {"spec_file", Kind::input, "SPEC", false, "spec", a_spec_file},
        {"design_file", Kind::input, "SPEC", false, "spec", "A design.json"},
        {"at", Kind::place, "--why", true, {}, "The place, [x, y] in mm"}},
       false,
       true,
       false,
       false},
      {"verify",
       "Verify a design",
       "verify",
       "",
       "The answer names everything that the file states and that does not hold.",
       {{"design_file", Kind::input, "DESIGN", true}},
       false,
       false,
       false,
       true},
      {"trace",
       "Copy a drawing",
       "trace",
       "",
       "The answer says how much was drawn, and for what is left out the cause.",
       {{"design_file", Kind::input, "DESIGN", true},
        {"drawing_file", Kind::input, "DRAWING", true},
        {"copy_file", Kind::output_file, "--output", true},
        {"fit", Kind::truth, "--fit"},
        {"at", Kind::place, "--at"},
        {"scale", Kind::number, "--scale"},
        {"load", Kind::truth, "--load"},
        {"instrument", Kind::whole_number, "--instrument"},
        {"tolerance_mm", Kind::number, "--tolerance"},
        {"step_mm", Kind::number, "--step"},
        {"csv_file", Kind::output_file, "--csv"},
        {"forces_file", Kind::output_file, "--forces"}},
       true,
       false,
       false,
       true},
      {"calibrate",
       "Calibrate an instrument",
       "calibrate",
       "",
       "The answer has the errors found with their uncertainty, what to set, and what is left.",
       {{"measurements", Kind::measurements, "MEASUREMENTS", false, "measurements",
         "Instrument and readings: the tables and keys of docs/calibration.md, such as instrument and "
         "reading"},
        {"measurements_file", Kind::input, "MEASUREMENTS", false, "measurements",
         "The same as a file (TOML; see docs/calibration.md)"},
        {"folder", Kind::output_folder, "--output"},
        {"target_mm", Kind::number, "--target-mm"},
        {"equations", Kind::truth, "--equations"},
        {"ratios", Kind::words, "--ratios"},
        {"plan", Kind::truth, "--plan"},
        {"plan_readings", Kind::whole_number, "--plan-readings"}},
       true,
       false,
       false,
       false}};
  return all;
}

bool is_path(Kind kind) {
  return kind == Kind::input || kind == Kind::output_file || kind == Kind::output_folder;
}

std::string allowed(Kind kind) {
  switch (kind) {
    case Kind::spec: return "an object with a spec's tables";
    case Kind::measurements: return "an object with a measurements file's tables";
    case Kind::input:
    case Kind::output_file:
    case Kind::output_folder: return "a text, the path from the served folder";
    case Kind::number: return "a number";
    case Kind::whole_number: return "a whole number from 0";
    case Kind::truth: return "true or false";
    case Kind::place: return "[x, y], two numbers";
    case Kind::words: return "a list of texts without commas";
  }
  return {};
}

bool fits(Kind kind, const Json& value) {
  const auto is_word = [](const Json& one) {
    return one.is_string() && one.get_ref<const std::string&>().find(',') == std::string::npos;
  };
  switch (kind) {
    case Kind::spec:
    case Kind::measurements: return value.is_object();
    case Kind::input:
    case Kind::output_file:
    case Kind::output_folder: return value.is_string();
    case Kind::number: return value.is_number();
    case Kind::whole_number: return value.is_number_unsigned();
    case Kind::truth: return value.is_boolean();
    case Kind::place:
      return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
    case Kind::words:
      return value.is_array() && !value.empty() && std::all_of(value.begin(), value.end(), is_word);
  }
  return false;
}

Json schema_of(const Tool& tool, Kind kind) {
  switch (kind) {
    case Kind::spec: {
      // All keys once: a model reads the list of all tools at once, and pays for every word of it.
      std::vector<std::string_view> outlined;
      if (tool.name != "design")
        std::copy_if(spec_tables().begin(), spec_tables().end(), std::back_inserter(outlined),
                     [](std::string_view table) { return table != "mechanism"; });
      Json schema = spec_schema(outlined);
      schema.erase("$schema");
      return schema;
    }
    case Kind::measurements: return {{"type", "object"}};
    case Kind::input:
    case Kind::output_file:
    case Kind::output_folder: return {{"type", "string"}, {"minLength", 1}};
    case Kind::number: return {{"type", "number"}};
    case Kind::whole_number: return {{"type", "integer"}, {"minimum", 0}};
    case Kind::truth: return {{"type", "boolean"}};
    case Kind::place:
      return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
    case Kind::words: return {{"type", "array"}, {"items", {{"type", "string"}}}, {"minItems", 1}};
  }
  return {};
}

/// "one of spec, spec_file is required" for arguments of a choice.
std::string choice_sentence(const Tool& tool, const ToolArgument& argument) {
  if (argument.choice.empty()) return "";
  std::vector<std::string_view> names;
  for (const ToolArgument& other : tool.arguments)
    if (other.choice == argument.choice) names.push_back(other.name);
  return fmt::format("give exactly one of {}", fmt::join(names, ", "));
}

/// The option that an argument stands for. There is one.
CLI::Option* option_of(CLI::App& command, const ToolArgument& argument) {
  for (CLI::Option* option : command.get_options(nullptr))
    if (option->check_name(std::string(argument.option)) || option->get_name(true) == argument.option)
      return option;
  throw std::logic_error("a tool's argument without an option: " + std::string(argument.name));
}

std::string description_of(CLI::App& command, const Tool& tool, const ToolArgument& argument) {
  std::string text(argument.words);
  if (text.empty()) text = option_of(command, argument)->get_description();
  if (is_path(argument.kind)) text += "; a path from the served folder";
  if (const std::string choice = choice_sentence(tool, argument); !choice.empty()) text += "; " + choice;
  return text;
}

Json listed(CLI::App& program, const Tool& tool) {
  CLI::App* command = program.get_subcommand(std::string(tool.command));
  Json properties = Json::object(), required = Json::array();
  for (const ToolArgument& argument : tool.arguments) {
    Json schema = schema_of(tool, argument.kind);
    schema["description"] = description_of(*command, tool, argument);
    properties[std::string(argument.name)] = std::move(schema);
    if (argument.required) required.push_back(argument.name);
  }
  if (tool.takes_limit)
    properties[limit_name] = {{"type", "number"},
                              {"exclusiveMinimum", 0},
                              {"description", command->get_option("--time-limit")->get_description()}};
  return {{"name", tool.name},
          {"title", tool.title},
          {"description", (tool.does.empty() ? command->get_description() : std::string(tool.does)) + ". " +
                              std::string(tool.answer)},
          {"inputSchema",
           {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)},
            {"additionalProperties", false}}},
          {"annotations",
           {{"readOnlyHint", !tool.writes}, {"destructiveHint", tool.writes}, {"openWorldHint", false}}}};
}

/// What stands there, for a message.
std::string shown(const Json& value) {
  return printable(value.dump(-1, ' ', false, Json::error_handler_t::replace), 100);
}

/// Faults, the first with the others.
class ArgumentFaults {
 public:
  void add(InputError fault) { made_.push_back(std::move(fault)); }
  void add(std::string_view key, std::string found, std::string allowed_there) {
    add({"", 0, std::string(key), std::move(found), std::move(allowed_there)});
  }
  bool none() const { return made_.empty(); }
  InputError all() const {
    InputError first = made_.front();
    first.others.assign(made_.begin() + 1, made_.end());
    return first;
  }

 private:
  std::vector<InputError> made_;
};

void check_names(const Tool& tool, const Json& arguments, ArgumentFaults& faults) {
  std::vector<std::string_view> known;
  for (const ToolArgument& argument : tool.arguments) known.push_back(argument.name);
  if (tool.takes_limit) known.emplace_back(limit_name);
  for (const auto& [name, value] : arguments.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      faults.add(printable(name, 60), "an argument that is not known",
                 known_instead(std::string_view(name).substr(0, 60), known, "argument"));
}

void check_choices(const Tool& tool, const Json& arguments, ArgumentFaults& faults) {
  std::map<std::string_view, int> given;
  for (const ToolArgument& argument : tool.arguments)
    if (!argument.choice.empty()) given[argument.choice] += arguments.contains(argument.name) ? 1 : 0;
  for (const ToolArgument& argument : tool.arguments) {
    const auto count = given.find(argument.choice);
    if (argument.choice.empty() || count == given.end() || count->second == 1) continue;
    faults.add(argument.name, count->second == 0 ? "nothing" : "more than one of them",
               choice_sentence(tool, argument));
    given.erase(count);
  }
}

std::vector<CLI::Validator*> validators_of(CLI::Option& option) {
  std::vector<CLI::Validator*> all;
  try {
    for (int i = 0;; ++i) all.push_back(option.get_validator(i));
  } catch (const CLI::OptionNotFound&) {  // there is no other way to ask how many there are
  }
  return all;
}

/// What the option's own checks say to numbers: "found 7; allowed: a number from 0 to 1", or words of CLI11.
void check_numbers(CLI::App& command, const ToolArgument& argument, const Json& value,
                   ArgumentFaults& faults) {
  if (argument.kind != Kind::number && argument.kind != Kind::whole_number && argument.kind != Kind::place)
    return;
  CLI::Option* option = option_of(command, argument);
  for (const Json& number : value.is_array() ? value : Json::array({value}))
    for (CLI::Validator* check : validators_of(*option)) {
      std::string text = number.dump();
      const std::string said = (*check)(text);
      if (said.empty()) continue;
      constexpr std::string_view before = "; allowed: ";
      const std::size_t at = said.find(before);
      return faults.add(argument.name, shown(number),
                        at == std::string::npos ? said : said.substr(at + before.size()));
    }
}

/// An argument's part of the command line. Values stand behind "=", so that none is taken for an option.
void add_words(const ToolArgument& argument, const Json& value, ToolRun& run, std::vector<std::string>& last,
               ArgumentFaults& faults) {
  const std::string option(argument.option), name(argument.name);
  const bool positional = !option.starts_with("-");
  const auto put = [&](const std::string& text) {
    if (positional)
      last.push_back(text);
    else
      run.words.push_back(option + "=" + text);
  };
  switch (argument.kind) {
    case Kind::spec:
    case Kind::measurements: {
      auto toml = toml_from_json(value.dump(-1, ' ', false, Json::error_handler_t::replace), name);
      if (!toml) {
        toml.error().line = 0;
        return faults.add(toml.error());
      }
      run.given = GivenText{name, std::move(*toml)};
      return put(name);
    }
    case Kind::input:
    case Kind::output_file:
    case Kind::output_folder: {
      const PathUse use = argument.kind == Kind::input         ? PathUse::input
                          : argument.kind == Kind::output_file ? PathUse::output_file
                                                               : PathUse::output_folder;
      run.paths.push_back({name, value.get<std::string>(), use});
      return put(value.get<std::string>());
    }
    case Kind::number:
    case Kind::whole_number: return put(value.dump());
    case Kind::truth:
      if (value.get<bool>()) run.words.push_back(option);
      return;
    case Kind::place:
      if (option == "--why") return put(value[0].dump() + "," + value[1].dump());
      run.words.insert(run.words.end(), {option, value[0].dump(), value[1].dump()});
      return;
    case Kind::words: {
      std::vector<std::string> all = value.get<std::vector<std::string>>();
      return put(fmt::format("{}", fmt::join(all, ",")));
    }
  }
}

/// Why a file that an input's text names may not be read, or nothing.
std::optional<InputError> named_file_fault(const Tool& tool, const std::string& text,
                                           const std::string& file) {
  if (tool.command == "calibrate") {
    const auto measurements = read_measurements(text, file);
    if (!measurements || measurements->design.empty()) return std::nullopt;
    return named_path_fault("design", file, measurements->design);
  }
  const auto drawing = region_file_of(text);
  return drawing ? named_path_fault("region.file", file, *drawing) : std::nullopt;
}

}  // namespace

std::span<const Tool> tools() { return all_tools(); }

const Tool* find_tool(std::string_view name) {
  const auto all = tools();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Tool& tool) { return tool.name == name; });
  return found == all.end() ? nullptr : &*found;
}

nlohmann::ordered_json tool_list(CLI::App& program) {
  Json list = Json::array();
  for (const Tool& tool : tools()) list.push_back(listed(program, tool));
  return list;
}

tl::expected<ToolRun, InputError> tool_run(CLI::App& program, const Tool& tool, const Json& arguments,
                                           double limit, int threads) {
  ArgumentFaults faults;
  ToolRun run{&tool, {"kempe", std::string(tool.command), "--json", "--quiet"}, {}, {}, limit};
  std::vector<std::string> last{"--"};  // the positional words
  check_names(tool, arguments, faults);
  check_choices(tool, arguments, faults);
  for (const ToolArgument& argument : tool.arguments) {
    const auto value = arguments.find(argument.name);
    if (value == arguments.end()) {
      if (argument.required) faults.add(argument.name, "nothing", allowed(argument.kind));
    } else if (!fits(argument.kind, *value)) {
      faults.add(argument.name, shown(*value), allowed(argument.kind));
    } else {
      check_numbers(*program.get_subcommand(std::string(tool.command)), argument, *value, faults);
      add_words(argument, *value, run, last, faults);
    }
  }
  if (const auto wish = arguments.find(limit_name); tool.takes_limit && wish != arguments.end()) {
    if (wish->is_number() && wish->get<double>() > 0)
      run.limit = std::min(limit, wish->get<double>());
    else
      faults.add(limit_name, shown(*wish), "a number of seconds above 0");
  }
  if (!faults.none()) return tl::unexpected(faults.all());
  if (tool.takes_limit) run.words.push_back(fmt::format("--time-limit={}", run.limit));
  if (tool.takes_threads) run.words.push_back(fmt::format("--threads={}", threads));
  run.words.insert(run.words.end(), last.begin(), last.end());
  return run;
}

std::optional<InputError> files_fault(const ToolRun& run) {
  ArgumentFaults faults;
  for (const PathGiven& path : run.paths)
    if (auto fault = path_fault(path.key, path.path, path.use)) faults.add(std::move(*fault));
  if (!faults.none()) return faults.all();
  if (run.given) return named_file_fault(*run.tool, run.given->text, run.given->name);
  // Every input, whatever its argument is called: a command takes a spec where a design.json is asked for. What cannot be read the
  // command itself refuses.
  for (const PathGiven& path : run.paths) {
    if (path.use != PathUse::input) continue;
    const auto text = read_text_file(path.path);
    if (!text) continue;
    if (auto fault = named_file_fault(*run.tool, *text, path.path)) return fault;
  }
  return std::nullopt;
}

}  // namespace kempe::app
