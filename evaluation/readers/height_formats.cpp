#include "evaluation/readers/height_formats.h"

#include <algorithm>
#include <array>

#include "brdf/error.h"
#include "evaluation/readers/gwy_reader.h"
#include "evaluation/readers/npy_heights.h"
#include "evaluation/readers/openexr_reader.h"
#include "evaluation/readers/sdf_reader.h"
#include "evaluation/readers/text_reader.h"
#include "evaluation/readers/tiff_reader.h"
#include "evaluation/readers/x3p_reader.h"

namespace evaluation {

std::span<const HeightFormat> height_formats() {
  static constexpr std::array formats{
      HeightFormat{"PNG", "", true, detail::is_png, detail::decode_png},
      HeightFormat{"Gwyddion Simple Field (.gsf)", "", true, detail::is_gsf, detail::decode_gsf},
      HeightFormat{"Surface Data File (.sdf)", "", true, detail::is_sdf, detail::decode_sdf},
      // A decoder that is not built in is not referred to: the choice is made by the compiler.
      HeightFormat{"TIFF", "libtiff", SHEDLIGHT_HAS_TIFF, detail::is_tiff,
                   SHEDLIGHT_HAS_TIFF ? detail::decode_tiff : nullptr},
      HeightFormat{"OpenEXR", "OpenEXR", SHEDLIGHT_HAS_OPENEXR, detail::is_openexr,
                   SHEDLIGHT_HAS_OPENEXR ? detail::decode_openexr : nullptr},
      HeightFormat{"X3P (.x3p)", "libzip and pugixml", SHEDLIGHT_HAS_X3P, detail::is_x3p,
                   SHEDLIGHT_HAS_X3P ? detail::decode_x3p : nullptr},
      HeightFormat{"Gwyddion native (.gwy)", "", true, detail::is_gwy, detail::decode_gwy},
      HeightFormat{"NumPy (.npy)", "", true, detail::is_npy_heights, detail::decode_npy},
      // The last: it is told by having no other beginning than numbers.
      HeightFormat{"text (matrix or x, y, z)", "", true, detail::is_text, detail::decode_text},
  };
  return formats;
}

const HeightFormat* height_format_of(std::string_view head) {
  const auto formats = height_formats();
  const auto found = std::ranges::find_if(
      formats, [&](const HeightFormat& format) { return format.recognises(head); });
  return found == formats.end() ? nullptr : &*found;
}

void detail::require_grid(std::uint64_t cols, std::uint64_t rows, const HeightRequest& request,
                          const std::string& name) {
  const std::uint64_t most = request.max_pixels;
  if (cols == 0 || rows == 0 || cols > most || rows > most / cols)
    throw brdf::Error(brdf::Errc::bad_input, name + ": " + std::to_string(cols) + " x " +
                                                 std::to_string(rows) +
                                                 " pixels, must be from 1 to " +
                                                 std::to_string(most) + " in all (--max-pixels)");
}

}  // namespace evaluation
