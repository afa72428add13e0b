#include "reports/linkages/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "reports/linkages/picture.hpp"
#include "reports/page/html_page.hpp"
#include "reports/page/web_assets.hpp"
#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

constexpr double seconds_of_motion = 5;

std::string static_layers(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (const std::size_t traced : scene.traced) text += trace_curve(scene, traced, scale) + "\n";
  text += fmt::format("<g color=\"{}\">{}</g>\n", link_colour(0), body_shape(scene.bodies[0], 0, scale));
  for (const ScenePoint& point : scene.points)
    if (point.fixed) text += ground_sign(point, scale) + "\n";
  return text;
}

std::string group_transform(const LinkageScene::Moment& moment, std::size_t body, const PictureScale& scale) {
  return fmt::format("translate({}) rotate({:.5f})", scale.pair(moment.at[body]),
                     degrees(moment.angle[body]));
}

std::string moving_bodies(const LinkageScene& scene, const PictureScale& scale, bool with_motion);

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
  return fmt::format(
      "<animateTransform attributeName=\"transform\" type=\"{}\" additive=\"{}\" dur=\"{:g}s\" "
      "repeatCount=\"indefinite\" values=\"{}\"/>",
      type, type == "rotate" ? "sum" : "replace", scene.closed ? seconds_of_motion : 2 * seconds_of_motion,
      values);
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
    text += fmt::format("<g id=\"body{}\" color=\"{}\" transform=\"{}\"><title>{}</title>{}{}</g>\n", number,
                        link_colour(number), group_transform(scene.moments[0], body, scale),
                        html_escaped(scene.bodies[body].name), body_shape(scene.bodies[body], number, scale),
                        motion);
  }
  return text;
}

std::string names_at_start(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const Point at = scene.place(scene.points[i], scene.moments[0]) + Point(1.6, -1.6) * scale.pin;
    text += fmt::format("<text {} id=\"name{}\" x=\"{}\" y=\"{}\">{}</text>", look("name", scale), i,
                        scale.number(at.x()), scale.number(at.y()), html_escaped(scene.points[i].name));
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
  return script_escaped(text + "]}");
}

std::string traced_dots(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (const std::size_t traced : scene.traced)
    text += fmt::format("<circle id=\"dot{}\" r=\"{}\" fill=\"{}\"/>", traced, scale.number(0.8 * scale.pin),
                        link_colour(scene.points[traced].body));
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
  const std::string title = html_escaped(scene.title);
  const std::string ending =
      scene.ending.empty() ? "" : " The motion ends early: " + html_escaped(scene.ending) + ".";
  const double steps = scene.moments.back().step;
  std::string page =
      page_head(scene.title, {web_assets::animation_style}, {web_assets::animation}) + "<body>\n";
  page +=
      fmt::format("<header><h1>{}</h1><p>Lengths in {}.{}</p></header>\n<main>", title, scene.unit, ending);
  page += fmt::format("<svg id=\"picture\" viewBox=\"{}\" role=\"img\" aria-label=\"{}\">\n",
                      scale.view_box(), title);
  page += static_layers(scene, scale) + moving_bodies(scene, scale, false) + traced_dots(scene, scale) +
          names_at_start(scene, scale);
  page += fmt::format(
      "</svg></main>\n<footer><button id=\"play\">Play</button><input type=\"range\" id=\"moment\" min=\"0\" "
      "max=\"{}\" "
      "value=\"0\" aria-label=\"Step of the motion\"><output id=\"step\" data-all=\"{:.6g}\"></output>"
      "<label>Speed <select id=\"speed\"><option value=\"0.25\">1/4</option><option value=\"1\" "
      "selected>1</option>"
      "<option value=\"3\">3</option></select></label><label><input type=\"checkbox\" id=\"names\" checked> "
      "Names</label>"
      "<div id=\"places\">{}</div></footer>\n",
      scene.moments.size() - 1, steps, places_line(scene));
  page +=
      fmt::format("<script type=\"application/json\" id=\"scene\">{}</script>\n", scene_json(scene, scale)) +
      page_element("script", web_assets::animation) + "</body></html>\n";
  return page;
}

std::string animation_svg(const LinkageScene& scene) {
  const PictureScale scale = PictureScale::of(scene.lower, scene.upper);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\" width=\"800\" "
      "role=\"img\">\n<title>{}</title>\n"
      "<rect x=\"{}\" y=\"{}\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      scale.view_box(), html_escaped(scene.title), scale.number(scale.lower.x()),
      scale.number(scale.lower.y()));
  text += static_layers(scene, scale) + moving_bodies(scene, scale, true);
  for (const ScenePoint& point : scene.points) {
    if (!point.fixed) continue;
    const Point at = point.local + Point(1.6, -1.6) * scale.pin;
    text += fmt::format("<text {} x=\"{}\" y=\"{}\">{}</text>\n", look("name", scale), scale.number(at.x()),
                        scale.number(at.y()), html_escaped(point.name));
  }
  return text + "</svg>\n";
}

}  // namespace kempe
