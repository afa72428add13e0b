#include "reports/html_page.hpp"

#include <fmt/format.h>

#include "reports/html_text.hpp"
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

}  // namespace

std::string html_page(std::string_view title, std::string_view program_version, const std::string& body) {
  const web_assets::Asset& style = web_assets::style;
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "http-equiv=\"Content-Security-Policy\" "
      "content=\"default-src 'none'; base-uri 'none'; form-action 'none'; style-src 'sha256-{}'\">\n<meta "
      "name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light "
      "dark\">\n<meta "
      "name=\"generator\" content=\"Kempe "
      "{}\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      base64(bytes_of_hex(style.sha256)), html_escaped(program_version), html_escaped(title), style.text,
      body);
}

std::string html_key_figure(std::string_view name, const std::string& value, const std::string& note) {
  return fmt::format("<div class=\"key\"><dt>{}</dt><dd>{}<small>{}</small></dd></div>\n", name, value, note);
}

std::string html_badge(bool good, std::string_view words) {
  return fmt::format("<li class=\"badge {}\">{} {}</li>\n", good ? "good" : "bad", good ? "✓" : "✗",
                     html_escaped(words));
}

}  // namespace kempe
