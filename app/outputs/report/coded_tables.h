// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/base/csv_style.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"

namespace torsio {

/// Writes the recordings of a cohort's trainees as a table under their codes, oldest first (UTF-8 with byte
/// order mark, comma-separated), and keeps in the audit trail that it was taken out. Returns how many there
/// are. kTrialViewCoded. Throws Error{kFileUnwritable}.
std::size_t exportRecordings(SessionContext& session, const CohortId& cohortId,
                             const std::filesystem::path& file, const CsvStyle& look = {});

/// Writes every newest mark of a cohort under the codes of trainee and rater, without comments, in the same
/// form. Returns how many there are. kMarkViewCoded. Throws Error{kFileUnwritable}.
std::size_t exportMarks(SessionContext& session, const CohortId& cohortId, const std::filesystem::path& file,
                        const CsvStyle& look = {});

/// The sheets behind the marks: one line a mark and criterion, with the scoring sheet, its revision and the
/// hash of the program. kMarkViewCoded. Returns the number of lines. Throws Error{kFileUnwritable}.
std::size_t exportCriteria(SessionContext& session, const CohortId& cohortId,
                           const std::filesystem::path& file, const CsvStyle& look = {});
/// The scoring sheets that were used in a cohort: one line an anchor (a criterion without one has a line,
/// too). kMarkViewCoded. Returns the number of lines. Throws Error{kFileUnwritable}.
std::size_t exportRubrics(SessionContext& session, const CohortId& cohortId,
                          const std::filesystem::path& file, const CsvStyle& look = {});

/// Writes the entries of the audit trail that pass a filter, all of them, newest first, with the codes of
/// whom they are about, in the same form. Returns how many there are. kAuditView. Throws
/// Error{kFileUnwritable}.
std::size_t exportAuditTrail(SessionContext& session, AuditFilter filter, const std::filesystem::path& file,
                             const CsvStyle& look = {});

}  // namespace torsio
