// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/curriculum_state.h"

#include <QCoreApplication>
#include <QStringList>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"

namespace torsio::gui {

namespace {

struct CurriculumState {
  Q_DECLARE_TR_FUNCTIONS(CurriculumState)
};

}  // namespace

QString draftText(const CurriculumRow& row, bool changed, const QLocale& locale) {
  if (changed) {
    return CurriculumState::tr("%1: changed, not saved. The draft is also saved when you leave.")
        .arg(toQString(Text(row.curriculum.name)));
  }
  QString next = CurriculumState::tr(
                     "Everything may be changed; nobody is affected until it is published as version %1.")
                     .arg(row.versions.size() + 1);
  if (row.hasDraft) {
    next = CurriculumState::tr("Saved %1. %2").arg(shownTime(row.draftChangedUtc_us, locale), next);
  }
  if (row.versions.empty()) {
    return next;
  }
  const CurriculumVersionRow& newest = row.versions.back();
  return CurriculumState::tr("%1 The newest version is %2: %3.")
      .arg(next)
      .arg(newest.number)
      .arg(toQString(labelOf(newest.state)));
}

QString versionText(const CurriculumRow& row, const CurriculumVersionRow& version, const QLocale& locale) {
  QStringList followers;
  for (const std::string& cohort : version.cohorts) {
    followers << toQString(cohort);
  }
  const QString who =
      followers.isEmpty()
          ? CurriculumState::tr("No cohort follows it.")
          : CurriculumState::tr("Followed by: %1.").arg(followers.join(CurriculumState::tr(", ")));
  QString words;
  if (version.state == torsio::CurriculumState::kDraft) {
    words =
        CurriculumState::tr("Published on %1 and never changes. Begin it, so that cohorts can follow it.");
  } else if (version.state == torsio::CurriculumState::kRunning) {
    words = CurriculumState::tr(
        "Published on %1, running: cohorts can choose it. It never changes; to change anything, edit the "
        "draft and publish the next version.");
  } else {
    words = CurriculumState::tr(
        "Published on %1, closed: no further cohort can choose it; who follows it goes on. It is kept as "
        "it was.");
  }
  words = words.arg(shownTime(version.createdUtc_us, locale));
  if (!version.note.empty()) {
    words = joinedSentences({words, CurriculumState::tr("Note: %1.").arg(toQString(version.note))});
  }
  if (version.number < row.versions.back().number) {
    words = joinedSentences(
        {words, CurriculumState::tr("Superseded by version %1.").arg(row.versions.back().number)});
  }
  return joinedSentences({words, who});
}

}  // namespace torsio::gui
