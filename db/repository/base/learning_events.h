// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/learning_event.h"
#include "db/connection/connection.h"

namespace torsio {

/// Puts what has just been stored into the outbox for the learning system; call it in the transaction of the
/// event. Nothing happens while the centre sends nothing, when the person has not agreed, for demonstration
/// data, for what is nobody's, or when it is there already. `objectIds`: as LearningEventKind says.
void noteLearningEvents(Connection& connection, LearningEventKind kind,
                        std::span<const std::string> objectIds);

/// Whether the newest decision of a person lets a learning system hear of them.
[[nodiscard]] bool agreesToLearningRecords(Connection& connection, const PersonId& personId);

}  // namespace torsio
