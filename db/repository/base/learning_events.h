// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/learning_event.h"
#include "db/connection/connection.h"

namespace torsio {

/// Adds outbox entries for the learning system about what was just stored; call it in the same transaction.
/// No effect if sending is off, the person has not agreed, the data are demonstration data or nobody's, or
/// the entry exists. `objectIds`: as in LearningEventKind.
void noteLearningEvents(Connection& connection, LearningEventKind kind,
                        std::span<const std::string> objectIds);

/// True if the person's newest decision permits reporting to a learning system.
[[nodiscard]] bool agreesToLearningRecords(Connection& connection, const PersonId& personId);

}  // namespace torsio
