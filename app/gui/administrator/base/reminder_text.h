// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QLocale>
#include <QString>

#include "app/services/study/reminders.h"
#include "assessment/domain/ids.h"

namespace torsio::gui {

class ShellContext;

/// Plain text to paste into messages, a rater a line: whom, which cases, since when. No trainee, no stage.
[[nodiscard]] QString reminderText(const std::vector<Reminder>& owed, const QLocale& locale);

/// Puts that text of a cohort on the clipboard, notes it in the audit trail and says so. GUI thread. Throws
/// Error.
void copyReminders(ShellContext& shell, const CohortId& cohortId, const QLocale& locale);

}  // namespace torsio::gui
