// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <thread>

#include "app/services/access/session_context.h"

namespace torsio {

/// Sends the centre's learning records in the background, on its own thread and connection, if this station
/// has a key; retries what fails. Does nothing if the centre sends nothing.
class LrsWorker {
 public:
  /// `again`: interval between checks of the outbox.
  explicit LrsWorker(SessionKey key, std::chrono::milliseconds again);
  /// Aborts a running request.
  ~LrsWorker();
  LrsWorker(const LrsWorker&) = delete;
  LrsWorker& operator=(const LrsWorker&) = delete;

 private:
  struct State;
  static void run(State& state);
  std::unique_ptr<State> state_;
  std::thread thread_;
};

}  // namespace torsio
