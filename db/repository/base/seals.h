// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// What frozen data name a row by: the hash of every submitted training mark with its rows, as the tables
/// have them now; `ids` empty: of all. Without the comment, which may be erased.
[[nodiscard]] std::map<std::string, std::string> markHashes(Connection& connection,
                                                            std::span<const MarkId> ids = {});
[[nodiscard]] std::map<std::string, std::string> evaluationMarkHashes(
    Connection& connection, std::span<const EvaluationMarkId> ids = {});
/// Of every trial that has ended: its closing row with the content hash.
[[nodiscard]] std::map<std::string, std::string> trialHashes(Connection& connection,
                                                             std::span<const TrialId> ids = {});

}  // namespace torsio
