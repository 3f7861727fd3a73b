// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>

namespace torsio {

/// Sets rounding to nearest, denormal numbers as they are and no traps while it lives, whatever the thread
/// had set before (a plug-in, a vendor's callback): what is computed then has the same bits everywhere. For
/// the tick: no allocation, no lock.
class PinnedFloatMode {
 public:
  PinnedFloatMode() noexcept {
    (void)std::fegetenv(&before_);
    (void)std::fesetenv(FE_DFL_ENV);
  }
  ~PinnedFloatMode() { (void)std::fesetenv(&before_); }
  PinnedFloatMode(const PinnedFloatMode&) = delete;
  PinnedFloatMode& operator=(const PinnedFloatMode&) = delete;

 private:
  std::fenv_t before_{};
};

}  // namespace torsio
