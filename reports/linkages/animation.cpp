#include "reports/linkages/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "reports/linkages/scene_forces.hpp"
#include "reports/linkages/scene_motion.hpp"
#include "reports/linkages/scene_wanted.hpp"
#include "reports/linkages/traced_curves.hpp"
#include "reports/page/html_page.hpp"
#include "reports/page/web_assets.hpp"
#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

constexpr double seconds_of_motion = 5;

/// True if a link turns about a point of the ground.
bool is_pivoted(const LinkageScene& scene, int body) {
  const auto& pins = scene.bodies[static_cast<std::size_t>(body)].pins;
  return std::any_of(scene.points.begin(), scene.points.end(), [&](const ScenePoint& point) {
    return point.fixed && std::any_of(pins.begin(), pins.end(), [&](const Point& pin) {
             const ScenePoint on_link{"", body, pin, false};
             return (scene.place(on_link, scene.moments.front()) - point.local).norm() <
                    1e-6 * scene.extent();
           });
  });
}

/// Cranks and rockers where they turn back, as they stand there.
std::string ghosts(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (const SceneMark& mark : scene.marks) {
    if (mark.body < 1 || !is_pivoted(scene, mark.body)) continue;
    const auto moment = static_cast<std::size_t>(std::lround(mark.moment));
    text +=
        SvgElement("g")
            .with("class", "ghost")
            .with("color", link_colour(mark.body))
            .with("opacity", ".28")
            .with("transform", placement(scene.moments[moment], static_cast<std::size_t>(mark.body), scale))
            .holding(SvgElement("title").saying(mark.words).text())
            .holding(body_shape(scene.bodies[static_cast<std::size_t>(mark.body)], mark.body, scale))
            .line();
  }
  return text;
}

std::string static_layers(const LinkageScene& scene, const PictureScale& scale) {
  std::string text = ghosts(scene, scale);
  for (const std::size_t traced : scene.traced)
    text += trace_curve(scene, traced, scale) + "\n" + trace_beats(scene, traced, scale) + "\n";
  text += wanted_marks(scene, scale);
  text += ground_group(scene, scale).line();
  for (const ScenePoint& point : scene.points)
    if (point.fixed) text += ground_sign(point, scale) + "\n";
  return text;
}

/// Values of one attribute over all moments, and back again unless the motion runs around.
template <class Value>
std::string over_time(const LinkageScene& scene, const Value& value) {
  std::string text;
  const std::size_t count = scene.moments.size(), all = scene.closed ? count : 2 * count - 1;
  for (std::size_t i = 0; i < all; ++i) {
    const std::size_t moment = i < count ? i : 2 * count - 2 - i;
    text += (i ? ";" : "") + value(scene.moments[moment]);
  }
  return text;
}

std::string smil(const LinkageScene& scene, std::string_view type, const std::string& values) {
  const double seconds = scene.closed ? seconds_of_motion : 2 * seconds_of_motion;
  return SvgElement("animateTransform")
      .with("attributeName", "transform")
      .with("type", type)
      .with("additive", type == "rotate" ? "sum" : "replace")
      .with("dur", fmt::format("{:g}s", seconds))
      .with("repeatCount", "indefinite")
      .with("values", values)
      .text();
}

std::string moving_bodies(const LinkageScene& scene, const PictureScale& scale, bool with_motion) {
  std::string text;
  for (std::size_t body = 1; body < scene.bodies.size(); ++body) {
    const int number = static_cast<int>(body);
    std::string motion;
    if (with_motion)
      motion =
          smil(scene, "translate", over_time(scene, [&](const auto& m) { return scale.pair(m.at[body]); })) +
          smil(scene, "rotate", over_time(scene, [&](const auto& m) {
                 return fmt::format("{:.4f}", degrees(m.angle[body]));
               }));
    text += SvgElement("g")
                .with("id", fmt::format("body{}", number))
                .with("color", link_colour(number))
                .with("transform", placement(scene.moments[0], body, scale))
                .holding(SvgElement("title").saying(scene.bodies[body].name).text())
                .holding(body_shape(scene.bodies[body], number, scale))
                .holding(carried_axes(scene, body, scale))
                .holding(motion)
                .line();
  }
  return text;
}

