// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include "app/services/study/curriculum_service.h"

namespace torsio::gui {

/// Returns the status line of a draft: when it was saved, its next version number, the latest published
/// version. `changed`: it has unsaved edits.
[[nodiscard]] QString draftText(const CurriculumRow& row, bool changed, const QLocale& locale);
/// Returns the status line of a published version: date, state, cohorts that follow it, version that
/// superseded it.
[[nodiscard]] QString versionText(const CurriculumRow& row, const CurriculumVersionRow& version,
                                  const QLocale& locale);

}  // namespace torsio::gui
