// Texts of other systems as UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace evaluation::detail {

/// A text without its byte order mark, UTF-16 of either order turned into UTF-8; a text without a
/// mark is taken as it is. `own` holds what had to be turned; the result refers to it or to
/// `bytes`. What is no UTF-16 becomes U+FFFD, which is no part of any number.
std::string_view utf8_text(std::string_view bytes, std::string& own);

}  // namespace evaluation::detail
