#pragma once
// Everything a person takes away from a design, as files by name. To add an output: its function, and its line here.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/stop_flag.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/drawings/part_files.hpp"
#include "reports/page/html_report.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// What a time limit leaves for a design that is found. Unless they are set, all is done.
struct TimeToFinish {
  StopFlag enough{};  ///< set: what takes long is cut short
  StopFlag over{};    ///< set: what can be left out is
};

/// Why a file is left out.
std::string left_out_for_time(const std::string& file);

/// What is made before the rest: what states neither a design's bound nor its verification can be made before they are known.
struct EarlyFiles {
  std::vector<OutputFile> files;  ///< those that are not made are empty
  std::string workshop;           ///< workshop.pdf, if bound and verification were settled first
  std::optional<PartFiles> parts;
  std::optional<MapPicture> picture;  ///< for the report
};

/// Jobs that make them, each independent of the others: what is given here must outlive them. Of a region of very many corners the parts
/// alone, so that no large texts wait in memory for others. Nothing more is made once `time.over` is set. `settle` fills in bound and
/// verification, which no other job looks at: the first job calls it and goes on with workshop.pdf, which names the contents of design.json.
std::vector<std::function<void()>> early_jobs(const Design& design, const CuttingSpec& cutting,
                                              const ReportExtras& extras, const TimeToFinish& time,
                                              const std::function<void()>& settle, EarlyFiles& to);

/// Gives the files of a design's folder to `take`, one after the other: design.json first, map, drawings and report,
/// then those of the parts (part_files.hpp). Stops at the first error of `take` and returns it; else what is left out and
/// why. What is given depends on the other arguments alone, and on time: once `enough` is set, the assembly as STEP is left
/// out, once `over` is, every file is but design.json and the tables. What `early` holds is taken from there. The rest is made on up to
/// `threads` threads, of a region of very many corners on one.
tl::expected<std::vector<std::string>, std::string> make_design_package(
    const Design& design, const CuttingSpec& cutting, const ReportExtras& extras,
    const std::function<tl::expected<void, std::string>(const OutputFile&)>& take,
    const TimeToFinish& time = {}, EarlyFiles early = {}, int threads = 1);

}  // namespace kempe
