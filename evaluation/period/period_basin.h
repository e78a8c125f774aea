// Where the search for a period starts, and whether there is one.
#pragma once

#include "evaluation/period/lobe_basis.h"

namespace evaluation {

/// The K = 2 pi / d [rad/um] near a start that explains most of a response's power by lobes at its
/// orders: the sidelobes make local optima for a solver, so K is scanned in steps of a third of the
/// lobe's half-width at the highest order in view.
///
/// Searched: a tenth of an order's spacing at the highest order in view, but at least 3 %. What
/// counts is the power that W^2 times parabolas in c explains around the orders; where neighbours
/// overlap, the part that the whole model explains (lobe_basis.h). Orders that the mirror's lobe
/// reaches are left out, unless there is no other.
double best_start(const PowerView& view, const WindowLobe& lobe, double start_per_um);

/// Width of the lobes found at K over the window's own: the one that leaves least of the power of
/// all cells, 0.6 to 8, refined by a parabola in its logarithm. Strong orders decide.
double relative_width(const std::vector<OrderProblem>& problems, const WindowLobe& lobe,
                      double k_grating_per_um);

}  // namespace evaluation
