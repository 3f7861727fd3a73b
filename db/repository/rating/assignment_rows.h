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

/// Returns "SELECT ... FROM assignment a" with the columns of readAssignment(), followed by `more`, which
/// starts with a comma or is empty.
[[nodiscard]] std::string selectAssignments(std::string_view more = {});

/// Returns the condition that the assignment `alias` is not withdrawn.
[[nodiscard]] std::string isAskedFor(std::string_view alias);

/// Reads the columns of selectAssignments().
[[nodiscard]] Assignment readAssignment(RowReader& row);

/// Reads the rows of a sheet, by code: of a draft or of a sealed mark. Throws DbError.
[[nodiscard]] std::vector<SheetRow> draftRows(Connection& connection, const AssignmentId& assignmentId);
[[nodiscard]] std::vector<SheetRow> markRows(Connection& connection, const MarkId& markId);

}  // namespace torsio
