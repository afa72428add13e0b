#pragma once
// A command of the program: it declares its arguments and, once chosen, runs. To add one, write its file, declare it in
// all_commands.hpp and add its line there or in other_commands.cpp.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "app/session.hpp"
#include "kempe/input_error.hpp"

namespace kempe::app {

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
/// Bad input, every fault of it (those of a given text without lines): {"error": {"faults": [{"file", "line", "key", "found", "allowed"}, ...]}}.
int fail(const Session& session, const InputError& error);

/// The object that the latter prints.
std::string faults_json(const InputError& error);

/// Prints "kempe: MESSAGE" to stderr as a note, which changes nothing of the outcome.
void say(const std::string& message);

/// The text of an input file, or the one given in its place.
tl::expected<std::string, InputError> input_text(const Session& session, const std::string& file);

/// Prints a command's answer: `text` for people, or with --json `object`.
void answer(const Session& session, const std::string& text, const std::string& object);

/// JSON as text by lines, whatever bytes its texts hold.
std::string json_text(const nlohmann::ordered_json& object);

/// A number of an option: finite and from `lowest` to `highest`.
CLI::Validator number_between(double lowest, double highest);

/// The option -j of a command that searches.
CLI::Option* add_threads_option(CLI::App& command, int& threads);
/// A file's name as one word of a command that a shell reads: in single quotes where it has other characters than letters, digits and
/// . _ - / + , = @ %.
std::string shell_word(std::string_view text);
/// --seed, a whole number from 0 to 2^64 - 1.
CLI::Option* add_seed_option(CLI::App& command, std::uint64_t& seed, const std::string& description);

/// Prints to stdout, what could mislead on a terminal written out; a closed stdout makes the program end with `cannot_write`.
void print(const std::string& text);

}  // namespace kempe::app
