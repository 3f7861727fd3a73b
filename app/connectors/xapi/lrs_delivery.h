// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "app/connectors/xapi/lrs_settings.h"
#include "app/services/access/session_context.h"

namespace torsio {

class Connection;

/// Result of one round of sending.
struct LrsDelivery {
  std::int64_t delivered = 0;
  std::int64_t dead = 0;       ///< set aside: refused while others were taken
  std::int64_t later = 0;      ///< to be tried again
  std::int64_t forgotten = 0;  ///< nothing to report, or consent was withdrawn
  bool stopped = false;        ///< the store accepts nothing now; the rest waits
};

/// Wait before try number `tries` + 1: from half a minute, doubled each time up to six hours, varied by a
/// quarter depending on `id`, so that entries that failed together are not retried together.
[[nodiscard]] std::int64_t waitBeforeNextTry_us(std::int64_t tries, const std::string& id);
/// Parses Retry-After (seconds or a date), capped at a day. Empty or invalid: 0.
[[nodiscard]] std::int64_t retryAfter_us(const std::string& header, std::int64_t now_us);

/// Sends due entries in the order of their events. Each statement is stored before it is sent, and resent
/// with the same bytes, so the store has it once even if answers get lost. Stops early, without losing
/// anything, if the store is unreachable, rejects the key, does not know the address, or takes none of three
/// statements: that concerns the sender. A statement is set aside for good only where the store takes others,
/// or after many tries. Throws Error, DbError.
LrsDelivery deliverLearningRecords(Connection& connection, const LrsIdentity& identity, LrsClient& store,
                                   const UtcClock& now);

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
