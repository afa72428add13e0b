#pragma once
// The strategy for every goal that a formula gives: lengths and pole by each choice's own search, pruned by what the choice can
// be at best without contact.

#include "synthesis/search/strategies/strategy.hpp"

namespace kempe {

class LengthStrategy final : public Strategy {
 public:
  std::vector<Prospect> relax(const SearchTask& task, const std::vector<RelaxedDesign>& known,
                              Incumbent& best) const override;
  ChoiceResult search(const SearchTask& task, const Prospect& prospect,
                      const ChoiceResult& best) const override;
  void certify(const SearchTask& task, Prospect& prospect, const ChoiceResult& found,
               Incumbent& best) const override;
  void finish(const SearchTask& task, Incumbent& best) const override;
};

}  // namespace kempe
