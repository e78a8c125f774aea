#include "evaluation/readers/png_text.h"

#include <charconv>
#include <cmath>

#include "brdf/error.h"
#include "evaluation/lengths.h"

namespace evaluation::detail {
namespace {

using brdf::Length;

class Texts {
 public:
  Texts(const PngTexts& texts, const std::string& name) : texts_(texts), name_(name) {}

  std::string text(const std::string& key) const {
    const auto found = texts_.find(key);
    return found == texts_.end() ? std::string{} : found->second;
  }

  std::optional<double> number(const std::string& key) const {
    const auto found = texts_.find(key);
    if (found == texts_.end()) return std::nullopt;
    const std::string& text = found->second;
    double value = 0;
    const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (ec != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
      refuse(key + " is \"" + text.substr(0, 40) + "\", not a number");
    return value;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw brdf::Error(brdf::Errc::bad_input, name_ + ": PNG: " + what);
  }

 private:
  const PngTexts& texts_;
  const std::string& name_;
};

std::optional<Length> pixel(const Texts& texts, const std::string& key, Eigen::Index count) {
  const std::optional<double> side = texts.number(key);
  const std::optional<Length> one = length_unit(texts.text("Gwy::XYUnit"));
  if (!side || !one) return std::nullopt;
  if (!(*side > 0)) texts.refuse(key + " is " + brdf::text(*side) + ", must be > 0");
  return Length::um(*side * one->um() / static_cast<double>(count));
}

}  // namespace

void take_png_scale(const PngTexts& by_key, const std::string& name, RawHeights& raw) {
  const Texts texts(by_key, name);
  raw.channel = texts.text("Gwy::Title");
  raw.unit_name = texts.text("Gwy::ZUnit");
  raw.pixel_x = pixel(texts, "Gwy::XReal", raw.values.cols());
  raw.pixel_y = pixel(texts, "Gwy::YReal", raw.values.rows());
  const auto lowest = texts.number("Gwy::ZMin"), highest = texts.number("Gwy::ZMax");
  const std::optional<Length> one = length_unit(raw.unit_name);
  if (!lowest || !highest || !one) return;
  if (!(*lowest <= *highest))
    texts.refuse("Gwy::ZMin " + brdf::text(*lowest) + " must be <= Gwy::ZMax " +
                 brdf::text(*highest));
  raw.code_heights = {Length::um(*lowest * one->um()), Length::um(*highest * one->um())};
}

}  // namespace evaluation::detail
