// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/connectors/xapi/lrs_client.h"
#include "app/connectors/xapi/lrs_settings.h"
#include "app/services/access/session_context.h"

namespace torsio {

class Connection;

/// What one round of sending came to.
struct LrsDelivery {
  std::int64_t delivered = 0;
  std::int64_t dead = 0;       ///< refused for good
  std::int64_t later = 0;      ///< tried again after a while
  std::int64_t forgotten = 0;  ///< nothing to tell, or the person no longer agrees
  bool stopped = false;        ///< the store does not take anything now: what is left waits
};

/// How long to wait before try number `tries` + 1: twice as long each time, from half a minute to six hours,
/// a quarter earlier or later by `id`, so that what failed together is not tried together.
[[nodiscard]] std::int64_t waitBeforeNextTry_us(std::int64_t tries, const std::string& id);
/// Reads Retry-After, seconds or a date; at most a day. Empty or unreadable: 0.
[[nodiscard]] std::int64_t retryAfter_us(const std::string& header, std::int64_t now_us);

/// Sends what waits and is due, each statement once, in the order in which things happened. A statement is
/// made and kept before it is sent, and sent again in the same bytes, so that the store has it once whatever
/// happens to the answers. Ends early when the store is away, refuses the key or has no such address; nothing
/// is lost by that. Throws Error, DbError.
LrsDelivery deliverLearningRecords(Connection& connection, const LrsIdentity& identity, LrsClient& store,
                                   const UtcClock& now);

}  // namespace torsio
