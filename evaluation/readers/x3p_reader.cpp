#include "evaluation/readers/x3p_reader.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <string>

#include "brdf/error.h"
#include "evaluation/readers/samples.h"
#include "evaluation/readers/stored_number.h"
#include "evaluation/readers/zip_archive.h"

namespace evaluation::detail {
namespace {

// The description is some kilobytes; its tree takes some twenty times its length.
constexpr std::uint64_t longest_description = 1 << 20;

/// A data type by its letter in the description.
struct DataType {
  std::string_view letter, name;
  std::size_t bytes;
  double (*number)(const char* bytes);
  bool is_integer;
};

template <class T>
double number(const char* bytes) {
  return static_cast<double>(stored_number<T>(bytes));
}

constexpr std::array data_types{
    DataType{"I", "16 bit signed", 2, number<std::int16_t>, true},
    DataType{"L", "32 bit signed", 4, number<std::int32_t>, true},
    DataType{"F", "32 bit float", 4, number<float>, false},
    DataType{"D", "64 bit float", 8, number<double>, false},
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::string_view without_prefix(std::string_view name) {
  return name.substr(name.find(':') + 1);
}

/// Whether the text is the MD5 of the bytes in hexadecimal, of either case.
bool is_md5_of(std::string_view bytes, std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_md5(), nullptr) != 1)
    throw brdf::Error(brdf::Errc::bad_input, "MD5 is not available from libcrypto");
  if (text.size() != 2 * length) return false;
  for (unsigned i = 0; i < length; ++i) {
    unsigned value = 0;
    const char* const end = text.data() + 2 * i + 2;
    const auto [stop, ec] = std::from_chars(end - 2, end, value, 16);
    if (ec != std::errc{} || stop != end || value != digest[i]) return false;
  }
  return true;
}

/// main.xml: texts and numbers by their path, such as "Record1/Axes/CX/Increment".
class Description {
 public:
  explicit Description(const ZipArchive& archive) : archive_(archive) {
    std::string xml = archive.read("main.xml", longest_description);
    require_checksum(xml);
    const pugi::xml_parse_result result = document_.load_buffer(xml.data(), xml.size());
    if (!result)
      archive.refuse("main.xml is no sound XML: " + std::string(result.description()) +
                     " at byte " + std::to_string(result.offset));
    if (without_prefix(document_.document_element().name()) != "ISO5436_2")
      archive.refuse("main.xml does not hold ISO5436_2");
  }

  /// Empty where there is none.
  std::string text(std::string_view path) const {
    pugi::xml_node node = document_.document_element();
    while (!path.empty()) {
      const std::string_view name = path.substr(0, path.find('/'));
      path.remove_prefix(std::min(name.size() + 1, path.size()));
      node = node.find_child(
          [&](const pugi::xml_node& child) { return without_prefix(child.name()) == name; });
    }
    return std::string(trimmed(node.text().get()));
  }

  /// Refuses a text that is not as expected.
  void require(const char* path, std::string_view expected, const char* reason) const {
    if (const std::string found = text(path); found != expected)
      archive_.refuse(std::string(path) + " is \"" + found.substr(0, 40) + "\", must be \"" +
                      std::string(expected) + "\": " + reason);
  }

  template <class T>
  T number(const char* path) const {
    const std::string found = text(path);
    T value{};
    const char* const end = found.data() + found.size();
    const auto [stop, ec] = std::from_chars(found.data(), end, value);
    if (ec != std::errc{} || stop != end)
      archive_.refuse(std::string(path) + " is \"" + found.substr(0, 40) + "\", not a number");
    return value;
  }

  double positive(const char* path) const {
    const double value = number<double>(path);
    if (!(value > 0 && std::isfinite(value)))
      archive_.refuse(std::string(path) + " is " + brdf::text(value) + " m, must be > 0");
    return value;
  }

