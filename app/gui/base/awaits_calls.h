// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio::gui {

/// A page on which people wait for calls to the real arm: the idle desk is not locked meanwhile. GUI thread.
class AwaitsCalls {
 public:
  AwaitsCalls() = default;
  virtual ~AwaitsCalls() = default;
  AwaitsCalls(const AwaitsCalls&) = delete;
  AwaitsCalls& operator=(const AwaitsCalls&) = delete;

  /// Returns whether calls are going on.
  [[nodiscard]] virtual bool callsGoOn() const = 0;
};

}  // namespace torsio::gui
