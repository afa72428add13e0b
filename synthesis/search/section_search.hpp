#pragma once
// Several sections to choose from: each is a choice of its own, as an assignment of layers is.

#include <functional>
#include <string>

#include "kempe/spec.hpp"
#include "synthesis/search/steps/outcome.hpp"
#include "synthesis/search/steps/search_options.hpp"

namespace kempe {

/// The spec with this section alone.
Spec with_section(Spec spec, const LinkSection& section);
/// "with none of the 3 sections; with 12 x 4 mm: " and the sentence, which says why there is no design with the last of the spec's
/// sections.
std::string of_no_section(const Spec& spec, SpecUnit unit, const std::string& sentence);

/// The best design with any of LinkSpec::sections (two or more): `search` is run for each, the lightest first, with an equal share of the
/// time that is left. Of designs that are equally good the lighter one comes back. No bound is stated: each section's own bound says nothing
/// of the others. Without a design the reason is that of the last section, the heaviest; it is proven if it is for every one.
SearchOutcome best_of_sections(const Spec& spec, const SearchOptions& options,
                               const std::function<SearchOutcome(const Spec&, const SearchOptions&)>& search);

}  // namespace kempe
