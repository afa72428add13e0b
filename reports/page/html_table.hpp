#pragma once
// Sections and tables of the report as HTML. Cells are HTML: what comes from outside is escaped before.

#include <string>
#include <string_view>
#include <vector>

namespace kempe {

/// <section> with a heading; empty if `inside` is.
std::string html_section(std::string_view id, std::string_view heading, const std::string& inside);

struct HtmlColumn {
  std::string heading;
  bool is_number = false;
};

/// A table in a box that scrolls sideways where it is too wide; on a phone report.css makes a list of it, each cell behind
/// its column's heading. Empty without rows.
std::string html_table(std::string_view css, const std::vector<HtmlColumn>& columns,
                       const std::vector<std::vector<std::string>>& rows);

}  // namespace kempe
