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

std::string cell(const std::string& inside, bool is_number) {
  const bool is_empty = inside == "–";
  if (!is_number) return "<td>" + inside + "</td>";
  return fmt::format("<td class=\"number{}\">{}</td>", is_empty ? " none" : "", inside);
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
                     : cell(row[i], i < columns.size() && columns[i].is_number);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace kempe
