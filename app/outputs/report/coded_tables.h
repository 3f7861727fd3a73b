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

/// Writes the recordings of a cohort's trainees as a table under codes, oldest first (UTF-8 with byte order
/// mark, comma-separated), and audits the export. Returns the number of rows. kTrialViewCoded. Throws
/// Error{kFileUnwritable}.
std::size_t exportRecordings(SessionContext& session, const CohortId& cohortId,
                             const std::filesystem::path& file, const CsvStyle& look = {});

/// Writes the latest version of every mark of a cohort under the codes of trainee and rater, without
/// comments, in the same format. Returns the number of rows. kMarkViewCoded. Throws Error{kFileUnwritable}.
std::size_t exportMarks(SessionContext& session, const CohortId& cohortId, const std::filesystem::path& file,
                        const CsvStyle& look = {});

/// Writes the sheets behind the marks: one row per mark and criterion, with scoring sheet, revision and
/// program hash. kMarkViewCoded. Returns the number of rows. Throws Error{kFileUnwritable}.
std::size_t exportCriteria(SessionContext& session, const CohortId& cohortId,
                           const std::filesystem::path& file, const CsvStyle& look = {});
/// Writes the scoring sheets used in a cohort: one row per anchor (and one per criterion without anchors).
/// kMarkViewCoded. Returns the number of rows. Throws Error{kFileUnwritable}.
std::size_t exportRubrics(SessionContext& session, const CohortId& cohortId,
                          const std::filesystem::path& file, const CsvStyle& look = {});

/// Writes all audit entries that match the filter, latest first, with the codes of their subjects, in the
/// same format. Returns the number of rows. kAuditView. Throws Error{kFileUnwritable}.
std::size_t exportAuditTrail(SessionContext& session, AuditFilter filter, const std::filesystem::path& file,
                             const CsvStyle& look = {});

}  // namespace torsio
