// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QLocale>
#include <QString>

#include "app/study/reminders.h"

namespace torsio::gui {

/// Plain text to paste into messages, a rater a line: whom, which cases, since when. No trainee, no stage.
[[nodiscard]] QString reminderText(const std::vector<Reminder>& owed, const QLocale& locale);

}  // namespace torsio::gui
