#include "reports/page/html_page.hpp"

#include <fmt/format.h>

#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

std::string bytes_of_hex(std::string_view hex) {
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(value(hex[i]) * 16 + value(hex[i + 1]));
  return bytes;
}

/// How the policy names inline elements that it allows.
std::string sources_of(const PageAssets& assets) {
  std::string text;
  for (const web_assets::Asset& asset : assets)
    if (!asset.text.empty()) text += fmt::format(" 'sha256-{}'", base64(bytes_of_hex(asset.sha256)));
  return text.empty() ? " 'none'" : text;
}

}  // namespace

std::string page_element(std::string_view tag, const web_assets::Asset& asset) {
  return asset.text.empty() ? std::string() : fmt::format("<{0}>{1}</{0}>\n", tag, asset.text);
}

std::string page_head(std::string_view title, const PageAssets& styles, const PageAssets& scripts,
                      std::string_view program_version) {
  std::string head = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; "
      "form-action 'none'; "
      "img-src data:; style-src{}; script-src{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n",
      sources_of(styles), sources_of(scripts));
  if (!program_version.empty())
    head += fmt::format("<meta name=\"generator\" content=\"Kempe {}\">\n", html_escaped(program_version));
  head += fmt::format("<title>{}</title>\n", html_escaped(title));
  for (const web_assets::Asset& style : styles) head += page_element("style", style);
  return head + "</head>\n";
}

std::string html_page(std::string_view title, std::string_view program_version, const std::string& body) {
  return page_head(title, {web_assets::style}, {}, program_version) + "<body>\n" + body +
         "</body>\n</html>\n";
}

std::string html_heading(std::string_view brand, std::string_view title, std::string_view lead) {
  return fmt::format("<p class=\"brand\">{}</p>\n<h1>{}</h1>\n<p class=\"lead\">{}</p>\n", brand,
                     html_escaped(title), lead);
}

std::string html_key_figure(std::string_view name, const std::string& value, const std::string& note) {
  return fmt::format("<div class=\"key\"><dt>{}</dt><dd>{}<small>{}</small></dd></div>\n", name, value, note);
}

std::string html_badge(bool good, std::string_view words) {
  return fmt::format("<li class=\"badge {}\">{} {}</li>\n", good ? "good" : "bad", good ? "✓" : "✗",
                     html_escaped(words));
}

}  // namespace kempe
