#include "reports/page/html_report.hpp"

#include <fmt/format.h>

#include "reports/page/html_page.hpp"
#include "reports/page/model.hpp"
#include "reports/page/sections.hpp"
#include "reports/page/web_assets.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/map_picture.hpp"
#include "specs/spec_reader.hpp"
#include "specs/unit_words.hpp"

namespace kempe {
namespace {

std::string head(const Design& design, const ReportExtras& extras) {
  return page_head(report_sections::title(design), {web_assets::live_style, web_assets::style},
                   {web_assets::geometry, web_assets::live}, extras.program_version);
}

/// The design as data, and the scripts that bring it to life, with their licence notice.
std::string live_part(const Design& design, const MapPicture& picture) {
  return fmt::format(
             "<script type=\"application/json\" id=\"kempe-model\">{}</script>\n<!--\nJSXGraph:\n{}-->\n",
             script_escaped(report_model(design, picture)), web_assets::notice.text) +
         page_element("script", web_assets::geometry) + page_element("script", web_assets::live);
}

}  // namespace

bool report_is_live() { return !web_assets::live.text.empty(); }

std::string html_report(const Design& design, const ReportExtras& extras) {
  return html_report(design, extras, map_picture(design));
}

std::string html_report(const Design& design, const ReportExtras& extras, const MapPicture& picture) {
  namespace section = report_sections;
  const SpecUnit unit = unit_of_spec(extras.spec_text);
  std::string body = section::header(design, extras) + section::pareto(extras) +
                     section::key_figures(design) + section::map(picture, report_is_live());
  body += section::making(design) + section::parts(design, extras) +
          keys_in(unit, section::quality(design, extras)) + section::workspace(design);
  body += keys_in(unit, section::loads(design) + section::weight(design) + section::tolerance(design)) +
          section::verification(design) + section::search(design);
  body += section::spec(extras);
  std::string page = head(design, extras) + "<body>\n<main>\n" + body + "</main>\n" +
                     section::footer(extras, report_is_live());
  if (report_is_live()) page += live_part(design, picture);
  return page + "</body>\n</html>\n";
}

}  // namespace kempe
