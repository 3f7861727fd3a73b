// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/connectors/xapi/lrs_settings.h"
#include "app/services/recording/kept_digests.h"
#include "assessment/domain/people/learning_event.h"

namespace torsio {

class Connection;

/// Namespace of the extensions in Torsio's statements (docs/xapi.md).
inline constexpr const char* kXapiExtensions = "urn:x-torsio:xapi:";

/// The id of an entry's statement: always the same (UUID version 5).
[[nodiscard]] std::string statementId(const LearningEvent& event);
/// Opaque name of a person's account at the store; constant while the centre keeps its settings.
[[nodiscard]] std::string accountName(const LrsIdentity& identity, const PersonId& personId);

/// The xAPI statement of an entry (JSON), without name, code or group. Empty if there is nothing to report:
/// the run does not count, or the event no longer exists. Measures the recording if that has not been done.
/// Throws Error, DbError.
[[nodiscard]] std::string statementOf(Connection& connection, const LearningEvent& event,
                                      const LrsIdentity& identity, ExerciseRules& rules, std::int64_t now_us);

/// Whether two statements are equivalent, ignoring the order of keys, the notation of times, and what the
/// store adds (stored, authority, version, descriptions). False for invalid JSON.
[[nodiscard]] bool sameStatement(const std::string& sent, const std::string& stored);

}  // namespace torsio
