#include "kempe/input_error.hpp"

#include "specs/text/printable.hpp"

namespace kempe {

std::string InputError::message() const {
  std::string text = printable(file);
  const auto add = [&text](const char* separator, const char* label, const std::string& part) {
    if (part.empty()) return;
    if (!text.empty()) text.append(separator);
    text.append(label).append(printable(part));
  };
  if (line > 0) text.append(":").append(std::to_string(line));
  add(": ", "", key);
  add(": ", "found ", found);
  add("; ", "allowed: ", allowed);
  return text;
}

std::string InputError::messages() const {
  std::string text = message();
  for (const InputError& other : others) text.append("\n").append(other.message());
  return text;
}

}  // namespace kempe
