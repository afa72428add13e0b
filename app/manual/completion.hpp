#pragma once
// What shells need to complete the program's commands and options.

#include <string>
#include <vector>

#include "app/manual/words.hpp"

namespace kempe::app {

/// share/bash-completion/completions/kempe
std::string bash_completion(const std::vector<CommandWords>& words);
/// share/zsh/site-functions/_kempe
std::string zsh_completion(const std::vector<CommandWords>& words);
/// share/fish/vendor_completions.d/kempe.fish
std::string fish_completion(const std::vector<CommandWords>& words);

}  // namespace kempe::app
