#include "evaluation/readers/text_encoding.h"

#include <cstdint>

#include "evaluation/readers/stored_number.h"

namespace evaluation::detail {
namespace {

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

}  // namespace

std::string_view utf8_text(std::string_view bytes, std::string& own) {
  constexpr std::string_view utf8 = "\xEF\xBB\xBF", little = "\xFF\xFE", big = "\xFE\xFF";
  if (bytes.starts_with(utf8)) return bytes.substr(utf8.size());
  if (bytes.starts_with(little))
    return own = from_utf16(bytes.substr(little.size()), std::endian::little);
  if (bytes.starts_with(big)) return own = from_utf16(bytes.substr(big.size()), std::endian::big);
  return bytes;
}

}  // namespace evaluation::detail
