#include "evaluation/table_sidecar.h"

#include <cmath>

#include "brdf/error.h"
#include "brdf/taylor_bounds.h"

namespace evaluation {
namespace {

namespace fs = std::filesystem;
using brdf::Extrema;
using brdf::PowerSpectraShape;
using brdf::SpectrumExtrema;

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw brdf::Error(brdf::Errc::bad_input, file.string() + ": " + what);
}

/// A value of a sidecar for a message, however long it is.
std::string shown(const Json& value) {
  constexpr std::size_t longest = 70;
  const std::string text = value.dump();
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

}  // namespace

std::string_view name_of(TableNormalisation normalisation) {
  return normalisation == TableNormalisation::none ? "none" : "extrema";
}

/// What tables and heights must have in common beside the input.
Json heights_json(const TableSource& source) {
  const brdf::HeightField& field = source.input->field;
  return {{"reduce", source.reduction},
          {"level", source.level},
          {"columns", field.cols()},
          {"rows", field.rows()},
          {"pixel_um", {field.dx_um(), field.dy_um()}},
          {"mid_range_um", field.mid_range_um()},
          {"half_range_um", field.half_range_um()}};
}

Json extrema_json(const SpectrumExtrema& extrema) {
  return {{"re_min", extrema.re.min},
          {"re_max", extrema.re.max},
          {"im_min", extrema.im.min},
          {"im_max", extrema.im.max}};
}

NpyShape npy_shape(const PowerSpectraShape& shape) {
  return {NpyType::complex_value,
          {static_cast<std::size_t>(shape.terms), static_cast<std::size_t>(shape.rows),
           static_cast<std::size_t>(shape.half_cols())}};
}

double pixels_of(const PowerSpectraShape& shape) {
  return static_cast<double>(shape.rows) * static_cast<double>(shape.cols);
}

TableSidecar::TableSidecar(const fs::path& tables)
    : tables_(tables), path_(sidecar_path(tables)), json_(read_sidecar(tables)) {
  if (json_.is_null())
    refuse(path_, "no such file, and without it nothing says what the tables are of");
}

void TableSidecar::require_source(const TableSource& source) const {
  const auto require_same = [&](const std::string& place, const Json& ours) {
    const Json& theirs = at(place);
    if (theirs != ours)
      refuse(tables_, "tables of other heights: their " + place.substr(1) + " is " + shown(theirs) +
                          ", the input's is " + shown(ours));
  };
  require_same("/input/sha256", source.input->sha256);
  const Json heights = heights_json(source);
  for (const auto& [key, ours] : heights.items()) require_same("/parameters/" + key, ours);
}

int TableSidecar::terms() const {
  const std::string place = "/parameters/terms";
  const Json& terms = at(place);
  if (!terms.is_number_integer() || terms < 1 || terms > brdf::max_taylor_terms)
    refuse_value(place, "a whole number from 1 to " + std::to_string(brdf::max_taylor_terms));
  return terms.get<int>();
}

TableNormalisation TableSidecar::normalisation() const {
  const std::string place = "/parameters/normalisation";
  for (const auto known : {TableNormalisation::none, TableNormalisation::extrema})
    if (at(place) == name_of(known)) return known;
  refuse_value(place, "\"none\" or \"extrema\"");
}

std::vector<SpectrumExtrema> TableSidecar::extrema(const PowerSpectraShape& shape) const {
  const std::string place = "/extrema";
  const auto count = static_cast<std::size_t>(shape.terms);
  if (!at(place).is_array() || at(place).size() != count)
    refuse_value(place, "one object for each of " + std::to_string(count) + " terms");
  // The transform of numbers from -1 to 1 is at most their number, but for the rounding of 2000
  // products and a sum over all pixels.
  const double largest = pixels_of(shape) * (1 + 1e-9);
  std::vector<SpectrumExtrema> powers;
  for (std::size_t n = 0; n < count; ++n) {
    const std::string power = place + "/" + std::to_string(n);
    powers.push_back({part(power + "/re", largest), part(power + "/im", largest)});
  }
  return powers;
}

Extrema TableSidecar::part(const std::string& place, double largest) const {
  const auto number = [&](const std::string& end) {
    const Json& value = at(place + end);
    if (!value.is_number() || !(std::abs(value.get<double>()) <= largest))
      refuse_value(place + end,
                   "a number from -" + brdf::text(largest) + " to " + brdf::text(largest));
    return value.get<double>();
  };
  const Extrema extrema{number("_min"), number("_max")};
  if (extrema.min > extrema.max) refuse_value(place + "_min", "at most " + brdf::text(extrema.max));
  return extrema;
}

void TableSidecar::require_shape(const NpyShape& found, const PowerSpectraShape& shape) const {
  const NpyShape expected = npy_shape(shape);
  if (found.type != expected.type) refuse(tables_, "holds real numbers, must hold complex ones");
  if (found.extents != expected.extents)
    refuse(tables_, "its shape is " + shown(found.extents) + ", by its sidecar it must be " +
                        shown(expected.extents));
}

void TableSidecar::require_hash(const std::string& sha256) const {
  const Json& expected = at("/output/sha256");
  if (expected != sha256)
    refuse(tables_, "damaged or changed: its SHA-256 is " + sha256 + ", by " + path_.string() +
                        " it must be " + shown(expected));
}

const Json& TableSidecar::at(const std::string& place) const {
  const Json::json_pointer pointer(place);
  if (!json_.contains(pointer)) refuse(path_, "has no " + place.substr(1));
  return json_.at(pointer);
}

void TableSidecar::refuse_value(const std::string& place, const std::string& must) const {
  refuse(path_, place.substr(1) + " is " + shown(at(place)) + ", must be " + must);
}

}  // namespace evaluation
