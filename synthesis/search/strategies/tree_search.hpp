#pragma once
// The search among obstacles, beside bodies and under a limit on the load error by the tree of the proven bound: it divides the designs into
// boxes, the local solver makes designs of what is promising in them, and what is certified rules out other boxes.

#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/steps/search_task.hpp"

namespace kempe {

/// True for tasks whose limits the tree knows, with obstacles, bodies, a table or a limit on the load error: without any of them the search of
/// every choice is as quick. Of a limit that counts pins and layers the tree knows too little to end.
bool suits_tree_search(const SearchTask& task);

/// The best design that the tree leads to, with its bound. `exhausted`: no other choice and no other place is better by more
/// than slack::tree_search, and the bound is within slack::tree_bound, or by more than slack::tree_under_load where the load error is limited;
/// else the boxes or trials allowed (TreeBudget) were not enough, and the design is a start. `proven_none`: no box is left, and no design exists.
SearchResult best_by_tree(const SearchTask& task);

}  // namespace kempe
