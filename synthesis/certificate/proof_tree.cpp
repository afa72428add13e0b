// The trees of all roots (root_proof.hpp has what is done at one node), each depth first, and how the bound gives way where none closes.

#include "synthesis/certificate/proof_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <variant>

#include "synthesis/certificate/root_proof.hpp"
#include "workspace/obstructions.hpp"

namespace kempe::certificate {
namespace {

/// The bound that a tree is grown for. Where no box of doubles is small enough for it, it is made looser.
class Loosening {
 public:
  Loosening(Objective objective, const std::optional<double>& bound)
      : given_(bound), direction_(is_maximized(objective) ? 1 : -1) {}

  std::optional<double> bound() const {
    if (!given_) return std::nullopt;
    const double share = slack::given_way[step_];
    if (direction_ < 0) return *given_ * (1 - share);
    return share < 1 ? std::min(*given_ * (1 + share), pi / 2) : pi / 2;  // no transmission angle is larger
  }
  double given_way() const { return slack::given_way[step_]; }
  bool loosen() {
    if (!given_ || step_ + 1 == std::size(slack::given_way)) return false;
    ++step_;
    return true;
  }

 private:
  std::optional<double> given_;
  double direction_;
  std::size_t step_ = 0;
};

/// One root's tree, depth first. A bound of size stands in sums only, and what refutes a node with one refutes it with a looser one,
/// too: where no box is small enough and no place of the tracer shows an obstacle that is met, the tree goes on with the looser one
/// from the largest box that this refutes.
class Growth {
 public:
  Growth(RootProof& proof, Loosening& bound, RegionPlaces& places, std::vector<Line>& lines)
      : proof_(proof), bound_(bound), places_(places), lines_(lines), first_line_(lines.size()) {
    open_.push_back({proof.whole(), 0});
  }

  tl::expected<void, NoLog> run(std::size_t most_lines, const StopFlag& stop) {
    while (!open_.empty()) {
      if (stop()) return tl::unexpected(NoLog::stopped);
      if (lines_.size() >= most_lines) return tl::unexpected(NoLog::too_long);
      const std::size_t depth = open_.back().depth;
      Node node = std::move(open_.back().node);
      open_.pop_back();
      path_.resize(depth);
      auto step = proof_.step(node);
      path_.push_back({std::move(node), lines_.size(), open_.size()});
      if (!step) {
        if (!look_from_more_places() && !go_back()) return tl::unexpected(NoLog::too_tight);
        continue;
      }
      lines_.push_back(std::move(step->line));
      for (auto child = step->children.rbegin(); child != step->children.rend(); ++child)
        open_.push_back({std::move(*child), depth + 1});
    }
    return {};
  }

 private:
  struct Waiting {
    Node node;
    std::size_t depth = 0;
  };
  /// A node on the way down, and what there was when it was come to.
  struct Visit {
    Node node;
    std::size_t lines = 0, open = 0;
  };

  /// Adds a place at which obstacles are looked at, if the last node shows one where one is met, and begins anew, as many boxes are larger
  /// with it. After some such places that no longer pays: then the tree goes on from the largest box on the way down that the place refutes.
  bool look_from_more_places() {
    constexpr int most_begun_anew = 20, most_added = 400;
    if (added_ == most_added) return false;
    const auto place = proof_.place_met(path_.back().node);
    if (!place) return false;
    ++added_;
    places_.add(*place);
    if (added_ <= most_begun_anew) {
      lines_.resize(first_line_);
      path_.clear();
      open_.assign(1, {proof_.whole(), 0});
      return true;
    }
    return go_up_to([&](Node node) {
      const auto step = proof_.step(node);
      return step && step->children.empty();
    });
  }

  /// Takes back what is below the first node on the way down of which this is true, and goes on from there; false if there is none.
  bool go_up_to(const std::function<bool(const Node&)>& is_refuted) {
    const auto refuted =
        std::find_if(path_.begin(), path_.end(), [&](const Visit& visit) { return is_refuted(visit.node); });
    if (refuted == path_.end()) return false;
    lines_.resize(refuted->lines);
    open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(refuted->open), open_.end());
    open_.push_back({refuted->node, static_cast<std::size_t>(refuted - path_.begin())});
    return true;
  }

