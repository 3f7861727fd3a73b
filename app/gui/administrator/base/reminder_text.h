// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QLocale>
#include <QString>

#include "app/services/study/open_sheets.h"
#include "assessment/domain/ids.h"

namespace torsio::gui {

class ShellContext;

/// Returns plain text for messages, one line per rater: name, cases, waiting since. No trainee, no stage.
[[nodiscard]] QString reminderText(const std::vector<Reminder>& owed, const QLocale& locale);

/// Copies the reminders of a cohort to the clipboard, records it in the audit trail and notifies the user.
/// GUI thread. Throws Error.
void copyReminders(ShellContext& shell, const CohortId& cohortId, const QLocale& locale);

}  // namespace torsio::gui
