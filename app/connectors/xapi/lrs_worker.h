// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <thread>

#include "app/services/access/session_context.h"

namespace torsio {

/// Sends the learning records of the centre while the program runs, on a thread and a connection of its own,
/// as soon as this station has a key of the store; what fails is tried again later. Nobody waits for it, and
/// it is never heard of where the centre sends nothing.
class LrsWorker {
 public:
  /// `again`: between two looks into the outbox.
  explicit LrsWorker(SessionKey key, std::chrono::milliseconds again);
  /// Gives a question to the store up at once.
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
