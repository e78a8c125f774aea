// Drawing by gnuplot: a script and data files of its own, run without a shell.
#pragma once

#include <gnuplot-iostream.h>

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/picture_format.h"
#include "evaluation/axis.h"

namespace apps {

/// A file in memory, under a name that a child finds too: nothing stays behind, however a run ends.
class MemoryFile {
 public:
  /// Throws Errc::cannot_write.
  MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile();

  std::string path() const { return "/dev/fd/" + std::to_string(descriptor_); }
  std::string bytes() const;

 private:
  int descriptor_;
};

/// The script of a picture, with its data. Numbers are kept in binary: as text they would have six
/// digits. All but `quoted` text is taken as commands.
class Drawing : public Gnuplot {
 public:
  Drawing() : Drawing(std::make_unique<MemoryFile>()) {}

  /// Points, for a plot command.
  std::string series(const std::vector<std::pair<double, double>>& points);
  /// Rows of an image, for a plot command.
  std::string image(const std::vector<std::vector<double>>& rows);
  /// Bytes, as a gnuplot string expression that names them.
  std::string file(std::string_view bytes);

  /// The script written so far. Throws Errc::cannot_write where it is not whole.
  const MemoryFile& script();

 private:
  explicit Drawing(std::unique_ptr<MemoryFile> script)
      : Gnuplot(std::string(1, '>').append(script->path())), script_(std::move(script)) {}

  std::unique_ptr<MemoryFile> script_;
  std::deque<MemoryFile> data_;
};

/// Text as a gnuplot string expression.
std::string quoted(const std::string& text);

/// First value and step of an axis for gnuplot, which wants a step even for one value.
std::pair<double, double> grid(const evaluation::Axis& axis);

/// Sets a range to the cells of an axis.
void set_range(Drawing& gp, const char* name, const evaluation::Axis& axis);

/// Dark to light, perceptually ordered; points and curves stand out on it.
extern const char* const dark_to_light;

struct PictureSize {
  int width, height;  ///< pixels
};

/// The bytes of the picture that the commands draw. Throws Errc::cannot_write where gnuplot is
/// missing or fails.
std::string draw(PictureSize size, PictureFormat format,
                 const std::function<void(Drawing&)>& commands);

}  // namespace apps
