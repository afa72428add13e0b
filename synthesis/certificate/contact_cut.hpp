#pragma once
// Contact of the linkage with itself in a proof's tree: an opening that no design of a node can pass, because two of its parts touch
// there, cuts the node into those that stay below it and those that stay above.

#include <array>
#include <optional>

#include "synthesis/certificate/proof_node.hpp"

namespace kempe::certificate {

/// The search for openings that cut nodes of one root. Keeps a reference to the task.
class ContactCuts {
 public:
  explicit ContactCuts(const RootTask& task) : task_(task) {}

  /// The node cut at such an opening; a parting of its layer assignments where the two parts share no layer in some of them;
  /// or nothing.
  std::optional<Step> step(const Node& node) const;

 private:
  /// A cut with what is left on its two sides, and how many of them a sum refutes.
  struct SeenCut {
    ContactCut cut;
    std::array<DesignCell, 2> sides;
    int refuted = 0;
  };

  bounding::Range passed(const DesignCell& cell) const;
  std::optional<ContactCut> cut_at(const ContactPair& pair, const DesignCell& cell, double psi) const;
  std::optional<SeenCut> seen_cut(const ContactPair& pair, const DesignCell& cell, double psi) const;
  std::optional<SeenCut> farthest_cut(const ContactPair& pair, const DesignCell& cell, double from,
                                      double to) const;
  static bool narrows(const SeenCut& cut, const DesignCell& cell, const bounding::Range& range);
  std::optional<SeenCut> best_cut(const ContactPair& pair, const DesignCell& cell, double deepest,
                                  const bounding::Range& range) const;

  const RootTask& task_;
};

}  // namespace kempe::certificate
