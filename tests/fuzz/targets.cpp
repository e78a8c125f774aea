#include "tests/fuzz/targets.h"

#include <cctype>
#include <stdexcept>

#include "brdf/error.h"
#include "evaluation/readers/height_formats.h"
#include "evaluation/response_matrix.h"
#include "evaluation/scene/mesh.h"
#include "evaluation/tradeoff/tradeoff.h"

namespace fuzz {
namespace {

/// Small, so that what is declared and what is there can both be reached.
constexpr std::uint64_t most_pixels = 1 << 16;

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

void read_heights(const evaluation::HeightFormat& format, std::string_view bytes) {
  const evaluation::FileSource source("file", std::string(bytes));
  if (!format.recognises(source.head())) return;
  const evaluation::RawHeights raw = format.decode(source, {{}, most_pixels});
  require(raw.values.size() > 0, "no pixels were read");
  require(static_cast<std::uint64_t>(raw.values.size()) <= most_pixels, "more than the limit");
  require(!raw.unit || raw.unit->um() > 0, "a unit that is not positive");
}

/// "gsf" of "Gwyddion Simple Field (.gsf)", "png" of "PNG": a name for files and options.
std::string short_name(std::string_view format) {
  const std::size_t dot = format.find("(.");
  const std::string_view name = dot == format.npos ? format : format.substr(dot + 2);
  std::string result;
  for (const char c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) break;
    result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

template <class Read>
Target refusing(std::string name, Read read) {
  return {std::move(name), [read](std::string_view bytes) {
            try {
              read(bytes);
            } catch (const brdf::Error&) {
            }
          }};
}

std::vector<Target> all_targets() {
  std::vector<Target> all;
  for (const evaluation::HeightFormat& format : evaluation::height_formats())
    if (format.is_built_in)
      all.push_back(refusing(short_name(format.name),
                             [&format](std::string_view bytes) { read_heights(format, bytes); }));
  all.push_back(refusing("response", [](std::string_view bytes) {
    const auto response = evaluation::response_from_csv(bytes, "file");
    require(response.values.size() ==
                static_cast<Eigen::Index>(response.lambda_nm.size() * response.theta_r_deg.size()),
            "a response whose axes do not fit");
  }));
  all.push_back(refusing(
      "obj", [](std::string_view bytes) { evaluation::decode_obj(std::string(bytes), "file"); }));
  all.push_back(refusing(
      "frontier", [](std::string_view bytes) { evaluation::trial_from_csv(bytes, "file", 1); }));
  return all;
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = all_targets();
  return all;
}

}  // namespace fuzz
