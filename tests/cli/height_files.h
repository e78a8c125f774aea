// Height files made byte by byte for the tests, independent of the program's own writer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// A PNG as libpng writes it.
struct Png {
  enum class Colour { grey, grey_alpha, rgb, rgba, palette };

  std::uint32_t cols = 8, rows = 6;
  int bits = 8;
  Colour colour = Colour::grey;
  bool interlaced = false;
  /// The code of one channel at (row, column, channel); for a palette its index.
  std::function<unsigned(std::uint32_t, std::uint32_t, int)> code = {};
  std::vector<unsigned> palette = {};             ///< grey values
  std::vector<std::uint8_t> palette_alphas = {};  ///< of its first entries
  int transparent_grey = -1;                      ///< the code that a grey image calls transparent
};

std::string png_bytes(const Png& png);

/// A Gwyddion Simple Field.
struct Gsf {
  int cols = 8, rows = 6;
  std::string resolution = {};  ///< instead of the true XRes and YRes lines
  std::string lines = "XReal = 0.8e-6\nYReal = 0.6e-6\nXYUnits = m\nZUnits = m\n";
  std::vector<float> heights = {};  ///< row by row; 0 where there are too few
};

std::string gsf_bytes(const Gsf& gsf);

/// A GSF file taken apart: its header and its heights.
struct ReadGsf {
  std::string header;
  std::vector<double> heights;
};

ReadGsf read_gsf(const std::string& bytes);
