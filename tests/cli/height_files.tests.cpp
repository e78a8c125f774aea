#include "tests/cli/height_files.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/cli/refusal.h"

namespace {

const std::string scaled = " --width 0.8um --height-range 255nm";

/// `info` and `sweep` read height files in the same way.
void check_file_refused(const Scratch& folder, const std::string& file, const std::string& scale,
                        const std::vector<std::string>& named) {
  check_refused(folder, "info " + file + scale, 3, named);
  check_refused(folder,
                "sweep " + file + scale +
                    " --theta-i 75deg --theta-r -50:-25:1deg --lambda 500nm -o older.csv",
                3, named);
}

unsigned ramp(std::uint32_t row, std::uint32_t col, int) {
  return 8 * row + col;
}

}  // namespace

TEST_CASE("a height file that is missing, empty or a folder is refused", "[cli][input]") {
  const Scratch folder;
  check_file_refused(folder, "nowhere.png", scaled, {"nowhere.png"});
  folder.write("empty.png", "");
  check_file_refused(folder, "empty.png", scaled, {"empty.png", "empty"});
  check_file_refused(folder, ".", scaled, {"."});
}

TEST_CASE("a file of another format is refused with the formats there are", "[cli][input]") {
  const Scratch folder;
  folder.write("text.png", "these are not the pixels of a picture\n");
  check_file_refused(folder, "text.png", scaled, {"text.png", "PNG", "Gwyddion"});
  std::string png = png_bytes({.code = ramp});
  png[1] = 'Q';
  folder.write("magic.png", png);
  check_file_refused(folder, "magic.png", scaled, {"magic.png"});
  std::string gsf = gsf_bytes({});
  gsf[0] = 'X';
  folder.write("magic.gsf", gsf);
  check_file_refused(folder, "magic.gsf", "", {"magic.gsf"});
}

TEST_CASE("a truncated PNG is refused wherever it was cut", "[cli][input]") {
  const Scratch folder;
  const std::string png = png_bytes({.cols = 64, .rows = 64, .code = ramp});
  // In the signature, the header, before and in the data, in the checksum, in the end mark.
  for (const std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{8}, std::size_t{20},
                                 std::size_t{33}, std::size_t{40}, png.size() / 2, png.size() - 14,
                                 png.size() - 12, png.size() - 4, png.size() - 1}) {
    INFO(size << " of " << png.size() << " bytes");
    folder.write("cut.png", png.substr(0, size));
    check_file_refused(folder, "cut.png", scaled, {"cut.png"});
  }
}

TEST_CASE("a PNG with a damaged byte is refused", "[cli][input]") {
  const Scratch folder;
  std::string png = png_bytes({.cols = 64, .rows = 64, .code = ramp});
  png[png.size() / 2] = static_cast<char>(png[png.size() / 2] ^ 0x55);
  folder.write("damaged.png", png);
  check_file_refused(folder, "damaged.png", scaled, {"damaged.png"});
}

TEST_CASE("a truncated GSF is refused wherever it was cut", "[cli][input]") {
  const Scratch folder;
  const std::string gsf = gsf_bytes({});
  const std::size_t data = gsf.size() - 4 * 48;
  for (const std::size_t size : {std::size_t{5}, std::size_t{26}, std::size_t{30}, data - 2, data,
                                 data + 3, data + 4 * 24, gsf.size() - 4, gsf.size() - 1}) {
    INFO(size << " of " << gsf.size() << " bytes");
    folder.write("cut.gsf", gsf.substr(0, size));
    check_file_refused(folder, "cut.gsf", "", {"cut.gsf"});
  }
  folder.write("long.gsf", gsf + "tail");
  check_file_refused(folder, "long.gsf", "", {"long.gsf"});
}

TEST_CASE("heights that are not finite are refused with their place", "[cli][input]") {
  const Scratch folder;
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()}) {
    Gsf gsf;
    gsf.heights.assign(48, 0.0f);
    gsf.heights[8 * 4 + 3] = bad;
    folder.write("bad.gsf", gsf_bytes(gsf));
    check_file_refused(folder, "bad.gsf", "", {"bad.gsf", "row 4", "column 3", "finite"});
  }
}

