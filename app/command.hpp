#pragma once
// A command of the program: it declares its arguments and, once chosen, runs. To add one, write its file and add a
// line to all_commands.hpp.

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "kempe/input_error.hpp"

namespace kempe::app {

enum ExitCode : int {
  done = 0,
  failed = 1,
  bad_input = 2,
  no_design = 3,  ///< none exists
  verification_failed = 4,
  cannot_write = 5,
  stopped = 6,  ///< by a limit of time or work, before an answer: nothing found, nothing proven
  interrupted = 130
};

/// What every command shares: the options --json and --quiet, and the run that the arguments chose.
struct Session {
  bool json = false;
  bool quiet = false;
  std::function<int()> chosen;  ///< set by the sub-command's callback; returns an ExitCode
};

/// Adds a sub-command with the shared options; `example` closes its --help.
CLI::App* add_command(CLI::App& program, Session& session, const std::string& name,
                      const std::string& description, const std::string& example);

/// Prints "kempe: MESSAGE" to stderr and, with --json, one object to stdout; returns the code. For a command that has
/// printed nothing yet.
int fail(const Session& session, ExitCode code, const std::string& message);
/// The verdict on a search that ended without a design and without a proof that there is none.
inline constexpr const char* none_found = "no design was found";
/// The same for that verdict, with `proven` false in the object: a search says nothing about what it did not find. Returns `stopped`.
int fail_unproven(const Session& session, const std::string& message);
/// Bad input, every fault of it: {"error": {"faults": [{"file", "line", "key", "found", "allowed"}, ...]}}.
int fail(const Session& session, const InputError& error);

/// The object that the latter prints.
std::string faults_json(const InputError& error);

/// Prints "kempe: MESSAGE" to stderr and returns the code: for a command that has printed its answer.
int fail_told(ExitCode code, const std::string& message);

/// The same as a note, which changes nothing of the outcome.
void say(const std::string& message);

/// JSON as text by lines, whatever bytes its texts hold.
std::string json_text(const nlohmann::ordered_json& object);

/// A number of an option: finite and from `lowest` to `highest`.
CLI::Validator number_between(double lowest, double highest);

/// The option -j of a command that searches.
CLI::Option* add_threads_option(CLI::App& command, int& threads);

/// Prints to stdout, what could mislead on a terminal written out; a closed stdout makes the program end with `cannot_write`.
void print(const std::string& text);

}  // namespace kempe::app
