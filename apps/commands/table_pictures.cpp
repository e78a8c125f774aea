#include "apps/commands/table_pictures.h"

#include <algorithm>
#include <system_error>

#include "brdf/error.h"
#include "evaluation/sha256.h"

namespace apps {

namespace fs = std::filesystem;

namespace {

constexpr int most_powers = 8;

}  // namespace

TablePictures::Folder::Folder(const fs::path& folder) : path(folder) {
  std::error_code ec;
  made = fs::create_directory(path, ec);
  if (std::error_code ignored; !fs::is_directory(path, ignored))
    throw brdf::Error(brdf::Errc::cannot_write, path.string() + ": cannot be made: " +
                                                    (ec ? ec.message() : "is not a folder"));
}

TablePictures::Folder::~Folder() {
  std::error_code ignored;
  if (made) fs::remove(path, ignored);
}

std::vector<fs::path> TablePictures::files(const fs::path& folder, int terms) {
  std::vector<fs::path> files{folder / "extrema.png"};
  for (int power = 0; power < std::min(terms, most_powers); ++power)
    files.push_back(folder / ("power_" + std::to_string(power) + ".png"));
  return files;
}

TablePictures::TablePictures(const fs::path& folder, int terms)
    : folder_(folder), files_(files(folder, terms)) {
  for (const fs::path& file : files_) outputs_.emplace_back(file);
}

void TablePictures::see(int power, const brdf::HalfSpectrum& spectrum,
                        const brdf::HeightField& field, const std::string& title) {
  if (power >= most_powers) return;
  write(static_cast<std::size_t>(power) + 1,
        draw(SpectrumPicture{&spectrum, field.dx_um(), field.dy_um(), power, title},
             PictureFormat::png));
}

evaluation::Json TablePictures::finish(std::span<const brdf::SpectrumExtrema> powers,
                                       const std::string& title) {
  write(0, draw(ExtremaPicture{powers, title}, PictureFormat::png));
  return described_;
}

std::vector<evaluation::OutputFile*> TablePictures::outputs() {
  std::vector<evaluation::OutputFile*> outputs;
  for (evaluation::OutputFile& output : outputs_) outputs.push_back(&output);
  return outputs;
}

void TablePictures::write(std::size_t number, const std::string& png) {
  outputs_[number].write(png);
  described_.push_back(
      {{"file", files_[number].string()}, {"sha256", evaluation::sha256_hex(png)}});
}

}  // namespace apps
