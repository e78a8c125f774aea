// Where each line of a grating lies, as a phase against an even carrier.
#pragma once

#include <vector>

#include "evaluation/period/frequency.h"
#include "evaluation/period/surface_wave.h"

namespace evaluation {

/// One entry per line (period) of the grating, in the order of their places.
struct LinePhases {
  std::vector<double> line;       ///< place along the grating vector, in periods from the middle
  std::vector<double> phase_rad;  ///< of the fundamental there, from the wave's origin of phases,
                                  ///< unwrapped from the middle outwards
  std::vector<double> weight;     ///< pixels that a line was seen in, the best seen being 1
  std::vector<double> amplitude;  ///< of the fundamental

  std::size_t size() const { return line.size(); }
};

/// Width of the Gaussian weight about a line, standard deviation in periods: neighbours then share
/// exp(-1 / (4 0.4^2)) = 0.21 of their weight.
inline constexpr double line_window_periods = 0.4;

/// Phases of the component exp(2 pi i f.x) line by line: least squares of
/// a + b t + g v + sum_m (c_m cos 2 pi m t + s_m sin 2 pi m t), t = f.x, v across it, under a
/// Gaussian weight one line wide. Bow, tilt and up to 3 harmonics (as the pixels hold) thereby
/// leave no trace, nor do the edges of the patch: for band-limited profiles the phases are right to
/// rounding (1e-9 rad).
///
/// Lines with less than a tenth of the typical number of pixels, at the corners of a patch that
/// the grating crosses at an angle, are left out. Cost: a pass over the pixels, some 100 ns each;
/// for a surface even along y, with f along x, over one row.
LinePhases line_phases(const SurfaceWave& wave, const Frequency& frequency);

}  // namespace evaluation
