// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace torsio {

/// Keeps the calling thread on the core it runs on, while it lives. Private to the benchmark.
class CorePin {
 public:
  CorePin();
  ~CorePin();
  CorePin(const CorePin&) = delete;
  CorePin& operator=(const CorePin&) = delete;

  /// Returns the core; -1 where the platform cannot pin, or forbids it.
  [[nodiscard]] int core() const noexcept { return core_; }

 private:
  struct Saved;
  int core_ = -1;
  std::unique_ptr<Saved> saved_;
};

/// Returns the load average of the last minute; -1 where the platform does not tell.
[[nodiscard]] double loadAverage();

}  // namespace torsio
