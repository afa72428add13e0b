#include "reports/drawings/step_assembly.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/drawings/step_module.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

/// Where a part lies in the assembly: its first two holes on their joints.
Placement in_pose(const CutPart& part, const Pose& pose) {
  const Complex drawn = as_complex(part.holes[1].centre - part.holes[0].centre);
  const Complex there = as_complex(pose[part.holes[1].joint] - pose[part.holes[0].joint]);
  const double turn = std::arg(there / drawn);
  return {pose[part.holes[0].joint] - as_point(as_complex(part.holes[0].centre) * std::polar(1.0, turn)),
          turn};
}

StepPlate plate(const CutPart& part, const Placement& placement, double raised) {
  const double bottom = raised + (part.layer - 1) * part.thickness;
  StepPlate plate{part.name, {}, {}, bottom, bottom + part.thickness};
  for (const ArcVertex& corner : placed(part.outline, placement))
    plate.outline.push_back({corner.at.x(), corner.at.y(), corner.bulge});
  for (const CutPart::Hole& hole : part.holes) {
    const Point centre = placed(hole.centre, placement);
    plate.holes.push_back({centre.x(), centre.y(), hole.diameter});
  }
  return plate;
}

StepCylinder pin(const JointStack& stack, const Pose& pose, double raised) {
  const Point& at = pose[stack.joint];
  const double bottom = stack.is_post ? 0 : raised + stack.from;
  return {stack.name, at.x(), at.y(), stack.diameter, bottom, raised + stack.to};
}

StepParts parts_in_pose(const Design& design, const CuttingSpec& cutting) {
  StepParts parts{"copying linkage", {}, {}};
  const Pose pose = assembly_pose(design);
  const auto stacks = joint_stacks(design);
  const double raised = raised_by(stacks);
  for (const CutPart& part : cut_parts(design, finished(cutting)))
    parts.plates.push_back(plate(part, in_pose(part, pose), raised));
  for (const JointStack& stack : stacks) parts.cylinders.push_back(pin(stack, pose, raised));
  return parts;
}

constexpr const char* how_to_add =
    "scripts/bootstrap step && scripts/build release -DKEMPE_WITH_OCCT=ON adds it";

/// The module's function, or why it is not there. A module once loaded stays: OpenCASCADE cannot be unloaded.
tl::expected<WriteStep, std::string> load_module() {
  if (void* module = ::dlopen(KEMPE_STEP_MODULE, RTLD_LAZY | RTLD_LOCAL))
    if (void* found = ::dlsym(module, write_step_symbol)) return reinterpret_cast<WriteStep>(found);
  const char* said = ::dlerror();
  const std::string fault = said ? said : KEMPE_STEP_MODULE " is another program's";
  // The loader begins with the file that it could not find: the module, or a library that the module needs.
  return tl::unexpected(
      fault.starts_with(KEMPE_STEP_MODULE ":")
          ? fmt::format("it is written where Kempe is built with OpenCASCADE; {}", how_to_add)
          : fmt::format("{}; {}", fault, how_to_add));
}

const tl::expected<WriteStep, std::string>& step_module() {
  static const auto module = load_module();
  return module;
}

/// A file that is gone when this is.
class ScratchFile {
 public:
  ScratchFile() {
    std::error_code none;
    name_ = (std::filesystem::temp_directory_path(none) / "kempe-XXXXXX.step").string();
    const int file = ::mkstemps(name_.data(), 5);
    if (file < 0)
      name_.clear();
    else
      ::close(file);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code none;
    if (!name_.empty()) std::filesystem::remove(name_, none);
  }

  const std::string& name() const { return name_; }  ///< empty if there is none

 private:
  std::string name_;
};

}  // namespace

std::optional<std::string> why_no_step() {
  if (step_module()) return {};
  return "no parts/assembly.step: " + step_module().error();
}

tl::expected<std::string, std::string> step_assembly(const Design& design, const CuttingSpec& cutting) {
  if (const auto lack = why_no_step()) return tl::unexpected(*lack);
  const ScratchFile file;
  if (file.name().empty())
    return tl::unexpected(std::string("no parts/assembly.step: no temporary file can be made"));
  std::string fault;
  if (!(*step_module())(parts_in_pose(design, cutting), file.name().c_str(), fault))
    return tl::unexpected("no parts/assembly.step: OpenCASCADE: " + fault);
  auto text = read_text_file(file.name());
  if (!text) return tl::unexpected(std::string("no parts/assembly.step: OpenCASCADE wrote nothing"));
  return std::move(*text);
}

}  // namespace kempe
