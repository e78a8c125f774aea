#include "evaluation/readers/text_header.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <vector>

#include "evaluation/lengths.h"

namespace evaluation::detail {
namespace {

using brdf::Length;

/// The words of Gwyddion's asciiexport in its languages (the catalogues of version 2.62).
constexpr std::array channel_words{"Channel", "Kanál",    "Kanal", "Canal",
                                   "Canale",  "チャネル", "채널",  "Канал"};
constexpr std::array width_words{"Width",     "Šířka",   "Breite", "Anchura", "Largeur",
                                 "Larghezza", "Largura", "幅",     "폭",      "Ширина"};
constexpr std::array height_words{"Height",  "Výška", "Höhe", "Altura", "Hauteur",
                                  "Altezza", "高さ",  "높이", "Высота"};
constexpr std::array unit_words{"Value units", "Jednotky hodnot",   "Einheiten",
                                "Unités",      "unità valore",      "値の単位",
                                "값 단위",     "Unidades de valor", "Единицы измерения"};

constexpr bool is_one_of(std::string_view word, const auto& words) {
  return std::ranges::any_of(words, [&](std::string_view known) { return known == word; });
}

/// The value and the rest of "10.00 µm".
std::optional<Length> length(std::string_view text, const TextLines& lines) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [after, ec] = std::from_chars(text.data(), end, value);
  if (ec != std::errc{}) return std::nullopt;
  const std::string_view rest(after, static_cast<std::size_t>(end - after));
  if (rest.starts_with(','))
    lines.refuse("\"" + std::string(text.substr(0, 40)) +
                 "\" has a decimal comma, which is not read; write a point");
  const std::optional<Length> one = length_unit(trimmed(rest));
  if (!one) return std::nullopt;
  if (!(value > 0 && std::isfinite(value)))
    lines.refuse("\"" + std::string(text.substr(0, 40)) + "\" must be > 0");
  return Length::um(value * one->um());
}

void take_comment(std::string_view comment, const TextLines& lines, TextHeader& header) {
  constexpr std::string_view wide_colon = "：";
  const std::size_t narrow = comment.find(':'), wide = comment.find(wide_colon);
  const std::size_t colon = std::min(narrow, wide);
  if (colon == std::string_view::npos) return;
  const std::string_view word = trimmed(comment.substr(0, colon));
  const std::string_view value =
      trimmed(comment.substr(colon + (colon == wide ? wide_colon.size() : 1)));
  const bool is_title = is_one_of(word, channel_words), is_unit = is_one_of(word, unit_words);
  const bool is_width = is_one_of(word, width_words), is_height = is_one_of(word, height_words);
  if (is_title) header.title = value;
  if (is_unit) header.z_unit = value;
  if (is_width) header.width = length(value, lines);
  if (is_height) header.height = length(value, lines);
  header.is_matrix |= is_title || is_unit || is_width || is_height;
}

/// The unit in "x", "x [um]", "x (um)", "x/um" or "x_um"; nothing for another name.
std::optional<std::string> unit_of_column(std::string_view field, char name) {
  field = trimmed(field);
  if (field.empty() || std::tolower(static_cast<unsigned char>(field[0])) != name)
    return std::nullopt;
  field = trimmed(field.substr(1));
  if (field.empty()) return "";
  for (const std::string_view frame : {"[]", "()"})
    if (field.front() == frame[0] && field.back() == frame[1])
      return std::string(trimmed(field.substr(1, field.size() - 2)));
  if (field.front() == '/' || field.front() == '_') return std::string(trimmed(field.substr(1)));
  return std::nullopt;
}

/// Whether a line names the columns x, y, z.
bool take_names(std::string_view line, TextHeader& header) {
  const std::size_t mark = line.find_first_of(",;\t");
  const char separator = mark == std::string_view::npos ? ' ' : line[mark];
  std::vector<std::string_view> fields;
  for (std::string_view rest = trimmed(line); !rest.empty();) {
    // "x [um] y [um]": a blank before a unit does not end a name.
    std::size_t end = rest.find(separator);
    while (separator == ' ' && end != rest.npos && end + 1 < rest.size() &&
           (rest[end + 1] == '[' || rest[end + 1] == '(' || rest[end + 1] == ' '))
      end = rest.find(separator, end + 1);
    fields.push_back(rest.substr(0, end));
    rest = end == rest.npos ? std::string_view{} : rest.substr(end + 1);
  }
  if (fields.size() != 3) return false;
  const auto x = unit_of_column(fields[0], 'x'), y = unit_of_column(fields[1], 'y'),
             z = unit_of_column(fields[2], 'z');
  if (!x || !y || !z) return false;
  header.is_points = true;
  header.x_unit = *x;
  header.y_unit = *y;
  header.z_unit = *z;
  return true;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks[] = {" ", "\t", "\r", "\xC2\xA0", "\xE2\x80\xAF"};
  for (bool again = true; again;) {
    again = false;
    for (const std::string_view blank : blanks) {
      const bool before = text.starts_with(blank);
      if (before) text.remove_prefix(blank.size());
      const bool behind = text.ends_with(blank);
      if (behind) text.remove_suffix(blank.size());
      again |= before || behind;
    }
  }
  return text;
}

bool read_text_header(TextLines& lines, TextHeader& header) {
  while (lines.next()) {
    const std::string_view line = trimmed(lines.line());
    if (line.empty()) continue;
    if (line[0] == '#' || line[0] == '%') {
      const std::string_view comment = trimmed(line.substr(1));
      if (!take_names(comment, header)) take_comment(comment, lines, header);
    } else if (!take_names(line, header)) {
      return true;
    }
  }
  return false;
}

}  // namespace evaluation::detail
