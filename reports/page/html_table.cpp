#include "reports/page/html_table.hpp"

#include <fmt/format.h>

namespace kempe {

std::string html_section(std::string_view id, std::string_view heading, const std::string& inside) {
  if (inside.empty()) return {};
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-heading\">\n<h2 "
      "id=\"{0}-heading\">{1}</h2>\n{2}</section>\n\n",
      id, heading, inside);
}

namespace {

/// With its column's heading, which stands before it where the table has become a list (report.css).
std::string cell(const HtmlColumn& column, const std::string& inside) {
  const std::string label = column.heading.empty() ? "" : fmt::format(" data-label=\"{}\"", column.heading);
  if (!column.is_number) return fmt::format("<td{}>{}</td>", label, inside);
  return fmt::format("<td class=\"number{}\"{}>{}</td>", inside == "–" ? " none" : "", label, inside);
}

}  // namespace

std::string html_table(std::string_view css, const std::vector<HtmlColumn>& columns,
                       const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return {};
  std::string html = fmt::format("<div class=\"scroll\"><table class=\"{}\">\n<thead><tr>", css);
  for (const HtmlColumn& column : columns)
    html += fmt::format("<th scope=\"col\"{}>{}</th>", column.is_number ? " class=\"number\"" : "",
                        column.heading);
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", row[i])
                     : cell(i < columns.size() ? columns[i] : HtmlColumn{}, row[i]);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace kempe
