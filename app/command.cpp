#include "app/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <system_error>

#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {

CLI::App* add_command(CLI::App& program, Session& session, const std::string& name,
                      const std::string& description, const std::string& example) {
  CLI::App* command = program.add_subcommand(name, description);
  command->add_flag("--json", session.json, "Print one JSON object instead of text");
  command->add_flag("--quiet", session.quiet, "Show no progress");
  command->footer("Example:\n  " + example);
  return command;
}

namespace {

using Json = nlohmann::ordered_json;

std::string_view name(ExitCode code) {
  switch (code) {
    case no_design: return "none exists";
    case verification_failed: return "verification failed";
    case cannot_write: return "cannot write";
    case stopped:
    case interrupted: return "stopped";
    default: return "failed";
  }
}

/// What is not known is null.
Json json_of(const InputError& fault) {
  const auto known = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  return {{"file", known(fault.file)},
          {"line", fault.line > 0 ? Json(fault.line) : Json(nullptr)},
          {"key", known(fault.key)},
          {"found", fault.found},
          {"allowed", fault.allowed}};
}

/// Lines of a given text are not those of the message that it came in.
InputError as_given(const Session& session, InputError error) {
  if (!session.given) return error;
  const auto without_line = [&](InputError& fault) {
    if (fault.file == session.given->name) fault.line = 0;
  };
  without_line(error);
  for (InputError& other : error.others) without_line(other);
  return error;
}

}  // namespace

int fail(const Session& session, ExitCode code, const std::string& message) {
  if (session.json) print(json_text(Json{{"error", std::string(name(code))}, {"sentence", message}}));
  return fail_told(code, message);
}

int fail_unproven(const Session& session, const std::string& message) {
  if (session.json) print(json_text(Json{{"error", none_found}, {"sentence", message}, {"proven", false}}));
  return fail_told(stopped, message);
}

int fail(const Session& session, const InputError& told) {
  const InputError error = as_given(session, told);
  say(error.message());
  for (const InputError& other : error.others) say(other.message());
  if (session.json) print(faults_json(error));
  return bad_input;
}

std::string faults_json(const InputError& error) {
  Json faults = Json::array({json_of(error)});
  for (const InputError& other : error.others) faults.push_back(json_of(other));
  return json_text(Json{{"error", {{"faults", faults}}}});
}

int fail_told(ExitCode code, const std::string& message) {
  say(message);
  return code;
}

tl::expected<std::string, InputError> input_text(const Session& session, const std::string& file) {
  if (session.given && session.given->name == file) return session.given->text;
  return read_text_file(file);
}

void answer(const Session& session, const std::string& text, const std::string& object) {
  print(session.json ? object : text);
  if (session.json && session.both) std::fputs(printable_lines(text).c_str(), stderr);
}

void say(const std::string& message) {
  std::fprintf(stderr, "kempe: %s\n", printable_lines(message).c_str());
}

std::string json_text(const Json& object) {
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

CLI::Option* add_threads_option(CLI::App& command, int& threads) {
  return command
      .add_option("-j,--threads", threads, "Threads to search on, 1 to 256; left out: one for each core")
      ->check(CLI::Range(1, 256));
}

std::string shell_word(std::string_view text) {
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           std::string_view("._-/+,=@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

CLI::Option* add_seed_option(CLI::App& command, std::uint64_t& seed, const std::string& description) {
  const auto is_seed = [](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [read, fault] = std::from_chars(text.data(), end, value);
    if (fault == std::errc() && read == end) return {};
    return fmt::format("found {}; allowed: a whole number from 0 to 18446744073709551615", text);
  };
  return command.add_option("--seed", seed, description)->check(CLI::Validator(is_seed, "NUMBER"));
}

CLI::Validator number_between(double lowest, double highest) {
  const auto check = [lowest, highest](std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= lowest && value <= highest)
      return {};  // NaN is neither
    return fmt::format("found {}; allowed: a number from {:g} to {:g}", text, lowest, highest);
  };
  return {check, fmt::format("{:g} to {:g}", lowest, highest)};
}

void print(const std::string& text) {
  const std::string shown = printable_lines(text);
  std::fwrite(shown.data(), 1, shown.size(), stdout);
}

}  // namespace kempe::app
