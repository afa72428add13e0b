#pragma once
// Cells of tables for spreadsheets.

#include <string>
#include <string_view>

namespace kempe {

/// A text as a cell of a CSV file (RFC 4180): in quotation marks where it holds a comma, a quotation mark or a line end. A
/// text that a spreadsheet would take for a formula, beginning with = + - @, a tab or a line end, gets an apostrophe in
/// front, by which spreadsheets know a text.
std::string csv_cell(std::string_view text);

}  // namespace kempe
