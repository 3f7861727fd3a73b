// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "db/connection/connection.h"

namespace torsio {

/// Tells by codes whom or what the entries of the audit trail from `fromSequence` on are about: the code of a
/// person, a sign-in name, "R-03: case 7F", the name of a cohort. By the ids that stand in the entries; what
/// has no such code is left out. Never a name of a person. Throws DbError.
[[nodiscard]] std::map<std::string, std::string> auditSubjects(Connection& connection,
                                                               std::int64_t fromSequence);

}  // namespace torsio
