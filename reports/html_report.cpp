#include "reports/html_report.hpp"

#include <fmt/format.h>

#include "reports/html_text.hpp"
#include "reports/map_picture.hpp"
#include "reports/report_model.hpp"
#include "reports/report_sections.hpp"
#include "reports/web_assets.hpp"

namespace kempe {
namespace {

std::string bytes_of_hex(std::string_view hex) {
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(value(hex[i]) * 16 + value(hex[i + 1]));
  return bytes;
}

/// How a content security policy names an inline element that it allows.
std::string source_of(const web_assets::Asset& asset) {
  return asset.text.empty() ? std::string() : fmt::format(" 'sha256-{}'", base64(bytes_of_hex(asset.sha256)));
}

std::string security_policy() {
  const std::string scripts = source_of(web_assets::geometry) + source_of(web_assets::live);
  return fmt::format(
      "default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; style-src{}{}; script-src{}",
      source_of(web_assets::style), source_of(web_assets::live_style), scripts.empty() ? " 'none'" : scripts);
}

std::string element(std::string_view tag, const web_assets::Asset& asset) {
  return asset.text.empty() ? std::string() : fmt::format("<{0}>{1}</{0}>\n", tag, asset.text);
}

std::string head(const Design& design, const ReportExtras& extras) {
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
             "http-equiv=\"Content-Security-Policy\" "
             "content=\"{}\">\n<meta name=\"viewport\" content=\"width=device-width, "
             "initial-scale=1\">\n<meta name=\"color-scheme\" "
             "content=\"light dark\">\n<meta name=\"generator\" content=\"Kempe {}\">\n<title>{}</title>\n",
             security_policy(), html_escaped(extras.program_version),
             html_escaped(report_sections::title(design, extras))) +
         element("style", web_assets::live_style) + element("style", web_assets::style) + "</head>\n";
}

/// The design as data, and the scripts that bring it to life, with their licence notice.
std::string live_part(const Design& design, const MapPicture& picture) {
  return fmt::format(
             "<script type=\"application/json\" id=\"kempe-model\">{}</script>\n<!--\nJSXGraph:\n{}-->\n",
             script_escaped(report_model(design, picture)), web_assets::notice.text) +
         element("script", web_assets::geometry) + element("script", web_assets::live);
}

}  // namespace

bool report_is_live() { return !web_assets::live.text.empty(); }

std::string html_report(const Design& design, const ReportExtras& extras) {
  namespace section = report_sections;
  const MapPicture picture = map_picture(design);
  std::string body = section::header(design, extras) + section::key_figures(design) +
                     section::map(picture, report_is_live());
  body += section::making(design) + section::parts(design, extras) + section::quality(design) +
          section::workspace(design);
  body += section::tolerance(design) + section::verification(design) + section::search(design);
  body += section::pareto(extras) + section::spec(extras);
  std::string page = head(design, extras) + "<body>\n<main>\n" + body + "</main>\n" +
                     section::footer(extras, report_is_live());
  if (report_is_live()) page += live_part(design, picture);
  return page + "</body>\n</html>\n";
}

}  // namespace kempe
