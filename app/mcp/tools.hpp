#pragma once
// The tools that a server offers: which command each runs, with which of its options.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/command.hpp"
#include "app/mcp/served_folder.hpp"

namespace kempe::app {

struct ToolArgument {
  enum class Kind {
    spec,          ///< a spec's tables
    measurements,  ///< a measurements file's tables
    input,         ///< a path, and so are the next two
    output_file,
    output_folder,
    number,
    whole_number,  ///< from 0
    truth,
    place,  ///< [x, y]
    words   ///< a list of texts
  };
  std::string_view name;
  Kind kind;
  std::string_view option;  ///< of the command: "--fit", "SPEC"
  bool required = false;
  std::string_view choice = {};  ///< arguments with the same word: exactly one of them is given
  std::string_view words = {};   ///< for a person; empty: those of the option
};

struct Tool {
  std::string_view name, title, command;
  std::string_view does;    ///< for a person, a sentence without its full stop; empty: the command's
  std::string_view answer;  ///< what comes back
  std::vector<ToolArgument> arguments;
  bool writes;          ///< it may write files
  bool takes_limit;     ///< the command has --time-limit
  bool takes_threads;   ///< the command has --threads
  bool four_is_answer;  ///< exit code 4 is the command's answer, not its failure
};

std::span<const Tool> tools();
/// The tool of this name, or null.
const Tool* find_tool(std::string_view name);

/// What tools/list says of every tool; the words are those of the options of `program`.
nlohmann::ordered_json tool_list(CLI::App& program);

struct PathGiven {
  std::string key, path;
  PathUse use;
};

/// A call as a command line. `limit` and `threads` are the server's.
struct ToolRun {
  const Tool* tool = nullptr;
  std::vector<std::string> words;
  std::optional<GivenText> given;
  std::vector<PathGiven> paths;
  double limit = 0;  ///< s
};

/// The error holds every argument that is unknown, missing, of a wrong kind, or refused by the option of `program` that it stands
/// for.
tl::expected<ToolRun, InputError> tool_run(CLI::App& program, const Tool& tool,
                                           const nlohmann::ordered_json& arguments, double limit,
                                           int threads);

/// Why the files that the call names, or that those name in turn, may not be used; nothing if they may. Reads them.
std::optional<InputError> files_fault(const ToolRun& run);

}  // namespace kempe::app
