#include "evaluation/readers/text_encoding.h"

#include <cstdint>

#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

constexpr std::uint64_t piece_bytes = FileSource::head_bytes;
constexpr char32_t no_character = 0xFFFD;

void append_utf8(char32_t code, std::string& text) {
  const auto byte = [&](char32_t bits) { text += static_cast<char>(bits); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | code >> 6);
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | code >> 12);
    byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | code >> 18);
    byte(0x80 | (code >> 12 & 0x3F));
    byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

std::string from_utf16(std::string_view bytes, std::endian order) {
  std::string text;
  text.reserve(bytes.size() / 2);
  const auto unit = [&](std::size_t at) -> char32_t {
    return at + 2 <= bytes.size() ? stored_number<std::uint16_t>(bytes.data() + at, order)
                                  : no_character;
  };
  for (std::size_t at = 0; at < bytes.size(); at += 2) {
    char32_t code = unit(at);
    const bool is_half = code >= 0xD800 && code < 0xE000;
    const char32_t other = is_half && at + 2 < bytes.size() ? unit(at + 2) : 0;
    if (is_half && code < 0xDC00 && other >= 0xDC00 && other < 0xE000) {
      code = 0x10000 + ((code - 0xD800) << 10) + (other - 0xDC00);
      at += 2;
    } else if (is_half) {
      code = no_character;
    }
    append_utf8(code, text);
  }
  return text;
}

/// Without half a unit or the first of a pair at the end.
std::size_t whole_characters(std::string_view bytes, std::endian order) {
  const std::size_t units = bytes.size() / 2 * 2;
  if (units == 0) return 0;
  const auto last = stored_number<std::uint16_t>(bytes.data() + units - 2, order);
  return last >= 0xD800 && last < 0xDC00 ? units - 2 : units;
}

}  // namespace

Utf8Pieces::Utf8Pieces(const FileSource& source) : source_(&source) {
  constexpr std::string_view utf8 = "\xEF\xBB\xBF", little = "\xFF\xFE", big = "\xFE\xFF";
  const std::string_view head = source.head();
  if (head.starts_with(little)) utf16_ = std::endian::little;
  if (head.starts_with(big)) utf16_ = std::endian::big;
  if (utf16_) at_ = little.size();
  if (head.starts_with(utf8)) at_ = utf8.size();
}

std::string_view Utf8Pieces::next() {
  while (at_ < source_->size()) {
    bytes_.erase(0, bytes_.size() - left_over_).resize(left_over_ + piece_bytes);
    const std::size_t read = source_->read_at(at_, bytes_.data() + left_over_, piece_bytes);
    at_ += read;
    bytes_.resize(left_over_ + read);
    left_over_ = 0;
    if (!utf16_) return bytes_;
    const std::size_t whole =
        at_ < source_->size() ? whole_characters(bytes_, *utf16_) : bytes_.size();
    left_over_ = bytes_.size() - whole;
    if (whole > 0) return text_ = from_utf16(std::string_view(bytes_).substr(0, whole), *utf16_);
  }
  return {};
}

}  // namespace evaluation::detail