/// A point's name beside its place.
SvgElement named(SvgElement text, const ScenePoint& point, const Point& place, const PictureScale& scale) {
  const Point at = place + Point(1.6, -1.6) * scale.pin;
  return text.with("x", scale.number(at.x())).with("y", scale.number(at.y())).saying(point.name);
}

std::string names_at_start(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const SvgElement name = drawn("text", "name", scale).with("id", fmt::format("name{}", i));
    text += named(name, scene.points[i], scene.place(scene.points[i], scene.moments[0]), scale).text();
  }
  return text;
}

/// What the page's script needs: moments as rows step, then x, y, angle of each moving body.
std::string scene_json(const LinkageScene& scene, const PictureScale& scale) {
  std::string text = fmt::format(
      "{{\"unit\":\"{}\",\"closed\":{},\"seconds\":{:g},\"offset\":{},\"decimals\":{},\"points\":[",
      scene.unit, scene.closed, seconds_of_motion, scale.number(1.6 * scale.pin),
      std::max(0, scale.decimals - 1));
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const ScenePoint& p = scene.points[i];
    text += fmt::format("{}[{},{},{}]", i ? "," : "", p.body, p.local.x(), p.local.y());
  }
  text += fmt::format("],\"traced\":[{}],\"moments\":[", fmt::join(scene.traced, ","));
  for (std::size_t i = 0; i < scene.moments.size(); ++i) {
    const auto& moment = scene.moments[i];
    text += fmt::format("{}[{:.6g}", i ? ",\n" : "", moment.step);
    for (std::size_t body = 1; body < scene.bodies.size(); ++body)
      text +=
          fmt::format(",{:.9g},{:.9g},{:.9g}", moment.at[body].x(), moment.at[body].y(), moment.angle[body]);
    text += "]";
  }
  return script_escaped(text + "],\"loads\":" + scene_forces_json(scene) +
                        ",\"motion\":" + scene_motion_json(scene) + "}");
}

std::string traced_dots(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (const std::size_t traced : scene.traced)
    text += SvgElement("circle")
                .with("id", fmt::format("dot{}", traced))
                .with("r", scale.number(0.8 * scale.pin))
                .with("fill", link_colour(scene.points[traced].body))
                .text();
  return text;
}

/// The arrows, which the script draws.
std::string force_arrows(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (std::size_t i = 0; i < scene.moments.front().arrows.size(); ++i)
    text += drawn("path", "force", scale).with("id", fmt::format("arrow{}", i)).text();
  return text;
}

/// How long the arrows are.
std::string arrows_sentence(const LinkageScene& scene) {
  if (!(scene.largest_force > 0)) return "";
  return fmt::format(" Red arrows are forces, the longest is {:.4g} N.", scene.largest_force);
}

std::string driver_forces_line(const LinkageScene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.drivers.size(); ++i)
    text += fmt::format("<span><b>driver {}</b> <span id=\"force{}\"></span></span>",
                        html_escaped(scene.drivers[i].label), i);
  return text;
}

/// How far apart the dots on the curves are in time.
std::string beats_sentence(const LinkageScene& scene) {
  if (scene.traced.empty() || scene.moments.size() < 2) return "";
  const double seconds = static_cast<double>(beat_of(scene)) * scene.seconds_a_step *
                         (scene.moments[1].step - scene.moments[0].step);
  return fmt::format(" Dots on a curve are {:.4g} s apart.", seconds);
}

/// Beside the picture: the polygons, what is plotted over what, three plots, the marks. The script fills them.
std::string figures_panel(const LinkageScene& scene) {
  std::string text = "<aside class=\"figures\" aria-label=\"Plots\">\n" + wanted_table(scene) +
                     "<div id=\"polygons\" hidden>";
  for (const char* kind : {"velocities", "accelerations"})
    text += fmt::format(
        "<figure id=\"polygon-{0}\" hidden><figcaption>polygon of {0}</figcaption><svg viewBox=\"0 0 200 "
        "200\" "
        "role=\"img\" aria-label=\"Polygon of {0}\"></svg></figure>",
        kind);
  text +=
      "</div>\n<div class=\"pick\"><label>Plot <select id=\"of\"></select></label> <label>over <select "
      "id=\"over\"></select></label></div>\n";
  for (const int plot : {0, 1, 2})
    text += fmt::format(
        "<figure class=\"plot\" id=\"plot{}\"><figcaption></figcaption><svg role=\"img\"></svg></figure>\n",
        plot);
  text += "<p class=\"over\">over <span id=\"overword\"></span></p>\n";
  text += "<div id=\"marksbox\" hidden><h3>Marks</h3><ul id=\"marks\"></ul>";
  if (scene.driven.size() == 1)
    text +=
        "<p class=\"note\">Where a part turns back it stands still: a dead point, if that part drove the "
        "others.</p>";
  return text + "</div></aside>\n";
}

