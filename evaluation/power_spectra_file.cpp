#include "evaluation/power_spectra_file.h"

#include <algorithm>

#include "evaluation/npy.h"

namespace evaluation {
namespace {

namespace fs = std::filesystem;
using brdf::HalfSpectrum;
using brdf::PowerSpectraShape;
using brdf::SpectrumExtrema;
using Complex = std::complex<double>;

PowerSpectraShape shape_of(const TableSource& source, int terms) {
  PowerSpectraShape shape = brdf::ComputedPowerSpectra(source.input->field).shape();
  shape.terms = terms;
  return shape;
}

/// What rescaling changes in a value, over the number of pixels.
double value_error(std::span<const SpectrumExtrema> powers, double pixels) {
  double largest = 0;
  for (const SpectrumExtrema& extrema : powers)
    largest = std::max(largest, rescaling_bound(extrema) / pixels);
  return largest;
}

/// Reads one power at a time.
class SpectraOnDisk final : public brdf::PowerSpectra {
 public:
  /// extrema: one for each power, or none.
  SpectraOnDisk(NpyReader file, const PowerSpectraShape& shape,
                std::vector<SpectrumExtrema> extrema)
      : file_(std::move(file)), shape_(shape), extrema_(std::move(extrema)) {}

  PowerSpectraShape shape() const override { return shape_; }

  void visit(int terms, const Visit& visit) const override {
    std::vector<Complex> values(each());
    const std::span<double> parts{reinterpret_cast<double*>(values.data()), 2 * values.size()};
    for (int power = 0; power < terms; ++power) {
      const auto n = static_cast<std::size_t>(power);
      file_.read(n * parts.size(), parts);
      if (!extrema_.empty())
        for (Complex& value : values) value = rescaled(value, extrema_[n]);
      visit(power, {values, shape_.rows, shape_.cols});
    }
  }

  std::size_t visit_bytes() const override { return each() * sizeof(Complex); }
  double value_error() const override {
    return evaluation::value_error(extrema_, pixels_of(shape_));
  }

 private:
  std::size_t each() const { return static_cast<std::size_t>(shape_.rows * shape_.half_cols()); }

  NpyReader file_;
  PowerSpectraShape shape_;
  std::vector<SpectrumExtrema> extrema_;
};

}  // namespace

PowerSpectraWriter::PowerSpectraWriter(OutputWithSidecar& output, const TableSource& source,
                                       int terms, TableNormalisation normalisation)
    : output_(&output), normalisation_(normalisation) {
  const PowerSpectraShape shape = shape_of(source, terms);
  pixels_ = pixels_of(shape);
  parameters_ = heights_json(source);
  parameters_["terms"] = terms;
  parameters_["normalisation"] = name_of(normalisation);
  output.write(npy_header(npy_shape(shape)));
}

void PowerSpectraWriter::write(const HalfSpectrum& spectrum) {
  const SpectrumExtrema& extrema = extrema_.emplace_back(brdf::spectrum_extrema(spectrum.half));
  if (normalisation_ == TableNormalisation::none) return output_->write(npy_bytes(spectrum.half));
  std::vector<Complex> row(static_cast<std::size_t>(spectrum.half_cols()));
  for (std::size_t first = 0; first < spectrum.half.size(); first += row.size()) {
    const auto values = spectrum.half.subspan(first, row.size());
    std::transform(values.begin(), values.end(), row.begin(),
                   [&](const Complex& value) { return normalised(value, extrema); });
    output_->write(npy_bytes(std::span<const Complex>(row)));
  }
}

Json PowerSpectraWriter::commit(Json sidecar, std::vector<OutputFile*> beside) {
  sidecar["parameters"] = parameters_;
  if (normalisation_ == TableNormalisation::extrema) {
    sidecar["error"] = {{"rescaled_value", value_error(extrema_, pixels_)},
                        {"relative_to", "the number of pixels, a table's largest value"}};
    for (const SpectrumExtrema& extrema : extrema_)
      sidecar["extrema"].push_back(extrema_json(extrema));
  }
  return output_->commit(std::move(sidecar), std::move(beside));
}

std::size_t PowerSpectraWriter::file_bytes(const PowerSpectraShape& shape) {
  return npy_header(npy_shape(shape)).size() + shape.size() * sizeof(Complex);
}

PowerSpectraFile read_power_spectra(const fs::path& path, const TableSource& source) {
  NpyReader file(path);
  const TableSidecar sidecar(path);
  sidecar.require_source(source);
  const PowerSpectraShape shape = shape_of(source, sidecar.terms());
  sidecar.require_shape(file.shape(), shape);
  std::vector<SpectrumExtrema> extrema;
  if (sidecar.normalisation() == TableNormalisation::extrema) extrema = sidecar.extrema(shape);
  std::string sha256 = file.sha256();
  sidecar.require_hash(sha256);
  return {std::make_shared<SpectraOnDisk>(std::move(file), shape, std::move(extrema)),
          std::move(sha256)};
}

}  // namespace evaluation
