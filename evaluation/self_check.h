// Checks of the installed program against closed forms and identities.
#pragma once

#include <vector>

#include "evaluation/checks.h"
#include "evaluation/methods.h"

namespace evaluation {

/// The checks that apply to a method, in each of its surface models that a check has a meaning for.
///
/// Closed forms: the Gaussian of a flat patch; the powers of the orders of a sinusoid
/// (J_m(c H / 2)^2), a blaze and a lamellar grating as sampled; slits. Energy: Parseval over the
/// frequencies of a tile, and over the orders of a sinusoid. Identities: reciprocity of abs(a)^2
/// and of f_r; a tilted plane is a tilted mirror; a translation and a constant height only turn the
/// phase; the mirror image has mirrored frequencies. Limits follow from the tolerance that the
/// plans are asked for, 1e-10.
std::vector<CheckRow> self_check(const Method& method);

/// The checks of all methods; a second or so.
std::vector<CheckRow> self_check();

}  // namespace evaluation
