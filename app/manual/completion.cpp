#include "app/manual/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kempe::app {
namespace {

/// In single quotes, for a shell; a quote inside as the given text.
std::string quoted(std::string_view text, std::string_view quote) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'')
      out += quote;
    else
      out += c;
  }
  return out + "'";
}

/// For bash and zsh the string ends, a quote follows, and it goes on.
std::string posix_quoted(std::string_view text) { return quoted(text, "'\\''"); }
std::string fish_quoted(std::string_view text) { return quoted(text, "\\'"); }

std::vector<std::string> flags_of(const CommandWords& command) {
  std::vector<std::string> flags;
  for (const OptionWords& option : command.options) {
    for (const std::string& name : option.long_names) flags.push_back("--" + name);
    for (const std::string& name : option.short_names) flags.push_back("-" + name);
  }
  return flags;
}

std::vector<std::string> names_of(const std::vector<CommandWords>& words) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < words.size(); ++i) names.push_back(words[i].name);
  return names;
}

/// What _describe of zsh takes: colons in names end them, so none may stand there unescaped.
std::string zsh_entry(const std::string& name, const std::string& meaning) {
  return posix_quoted(name + ":" + meaning);
}

}  // namespace

std::string bash_completion(const std::vector<CommandWords>& words) {
  std::string text =
      "# Completion of kempe for bash, made from the program's own help.\n"
      "_kempe() {\n"
      "  local word=\"${COMP_WORDS[COMP_CWORD]}\" options\n"
      "  case \"${COMP_WORDS[1]}\" in\n";
  for (std::size_t i = 1; i < words.size(); ++i)
    text += fmt::format("    {}) options=\"{}\" ;;\n", words[i].name, fmt::join(flags_of(words[i]), " "));
  text += fmt::format("    *) options=\"{}\" ;;\n  esac\n", fmt::join(flags_of(words.front()), " "));
  text += fmt::format(
      "  if [[ $COMP_CWORD -eq 1 || ( $COMP_CWORD -eq 2 && ${{COMP_WORDS[1]}} == help ) ]]; then\n"
      "    COMPREPLY=($(compgen -W \"{} $([[ $COMP_CWORD -eq 1 ]] && echo $options)\" -- \"$word\"))\n"
      "  elif [[ $word == -* ]]; then\n"
      "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
      "  else\n"
      "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
      "  fi\n"
      "}}\n"
      "complete -o filenames -F _kempe kempe\n",
      fmt::join(names_of(words), " "));
  return text;
}

std::string zsh_completion(const std::vector<CommandWords>& words) {
  std::string text =
      "#compdef kempe\n# Completion of kempe for zsh, made from the program's own help.\n"
      "local -a commands options\ncommands=(\n";
  for (std::size_t i = 1; i < words.size(); ++i)
    text += "  " + zsh_entry(words[i].name, words[i].purpose) + "\n";
  text +=
      ")\nif (( CURRENT == 2 )) || [[ $CURRENT -eq 3 && $words[2] == help ]]; then\n"
      "  _describe command commands\n  return\nfi\ncase $words[2] in\n";
  for (std::size_t i = 1; i < words.size(); ++i) {
    text += "  " + words[i].name + ") options=(\n";
    for (const OptionWords& option : words[i].options)
      for (const std::string& name : option.long_names)
        text += "    " + zsh_entry("--" + name, option.meaning) + "\n";
    text += "  ) ;;\n";
  }
  return text + "esac\nif [[ $PREFIX == -* ]]; then _describe option options; else _files; fi\n";
}

std::string fish_completion(const std::vector<CommandWords>& words) {
  std::string text = "# Completion of kempe for fish, made from the program's own help.\n";
  for (std::size_t i = 1; i < words.size(); ++i) {
    const CommandWords& command = words[i];
    text += fmt::format("complete -c kempe -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                        fish_quoted(command.purpose));
    for (const OptionWords& option : command.options) {
      if (!option.name.empty()) continue;
      text += fmt::format("complete -c kempe -n '__fish_seen_subcommand_from {}'", command.name);
      for (const std::string& name : option.short_names) text += " -s " + name;
      for (const std::string& name : option.long_names) text += " -l " + name;
      text += fmt::format("{} -d {}\n", option.value.empty() ? "" : " -r", fish_quoted(option.meaning));
    }
  }
  return text + fmt::format("complete -c kempe -n '__fish_seen_subcommand_from help' -f -a '{}'\n",
                            fmt::join(names_of(words), " "));
}

}  // namespace kempe::app
