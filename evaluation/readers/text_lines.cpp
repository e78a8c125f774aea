#include "evaluation/readers/text_lines.h"

#include "brdf/error.h"

namespace evaluation::detail {

bool TextLines::next() {
  begin_ = behind_;
  std::size_t end = buffer_.find('\n', begin_);
  while (end == std::string::npos) {
    const std::string_view piece = pieces_.next();
    if (piece.empty()) break;
    const std::size_t looked_at = buffer_.size() - begin_;
    buffer_.erase(0, begin_).append(piece);
    begin_ = 0;
    end = buffer_.find('\n', looked_at);
    if (end == std::string::npos && buffer_.size() > longest_line) break;
  }
  if (begin_ == buffer_.size()) return false;
  size_ = (end == std::string::npos ? buffer_.size() : end) - begin_;
  behind_ = end == std::string::npos ? buffer_.size() : end + 1;
  ++number_;
  if (size_ > longest_line)
    refuse("more than " + std::to_string(longest_line) + " bytes without an end");
  return true;
}

std::string_view TextLines::line() const {
  std::string_view line = std::string_view(buffer_).substr(begin_, size_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

void TextLines::refuse(const std::string& what) const {
  throw brdf::Error(brdf::Errc::bad_input,
                    *name_ + ": line " + std::to_string(number_) + ": " + what);
}

}  // namespace evaluation::detail
