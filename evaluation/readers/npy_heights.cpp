#include "evaluation/readers/npy_heights.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "brdf/error.h"
#include "evaluation/npy_header.h"
#include "evaluation/readers/samples.h"
#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

/// Whole numbers beyond it are no doubles.
constexpr double largest_whole = 9007199254740992;  // 2^53

/// A type of NumPy, without its order of bytes.
struct NumberType {
  std::string_view name;
  std::size_t bytes;
  double (*read)(const char* bytes, std::endian order);
  bool is_integer;
};

template <class Number>
constexpr NumberType number_type(std::string_view name) {
  return {name, sizeof(Number),
          [](const char* bytes, std::endian order) {
            return static_cast<double>(stored_number<Number>(bytes, order));
          },
          std::is_integral_v<Number>};
}

constexpr std::array number_types{
    number_type<float>("f4"),         number_type<double>("f8"),
    number_type<std::int8_t>("i1"),   number_type<std::int16_t>("i2"),
    number_type<std::int32_t>("i4"),  number_type<std::int64_t>("i8"),
    number_type<std::uint8_t>("u1"),  number_type<std::uint16_t>("u2"),
    number_type<std::uint32_t>("u4"), number_type<std::uint64_t>("u8")};

}  // namespace

bool is_npy_heights(std::string_view head) {
  return begins_as_npy(head);
}

RawHeights decode_npy(const FileSource& source, const HeightRequest& request) {
  const std::string& name = source.name();
  const auto refuse = [&](const std::string& what) {
    throw brdf::Error(brdf::Errc::bad_input, name + ": " + what);
  };
  const NpyHeader header = read_npy_header(source.head(), name);
  if (header.extents.size() != 2)
    refuse("NPY shape " + header.shape + ": heights have two axes, rows and columns");
  const std::uint64_t rows = header.extents[0], cols = header.extents[1];
  require_grid(cols, rows, request, name);
  const auto type = std::ranges::find_if(number_types, [&](const NumberType& known) {
    return header.type.size() == 3 && std::string_view(header.type).substr(1) == known.name &&
           std::string_view(known.bytes == 1 ? "|<>" : "<>").find(header.type[0]) !=
               std::string_view::npos;
  });
  if (type == number_types.end())
    refuse("NPY type " + header.type.substr(0, 40) +
           ", must be f4, f8, or an integer of 1, 2, 4 or 8 bytes");
  const std::uint64_t needed = header.size + *header.number_bytes(type->bytes);
  if (source.size() != needed)
    refuse(std::to_string(source.size()) + " bytes, NPY shape " + header.shape + " needs " +
           std::to_string(needed) + (source.size() < needed ? ": file is truncated" : ""));

  RawHeights raw;
  raw.format = "NPY, " + header.type;
  raw.values.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
  const char* const numbers = source.bytes().data() + header.size;
  const std::endian order = header.type[0] == '>' ? std::endian::big : std::endian::little;
  const std::uint64_t along = header.is_fortran_order ? rows : 1;
  const std::uint64_t down = header.is_fortran_order ? 1 : cols;
  for (std::uint64_t row = 0; row < rows; ++row)
    for (std::uint64_t col = 0; col < cols; ++col) {
      const double value = type->read(numbers + (row * down + col * along) * type->bytes, order);
      if (type->is_integer && std::abs(value) > largest_whole)
        refuse("a whole number beyond 2^53, which double does not hold");
      raw.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(col)) = value;
    }
  raw.step = step_of(*type, raw.values);
  return raw;
}

}  // namespace evaluation::detail
