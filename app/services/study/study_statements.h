// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/study_statement.h"

namespace torsio {

inline constexpr std::size_t kLongestStatement = 600;  // bytes of UTF-8

/// Returns what the cohort's study says about itself. kPersonViewCoded. Throws Error{kBadData} for an unknown
/// cohort.
[[nodiscard]] StudyStatements studyStatements(SessionContext& session, const CohortId& cohortId);

/// Makes these the statements of the cohort: appends what differs, and an empty version of what is absent.
/// Earlier versions stay. Audited with both versions. kStudySetup. Throws Error{kBadParameter} for a
/// statement longer than kLongestStatement, {kBadData} for an unknown cohort.
void setStudyStatements(SessionContext& session, const CohortId& cohortId, const StudyStatements& statements);

}  // namespace torsio
