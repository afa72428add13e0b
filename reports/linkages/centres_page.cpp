#include "reports/linkages/centres_page.hpp"

#include <fmt/format.h>

#include <regex>

#include "reports/linkages/centres_picture.hpp"
#include "reports/linkages/text.hpp"
#include "reports/page/html_page.hpp"
#include "reports/page/web_assets.hpp"
#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

std::string links_list(const LinkageModel& model, const std::vector<InstantCentre>& centres) {
  std::string text = "<ul id=\"links\">";
  for (const auto& [body, number] : link_numbers(centres))
    text += fmt::format("<li><b>{}</b> {}</li>", number, html_escaped(model.linkage.body_name(body)));
  return text + "</ul>\n";
}

/// Names such as 2-3 hold together at the end of a line.
std::string unbroken(const std::string& words) {
  static const std::regex hyphen("([0-9])-([0-9])");
  return std::regex_replace(words, hyphen, "$1\u2011$2");
}

std::string step_item(const LinkageFile& file, const LinkageModel& model, const CentreStep& step) {
  return fmt::format(
      "<li data-centre=\"{}\" data-uses=\"{}\"><button type=\"button\">{}</button> <span>{} "
      "<i>{}</i></span></li>\n",
      step.name, fmt::join(step.uses, " "), step.name, unbroken(html_escaped(step.reason)),
      html_escaped(centre_place_text(file, model, *step.centre)));
}

/// Those that joints give stand first, for they are where everything begins.
std::string steps_lists(const LinkageFile& file, const LinkageModel& model,
                        const std::vector<InstantCentre>& centres) {
  std::string joints, found;
  for (const CentreStep& step : centre_steps(model, centres)) {
    const bool is_primary = step.centre->source == InstantCentre::Source::primary;
    (is_primary ? joints : found) += step_item(file, model, step);
  }
  return "<h3>From the joints</h3>\n<ul id=\"joints\" class=\"centres\">\n" + joints +
         "</ul>\n<h3>One after another</h3>\n<ol id=\"steps\" class=\"centres\">\n" + found + "</ol>\n";
}

}  // namespace

std::string centres_html(const LinkageFile& file, const LinkageModel& model, const LinkageScene& scene,
                         double step, const std::vector<InstantCentre>& centres) {
  std::string page = page_head("Instant centres: " + scene.title,
                               {web_assets::style, web_assets::centres_style}, {web_assets::centres});
  const std::string lead = fmt::format(
      "Step {:.6g} of {}, lengths in {}. The instant centre of two links is the point where both move alike. "
      "The "
      "three centres of any three links lie on one line (Aronhold and Kennedy): two such lines give the next "
      "centre.",
      step, file.steps, scene.unit == "in" ? "inches" : scene.unit);
  page += "<body>\n<header>\n" + html_heading("Kempe · instant centres", scene.title, lead) +
          "</header>\n<main class=\"construction\">\n<div>\n";
  page += centres_drawing(scene, centres, file.unit.in_mm);
  page +=
      "\n<div class=\"drive\"><button type=\"button\" id=\"back\">Back</button><button type=\"button\" "
      "id=\"next\">Next</button><button type=\"button\" id=\"all\">All</button><output "
      "id=\"told\"></output></div>\n"
      "</div>\n<aside>\n<h3>Links</h3>\n";
  page += links_list(model, centres) + steps_lists(file, model, centres);
  return page + "</aside>\n</main>\n" + page_element("script", web_assets::centres) + "</body></html>\n";
}

}  // namespace kempe
