// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/connectors/xapi/lrs_settings.h"
#include "app/services/recording/kept_digests.h"
#include "assessment/domain/people/learning_event.h"

namespace torsio {

class Connection;

/// Where the extensions of Torsio's statements live; docs/xapi.md lists them.
inline constexpr const char* kXapiExtensions = "urn:x-torsio:xapi:";

/// The id of an entry's statement: the same whoever makes it, and whenever (UUID version 5).
[[nodiscard]] std::string statementId(const LearningEvent& event);
/// The name of a person's account at the store: opaque, the same as long as the centre keeps its settings.
[[nodiscard]] std::string accountName(const LrsIdentity& identity, const PersonId& personId);

/// Makes the xAPI statement of an entry (JSON): no name, no code, no group. Empty: there is nothing to tell,
/// since a run does not count at its exercise or what happened is gone. A recording that was not measured yet
/// is measured and kept. Throws Error, DbError.
[[nodiscard]] std::string statementOf(Connection& connection, const LearningEvent& event,
                                      const LrsIdentity& identity, ExerciseRules& rules, std::int64_t now_us);

/// Whether two statements say the same: order of keys, spelling of times, and what the store adds (stored,
/// authority, version, words that describe) do not count. False for what is no JSON.
[[nodiscard]] bool sameStatement(const std::string& sent, const std::string& stored);

}  // namespace torsio
