#pragma once
// The frame of a page that only shows: head with the report's style, a security policy that forbids
// everything else.

#include <string>
#include <string_view>

namespace kempe {

/// A whole page in the report's style; `body` is HTML, the rest is escaped. No script runs on it.
std::string html_page(std::string_view title, std::string_view program_version, const std::string& body);

/// <div class="key"> of a <dl class="keys">; name and note are HTML.
std::string html_key_figure(std::string_view name, const std::string& value, const std::string& note);

/// A badge with a tick or a cross.
std::string html_badge(bool good, std::string_view words);

}  // namespace kempe
