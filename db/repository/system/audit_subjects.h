// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "db/connection/connection.h"

namespace torsio {

/// Returns display texts for the subjects of audit entries from `fromSequence` on, by object id: a person's
/// code, a login, "R-03: case 7F", the name of a cohort. Objects without one are omitted. Never a person's
/// name. Throws DbError.
[[nodiscard]] std::map<std::string, std::string> auditSubjects(Connection& connection,
                                                               std::int64_t fromSequence);

}  // namespace torsio
