#include "evaluation/readers/text_table.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <vector>

namespace evaluation::detail {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// ' ' stands for any number of blanks and tabs.
char separator_of(std::string_view line) {
  for (const char separator : {';', '\t', ','})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t") == std::string_view::npos;
}

int significant_digits(const char* at, const char* end) {
  int digits = 0;
  for (; at != end && *at != 'e' && *at != 'E'; ++at)
    if (*at >= (digits == 0 ? '1' : '0') && *at <= '9') ++digits;
  return digits;
}

class RowReader {
 public:
  explicit RowReader(char separator) : separator_(separator) {}

  /// The cells of a line; a separator at its end is told by `ends_open`.
  void read(const TextLines& lines) {
    at_ = lines.line().data();
    end_ = at_ + lines.line().size();
    row.clear();
    ends_open = false;
    for (skip_blanks(); at_ != end_; skip_blanks()) {
      ends_open = *at_ == separator_;
      if (ends_open)
        row.push_back(missing);
      else
        take_number(lines);
      if (at_ == end_ || separator_ == ' ') continue;
      ends_open = true;
      ++at_;
    }
  }

  std::vector<double> row;
  bool ends_open = false;
  int digits = 0;

 private:
  void skip_blanks() {
    while (at_ != end_ && (*at_ == ' ' || (*at_ == '\t' && separator_ != '\t'))) ++at_;
  }

  /// Up to the separator, or the end of the line.
  void take_number(const TextLines& lines) {
    const char* const cell = at_;
    if (*at_ == '+' && at_ + 1 != end_ && at_[1] != '-') ++at_;
    double value = 0;
    const auto [after, ec] = std::from_chars(at_, end_, value);
    digits = std::max(digits, significant_digits(at_, after));
    const char* const number_end = after;
    at_ = number_end;
    skip_blanks();
    const bool ends = at_ == end_ || *at_ == separator_ || (separator_ == ' ' && at_ != number_end);
    if (ec != std::errc{} || !ends) refuse(lines, cell);
    row.push_back(value);
  }

  [[noreturn]] void refuse(const TextLines& lines, const char* cell) const {
    const std::string_view rest(cell, static_cast<std::size_t>(end_ - cell));
    const std::string_view text = rest.substr(0, rest.find(separator_));
    // "1,5 2,5" comes in pieces of which one holds a blank.
    const bool has_comma =
        (separator_ == ',' ? text.find(' ') : text.find(',')) != std::string_view::npos;
    std::string shown(text.substr(0, 40));
    std::ranges::replace_if(
        shown, [](unsigned char c) { return c < ' '; }, '?');
    lines.refuse("column " + std::to_string(row.size() + 1) + ": \"" + shown +
                 "\" is not a number" +
                 (has_comma ? "; decimal commas are not read, write points" : ""));
  }

  char separator_;
  const char *at_ = nullptr, *end_ = nullptr;
};

std::size_t rows_from(TextLines lines) {
  std::size_t rows = 0;
  do rows += is_blank(lines.line()) ? 0 : 1;
  while (lines.next());
  return rows;
}

}  // namespace

bool looks_like_numbers(std::string_view line) {
  constexpr std::string_view digits = "0123456789";
  if (line.find_first_not_of("0123456789+-.,;eE \tnaNAifIF") != std::string_view::npos)
    return false;
  return line.find_first_of(digits) != std::string_view::npos || line.starts_with("nan") ||
         line.starts_with("NaN") || line.starts_with("NAN");
}

TextTable read_text_table(TextLines lines,
                          const std::function<void(std::size_t, std::size_t)>& require) {
  RowReader reader(separator_of(lines.line()));
  reader.read(lines);
  const std::size_t cols = reader.row.size(), rows = rows_from(lines);
  require(cols, rows);
  TextTable table;
  table.values.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
  double* next = table.values.data();
  const double* const end = next + table.values.size();
  const auto require_unchanged = [&](bool holds) {
    if (!holds) lines.refuse("the file has changed while it was read");
  };
  do {
    if (is_blank(lines.line())) continue;
    reader.read(lines);
    if (reader.row.size() + 1 == cols && reader.ends_open) reader.row.push_back(missing);
    if (reader.row.size() != cols)
      lines.refuse(std::to_string(reader.row.size()) + " cells, the first row has " +
                   std::to_string(cols));
    require_unchanged(next != end);
    next = std::copy(reader.row.begin(), reader.row.end(), next);
  } while (lines.next());
  require_unchanged(next == end);
  table.digits = reader.digits;
  return table;
}

}  // namespace evaluation::detail
