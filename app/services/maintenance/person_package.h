// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// Returns whether the person can be erased now: somebody else has requested it, the centre requires only one
/// person, or the person is simulated. Call after checking kPersonErase.
[[nodiscard]] bool mayEraseNow(SessionContext& session, const PersonId& personId);

/// Erases in one transaction and uses up the request. Call after checking kPersonErase. Throws
/// SecondPersonNeeded, and what erasePerson() throws.
void eraseGuarded(SessionContext& session, const PersonId& personId, const std::string& reason);

/// Summary of a person's package.
struct PersonPackage {
  std::filesystem::path folder;
  std::int64_t tables = 0;
  std::int64_t rows = 0;
  std::int64_t recordings = 0;
};

/// Writes all data of a person into a new folder: each table as CSV and JSON, recordings as trial files,
/// manifest.json with the BLAKE2b-256 of every file, README.txt in plain language. The folder gets its name
/// when it is complete. kPersonExport, audited. Throws Error: kFileUnwritable if the folder exists, kBadData
/// if there is no such person.
PersonPackage exportPersonPackage(SessionContext& session, const PersonId& personId,
                                  const std::filesystem::path& folder, const std::string& reason);

/// Writes packages of several people into a new folder, each in a folder "record-CODE". kPersonExport, each
/// audited. Throws like exportPersonPackage(), and Cancelled; completed packages stay.
std::vector<PersonPackage> exportPersonPackages(SessionContext& session, std::span<const PersonId> people,
                                                const std::filesystem::path& folder,
                                                const std::string& reason,
                                                const ProgressCallback& progress = {});

/// Erases a person as described at erasePerson (db/repository/people/person_data.h). kPersonErase, audited.
/// Throws Error (kBadParameter) without a reason.
void erasePersonRecord(SessionContext& session, const PersonId& personId, const std::string& reason);

}  // namespace torsio
