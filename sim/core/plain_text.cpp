// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/plain_text.h"

#include <algorithm>
#include <cstdint>

namespace torsio {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// A character and its length; nothing for bytes that are no UTF-8 (RFC 3629).
struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// Bytes that the first one announces; 0: it begins no character.
std::size_t announced(std::uint8_t lead) {
  return lead < 0x80 ? 1 : lead < 0xC2 || lead > 0xF4 ? 0 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
}

Character firstOf(std::string_view text) {
  const auto lead = static_cast<std::uint8_t>(text.front());
  const std::size_t length = announced(lead);
  if (length <= 1) {
    return {lead, length};
  }
  if (text.size() < length) {
    return {};
  }
  char32_t code = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<std::uint8_t>(text[i]);
    if ((next & 0xC0U) != 0x80) {
      return {};
    }
    code = (code << 6U) | (next & 0x3FU);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < kLeast[length] || surrogate || code > 0x10FFFF ? Character{} : Character{code, length};
}

constexpr char32_t kNonJoiner = 0x200C;
constexpr char32_t kJoiner = 0x200D;
constexpr char32_t kFirstJoined = 0x0600;  // of the scripts and pictures that need joiners

/// `before`: the character in front of it; 0: none.
bool isPlain(char32_t code, char32_t before, bool oneLine) {
  if (code < 0x20) {
    return !oneLine && (code == '\n' || code == '\t');
  }
  if (code == kNonJoiner || code == kJoiner) {
    return before >= kFirstJoined && before != kNonJoiner && before != kJoiner;
  }
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  return !within(0x7F, 0x9F)            // delete, and controls that some terminals obey
         && code != 0x00AD              // soft hyphen
         && code != 0x034F              // grapheme joiner
         && code != 0x061C              // Arabic letter mark
         && !within(0x115F, 0x1160)     // Hangul fillers
         && !within(0x17B4, 0x17B5)     // Khmer vowels that are not written
         && !within(0x180B, 0x180F)     // Mongolian selectors
         && code != 0x200B              // zero-width space
         && !within(0x200E, 0x200F)     // left-to-right and right-to-left mark
         && !within(0x2028, 0x202E)     // separators of lines and paragraphs, embeddings and overrides
         && !within(0x2060, 0x206F)     // invisible operators, isolates, deprecated controls
         && code != 0x2800              // braille without a dot
         && code != 0x3164              // Hangul filler
         && code != 0xFEFF              // byte order mark
         && code != 0xFFA0              // half-width Hangul filler
         && !within(0xFFF9, 0xFFFB)     // interlinear annotation
         && !within(0x1D173, 0x1D17A)   // musical beams and phrases
         && !within(0xE0000, 0xE007F);  // tags
}

std::string plain(std::string_view text, bool oneLine, std::size_t most) {
  std::string out;
  out.reserve(text.size());
  std::size_t characters = 0;
  char32_t before = 0;
  while (!text.empty()) {
    if (characters++ == most) {
      return out + "...";
    }
    const Character next = firstOf(text);
    if (oneLine && (next.code == '\n' || next.code == '\t' || next.code == '\r')) {
      out += ' ';
    } else if (next.bytes > 0 && isPlain(next.code, before, oneLine)) {
      out += text.substr(0, next.bytes);
    } else {
      out += kReplacement;
    }
    before = next.code;
    text.remove_prefix(std::max<std::size_t>(next.bytes, 1));
  }
  return out;
}

}  // namespace

std::string plainText(std::string_view text) {
  return plain(text, false, std::string_view::npos);
}

std::string plainLine(std::string_view text, std::size_t most) {
  return plain(text, true, most);
}

std::size_t completeBytes(std::string_view text) {
  for (std::size_t back = 1; back <= std::min<std::size_t>(3, text.size()); ++back) {
    const auto byte = static_cast<std::uint8_t>(text[text.size() - back]);
    if ((byte & 0xC0U) != 0x80) {
      return announced(byte) > back ? text.size() - back : text.size();
    }
  }
  return text.size();
}

}  // namespace torsio
