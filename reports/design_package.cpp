#include "reports/design_package.hpp"

#include <algorithm>
#include <utility>

#include "kinematics/parallel.hpp"
#include "reports/data/design_json.hpp"
#include "reports/data/links_csv.hpp"
#include "reports/data/workspace_geojson.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/dxf_writer.hpp"
#include "reports/drawings/svg_writer.hpp"
#include "reports/workshop/workshop_pdf.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// How closely the map's arcs are followed, mm: a hundredth, and for linkages of few millimetres less.
double map_tolerance_of(const Design& design) {
  constexpr double most = 0.01, share = 1e-3;
  return std::min(most, share * chain_annulus(design.linkage).outer);
}

constexpr std::string_view workshop_name = "workshop.pdf";
constexpr const char* always[] = {"design.json", "links.csv", "bom.csv"};

bool is_needed(const std::string& file) {
  return std::find(std::begin(always), std::end(always), file) != std::end(always);
}

const std::string& title_of(const Design& design, const ReportExtras& extras) {
  return design.title.empty() ? extras.spec_name : design.title;
}

/// So few corners that all texts can be held at a time.
bool has_small_texts(const Design& design) {
  constexpr std::size_t most_corners = 20'000;
  std::size_t corners = 0;
  for (const Polygon& polygon : design.region.polygons) {
    corners += polygon.outer.size();
    for (const auto& hole : polygon.holes) corners += hole.size();
  }
  return corners <= most_corners;
}

std::string workshop_text(const Design& design, const ReportExtras& extras) {
  return workshop_pdf(design, {title_of(design, extras), extras.program_version, extras.paper});
}

using Text = std::function<std::string()>;

/// The files that state neither bound nor verification.
std::vector<std::pair<std::string, Text>> early_texts(const Design& design, const CuttingSpec& cutting) {
  return {{"links.csv", [&] { return links_csv(design); }},
          {"drawing.dxf", [&] { return dxf_text(design_drawing(design, cutting)); }},
          {"drawing.svg", [&] { return svg_text(design_drawing(design, cutting), drawing_title(design)); }},
          {"workspace.geojson", [&] { return workspace_geojson(design, map_tolerance_of(design)); }}};
}

}  // namespace

std::string left_out_for_time(const std::string& file) { return file + " is left out: the time was over."; }

std::vector<std::function<void()>> early_jobs(const Design& design, const CuttingSpec& cutting,
                                              const ReportExtras& extras, const TimeToFinish& time,
                                              const std::function<void()>& settle, EarlyFiles& to) {
  std::vector<std::function<void()>> jobs;
  const bool small = has_small_texts(design);
  if (settle)
    jobs.push_back([&, time, settle, small] {
      settle();
      if (small && !time.over()) to.workshop = workshop_text(design, extras);
    });
  if (small) {
    auto texts = early_texts(design, cutting);
    to.files.resize(texts.size());
    jobs.push_back([&design, &to, time] {
      if (!time.over()) to.picture = map_picture(design);
    });
    for (std::size_t i = texts.size(); i-- > 0;)  // the longest first
      jobs.push_back([&to, time, i, text = std::move(texts[i])] {
        if (!time.over()) to.files[i] = {text.first, text.second()};
      });
  }
  jobs.push_back([&design, &cutting, &to, time] { to.parts = part_files(design, cutting, time.enough); });
  return jobs;
}

tl::expected<std::vector<std::string>, std::string> make_design_package(
    const Design& design, const CuttingSpec& cutting, const ReportExtras& extras,
    const std::function<tl::expected<void, std::string>(const OutputFile&)>& take, const TimeToFinish& time,
    EarlyFiles early, int threads) {
  std::vector<std::string> left_out;
  const auto is_made_in_time = [&](const std::string& file) { return is_needed(file) || !time.over(); };
  const auto has_time_for = [&](const std::string& file) {
    if (is_made_in_time(file)) return true;
    left_out.push_back(left_out_for_time(file));
    return false;
  };
  std::vector<std::pair<std::string, Text>> files = early_texts(design, cutting);
  files.insert(files.begin(), {"design.json", [&] { return design_json(design); }});
  files.push_back({std::string(workshop_name), [&] { return workshop_text(design, extras); }});
  files.push_back({"report.html", [&] {
                     return early.picture ? html_report(design, extras, *early.picture)
                                          : html_report(design, extras);
                   }});
  std::vector<std::string> made(files.size());
  early.files.push_back({std::string(workshop_name), std::move(early.workshop)});
  for (OutputFile& file : early.files)
    for (std::size_t i = 0; i < files.size(); ++i)
      if (file.name == files[i].first) std::swap(made[i], file.contents);
  // Else one text after the other: those of a region of a million corners are large.
  if (has_small_texts(design))
    run_parallel(files.size(), threads, [&](std::size_t i) {
      if (made[i].empty() && is_made_in_time(files[i].first)) made[i] = files[i].second();
    });
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto& [name, text] = files[i];
    if (made[i].empty() && !has_time_for(name)) continue;
    if (auto taken = take({name, made[i].empty() ? text() : std::move(made[i])}); !taken)
      return tl::unexpected(taken.error());
  }
  if (!early.parts) early.parts = part_files(design, cutting, time.enough);
  for (const OutputFile& file : early.parts->files)
    if (has_time_for(file.name.string()))
      if (auto taken = take(file); !taken) return tl::unexpected(taken.error());
  left_out.insert(left_out.end(), early.parts->left_out.begin(), early.parts->left_out.end());
  return left_out;
}

}  // namespace kempe
