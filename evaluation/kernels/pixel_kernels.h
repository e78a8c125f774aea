// The loops over the pixels of a surface, vectorised.
#pragma once

#include "brdf/term_table.h"

namespace evaluation {

/// `moments` and `spread` of brdf::SeriesKernels.
struct PixelKernels {
  decltype(brdf::SeriesKernels::moments) moments;
  decltype(brdf::SeriesKernels::spread) spread;
};

/// For the instruction set that is chosen when it is called.
PixelKernels vectorised_pixel_kernels();

}  // namespace evaluation
