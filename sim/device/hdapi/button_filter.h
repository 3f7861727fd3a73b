// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace torsio {

/// Debounce time: a switch bounces within it, a person does not press twice.
inline constexpr std::int64_t kButtonBounce_us = 5'000;

/// Debounces buttons without delaying them: a change counts at once, further changes of the same button are
/// ignored for kButtonBounce_us, then the button's level counts again. Servo thread; a plain value.
class ButtonFilter {
 public:
  /// Returns the mask of pressed buttons at `now_us`; bits beyond the first kButtons are dropped.
  std::uint32_t filter(std::uint32_t raw, std::int64_t now_us) noexcept {
    for (std::size_t i = 0; i < kButtons; ++i) {
      const std::uint32_t bit = 1U << i;
      if (((raw ^ mask_) & bit) == 0 || now_us < quietUntil_us_[i]) {
        continue;
      }
      mask_ ^= bit;
      quietUntil_us_[i] = now_us + kButtonBounce_us;
    }
    return mask_;
  }

  static constexpr std::size_t kButtons = 2;  ///< on the stylus of an Omni or Touch

 private:
  std::uint32_t mask_ = 0;
  std::array<std::int64_t, kButtons> quietUntil_us_{};
};

}  // namespace torsio
