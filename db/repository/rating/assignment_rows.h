// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/sheet.h"
#include "db/connection/row_reader.h"
#include "db/repository/rating/sheet_repository.h"

namespace torsio {

/// "SELECT ... FROM assignment a" with the columns that readAssignment() takes and then `more`, which begins
/// with a comma or is empty.
[[nodiscard]] std::string selectAssignments(std::string_view more = {});

/// A condition: the sheet of the assignment that the query calls `alias` is asked for, not taken back from
/// its rater.
[[nodiscard]] std::string isAskedFor(std::string_view alias);

/// Reads the columns of selectAssignments().
[[nodiscard]] Assignment readAssignment(RowReader& row);

/// Reads the rows of a sheet, by their code: those of a draft or of a sealed mark. Throws DbError.
[[nodiscard]] std::vector<SheetRow> draftRows(Connection& connection, const AssignmentId& assignmentId);
[[nodiscard]] std::vector<SheetRow> markRows(Connection& connection, const MarkId& markId);

}  // namespace torsio
