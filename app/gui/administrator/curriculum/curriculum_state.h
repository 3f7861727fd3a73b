// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include "app/services/study/curriculum_service.h"

namespace torsio::gui {

/// Says what a draft is: saved when, to become which version, after which newest one. `changed`: it has been
/// edited and is not saved.
[[nodiscard]] QString draftText(const CurriculumRow& row, bool changed, const QLocale& locale);
/// Says what a published version is: since when, in which state, followed by whom, superseded by which.
[[nodiscard]] QString versionText(const CurriculumRow& row, const CurriculumVersionRow& version,
                                  const QLocale& locale);

}  // namespace torsio::gui
