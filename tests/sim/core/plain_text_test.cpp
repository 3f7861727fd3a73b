// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/plain_text.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/text.h"

namespace torsio {
namespace {

const std::string kOdd = "\xEF\xBF\xBD";

std::string randomBytes(std::mt19937& random) {
  const char* const parts[] = {
      "\x1b[31m",        "\xff", "\xc3",         "\xe2\x80\xae", "\xc2\x9b", "\r",   "\xe2\x81\xa6",
      "\xf0\x9f\x98",    "A",    "\xe4\xb8\xad", "\n",           "\t",       "\x7f", "\xed\xa0\x80",
      "\xf3\xa0\x81\x81"};
  std::string text;
  for (int i = 0; i < 12; ++i) {
    text +=
        random() % 3 == 0 ? std::string(1, static_cast<char>(random())) : parts[random() % std::size(parts)];
  }
  return text;
}

/// No byte that a terminal obeys.
bool commandsNothing(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool control = byte < 0x20 && byte != '\n' && byte != '\t';
    const bool upper = byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (control || byte == 0x7F || upper) {
      return false;
    }
  }
  return text.find("\xe2\x80\xae") == std::string::npos && text.find("\xe2\x81\xa6") == std::string::npos;
}

TEST(PlainText, LeavesWhatPeopleWriteAsItIs) {
  for (const char* const text : {"", "Touch", "two\nlines\tand a tab", "Zwölf Ärzte", "扭转 60°", "‰ µ é",
                                 "👩‍⚕️", "می‌خواهم"}) {
    EXPECT_EQ(plainText(text), text);
  }
  EXPECT_EQ(plainLine("扭转", 2), "扭转");
  EXPECT_EQ(plainLine("扭转器", 2), "扭转...");
}

TEST(PlainText, ReplacesWhatCommandsATerminalTurnsTheTextOrIsNoUtf8) {
  EXPECT_EQ(plainText("\x1b[31mred"), kOdd + "[31mred");
  EXPECT_EQ(plainText("\xc2\x9b"
                      "31m"),
            kOdd + "31m");
  EXPECT_EQ(plainText("a\rb"), "a" + kOdd + "b");
  EXPECT_EQ(plainText("Tou\xff\xfe"), "Tou" + kOdd + kOdd);
  EXPECT_EQ(plainText("\xe2\x80\xaegpj.exe"), kOdd + "gpj.exe");
  EXPECT_EQ(plainText("\xc0\x80\xed\xa0\x80").find('\xc0'), std::string::npos);
  EXPECT_EQ(plainLine("two\r\nlines\x1b"), "two  lines" + kOdd);
}

TEST(PlainText, ShowsWhatIsNeverSeen) {
  for (const char* const hidden :
       {"\u00AD", "\u034F", "\u061C", "\u115F", "\u17B4", "\u180E", "\u200B",     "\u200C",
        "\u200D", "\u200E", "\u202D", "\u202E", "\u2060", "\u2062", "\u2066",     "\u2069",
        "\u206A", "\u2800", "\u3164", "\uFEFF", "\uFFA0", "\uFFF9", "\U0001D173", "\U000E0041"}) {
    EXPECT_EQ(plainText(std::string("ad") + hidden + "min"), "ad" + kOdd + "min") << hidden;
    EXPECT_EQ(plainLine(hidden), kOdd);
  }
  EXPECT_EQ(plainText("\u06CC\u200C\u200C\u062E"), "\u06CC\u200C" + kOdd + "\u062E");
}

TEST(PlainText, OfAnyBytesIsPlainAndStaysSo) {
  std::mt19937 random(43);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same bytes each time
  for (int i = 0; i < 20'000; ++i) {
    const std::string text = randomBytes(random);
    const std::string plain = plainText(text);
    ASSERT_TRUE(commandsNothing(plain)) << i;
    ASSERT_EQ(plainText(plain), plain) << i;
    // In parts, as a stream gets it.
    std::string parts;
    std::string waiting;
    for (const char byte : text) {
      waiting += byte;
      const std::size_t whole = completeBytes(waiting);
      parts += plainText(waiting.substr(0, whole));
      waiting.erase(0, whole);
    }
    ASSERT_TRUE(commandsNothing(parts + plainText(waiting))) << i;
    // In a sentence, and in a refusal.
    const Error error(ErrorCode::kBadData, Text::tr("the device \"%1\" is lost", text), text, Text(text));
    ASSERT_TRUE(commandsNothing(error.what())) << i;
    ASSERT_TRUE(commandsNothing(error.happened() + error.where() + error.remedy())) << i;
  }
}

}  // namespace
}  // namespace torsio
