// How a response came about, from its sidecar, for the fit of all its lobes at once.
#pragma once

#include "apps/response_input.h"
#include "evaluation/period/ridge_cells.h"

namespace apps {

/// Window, patch and quantity of the response. Throws Errc::bad_input naming what the sidecar does
/// not say, or says of a sweep whose lobes are not those of a window about the patch's middle.
evaluation::JointScene joint_scene(const ResponseInput& input, const std::string& file);

/// Whether there is a sidecar of a sweep of all cells, centred, that says all of them.
bool has_joint_scene(const ResponseInput& input, const std::string& file);

}  // namespace apps
