// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>

#include "sim/core/file_io.h"

namespace torsio::gui::testing {

/// Estimates the time of a user's actions with mouse and keys: keystroke-level model (Card, Moran and Newell
/// 1980), and silent reading at 238 words per minute (Brysbaert 2019).
class ByHand {
 public:
  /// Decide, point, press.
  void press(int times = 1) { needed_s_ += times * (kDecide_s + kPoint_s + kKey_s), presses_ += times; }
  void type(std::size_t keys) { needed_s_ += static_cast<double>(keys) * kKey_s, keys_ += keys; }
  void wait_s(double seconds) { needed_s_ += seconds; }
  /// Reads a part of a page of the guide once, from one text to another.
  void read(const std::filesystem::path& page, const std::string& from, const std::string& to) {
    const std::string text = readFile(page);
    const std::size_t begin = text.find(from);
    std::istringstream part(text.substr(begin, text.find(to, begin) - begin));
    std::size_t words = 0;
    for (std::string word; part >> word;) {
      ++words;
    }
    needed_s_ += static_cast<double>(words) * kWord_s;
    words_ += words;
  }
  [[nodiscard]] double minutes() const { return needed_s_ / 60.0; }
  [[nodiscard]] int presses() const { return presses_; }
  [[nodiscard]] std::size_t keys() const { return keys_; }
  [[nodiscard]] std::size_t words() const { return words_; }

 private:
  static constexpr double kDecide_s = 1.35;
  static constexpr double kPoint_s = 1.1;
  static constexpr double kKey_s = 0.28;
  static constexpr double kWord_s = 60.0 / 238.0;
  double needed_s_ = 0.0;
  int presses_ = 0;
  std::size_t keys_ = 0;
  std::size_t words_ = 0;
};

}  // namespace torsio::gui::testing
