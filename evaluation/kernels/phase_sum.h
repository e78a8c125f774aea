// The loops of the direct sum, vectorised.
#pragma once

#include "brdf/phase_sum.h"

namespace evaluation {

/// With the widest instruction set of the machine: SSE4, AVX2 or AVX-512 on x86-64, NEON on ARM.
///
/// Phases of up to 1e5 rad have their sine and cosine to 2.5e-16; larger ones go the portable way.
/// Sums are bit-identical from run to run on one instruction set, and differ from the portable ones
/// and between instruction sets by rounding: at most 1e-13 of the normalised amplitude
/// (phase_sum.tests.cpp). Cost per complex exponential: benchmarks/results.
const brdf::PhaseKernels& vectorised_phase_kernels();

}  // namespace evaluation
