#pragma once
// What the commands of one run share, and how it ends.

#include <functional>
#include <optional>
#include <string>

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

/// An input's text that came in a message, as TOML; `name` stands for the file that there is not.
struct GivenText {
  std::string name, text;
};

/// What every command shares: the options --json and --quiet, and the run that the arguments chose.
struct Session {
  bool json = false;
  bool quiet = false;
  bool both = false;               ///< with json: what a person would read goes to stderr
  std::optional<GivenText> given;  ///< read in place of the file of its name; its lines nobody sees
  std::function<int()> chosen;     ///< set by the sub-command's callback; returns an ExitCode
};

/// Prints "kempe: MESSAGE" to stderr and returns the code: for a command that has printed its answer.
int fail_told(ExitCode code, const std::string& message);

}  // namespace kempe::app
