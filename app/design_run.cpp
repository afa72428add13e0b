#include "app/design_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/output_check.hpp"
#include "app/own_files.hpp"
#include "app/weight_lines.hpp"
#include "app/words.hpp"
#include "geometry/fixed_text.hpp"
#include "reports/certificate.hpp"
#include "reports/data/design_json.hpp"
#include "reports/data/error_budget_json.hpp"
#include "reports/data/feel_json.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "reports/drawings/making_notes.hpp"
#include "reports/drawings/overload_words.hpp"
#include "reports/drawings/tolerance_words.hpp"
#include "reports/drawings/tool_words.hpp"
#include "reports/earlier_design.hpp"
#include "reports/page/studio_page.hpp"
#include "specs/objective_unit.hpp"
#include "specs/spec_reader.hpp"
#include "specs/text/printable.hpp"
#include "specs/unit_words.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/design/copy_overlap.hpp"
#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/gravity.hpp"

namespace kempe::app {

std::string shown_name(const std::string& file) {
  using Json = nlohmann::json;
  const Json name(std::filesystem::path(file).filename().string());
  return Json::parse(name.dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

InputError as_in_file(InputError fault, SpecUnit unit) {
  fault.key = name_in(unit, fault.key);
  fault.allowed = keys_in(unit, fault.allowed);
  return fault;
}

tl::expected<LoadedSpec, InputError> load_spec(const Session& session, const std::string& file) {
  auto text = input_text(session, file);  // once: a pipe has nothing left for a second reading
  if (!text) return tl::unexpected(text.error());
  return spec_of_text(std::move(*text), file);
}

tl::expected<LoadedSpec, InputError> spec_of_text(std::string text, const std::string& file) {
  auto spec = read_spec(text, file, std::filesystem::path(file).parent_path());
  if (!spec) return tl::unexpected(spec.error());
  return LoadedSpec{file, std::move(text), std::move(*spec)};
}

SpecUnit LoadedSpec::unit() const { return unit_of_spec(text); }

std::vector<std::filesystem::path> LoadedSpec::inputs() const {
  std::vector<std::filesystem::path> all{file};
  if (const auto drawing = region_file_of(text))
    all.push_back(std::filesystem::path(file).parent_path() / *drawing);
  return all;
}

namespace {

std::string grounding_sentence(const CopyingLinkage& linkage) {
  return fmt::format("{} at the vertex V; pole {}, tracer {}, pen {}", name(linkage.grounding()),
                     letter(linkage.pole_joint()), letter(linkage.tracer_joint()),
                     letter(linkage.pen_joint()));
}

int decimals_for(const CopyingLinkage& linkage) { return decimals_of_size(linkage.size()); }

std::string lengths_table(const Design& design) {
  const LinkLengths lengths = design.linkage.lengths();
  const auto values = lengths.values();
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += fmt::format("  {} {:10.{}f} mm{}", LinkLengths::names[i], values[i], decimals_for(design.linkage),
                        i % 4 == 3 ? "\n" : "");
  return text;
}

std::string_view spoken(Objective objective) {
  return objective == Objective::copy_error   ? "copy error"
         : objective == Objective::load_error ? "load error"
                                              : name(objective);
}

/// What was sought; its figure only where no other line has it.
std::string objective_line(const SearchRecord& search, int decimals) {
  std::string text =
      fmt::format("{}objective    {} {}", search.complete ? "" : "STOPPED EARLY: the best so far\n",
                  is_maximized(search.objective) ? "largest" : "smallest", spoken(search.objective));
  if (search.objective == Objective::footprint)
    text += fmt::format(": {:.{}f} mm2", search.value, decimals + 1);
  return text + "\n";
}

std::string layers_line(const Design& design) {
  std::string text = "layers      ";
  for (const Link link : all_links)
    text += fmt::format("{} {} in {}", link == all_links.front() ? "" : ",", name(link), design.layers[link]);
  text += "; " + lowest_layer_words(raised_by(joint_stacks(design))) + "\n";
  for (const std::string& sentence : design.why_not_fewer_layers) text += "             " + sentence + "\n";
  return text;
}

/// Obstacles that the search could leave out.
std::string reach_line(std::size_t out_of_reach) {
  if (out_of_reach == 0) return "";
  return fmt::format("obstacles    {} out of reach of any permitted instrument\n", out_of_reach);
}

/// Why nothing is said of what other designs can reach.
std::string no_bound_line(const Design& design) {
  if (!design.search) return "";
  const Objective objective = design.search->objective;
  if (design.allowed && design.allowed->sections.size() > 1)
    return "bound        none is stated where there are sections to choose from\n";
  if (objective == Objective::load_error || objective == Objective::mass)
    return fmt::format("bound        none is stated for {}\n",
                       objective == Objective::mass ? "the mass" : "the load error");
  return "";
}

std::string bound_line(const Design& design) {
  if (!design.quality.proven_bound || !design.search) return no_bound_line(design);
  const bool angle = design.search->objective == Objective::transmission;
  const double bound = *design.quality.proven_bound;
  const double gap = std::abs(design.search->value - bound) / std::abs(design.search->value);
  std::string text = fmt::format(
      "bound        no design {} than {} {}", angle ? "has a larger angle" : "is smaller",
      shown(in_file_unit(design.search->objective, bound), 1 + (angle ? 3 : decimals_for(design.linkage))),
      angle ? "degrees" : "mm");
  if (design.limits.load_error) text += ", whatever limits.load_error_mm is";
  if (gap > 0.005) text += fmt::format(": {:.1f} % away", 100 * gap);
  return text + "\n";
}

/// "(12.500, 0.000)"
std::string place_text(const Point& place, int decimals) {
  return "(" + fixed_text(place.x(), decimals) + ", " + fixed_text(place.y(), decimals) + ")";
}

std::string relaxation_line(const Relaxation& relaxation, SpecUnit unit) {
  const CopyingLinkage& linkage = relaxation.design.linkage;
  const int d = decimals_for(linkage) + (unit == SpecUnit::inch ? 1 : 0);
  const double share = 1 / in_mm(unit);
  const auto& section = relaxation.design.section;
  return fmt::format("  {0}: {7}VA = {1:.{3}f} {4}, VB = {2:.{3}f} {4}, {5} at the vertex, pole {6} {4}\n",
                     relaxation.sentence, share * linkage.VA(), share * linkage.VB(), d, name(unit),
                     name(linkage.grounding()), place_text(share * linkage.pole(), d),
                     section ? fmt::format("links of {:.4g} x {:.4g} {}, ", share * section->width,
                                           share * section->thickness, name(unit))
                             : "");
}

std::string ratio_line(const Design& design) {
  std::string text = fmt::format("copy         scale {:.6g}, rotation {:.6g} degrees\n", design.scale,
                                 degrees(design.rotation));
  if (design.wanted)
    text += fmt::format(
        "             wanted: scale {:.6g}, rotation {:.6g} degrees; with stock lengths the copy is off by "
        "{:.2g} mm per 100 mm from the pole\n",
        design.wanted->scale, degrees(design.wanted->rotation), 100 * design.wanted->error);
  if (const std::string note = overlap_note(design); !note.empty()) text += "             " + note + "\n";
  return text;
}

std::string region_line(const Design& design) {
  if (design.region.empty())
    return fmt::format("region       none given; the collision-free workspace has {:.6g} mm2\n",
                       area(design.map.collision_free));
  return design.map.coverage.covered
             ? "region       covered: the tracer gets everywhere in it without contact\n"
             : "region       NOT COVERED: " + design.map.coverage.why_not + "\n";
}

/// Where the region is not reached there is no figure: the quality is then 0.
std::string transmission_line(const Design& design) {
  if (design.quality.transmission_min > 0)
    return fmt::format("transmission {:.3f} degrees at least\n", degrees(design.quality.transmission_min));
  return design.region.empty() ? "transmission none: no opening keeps the limits\n"
                               : "transmission none: this assembly mode does not reach all of the region\n";
}

std::string opening_line(const OpeningInterval& opening) {
  if (opening.empty()) return "opening      none keeps the transmission angle and the clearance asked for\n";
  return fmt::format("opening      {} .. {} degrees from VA to VB, all proven free of contact\n",
                     fixed_text(degrees(opening.lower), 3), fixed_text(degrees(opening.upper), 3));
}

/// What robustness keeps, and what it costs.
std::string robust_line(const Design& design, int decimals) {
  const auto& robust = design.quality.robust;
  if (!robust) return "";
  if (!robust->holds)
    return fmt::format(
        "robust       NO: not proven for every instrument within {:.4g} mm and {:.4g} mm of play\n",
        design.tolerance->length, design.tolerance->play);
  std::string text =
      fmt::format("robust       every instrument within the tolerances keeps {} mm of clearance",
                  shown(robust->clearance, decimals));
  if (robust->nominal_value && design.search) {
    const Objective objective = design.search->objective;
    const double value = design.search->value, without = *robust->nominal_value;
    if (value == without)
      text += fmt::format("; its {} is the same as without", spoken(objective));
    else
      text += fmt::format(
          "; its {} is {} {} ({} %) {} than without", spoken(objective),
          shown(std::abs(in_file_unit(objective, value) - in_file_unit(objective, without)), decimals),
          objective == Objective::transmission ? "degrees" : unit_of(objective),
          shown(100 * std::abs(value - without) / std::abs(without), 1),
          value < without ? "smaller" : "larger");
  }
  return text + "\n";
}

/// "the links are stressed to 34.1 MPa, 24.5 MPa in the plane alone; steel bears 235 MPa".
std::string stress_words(const Design& design) {
  const double in_plane = design.quality.loads->stress_max;
  if (!std::isfinite(in_plane)) return "a hole leaves nothing of a link";
  const auto& layered = design.quality.layered;
  return fmt::format(
      "the links are stressed to {} MPa{}; {} bears {} MPa", three_digits(largest_stress(design)),
      layered && layered->stress_max ? fmt::format(", {} MPa in the plane alone", three_digits(in_plane))
                                     : std::string(" in the plane; out of it is not stated"),
      design.material->name, three_digits(design.material->strength));
}

/// What the load breaks or bends too far.
std::string overload_lines(const Design& design) {
  std::string text;
  std::vector<std::string> sentences = overload_words(design);
  if (auto words = large_bending_words(design)) sentences.push_back(*std::move(words));
  for (const std::string& words : sentences)
    text += (text.empty() ? "overload     " : "             ") + words + "\n";
  return text;
}

/// Forces, how far the pen gives way, what the links weigh.
std::string loads_lines(const Design& design) {
  std::string text;
  if (design.material && design.allowed && design.allowed->sections.size() > 1)
    text += fmt::format("section      {:g} x {:g} mm, of {} to choose from\n", design.style.width,
                        design.style.thickness, design.allowed->sections.size());
  if (const auto& loads = design.quality.loads) {
    const double weight = most_force_at_pen(*design.load) - design.load->pen_force;
    const auto& limit = design.limits.load_error;
    const auto whole = give_in_all(design.quality);
    text += fmt::format("load         {:g} N {}at the pen: it gives way by ", design.load->pen_force,
                        weight > 0 ? fmt::format("and {:.3g} N of weight ", weight) : "");
    const std::string allowed = limit ? fmt::format(" (limit {:.4g} mm)", *limit) : "";
    const bool in_all = design.limits.load_error_in_all;
    if (whole)
      text += fmt::format("{:.4g} mm at worst{}, with {}\n             and by ", *whole,
                          in_all ? allowed : "", beside_the_links(design));
    text += fmt::format("{:.4g} mm by the links alone{}, {:.4g} mm in the stiffest direction\n",
                        loads->error_max, in_all ? "" : allowed, loads->error_min);
    if (gives_too_far_in_all(design))
      text += fmt::format(
          "             limits.load_error_mm speaks of the links alone: with {} it is exceeded;\n"
          "             limits.load_error_in_all = true counts them\n",
          beside_the_links(design));
    text +=
        fmt::format("             the hand holds {} N against the pen's force, the worst pin bears {} N{}\n",
                    three_digits(loads->hand_force_max), three_digits(loads->pin_force_max),
                    loads->weight_error_max ? " with the links' own weight" : "");
    text += "             " + stress_words(design) + "\n";
  }
  if (design.quality.mass)
    text += fmt::format("mass         {:.4g} kg: the four links of {}\n", *design.quality.mass,
                        design.material->name);
  return text;
}

/// What to put on the tracer, or how to draw the template, so that the cut is right.
std::string tool_lines(const std::optional<ToolAdvice>& tool) {
  std::string text;
  for (const std::string& words : tool_words(tool))
    text += (text.empty() ? "tool         " : "             ") + words + "\n";
  return text;
}

/// With four decimals, or of what is smaller three digits.
std::string error_text(double error) {
  return error == 0 || error >= 0.001 ? fmt::format("{:.4f}", error) : fmt::format("{:.3g}", error);
}

std::string copy_error_lines(const Design& design) {
  const Quality& q = design.quality;
  if (!q.copy_error_worst) return "";
  std::string text = fmt::format(
      "copy error   {} mm in the worst case, {} mm typically (root of the sum of squares)\n"
      "             {} mm of distortion, which no change of scale, rotation and origin removes\n",
      error_text(*q.copy_error_worst), error_text(q.copy_error_rss.value_or(0)),
      error_text(q.distortion_worst.value_or(0)));
  for (const std::string& words : tolerance_words(design)) text += "             " + words + "\n";
  return text;
}

/// The command that checks the proof's log, with the design or alone.
std::string how_to_check(const std::filesystem::path& folder, bool with_design) {
  const auto path = [&](std::string_view name) {
    return " " + printable(shell_word((folder / name).string()));
  };
  return "check it with: " + checker_command() + (with_design ? path("design.json") : "") +
         path(certificate_name);
}

}  // namespace

std::string summary_text(const Design& design, SpecUnit unit, const std::filesystem::path& folder,
                         const std::vector<std::string>& files, const std::vector<std::string>& left_out) {
  const Quality& q = design.quality;
  const Point& pole = design.linkage.pole();
  const int decimals = decimals_for(design.linkage);
  std::string text = keys_in(unit, ratio_line(design));
  text += fmt::format("grounding    {}\n", grounding_sentence(design.linkage));
  text += fmt::format("pole         {} mm\n", place_text(pole, decimals));
  text += "lengths\n" + lengths_table(design) + layers_line(design);
  if (design.search)
    text +=
        reach_line(design.search->obstacles_out_of_reach.size()) + objective_line(*design.search, decimals);
  text += keys_in(unit, bound_line(design));
  text += fmt::format("size         {:.{}f} mm: half the perimeter round each link's joints, summed\n",
                      q.size, decimals);
  text += transmission_line(design) + opening_line(design.opening);
  if (std::isfinite(q.clearance_min))
    text += fmt::format("clearance    {} mm at least, {}\n", shown(q.clearance_min, decimals),
                        design.map.clearance_min_parts);
  else if (!design.map.complete && !design.region.empty())
    text += "clearance    NOT MEASURED: stopped early; the limit is kept where the region is covered\n";
  text += keys_in(unit, copy_error_lines(design));
  text += keys_in(unit, overload_lines(design));
  text += keys_in(unit, loads_lines(design));
  text += weight_lines(design);
  text += keys_in(unit, budget_lines(design));
  text += robust_line(design, decimals);
  if (!design.map.complete) text += "map          STOPPED EARLY: coarser than asked for\n";
  text += keys_in(unit, region_line(design));
  text += tool_lines(design.tool);
  text += fmt::format(
      "verified     {} positions{} by the general solver: copy error {:.2g} mm, loop residual {:.2g} mm, {} "
      "changes of assembly mode\n",
      design.verification.samples, design.verification.over_workspace ? " of the free workspace" : "",
      design.verification.copy_error_max, design.verification.loop_residual_max, design.verification.flips);
  for (const std::string& note : part_notes(design))
    text += fmt::format("parts        {}\n", keys_in(unit, note));
  text += fmt::format("written      {}:", printable(folder.string()));
  bool has_parts = false;
  for (const std::string& file : files) {
    const bool is_part = file.starts_with("parts/");
    if (!is_part || !has_parts) text += is_part ? " parts/" : " " + file;
    has_parts = has_parts || is_part;
  }
  text += "\n";
  if (std::find(files.begin(), files.end(), certificate_name) != files.end())
    text += "proof        " + how_to_check(folder, true) + "\n";
  for (const std::string& sentence : left_out) text += "             " + keys_in(unit, sentence) + "\n";
  return text;
}

std::string summary_json(const Design& design, const std::filesystem::path& folder,
                         const std::vector<std::string>& files, const std::vector<std::string>& left_out) {
  nlohmann::ordered_json object = design_values(design);
  object.erase("region");
  object["coverage"] = {{"covered", design.map.coverage.covered}, {"why_not", design.map.coverage.why_not}};
  object["copy_overlaps_original"] = copy_overlaps_original(design);
  object["folder"] = folder.string();
  object["files"] = files;
  object["left_out"] = left_out;
  if (const auto budget = error_budget(design)) object["error_budget"] = error_budget_values(*budget);
  if (auto feel = feel_values(design)) object["feel"] = *std::move(feel);
  object["notes"] = making_notes(design);
  for (const std::string& words : tolerance_words(design)) object["notes"].push_back(words);
  return json_text(object);
}

namespace {

/// A limit by its name, anything else by its key; joints are kept apart by shortest_mm, or by their holes.
std::string limit_word(const Relaxation& relaxation) {
  if (!relaxation.limit) return relaxation.key.substr(relaxation.key.find('.') + 1);
  const bool by_holes = *relaxation.limit == Goal::shortest && relaxation.key != "links.shortest_mm";
  return by_holes ? "holes" : std::string(name(*relaxation.limit));
}

}  // namespace

int tell_no_design(const Session& session, const NoDesign& none, SpecUnit unit,
                   const std::optional<ProofFolder>& proof) {
  const std::string verdict = none.proven ? "no design exists" : none_found;
  std::string message = verdict +
                        (none.proven ? " (proven: no linkage can): " : " (not proven: one may exist): ") +
                        none.sentence + "\n";
  std::vector<std::string> files, left_out;
  const bool holds_design = proof && !design_files_in(proof->folder).empty();
  if (none.proven && holds_design) {
    left_out.push_back(fmt::format("{} is left out: {} holds a design. Another -o takes the log.",
                                   certificate_name, printable(proof->folder.string())));
    message += "  " + left_out.back() + "\n";
  } else if (none.proven && proof) {
    const auto log = certificate_of_none(proof->spec.spec, proof->stop);
    if (!log) {
      left_out.push_back(left_out_sentence(log.error()));
      message += "  " + left_out.back() + "\n";
    } else {
      if (const auto clash = output_clash(proof->spec.inputs(), proof->folder, {certificate_name}))
        return fail(session, *clash);
      if (const auto written = write_whole(proof->folder, {{certificate_name, *log}}); !written)
        return fail(session, cannot_write, written.error());
      message += "  " + how_to_check(proof->folder, false) + "\n";
      files.push_back(certificate_name);
    }
  }
  if (!none.diagnosed) message += "  ended before every limit was relaxed\n";
  if (!none.obstacles_out_of_reach.empty()) message += "  " + reach_line(none.obstacles_out_of_reach.size());
  for (const Relaxation& relaxation : none.relaxations) message += relaxation_line(relaxation, unit);
  message.pop_back();
  if (session.json) {
    nlohmann::ordered_json object{{"error", verdict},
                                  {"requirement", none.requirement},
                                  {"sentence", none.sentence},
                                  {"proven", none.proven},
                                  {"diagnosed", none.diagnosed},
                                  {"files", files},
                                  {"left_out", left_out},
                                  {"obstacles_out_of_reach", none.obstacles_out_of_reach}};
    object["relaxations"] = nlohmann::ordered_json::array();
    for (const Relaxation& relaxation : none.relaxations)
      object["relaxations"].push_back({{"limit", limit_word(relaxation)},
                                       {"key", relaxation.key},
                                       {"sentence", relaxation.sentence},
                                       {"least", relaxation.is_least},
                                       {"vertex", std::string(name(relaxation.design.linkage.grounding()))},
                                       {"VA_mm", relaxation.design.linkage.VA()},
                                       {"VB_mm", relaxation.design.linkage.VB()}});
    print(json_text(object));
  }
  return fail_told(none.proven ? no_design : stopped, message);
}

CLI::Option* add_paper_option(CLI::App& command, Paper& paper) {
  const auto read = [&paper](const std::string& text) {
    if (text == "A4" || text == "a4")
      paper = Paper::A4;
    else if (text == "A3" || text == "a3")
      paper = Paper::A3;
    else
      throw CLI::ValidationError("--paper", fmt::format("found {}; allowed: A4 or A3", text));
  };
  return command.add_option_function<std::string>("--paper", read, "Paper of workshop.pdf: A4 or A3")
      ->option_text("A4|A3");
}

int publish_design(const Session& session, Design& design, const LoadedSpec& spec,
                   const std::filesystem::path& folder, const TimeToFinish& time,
                   const std::string& studio_page, Paper paper, int threads,
                   std::optional<CertificateOrNone> proof) {
  ReportExtras extras;
  extras.program_version = KEMPE_VERSION;
  extras.spec_name = shown_name(spec.file);
  extras.spec_text = spec.text;
  extras.paper = paper;
  if (!studio_page.empty()) extras.studio_page = studio_page_name;
  FolderDraft draft(folder);
  const auto drafted = draft_design(design, extras, draft, time, threads, std::move(proof));
  if (!drafted)
    return fail(session, drafted.error().by == NotPublished::By::writing ? cannot_write : verification_failed,
                drafted.error().sentence);
  if (!studio_page.empty())
    if (const auto added = draft.add({studio_page_name, studio_page}); !added)
      return fail(session, cannot_write, added.error());
  const std::vector<std::string> files = draft.names(), earlier = design_files_in(folder);
  for (const std::vector<std::string>& names : {files, earlier})
    if (const auto clash = output_clash(spec.inputs(), folder, names)) return fail(session, *clash);
  if (const auto written = draft.put_in_place(); !written)
    return fail(session, cannot_write, written.error());
  const std::vector<std::string>& left_out = drafted->left_out;
  std::vector<std::string> told = left_out;  // and what is no news on stderr
  if (const auto removed = remove_left_over(folder, earlier, files); !removed.empty())
    told.push_back(removed_sentence(removed));
  answer(session, summary_text(design, spec.unit(), folder, files, told),
         summary_json(design, folder, files, told));
  for (const std::string& sentence : left_out) say(keys_in(spec.unit(), sentence));
  return done;
}

}  // namespace kempe::app
