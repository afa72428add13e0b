#pragma once
// Texts from outside as they may be shown: on a terminal, in a table, in a message.

#include <cstddef>
#include <string>
#include <string_view>

namespace kempe {

/// The text on one line, with what would move or colour a terminal's words written out: control characters as \n, \t or
/// \x1b, marks that change the direction of writing and separators of lines as \u202e, bytes that are no UTF-8 as \xff.
/// All else stays as it is, so the function may be applied twice.
std::string printable(std::string_view text);

/// The same, of at most the first `most` bytes, whole characters only; "..." where something is left out.
std::string printable(std::string_view text, std::size_t most);

/// The same line by line: line ends and tabs stay.
std::string printable_lines(std::string_view text);

}  // namespace kempe
