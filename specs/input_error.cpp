#include "specs/input_error.hpp"

namespace kempe {

std::string InputError::message() const {
  std::string text = file;
  if (line > 0) text += ":" + std::to_string(line);
  if (!key.empty()) text += (text.empty() ? "" : ": ") + key;
  if (!found.empty()) text += (text.empty() ? "found " : ": found ") + found;
  if (!allowed.empty()) text += (text.empty() ? "allowed: " : "; allowed: ") + allowed;
  return text;
}

}  // namespace kempe
