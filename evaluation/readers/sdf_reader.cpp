#include "evaluation/readers/sdf_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "brdf/error.h"
#include "evaluation/readers/samples.h"
#include "evaluation/readers/sdf_header.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

/// The lowest number of a type that has a sign is the standard's mark of a missing pixel.
template <class T>
double height(const char* bytes) {
  const T value = stored_number<T>(bytes);
  if (std::is_signed_v<T> && value == std::numeric_limits<T>::lowest())
    return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(value);
}

/// A data type by its number in the header.
struct DataType {
  std::string_view name;
  std::size_t bytes;
  double (*height)(const char* bytes);
  bool is_integer;
};

constexpr std::array data_types{
    DataType{"8 bit unsigned", 1, height<std::uint8_t>, true},
    DataType{"16 bit unsigned", 2, height<std::uint16_t>, true},
    DataType{"32 bit unsigned", 4, height<std::uint32_t>, true},
    DataType{"32 bit float", 4, height<float>, false},
    DataType{"8 bit signed", 1, height<std::int8_t>, true},
    DataType{"16 bit signed", 2, height<std::int16_t>, true},
    DataType{"32 bit signed", 4, height<std::int32_t>, true},
    DataType{"64 bit float", 8, height<double>, false},
};

// The longest that a writer makes of a number and the blanks about it, more than twice over.
constexpr std::uint64_t longest_number = 64;
// What a text file may hold behind its numbers.
constexpr std::uint64_t longest_trailer = 1 << 20;

[[noreturn]] void refuse(const FileSource& source, const std::string& what) {
  throw brdf::Error(brdf::Errc::bad_input, source.name() + ": SDF: " + what);
}

/// Whether the file is as long as its header says.
void require_size(const FileSource& source, std::uint64_t least, std::uint64_t most) {
  if (source.size() < least || source.size() > most)
    refuse(source, "file has " + std::to_string(source.size()) + " bytes, its header asks for " +
                       std::to_string(least) +
                       (most > least ? " to " + std::to_string(most) : std::string()));
}

void read_binary(const FileSource& source, const SdfHeader& header, const DataType& type,
                 brdf::HeightArray& values) {
  const std::string_view bytes = source.bytes();
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values.data()[i] =
        type.height(bytes.data() + header.size + type.bytes * static_cast<std::size_t>(i));
}

/// Numbers between blanks, one for each pixel, then a star or the end; read a piece at a time.
class TextNumbers {
 public:
  TextNumbers(const FileSource& source, std::uint64_t at) : source_(source), at_(at) {}

  double next() {
    const std::string word = next_word();
    if (word == "BAD") return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    const auto [end, ec] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (ec != std::errc{} || end != word.data() + word.size())
      refuse(source_, word.empty() || word == "*"
                          ? "data end after " + std::to_string(count_ - 1) + " numbers"
                          : "number " + std::to_string(count_) + " is \"" + word + "\"");
    return value;
  }

  /// The last number may be cut where nothing stands behind it.
  void require_end() {
    if (!peek()) refuse(source_, "no line ends behind the last number");
    const std::string word = next_word();
    if (!word.empty() && !word.starts_with('*'))
      refuse(source_, "data go on after " + std::to_string(count_ - 1) + " numbers");
  }

 private:
  /// The character that is next; none at the end of the file.
  std::optional<char> peek() {
    if (next_ == piece_.size()) {
      piece_.resize(FileSource::head_bytes);
      piece_.resize(source_.read_at(at_, piece_.data(), piece_.size()));
      at_ += piece_.size();
      next_ = 0;
    }
    return piece_.empty() ? std::nullopt : std::optional(piece_[next_]);
  }

  std::string next_word() {
    ++count_;
    constexpr std::string_view blank = " \t\r\n";
    const auto is_blank = [&](char c) { return blank.find(c) != std::string_view::npos; };
    std::string word;
    std::optional<char> c = peek();
    for (; c && is_blank(*c); c = peek()) ++next_;
    for (; c && !is_blank(*c) && word.size() < longest_number; c = peek()) {
      word += *c;
      ++next_;
    }
    if (word.size() == longest_number)
      refuse(source_, "number " + std::to_string(count_) + " has " +
                          std::to_string(longest_number) + " characters or more");
    return word;
  }

  const FileSource& source_;
  std::uint64_t at_, count_ = 0;
  std::string piece_;
  std::size_t next_ = 0;
};

void read_text(const FileSource& source, const SdfHeader& header, brdf::HeightArray& values) {
  TextNumbers numbers(source, header.size);
  for (double& value : values.reshaped<Eigen::RowMajor>()) value = numbers.next();
  numbers.require_end();
}

}  // namespace

bool is_sdf(std::string_view head) {
  constexpr std::array magics{"aBCR-", "bBCR-", "aISO-1.0", "bISO-1.0", "aISO-2.0", "bISO-2.0"};
  return std::ranges::any_of(magics, [&](const char* magic) { return head.starts_with(magic); });
}

RawHeights decode_sdf(const FileSource& source, const HeightRequest& request) {
  const SdfHeader header = read_sdf_header(source);
  require_grid(header.cols, header.rows, request, source.name());
  if (header.data_type >= data_types.size())
    refuse(source, "DataType " + std::to_string(header.data_type) + ", must be from 0 to 7");
  const DataType& type = data_types[header.data_type];
  const std::uint64_t pixels = header.cols * header.rows;
  const bool is_text = is_sdf_text(source.head());
  if (is_text)
    require_size(source, header.size + 2 * pixels - 1,
                 header.size + longest_number * pixels + longest_trailer);
  else
    require_size(source, header.size + type.bytes * pixels, header.size + type.bytes * pixels);

  RawHeights raw;
  raw.format = std::string("SDF, ") + (is_text ? "text, " : "binary, ") + std::string(type.name);
  raw.pixel_x = brdf::Length::um(1e6 * header.x_scale_m);
  raw.pixel_y = brdf::Length::um(1e6 * header.y_scale_m);
  raw.unit = brdf::Length::um(1e6 * header.z_scale_m);
  raw.values.resize(static_cast<Eigen::Index>(header.rows), static_cast<Eigen::Index>(header.cols));
  if (is_text)
    read_text(source, header, raw.values);
  else
    read_binary(source, header, type, raw.values);
  raw.step = step_of(type, raw.values);
  return raw;
}

}  // namespace evaluation::detail
