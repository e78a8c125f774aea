// Small inputs that many tests sweep.
#pragma once

#include <string>

#include "tests/cli/program.h"

/// 26 periods of 2.5 um in one row of 260 pixels: an order +1 that takes milliseconds to sweep.
inline const std::string small_blaze =
    "synth blazed --period 2500nm --height 600nm --size 65um,0.25um --pixels 260,1 -o g.gsf";

/// The light and the viewer of the examples, around order +1 of 2.5 um.
inline const std::string small_scene =
    " --theta-i 75deg --theta-r -55:-40:0.1deg --lambda 400:700:100nm --sigma 16.25um";

/// A folder with g.gsf.
inline void make_grating(const Scratch& folder) {
  folder.prepare(small_blaze);
}

/// A folder with a g.gsf of two axes: 24 columns, 10 rows.
inline void make_small(const Scratch& folder) {
  folder.prepare(
      "synth blazed --period 700nm --height 300nm --size 2.4um,1um --pixels 24,10 -o g.gsf");
}

/// A folder with g.gsf, its response R.csv and the sidecar.
inline void make_response(const Scratch& folder) {
  make_grating(folder);
  folder.prepare("sweep g.gsf" + small_scene + " -o R.csv");
}
