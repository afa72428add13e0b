#include "reports/workshop/workshop_pdf.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "reports/data/design_json.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/workshop/content_hash.hpp"
#include "reports/workshop/pdf.hpp"
#include "reports/workshop/sheets.hpp"

namespace kempe {
namespace {

using workshop::Sheet;

std::vector<Sheet> all_sheets(const workshop::Task& task) {
  std::vector<Sheet> sheets{assembly_sheet(task)};
  const auto append = [&](std::vector<Sheet> more) {
    sheets.insert(sheets.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  append(list_sheets(task));
  append({stack_sheet(task)});
  for (const Link link : all_links) append(link_sheets(task, link));
  append(bench_sheets(task));
  return sheets;
}

/// "1.4"; of a ratio of small numbers whose decimals do not end "2:3".
std::string scale_words(double scale) {
  constexpr int most = 20;
  constexpr double rounding = 1e-12;
  const std::string decimals = fmt::format("{:.6g}", scale), shortest = fmt::format("{}", scale);
  if (decimals == shortest) return decimals;
  for (int below = 1; below <= most; ++below)
    if (const double above = std::round(scale * below);
        above >= 1 && above <= most && std::abs(above / below - scale) <= rounding * scale)
      return fmt::format("{:.0f}:{}", above, below);
  return decimals;
}

}  // namespace

std::string workshop_pdf(const Design& design, const WorkshopJob& job) {
  workshop::Pdf pdf;
  const workshop::Lettering lettering = pdf.lettering();
  const auto bill = bill_of_materials(design);
  std::vector<Sheet> sheets = all_sheets({design, bill, job.paper, lettering});
  const std::string copy =
      fmt::format("scale {}, rotation {:.6g}\u00b0", scale_words(design.scale), degrees(design.rotation));
  const workshop::Job block{job.title.empty() ? drawing_title(design) : job.title, copy, "",
                            workshop::content_hash(design_json(design)), job.program_version};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    draw_frame(sheets[i], block, i + 1, sheets.size(), lettering);
    pdf.add(sheets[i]);
  }
  return pdf.bytes(block.title);
}

}  // namespace kempe
