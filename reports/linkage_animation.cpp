#include "reports/linkage_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "reports/html_text.hpp"
#include "reports/linkage_picture.hpp"

namespace kempe {
namespace {

constexpr double seconds_of_motion = 5;

std::string static_layers(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (const std::size_t traced : scene.traced) text += trace_curve(scene, traced, scale) + "\n";
  text +=
      fmt::format("<g style=\"color:{}\">{}</g>\n", link_colour(0), body_shape(scene.bodies[0], 0, scale));
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
    text += fmt::format("<g id=\"body{}\" style=\"color:{}\" transform=\"{}\"><title>{}</title>{}{}</g>\n",
                        number, link_colour(number), group_transform(scene.moments[0], body, scale),
                        html_escaped(scene.bodies[body].name), body_shape(scene.bodies[body], number, scale),
                        motion);
  }
  return text;
}

std::string names_at_start(const LinkageScene& scene, const PictureScale& scale) {
  std::string text;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const Point at = scene.place(scene.points[i], scene.moments[0]) + Point(1.6, -1.6) * scale.pin;
    text += fmt::format("<text class=\"name\" id=\"name{}\" x=\"{}\" y=\"{}\">{}</text>", i,
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

constexpr std::string_view page_style = R"(
:root{color-scheme:light}*{box-sizing:border-box}
body{margin:0;font:15px/1.5 system-ui,sans-serif;color:#222;background:#f5f4f0;display:flex;flex-direction:column;height:100vh}
header{padding:.7rem 1.2rem .2rem}h1{font:600 1.25rem Georgia,serif;margin:0}header p{margin:.1rem 0 0;color:#666}
main{flex:1;min-height:0;padding:.4rem 1.2rem}
svg{width:100%;height:100%;background:#fff;border:1px solid #ddd;border-radius:6px}
footer{display:flex;flex-wrap:wrap;gap:.8rem 1.1rem;align-items:center;padding:.5rem 1.2rem .9rem}
button{font:inherit;min-width:5.5rem;padding:.35rem .9rem;border:1px solid #0b6e99;border-radius:5px;background:#0b6e99;color:#fff;cursor:pointer}
button:focus-visible,input:focus-visible,select:focus-visible{outline:3px solid #f2b134}
input[type=range]{flex:1;min-width:12rem;accent-color:#0b6e99}
output,table{font-variant-numeric:tabular-nums}output{min-width:9.5rem}
#places{width:100%;display:flex;flex-wrap:wrap;gap:.2rem 1.6rem;color:#444;min-height:1.5em}
#places b{font:italic 1em Georgia,serif}
@media print{footer{display:none}body{background:#fff}}
)";

constexpr std::string_view page_script = R"(
const scene=JSON.parse(document.getElementById('scene').textContent);
const $=id=>document.getElementById(id), svg=$('picture'), slider=$('moment'), play=$('play');
const bodies=(scene.moments[0].length-1)/3, names=[...svg.querySelectorAll('.name')];
let now=0,way=1,running=false,last=null,exact=0;
function place(i,m){const [b,x,y]=scene.points[i];if(b===0)return[x,y];
  const o=3*b-2,c=Math.cos(m[o+2]),s=Math.sin(m[o+2]);return[m[o]+c*x-s*y,m[o+1]+s*x+c*y];}
const plain=v=>{const t=v.toFixed(scene.decimals);return +t===0?(0).toFixed(scene.decimals):t;};
function show(i){now=i;const m=scene.moments[i];
  for(let b=1;b<=bodies;b++){const o=3*b-2;
    $('body'+b).setAttribute('transform',`translate(${m[o]} ${m[o+1]}) rotate(${m[o+2]*180/Math.PI})`);}
  names.forEach((t,k)=>{const p=place(k,m);t.setAttribute('x',p[0]+scene.offset);t.setAttribute('y',p[1]-scene.offset);});
  scene.traced.forEach(k=>{const p=place(k,m),dot=$('dot'+k);dot.setAttribute('cx',p[0]);dot.setAttribute('cy',p[1]);
    $('place'+k).textContent=`(${plain(p[0])}, ${plain(-p[1])}) ${scene.unit}`;});
  slider.value=i;$('step').textContent='step '+(+m[0].toFixed(2))+' of '+$('step').dataset.all;
  slider.setAttribute('aria-valuetext',$('step').textContent);}
function tick(t){if(!running)return;
  if(last!==null){exact+=way*(t-last)/1000*(scene.moments.length-1)/scene.seconds*$('speed').value;
    const end=scene.moments.length-1;
    if(scene.closed){exact=((exact%end)+end)%end;}
    else{if(exact>end){exact=2*end-exact;way=-1;}if(exact<0){exact=-exact;way=1;}exact=Math.min(end,Math.max(0,exact));}
    show(Math.round(exact));}
  last=t;requestAnimationFrame(tick);}
function run(on){running=on;last=null;play.textContent=on?'Pause':'Play';play.setAttribute('aria-pressed',on);
  if(on){exact=now;requestAnimationFrame(tick);}}
play.onclick=()=>run(!running);
slider.oninput=()=>{run(false);show(+slider.value);};
$('names').onchange=e=>names.forEach(t=>t.style.display=e.target.checked?'':'none');
addEventListener('keydown',e=>{const step={ArrowLeft:-1,ArrowRight:1}[e.key];
  if(e.key===' '&&e.target!==play){e.preventDefault();run(!running);}
  else if(step&&e.target!==slider&&e.target.id!=='speed'){run(false);show(Math.min(scene.moments.length-1,Math.max(0,now+step)));}});
const asked=/^#(\d+)$/.exec(location.hash);
show(asked?Math.min(+asked[1],scene.moments.length-1):0);
if(!asked&&!matchMedia('(prefers-reduced-motion: reduce)').matches)run(true);
)";

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
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n";
  page +=
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width\">\n";
  page += fmt::format("<title>{}</title>\n<style>{}{}</style></head><body>\n", title, page_style,
                      picture_style(scale));
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
  page += fmt::format(
      "<script type=\"application/json\" id=\"scene\">{}</script>\n<script>{}</script>\n</body></html>\n",
      scene_json(scene, scale), page_script);
  return page;
}

std::string animation_svg(const LinkageScene& scene) {
  const PictureScale scale = PictureScale::of(scene.lower, scene.upper);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{}\" width=\"800\" "
      "role=\"img\">\n<title>{}</title>\n"
      "<style>{}</style>\n<rect x=\"{}\" y=\"{}\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      scale.view_box(), html_escaped(scene.title), picture_style(scale), scale.number(scale.lower.x()),
      scale.number(scale.lower.y()));
  text += static_layers(scene, scale) + moving_bodies(scene, scale, true);
  for (const ScenePoint& point : scene.points) {
    if (!point.fixed) continue;
    const Point at = point.local + Point(1.6, -1.6) * scale.pin;
    text += fmt::format("<text class=\"name\" x=\"{}\" y=\"{}\">{}</text>\n", scale.number(at.x()),
                        scale.number(at.y()), html_escaped(point.name));
  }
  return text + "</svg>\n";
}

}  // namespace kempe
