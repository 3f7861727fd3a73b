// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/services/people/roster_import.h"
#include "sim/core/error.h"

namespace torsio::gui {

/// Names a field of a roster in the user's language.
[[nodiscard]] QString rosterFieldName(RosterField field);
/// Names what would happen to a line, with its sign: "+ new".
[[nodiscard]] QString rosterStatusName(RosterStatus status);
/// Says what the user should read about one line: its error, its changes, what is peculiar about it.
[[nodiscard]] QString rosterNote(const RosterRow& row);
/// Says in sentences what happened, and what may help.
[[nodiscard]] QString rosterProblem(const Error& error);

}  // namespace torsio::gui
