// Drawing by gnuplot: a script and data files of its own, run without a shell.
#pragma once

#include <gnuplot-iostream.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/axis.h"

namespace apps {

/// A folder of its own for script and data, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Text as a gnuplot string expression.
std::string quoted(const std::string& text);

/// First value and step of an axis for gnuplot, which wants a step even for one value.
std::pair<double, double> grid(const evaluation::Axis& axis);

/// Sets a range to the cells of an axis.
void set_range(Gnuplot& gp, const char* name, const evaluation::Axis& axis);

/// Points for a plot command, in binary: as text they would keep six digits.
std::string series(Gnuplot& gp, const std::vector<std::pair<double, double>>& points,
                   const std::string& file);

/// Dark to light, perceptually ordered; points and curves stand out on it.
extern const char* const dark_to_light;

struct PictureSize {
  int width, height;  ///< pixels
};

/// The bytes of the PNG that the commands draw. Titles never reach gnuplot as commands as long as
/// they go through `quoted`. Throws Errc::cannot_write where gnuplot is missing or fails.
std::string draw_png(PictureSize size,
                     const std::function<void(Gnuplot&, const TemporaryFolder&)>& commands);

}  // namespace apps
