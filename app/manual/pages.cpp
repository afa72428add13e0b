#include "app/manual/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kempe::app {
namespace {

/// Text as man(7) takes it: hyphens that a reader may copy, and no line that begins like a request.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
      out += std::string("\\&") + c;
    } else {
      out += c;
    }
  }
  return out;
}

std::string head(const std::string& name, const std::string& purpose, const std::string& version) {
  std::string title = name;
  for (char& c : title)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return fmt::format(".TH {} 1 \"\" \"Kempe {}\" \"Kempe\"\n.SH NAME\n{} \\- {}\n", roff(title), version,
                     roff(name), roff(purpose));
}

/// "-o,--output FOLDER"
std::string label(const OptionWords& option) {
  if (!option.name.empty()) return option.name;
  std::vector<std::string> names;
  for (const std::string& name : option.short_names) names.push_back("-" + name);
  for (const std::string& name : option.long_names) names.push_back("--" + name);
  return fmt::format("{}{}{}", fmt::join(names, ", "), option.value.empty() ? "" : " ", option.value);
}

std::string options_section(const CommandWords& command) {
  std::string text = ".SH OPTIONS\n";
  for (const OptionWords& option : command.options)
    text += fmt::format(".TP\n.B {}\n{}{}\n", roff(label(option)), roff(option.meaning),
                        option.fallback.empty() ? "" : roff(fmt::format(" (left out: {})", option.fallback)));
  return text;
}

std::string synopsis(const CommandWords& command) {
  std::string text = ".SH SYNOPSIS\n.B kempe " + roff(command.name) + "\n";
  for (const OptionWords& option : command.options)
    if (!option.name.empty())
      text += option.required ? roff(option.name) + "\n" : "[" + roff(option.name) + "]\n";
  return text + "[options]\n";
}

constexpr const char* exit_codes =
    ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n2\nbad input\n.TP\n3\nno design exists; of a linkage, "
    "no such position\n.TP\n4\na verification "
    "failed\n.TP\n5\nthe output cannot be written\n.TP\n6\nstopped by a limit of time or work, without an "
    "answer: none was found, and it is not proven that none exists\n.TP\n130\nstopped by "
    "Ctrl\\-C\n.TP\n1\nanything else\n";

}  // namespace

std::string program_page(const std::vector<CommandWords>& words, const std::string& version) {
  std::string text = head("kempe", "design linkages that copy drawings", version);
  text += ".SH SYNOPSIS\n.B kempe\nCOMMAND [arguments]\n.SH DESCRIPTION\n" + roff(words.front().purpose) +
          "\n.SH COMMANDS\n";
  for (std::size_t i = 1; i < words.size(); ++i)
    text += fmt::format(".TP\n.BR kempe\\-{} (1)\n{}\n", roff(words[i].name), roff(words[i].purpose));
  return text + options_section(words.front()) + exit_codes;
}

std::string command_page(const CommandWords& command, const std::string& version) {
  return head("kempe-" + command.name, command.purpose, version) + synopsis(command) +
         options_section(command) +
         fmt::format(".SH EXAMPLE\n.EX\n{}\n.EE\n.SH SEE ALSO\n.BR kempe (1)\n", roff(command.example));
}

}  // namespace kempe::app
