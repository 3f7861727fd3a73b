// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "app/services/access/session_context.h"
#include "sim/core/text.h"

namespace torsio {

/// What waits for the actor.
struct WaitingRequests {
  std::size_t toConfirm = 0;  ///< requests of others that need a second person, which the actor may confirm
  std::size_t ofPeople = 0;   ///< unanswered requests of trainees about their own record
  friend bool operator==(const WaitingRequests&, const WaitingRequests&) = default;
};

/// Counts what the actor has the right to see; nothing without a right.
[[nodiscard]] WaitingRequests waitingRequests(SessionContext& session);
/// Returns the sentence about requests to confirm; empty for none.
[[nodiscard]] Text toConfirmWords(std::size_t count);

/// Subject and text of the message that tells an administrator of requests that wait.
[[nodiscard]] Text waitingMailSubject(const std::string& centre);
[[nodiscard]] Text waitingMailWords(const std::string& centre, const std::string& askedBy, std::size_t count);

}  // namespace torsio
