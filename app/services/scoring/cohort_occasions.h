// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/occasion.h"

namespace torsio {

class Connection;

/// Gives the occasions of a cohort in order of time: those of its curriculum, with their times of exposure,
/// and any other at which it was marked or raters are asked. A cohort whose curriculum names none has all
/// occasions of the record; one of recordings of other equipment those at which it was marked. Throws
/// Error{kBadData} when there is no such cohort.
[[nodiscard]] Occasions occasionsOfCohort(Connection& connection, const CohortId& cohortId);

}  // namespace torsio