  /// The entry that a link names, of exactly so many bytes, its checksum right where one is given.
  std::string linked(const char* link, const char* checksum, std::uint64_t bytes) const {
    const std::string entry = text(link);
    if (entry.empty()) archive_.refuse("main.xml has no " + std::string(link));
    if (const std::uint64_t size = archive_.size(entry); size != bytes)
      archive_.refuse(entry + " has " + std::to_string(size) + " bytes, main.xml asks for " +
                      std::to_string(bytes));
    std::string data = archive_.read(entry, bytes);
    if (const std::string md5 = text(checksum); !md5.empty() && !is_md5_of(data, md5))
      archive_.refuse(entry + " is damaged: its MD5 is not the one in main.xml");
    return data;
  }

 private:
  /// The checksum file reads "<MD5> *main.xml".
  void require_checksum(std::string_view xml) const {
    constexpr const char* name = "md5checksum.hex";
    if (!archive_.holds(name)) return;
    const std::string line = archive_.read(name, FileSource::head_bytes);
    if (!is_md5_of(xml, line.substr(0, line.find_first_of(" \t\r\n"))))
      archive_.refuse(std::string("main.xml is damaged: its MD5 is not the one in ") + name);
  }

  const ZipArchive& archive_;
  pugi::xml_document document_;
};

const DataType& data_type(const ZipArchive& archive, const std::string& letter) {
  const auto found = std::ranges::find(data_types, letter, &DataType::letter);
  if (found == data_types.end())
    archive.refuse("Record1/Axes/CZ/DataType is \"" + letter.substr(0, 40) +
                   "\", must be I, L, F or D");
  return *found;
}

}  // namespace

RawHeights decode_x3p(const FileSource& source, const HeightRequest& request) {
  const ZipArchive archive(source);
  const Description main(archive);
  main.require("Record1/FeatureType", "SUR", "profiles and clouds of points are not read");
  main.require("Record1/Axes/CX/AxisType", "I", "only equal steps are read");
  main.require("Record1/Axes/CY/AxisType", "I", "only equal steps are read");
  main.require("Record1/Axes/CZ/AxisType", "A", "heights are values of their own");
  main.require("Record3/MatrixDimension/SizeZ", "1", "only one layer is read");
  const auto cols = main.number<std::uint64_t>("Record3/MatrixDimension/SizeX");
  const auto rows = main.number<std::uint64_t>("Record3/MatrixDimension/SizeY");
  require_grid(cols, rows, request, source.name());
  const DataType& type = data_type(archive, main.text("Record1/Axes/CZ/DataType"));
  const bool has_increment = !main.text("Record1/Axes/CZ/Increment").empty();
  const double increment_m = has_increment ? main.positive("Record1/Axes/CZ/Increment") : 1;
  const bool has_offset = !main.text("Record1/Axes/CZ/Offset").empty();
  const double offset_m = has_offset ? main.number<double>("Record1/Axes/CZ/Offset") : 0;

  RawHeights raw;
  raw.format = "X3P, " + std::string(type.name);
  raw.pixel_x = brdf::Length::um(1e6 * main.positive("Record1/Axes/CX/Increment"));
  raw.pixel_y = brdf::Length::um(1e6 * main.positive("Record1/Axes/CY/Increment"));
  raw.unit = brdf::Length::um(1e6 * increment_m);
  const std::string data =
      main.linked("Record3/DataLink/PointDataLink", "Record3/DataLink/MD5ChecksumPointData",
                  type.bytes * cols * rows);
  raw.values.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
  for (std::size_t i = 0; i < cols * rows; ++i)
    raw.values.data()[i] = type.number(data.data() + type.bytes * i);
  if (!main.text("Record3/DataLink/ValidPointsLink").empty()) {
    const std::string valid =
        main.linked("Record3/DataLink/ValidPointsLink", "Record3/DataLink/MD5ChecksumValidPoints",
                    (cols * rows + 7) / 8);
    for (std::size_t i = 0; i < cols * rows; ++i)
      if (!(valid[i / 8] >> i % 8 & 1))
        raw.values.data()[i] = std::numeric_limits<double>::quiet_NaN();
  }
  if (offset_m != 0) raw.values += offset_m / increment_m;
  raw.step = step_of(type, raw.values);
  return raw;
}

}  // namespace evaluation::detail
