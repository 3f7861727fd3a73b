// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/written_words.h"

#include <cstdint>
#include <optional>

#include "sim/core/error.h"

namespace torsio {

namespace {

/// One UTF-8 character and its length in bytes.
struct Utf8Character {
  char32_t code = 0;
  std::size_t bytes = 1;
};

/// Decodes the first character (RFC 3629); empty for invalid bytes: truncated, overlong, a surrogate.
std::optional<Utf8Character> firstOf(std::string_view bytes) {
  const auto lead = static_cast<std::uint8_t>(bytes.front());
  if (lead < 0x80) {
    return Utf8Character{lead, 1};
  }
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || bytes.size() < length) {
    return std::nullopt;
  }
  char32_t code = lead & (0x7F >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<std::uint8_t>(bytes[i]);
    if ((next & 0xC0) != 0x80) {
      return std::nullopt;
    }
    code = (code << 6) | (next & 0x3F);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kLeast[length] || surrogate || code > 0x10FFFF) {
    return std::nullopt;
  }
  return Utf8Character{code, length};
}

}  // namespace

void requireWords(std::string_view words, std::size_t longest, const Text& where) {
  std::size_t characters = 0;
  for (std::string_view rest = words; !rest.empty(); ++characters) {
    const std::optional<Utf8Character> next = firstOf(rest);
    const bool written = next && (next->code >= 0x20 || next->code == '\n' || next->code == '\t') &&
                         (next->code < 0x7F || next->code > 0x9F);
    if (!written) {
      refuseParameter(Text::tr("the text holds a character that cannot be read"), where,
                      Text::tr("Type it again instead of pasting it"));
    }
    rest.remove_prefix(next->bytes);
  }
  if (characters > longest) {
    refuseParameter(Text::tr("the text has %1 characters; %2 are the most", characters, longest), where,
                    Text::tr("Shorten it"));
  }
}

}  // namespace torsio
