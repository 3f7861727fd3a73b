// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// Hashes of the submitted training marks with their rows as currently stored, by which frozen data reference
/// them; `ids` empty: all. Excludes the comment, which may be erased.
[[nodiscard]] std::map<std::string, std::string> markHashes(Connection& connection,
                                                            std::span<const MarkId> ids = {});
[[nodiscard]] std::map<std::string, std::string> evaluationMarkHashes(
    Connection& connection, std::span<const EvaluationMarkId> ids = {});
/// Hashes of ended trials: the closing row with its content hash.
[[nodiscard]] std::map<std::string, std::string> trialHashes(Connection& connection,
                                                             std::span<const TrialId> ids = {});

}  // namespace torsio