std::string arrow_buttons(const LinkageScene& scene) {
  std::string text =
      "<button type=\"button\" id=\"velocities\" aria-pressed=\"false\" title=\"key V\">Velocities</button>"
      "<button type=\"button\" id=\"accelerations\" aria-pressed=\"false\" title=\"key "
      "A\">Accelerations</button>";
  if (!scene.reactions.empty())
    text +=
        "<button type=\"button\" id=\"reactions\" aria-pressed=\"false\" title=\"key R\">Reactions</button>";
  return text;
}

std::string places_line(const LinkageScene& scene) {
  std::string text;
  for (const std::size_t traced : scene.traced)
    text += fmt::format("<span><b>{}</b> <span id=\"place{}\"></span></span>",
                        html_escaped(scene.points[traced].name), traced);
  return text;
}

}  // namespace

std::string animation_html(const LinkageScene& scene) {
  const PictureScale scale = PictureScale::of(scene.lower, scene.upper);
  const std::string ending =
      scene.ending.empty() ? "" : " The motion ends early: " + html_escaped(scene.ending) + ".";
  const double steps = scene.moments.back().step;
  std::string page =
      page_head(scene.title, {web_assets::style, web_assets::animation_style}, {web_assets::animation}) +
      "<body>\n";
  page += "<header>\n" +
          html_heading(
              "Kempe · linkage", scene.title,
              fmt::format("Lengths in {}.{}{}{}{}", scene.unit == "in" ? "inches" : scene.unit,
                          wanted_sentence(scene), beats_sentence(scene), arrows_sentence(scene), ending)) +
          "</header>\n<main class=\"motion\">";
  page += SvgElement("svg")
              .with("id", "picture")
              .with("viewBox", scale.view_box())
              .with("role", "img")
              .with("aria-label", scene.title)
              .holding("\n" + static_layers(scene, scale) + moving_bodies(scene, scale, false) +
                       traced_dots(scene, scale) + force_arrows(scene, scale) + names_at_start(scene, scale))
              .text();
  page += "\n" + figures_panel(scene);
  page += fmt::format(
      "</main>\n<footer class=\"drive\"><button type=\"button\" id=\"play\">Play</button><input "
      "type=\"range\" id=\"moment\" min=\"0\" "
      "max=\"{}\" "
      "value=\"0\" aria-label=\"Step of the motion\"><output id=\"step\" data-all=\"{:.6g}\"></output>"
      "<label>Speed <select id=\"speed\"><option value=\"0.25\">1/4</option><option value=\"1\" "
      "selected>1</option>"
      "<option value=\"3\">3</option></select></label><label><input type=\"checkbox\" id=\"names\" checked> "
      "Names</label>{}"
      "<div id=\"places\">{}<span id=\"arrowkey\"></span></div></footer>\n",
      scene.moments.size() - 1, steps, arrow_buttons(scene), driver_forces_line(scene) + places_line(scene));
  page +=
      fmt::format("<script type=\"application/json\" id=\"scene\">{}</script>\n", scene_json(scene, scale)) +
      page_element("script", web_assets::animation) + "</body></html>\n";
  return page;
}

std::string animation_svg(const LinkageScene& scene) {
  const PictureScale scale = PictureScale::of(scene.lower, scene.upper);
  std::string inside = SvgElement("title").saying(scene.title).line();
  inside += SvgElement("rect")
                .with("x", scale.number(scale.lower.x()))
                .with("y", scale.number(scale.lower.y()))
                .with("width", "100%")
                .with("height", "100%")
                .with("fill", "#fff")
                .line();
  inside += static_layers(scene, scale) + moving_bodies(scene, scale, true);
  for (const ScenePoint& point : scene.points)
    if (point.fixed) inside += named(drawn("text", "name", scale), point, point.local, scale).line();
  return svg_root()
      .with("viewBox", scale.view_box())
      .with("width", "800")
      .with("role", "img")
      .holding("\n" + inside)
      .line();
}

}  // namespace kempe
