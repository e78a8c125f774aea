#include "evaluation/colour_volume_file.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "evaluation/npy.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/temporary_folder.h"

namespace {

using brdf::Errc;
using brdf::VolumeGrid;
using evaluation::Json;
using evaluation::read_colour_volume;

constexpr std::size_t limit = 1 << 24;

VolumeGrid small_grid() {
  return VolumeGrid({0.1, 0.3, 5, 2});
}

std::vector<float> random_numbers(const VolumeGrid& grid) {
  Uniform uniform(311);
  std::vector<float> numbers(grid.size());
  for (float& number : numbers) number = static_cast<float>(uniform(-1, 2));
  return numbers;
}

/// A volume in a folder that is removed at the end.
class Volume {
 public:
  explicit Volume(const std::vector<float>& numbers = random_numbers(small_grid())) {
    evaluation::OutputWithSidecar output(path());
    output.write(evaluation::colour_volume_header(small_grid()));
    sidecar_ = output.commit(evaluation::npy_bytes(numbers),
                             {{"volume", evaluation::volume_json(small_grid().shape())}});
  }

  std::filesystem::path path() const { return folder_ / "volume.npy"; }
  std::string bytes() const {
    std::ifstream file(path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  const Json& sidecar() const { return sidecar_; }

  void replace_sidecar(const std::string& text) const {
    std::ofstream(path().string() + ".json") << text;
  }
  void change_sidecar(const std::string& place, const Json& value) const {
    Json changed = sidecar_;
    changed[Json::json_pointer(place)] = value;
    replace_sidecar(changed.dump());
  }
  /// Other bytes, of which the sidecar knows the hash.
  void replace_bytes(const std::string& bytes) {
    std::ofstream(path(), std::ios::binary) << bytes;
    sidecar_["output"]["sha256"] = evaluation::sha256_hex(bytes);
    replace_sidecar(sidecar_.dump());
  }

 private:
  TemporaryFolder folder_;
  Json sidecar_;
};

void check_refused(const Volume& volume, const std::string& part, Errc code = Errc::bad_input,
                   std::size_t limit_bytes = limit) {
  CAPTURE(part);
  CHECK_ERROR(read_colour_volume(volume.path(), limit_bytes), code, part);
  CHECK_ERROR(read_colour_volume(volume.path(), limit_bytes), code, "volume.npy");
}

}  // namespace

TEST_CASE("a volume that was written reads back the same to the last bit",
          "[colour_volume_file][invariant]") {
  const Volume volume;
  const auto read = read_colour_volume(volume.path(), limit);
  const std::vector<float> numbers = random_numbers(small_grid());
  REQUIRE(read.numbers.size() == numbers.size());
  CHECK(std::memcmp(read.numbers.data(), numbers.data(), numbers.size() * sizeof(float)) == 0);
  const auto shape = read.grid.shape(), written = small_grid().shape();
  CHECK(shape.centre_step == written.centre_step);
  CHECK(shape.relative_step == written.relative_step);
  CHECK(shape.angles_per_r == written.angles_per_r);
  CHECK(shape.terms == written.terms);
  CHECK(read.sha256 == evaluation::sha256_hex(volume.bytes()));
  CHECK(read.sidecar == volume.sidecar());
  CHECK_NOTHROW(brdf::ColourVolume(read.grid, read.numbers));
}

TEST_CASE("steps of a volume keep all their digits in the sidecar",
          "[colour_volume_file][invariant]") {
  const brdf::VolumeShape shape{1.0 / 3, 0.1 + 0.2, 1e3 / 7, 256};
  const Json read = Json::parse(evaluation::volume_json(shape).dump());
  CHECK(read.at("centre_step") == shape.centre_step);
  CHECK(read.at("relative_step") == shape.relative_step);
  CHECK(read.at("angles_per_r") == shape.angles_per_r);
  CHECK(read.at("terms") == shape.terms);
}

TEST_CASE("a volume of more bytes than allowed is refused", "[colour_volume_file]") {
  const Volume volume;
  const std::size_t bytes = small_grid().size() * sizeof(float);
  CHECK_NOTHROW(read_colour_volume(volume.path(), bytes));
  check_refused(volume, "at most " + std::to_string(bytes - 1), Errc::over_limit, bytes - 1);
}

TEST_CASE("volumes cut off, changed or with numbers that are none are refused",
          "[colour_volume_file]") {
  Volume volume;
  const std::string bytes = volume.bytes();
  const std::size_t header = evaluation::colour_volume_header(small_grid()).size();
  // Whether or not the sidecar knows of it.
  for (const std::size_t length : {bytes.size() - 1, bytes.size() - 4, header}) {
    volume.replace_bytes(bytes.substr(0, length));
    check_refused(volume, "does not match its " + std::to_string(length) + " bytes");
  }
  volume.replace_bytes(bytes + std::string(4, '\0'));
  check_refused(volume, "does not match its");
  volume.replace_bytes(bytes.substr(0, header / 2));
  check_refused(volume, "cut off");
  volume.replace_bytes("");
  check_refused(volume, "not NPY");
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    auto numbers = random_numbers(small_grid());
    numbers[17] = value;
    const Volume broken(numbers);
    check_refused(broken, "number 17 is not finite");
  }
}

TEST_CASE("arrays of another shape or type than the sidecar's are refused",
          "[colour_volume_file]") {
  Volume volume;
  const VolumeGrid grid = small_grid();
  const std::string wanted =
      "its shape is not that of its sidecar, " + std::to_string(grid.points()) + " x 2 x 3";
  const auto refused = [&](const evaluation::NpyShape& shape, std::size_t bytes) {
    volume.replace_bytes(npy_header(shape) + std::string(bytes, '\0'));
    check_refused(volume, wanted);
  };
  const std::size_t numbers = grid.size();
  using evaluation::NpyType;
  refused({NpyType::real, {grid.points(), 2, 3}}, 8 * numbers);
  refused({NpyType::complex_value, {grid.points(), 2, 3}}, 16 * numbers);
  refused({NpyType::single, {grid.points(), 6}}, 4 * numbers);
  refused({NpyType::single, {2, grid.points(), 3}}, 4 * numbers);
  refused({NpyType::single, {grid.points(), 2, 2}}, 4 * numbers / 3 * 2);
  refused({NpyType::single, {numbers}}, 4 * numbers);
  refused({NpyType::single, {}}, 4);
  refused({NpyType::single, {0, 2, 3}}, 0);
}

TEST_CASE("whatever stands in the sidecar of a volume is refused by name and value",
          "[colour_volume_file]") {
  const Volume volume;
  CHECK_NOTHROW(read_colour_volume(volume.path(), limit));
  struct Change {
    std::string place, value, part;
  };
  for (const Change& change : {
           Change{"/volume", "{}", "has no number volume."},
           {"/volume", "[]", "has no number volume."},
           {"/volume", "null", "has no number volume."},
           {"/volume", "\"x\"", "has no number volume."},
           {"/volume/terms", "\"2\"", "volume.terms"},
           {"/volume/terms", "[2]", "volume.terms"},
           {"/volume/terms", "0", "terms 0 must be a whole number"},
           {"/volume/terms", "-2", "terms -2 must be a whole number"},
           {"/volume/terms", "1e9", "terms 1e+09 must be a whole number"},
           {"/volume/terms", "1e300", "terms 1e+300 must be a whole number"},
           {"/volume/terms", "18446744073709551615", "must be a whole number"},
           {"/volume/terms", "2.5", "terms 2.5 must be a whole number"},
           {"/volume/terms", "3", "its shape is not that of its sidecar"},
           {"/volume/centre_step", "0", "centre step 0 must lie"},
           {"/volume/centre_step", "-0.1", "centre step -0.1 must lie"},
           {"/volume/centre_step", "1e-300", "centre step 1e-300 must lie"},
           {"/volume/relative_step", "0", "relative step 0 must lie"},
           {"/volume/relative_step", "1e300", "relative step 1e+300 must lie"},
           {"/volume/relative_step", "0.31", "its shape is not that of its sidecar"},
           {"/volume/angles_per_r", "0", "angles per r 0 must lie"},
           {"/volume/angles_per_r", "true", "volume.angles_per_r"},
           {"/output/sha256", "\"0123\"", "does not belong to"},
           {"/output/sha256", "5", "has no output.sha256"},
       }) {
    CAPTURE(change.place, change.value);
    volume.change_sidecar(change.place, Json::parse(change.value));
    check_refused(volume, change.part);
    // The file that is wrong: the sidecar, but for shapes that do not fit.
    check_refused(volume, change.part.starts_with("its shape") ? "volume.npy:" : "volume.npy.json");
  }
  for (const std::string text : {"", "{", "[]", "5"}) {
    volume.replace_sidecar(text);
    check_refused(volume, "volume.npy.json");
  }
  std::filesystem::remove(volume.path().string() + ".json");
  check_refused(volume, "volume.npy.json: no such file");
  std::filesystem::remove(volume.path());
  check_refused(volume, "volume.npy: no such file");
}