  /// Loosens the bound until it refutes a node on the way down; false if none does.
  bool go_back() {
    while (proof_.bounds_size() && bound_.loosen()) {
      proof_.bound_size(bound_.bound());
      if (go_up_to([&](const Node& node) { return proof_.refuted_by_sum(node.cell); })) return true;
    }
    return false;
  }

  RootProof& proof_;
  Loosening& bound_;
  RegionPlaces& places_;
  std::vector<Line>& lines_;
  std::size_t first_line_ = 0;
  int added_ = 0;
  std::vector<Waiting> open_;
  std::vector<Visit> path_;
};

bool bodies_may_meet_things(const Spec& spec) {
  const std::vector<Obstruction> all = obstructions_of(spec.obstacles, spec.bodies, spec.table);
  return std::any_of(all.begin(), all.end(), [](const Obstruction& one) { return one.met.has_value(); });
}

bool copy_gap_decides_poles(const Spec& spec) {
  return spec.limits.copy_gap && std::holds_alternative<Region>(spec.pole.place);
}

tl::expected<ProofLog, NoLog> log_of(const Spec& spec, RegionPlaces& places, Objective objective,
                                     Loosening& bound, const ProofOptions& options, CutOrder order) {
  const bool by_size = objective == Objective::size;
  const double transmission =
      by_size ? spec.limits.transmission : std::max(spec.limits.transmission, bound.bound().value_or(0));
  ProofLog log{objective, std::nullopt, {}};
  for (const Grounding grounding : all_groundings) {
    const auto& permitted = spec.objective.groundings;
    if (std::find(permitted.begin(), permitted.end(), grounding) == permitted.end()) continue;
    for (const AssemblyMode& mode : assembly_modes(shape_of(spec.copy.k(), grounding))) {
      RootProof proof(spec, places, grounding, mode, by_size ? bound.bound() : std::nullopt, transmission,
                      order);
      Growth growth(proof, bound, places, log.lines);
      if (const auto grown = growth.run(options.lines, options.stop); !grown)
        return tl::unexpected(grown.error());
    }
  }
  log.bound = bound.bound();
  return log;
}

}  // namespace

std::string reason(NoLog why, const ProofOptions& options) {
  switch (why) {
    case NoLog::too_long: return fmt::format("its proof takes more than {} lines", options.lines);
    case NoLog::stopped: return "its proof did not close before the time was over";
    case NoLog::too_tight:
      return "some linkages are so near to what is forbidden that no box of doubles parts them from it";
    case NoLog::bodies:
      return "its rules do not say where a body meets an obstacle, the table's edge or another body";
    case NoLog::loads:
      return "it has no rules for loads, and it is a limit on load error or sag that no design keeps";
    case NoLog::sections: return "it is of one cross-section, and the spec allows several";
    case NoLog::no_rules: break;
  }
  return "only size and transmission have rules";
}

tl::expected<ProofLog, NoLog> prove(const Spec& spec, Objective objective, const std::optional<double>& bound,
                                    const ProofOptions& options) {
  if ((objective != Objective::size && objective != Objective::transmission) || spec.region.empty())
    return tl::unexpected(NoLog::no_rules);
  if (options.stop()) return tl::unexpected(NoLog::stopped);
  RegionPlaces places(spec.region);
  Loosening loosening(objective, bound);
  while (true) {
    auto log = log_of(spec, places, objective, loosening, options, CutOrder::by_sum);
    if (!log && log.error() == NoLog::too_long && copy_gap_decides_poles(spec))
      log = log_of(spec, places, objective, loosening, options, CutOrder::poles_first);
    if (log) return log;
    const NoLog why = log.error();
    if (why == NoLog::stopped || !loosening.loosen())
      return tl::unexpected(why != NoLog::stopped && bodies_may_meet_things(spec) ? NoLog::bodies : why);
    while (why == NoLog::too_long && loosening.given_way() < slack::much_shorter) loosening.loosen();
  }
}

}  // namespace kempe::certificate
