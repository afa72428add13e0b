#pragma once
// Numbers as the written equations have them.

#include <string>

namespace kempe {

/// Ten digits, never -0.
std::string digits(double value);

/// What is added to a sum: " + 3", " - 3".
std::string signed_number(double value);

/// A number behind a sign or a factor: "3", "(-3)".
std::string bracketed_digits(double value);

}  // namespace kempe
