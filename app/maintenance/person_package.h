// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/access/session_context.h"
#include "sim/base/ids.h"

namespace torsio {

/// What a person's package holds.
struct PersonPackage {
  std::filesystem::path folder;
  std::int64_t tables = 0;
  std::int64_t rows = 0;
  std::int64_t recordings = 0;
};

/// Writes everything about one person into a new folder: each table as CSV and JSON, their recordings as
/// trial files, manifest.json with the BLAKE2b-256 of every file, README.txt in plain words. The folder gets
/// its name when it is complete. kPersonExport, audited. Throws Error: kFileUnwritable when the folder exists
/// already, kBadData when there is no such person.
PersonPackage exportPersonPackage(SessionContext& session, const PersonId& personId,
                                  const std::filesystem::path& folder, const std::string& reason);

/// Erases a person: what goes and what stays is said at erasePerson (db/repository/people/person_data.h).
/// kPersonErase, audited. Throws Error (kBadParameter) without a reason.
void erasePersonRecord(SessionContext& session, const PersonId& personId, const std::string& reason);

}  // namespace torsio
