#pragma once
// A page that finds the instant centres of a linkage step by step.

#include <string>
#include <vector>

#include "reports/linkages/centres_steps.hpp"
#include "reports/linkages/scene.hpp"

namespace kempe {

/// HTML in the report's dress that needs no network: the picture of one moment, the links' numbers, and the steps of `centre_steps`; at
/// each step the two lines that give the centre are drawn out, and only what is known by then is shown. Without a script: the whole
/// picture and all steps. `step` is the motion's, for the title.
std::string centres_html(const LinkageFile& file, const LinkageModel& model, const LinkageScene& scene,
                         double step, const std::vector<InstantCentre>& centres);

}  // namespace kempe