TEST_CASE("a GSF header that cannot be right is refused", "[cli][input]") {
  const Scratch folder;
  for (const std::string resolution :
       {"XRes = 100000\nYRes = 100000\n", "XRes = 4294967296\nYRes = 4294967296\n",
        "XRes = 18446744073709551615\nYRes = 2\n", "XRes = 99999999999999999999\nYRes = 1\n",
        "XRes = 0\nYRes = 6\n", "XRes = -8\nYRes = 6\n", "XRes = 8.5\nYRes = 6\n",
        "XRes = eight\nYRes = 6\n", "XRes = 8\n", "XRes\nYRes = 6\n"}) {
    INFO(resolution);
    folder.write("header.gsf", gsf_bytes({.resolution = resolution}));
    check_file_refused(folder, "header.gsf", "", {"header.gsf"});
  }
  folder.write("large.gsf", gsf_bytes({.resolution = "XRes = 100000\nYRes = 100000\n"}));
  check_file_refused(folder, "large.gsf", "", {"large.gsf", "100000 x 100000", "268435456"});
}

TEST_CASE("a PNG that is not grey is refused with the pixel", "[cli][input]") {
  const Scratch folder;
  const auto coloured = [](std::uint32_t row, std::uint32_t col, int channel) -> unsigned {
    if (channel == 3) return 255;
    return row == 2 && col == 5 && channel == 1 ? 9 : 7;
  };
  for (const auto colour : {Png::Colour::rgb, Png::Colour::rgba}) {
    folder.write("colour.png", png_bytes({.colour = colour, .code = coloured}));
    check_file_refused(folder, "colour.png", scaled,
                       {"colour.png", "row 2", "column 5", "7, 9, 7"});
  }
}

TEST_CASE("a transparent pixel carries no height and is refused", "[cli][input]") {
  const Scratch folder;
  const auto holed = [](int alpha_channel) {
    return [alpha_channel](std::uint32_t row, std::uint32_t col, int channel) -> unsigned {
      if (channel != alpha_channel) return 7;
      return row == 3 && col == 1 ? 254 : 255;
    };
  };
  folder.write("hole.png", png_bytes({.colour = Png::Colour::rgba, .code = holed(3)}));
  check_file_refused(folder, "hole.png", scaled, {"hole.png", "row 3", "column 1", "254"});
  folder.write("hole.png", png_bytes({.colour = Png::Colour::grey_alpha, .code = holed(1)}));
  check_file_refused(folder, "hole.png", scaled, {"hole.png", "row 3", "column 1", "254"});
  folder.write("hole.png", png_bytes({.code = ramp, .transparent_grey = 26}));
  check_file_refused(folder, "hole.png", scaled, {"hole.png", "row 3", "column 2"});
  folder.write("hole.png", png_bytes({.colour = Png::Colour::palette,
                                      .code = [](auto, auto col, int) { return col % 2; },
                                      .palette = {10, 200},
                                      .palette_alphas = {255, 0}}));
  check_file_refused(folder, "hole.png", scaled, {"hole.png", "row 0", "column 1"});
}

TEST_CASE("a file without a scale is refused with the option that gives it", "[cli][input]") {
  const Scratch folder;
  folder.write("scan.png", png_bytes({.code = ramp}));
  check_file_refused(folder, "scan.png", " --height-range 255nm", {"scan.png", "--width"});
  check_file_refused(folder, "scan.png", " --width 1um", {"scan.png", "--height-range"});
  folder.write("scan.gsf", gsf_bytes({.lines = "XReal = 1\nYReal = 1\nXYUnits = m\n"}));
  check_file_refused(folder, "scan.gsf", "", {"scan.gsf", "--height-unit"});
  folder.write("scan.gsf", gsf_bytes({.lines = "XReal = 1\nYReal = 1\nZUnits = m\n"}));
  check_file_refused(folder, "scan.gsf", "", {"scan.gsf", "--width", "--pixel"});
  folder.write("scan.gsf", gsf_bytes({.lines = ""}));
  check_file_refused(folder, "scan.gsf", "", {"scan.gsf", "--width", "--pixel"});
  folder.write("scan.gsf", gsf_bytes({.lines = "XReal = 1\nYReal = 1\nXYUnits = m\nZUnits = V\n"}));
  check_file_refused(folder, "scan.gsf", "", {"scan.gsf", "\"V\" is no length", "--height-unit"});
}

TEST_CASE("a scale of the wrong kind for a format is a usage error", "[cli][refusal]") {
  const Scratch folder;
  folder.write("scan.png", png_bytes({.code = ramp}));
  folder.write("scan.gsf", gsf_bytes({}));
  check_refused(folder, "info scan.png --width 1um --height-unit 1nm", 2,
                {"scan.png", "--height-unit", "--height-range"});
  check_refused(folder, "info scan.gsf --height-range 1um", 2, {"scan.gsf", "--height-range"});
}

TEST_CASE("blocks larger than the field are refused", "[cli][refusal]") {
  const Scratch folder;
  folder.write("scan.gsf", gsf_bytes({}));
  check_refused(folder, "info scan.gsf --reduce 7", 2, {"7"});
}
