#pragma once
// The frame of every page: head, security policy, the style sheets and scripts that it inlines.

#include <string>
#include <string_view>
#include <vector>

#include "reports/page/web_assets.hpp"

namespace kempe {

using PageAssets = std::vector<web_assets::Asset>;

/// "<!DOCTYPE html>" to "</head>" with the style sheets. The one security policy of all pages: nothing runs and nothing
/// styles but these sheets and scripts, by their SHA-256; nothing is loaded but pictures that the page itself holds. The
/// title is escaped. `program_version` becomes the generator's; empty: none is named. Assets without text are left out.
std::string page_head(std::string_view title, const PageAssets& styles, const PageAssets& scripts,
                      std::string_view program_version = {});

/// An asset as an element <style> or <script>; nothing if it has no text.
std::string page_element(std::string_view tag, const web_assets::Asset& asset);

/// A whole page in the report's style; `body` is HTML, the rest is escaped. No script runs on it.
std::string html_page(std::string_view title, std::string_view program_version, const std::string& body);

/// What a page's header begins with: a line above its title, the title, and what it is about in some sentences. The title is escaped,
/// `brand` and `lead` are HTML.
std::string html_heading(std::string_view brand, std::string_view title, std::string_view lead);

/// <div class="key"> of a <dl class="keys">; name and note are HTML.
std::string html_key_figure(std::string_view name, const std::string& value, const std::string& note);

/// A badge with a tick or a cross.
std::string html_badge(bool good, std::string_view words);

}  // namespace kempe
