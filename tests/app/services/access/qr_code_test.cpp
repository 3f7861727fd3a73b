// SPDX-License-Identifier: GPL-3.0-or-later
// QR codes of links: their finder patterns and content.
#include "app/services/access/qr_code.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace torsio {
namespace {

using Modules = std::vector<std::vector<bool>>;

/// 33 x 33, version 4: its single alignment pattern is centred at (26, 26).
constexpr std::size_t kSide = 33;

/// Returns whether a module holds no data: the three finder patterns with format bits, timing, alignment.
bool isFixed(std::size_t row, std::size_t column) {
  const bool corner =
      (row < 9 && column < 9) || (row < 9 && column >= kSide - 8) || (row >= kSide - 8 && column < 9);
  const bool alignment = row >= 24 && row <= 28 && column >= 24 && column <= 28;
  return corner || alignment || row == 6 || column == 6;
}

bool masked(int mask, std::size_t i, std::size_t j) {
  switch (mask) {
    case 0:
      return (i + j) % 2 == 0;
    case 1:
      return i % 2 == 0;
    case 2:
      return j % 3 == 0;
    case 3:
      return (i + j) % 3 == 0;
    case 4:
      return (i / 2 + j / 3) % 2 == 0;
    case 5:
      return i * j % 2 + i * j % 3 == 0;
    case 6:
      return (i * j % 2 + i * j % 3) % 2 == 0;
    default:
      return ((i + j) % 2 + i * j % 3) % 2 == 0;
  }
}

/// Returns the codewords in placement order: in pairs of columns from the right, up and down.
std::vector<unsigned> codewords(const Modules& dark) {
  int mask = 0;
  for (std::size_t column = 2; column < 5; ++column) {
    mask = 2 * mask + static_cast<int>(dark[8][column]);
  }
  mask ^= 0b101;  // XOR mask of the format bits
  std::vector<unsigned> words;
  unsigned bits = 1;
  bool up = true;
  for (int right = static_cast<int>(kSide) - 1; right > 0; right -= 2, up = !up) {
    if (right == 6) {
      --right;
    }
    for (std::size_t step = 0; step < kSide; ++step) {
      const std::size_t row = up ? kSide - 1 - step : step;
      for (const int column : {right, right - 1}) {
        const auto at = static_cast<std::size_t>(column);
        if (isFixed(row, at)) {
          continue;
        }
        bits = 2 * bits + static_cast<unsigned>(dark[row][at] != masked(mask, row, at));
        if (bits >= 0x100) {
          words.push_back(bits & 0xFF);
          bits = 1;
        }
      }
    }
  }
  return words;
}

/// Decodes byte mode of version 4-M: two interleaved blocks of 32 data codewords; four bits of mode, eight of
/// length.
std::string read(const Modules& dark) {
  const std::vector<unsigned> laid = codewords(dark);
  std::vector<unsigned> words;
  for (std::size_t block = 0; block < 2; ++block) {
    for (std::size_t i = 0; i < 32; ++i) {
      words.push_back(laid[2 * i + block]);
    }
  }
  const auto byte = [&words](std::size_t i) { return ((words[i] & 0x0F) << 4) | (words[i + 1] >> 4); };
  EXPECT_EQ(words[0] >> 4, 4U) << "bytes";
  std::string text;
  for (std::size_t i = 1; i <= byte(0); ++i) {
    text += static_cast<char>(byte(i));
  }
  return text;
}

TEST(QrCode, ContainsTheLinkOfAnInvitation) {
  const std::string link = "https://desk.example.org/join#7KQ2M-9XWPT-4HVRD-E3NYB";

  const Modules dark = qrCode(link).dark;

  ASSERT_EQ(dark.size(), kSide);
  for (const auto& row : dark) {
    ASSERT_EQ(row.size(), kSide);
  }
  // Ring, white ring, core, in three corners.
  for (const auto& [top, left] :
       {std::pair<std::size_t, std::size_t>{0, 0}, {0, kSide - 7}, {kSide - 7, 0}}) {
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_TRUE(dark[top][left + i] && dark[top + 6][left + i] && dark[top + i][left] &&
                  dark[top + i][left + 6]);
    }
    EXPECT_FALSE(dark[top + 1][left + 1]);
    EXPECT_TRUE(dark[top + 3][left + 3]);
  }
  EXPECT_EQ(read(dark), link);
}

TEST(QrCode, RejectsMoreThanACodeHolds) {
  EXPECT_EQ(qrCode(std::string(2331, '\xff')).dark.size(), 177U);
  EXPECT_THROW((void)qrCode(std::string(2332, '\xff')), Error);
}

}  // namespace
}  // namespace torsio
