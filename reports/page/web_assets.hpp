#pragma once
// What the report page inlines: made by reports/web/embed.cmake when the project is built.

#include <string_view>

namespace kempe::web_assets {

/// A style sheet or script: its text, ready to stand inside its element, and the SHA-256 of exactly this text
/// in hexadecimal, by which the page's content security policy allows it.
struct Asset {
  std::string_view text;
  std::string_view sha256;
};

extern const Asset style;            ///< reports/web/report.css
extern const Asset animation;        ///< reports/web/animation/*.js
extern const Asset animation_style;  ///< reports/web/animation/animation.css
extern const Asset centres;          ///< reports/web/centres/centres.js
extern const Asset centres_style;    ///< reports/web/centres/centres.css
extern const Asset geometry;         ///< the dynamic geometry, jsxgraph; empty if the build had none
extern const Asset live;             ///< the page's own scripts; empty if the build had no dynamic geometry
extern const Asset live_style;       ///< the dynamic geometry's style sheet; empty likewise
extern const Asset notice;           ///< licence notice of what is inlined

}  // namespace kempe::web_assets
