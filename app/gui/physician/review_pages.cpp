// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/review_pages.h"

#include <QCoreApplication>

#include "app/gui/physician/alignment_page.h"
#include "app/gui/physician/case_page.h"
#include "app/gui/physician/evaluation_page.h"
#include "app/gui/physician/live_page.h"
#include "app/gui/physician/queue_page.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/review_words.h"
#include "app/gui/physician/severity_page.h"
#include "app/gui/physician/warm_up_page.h"
#include "app/review/review_queue.h"

namespace torsio::gui {

namespace {

QString title(const char* text) {
  return QCoreApplication::translate("torsio::gui::ReviewPages", text);
}

template <class T>
std::function<Page*(ShellContext&)> maker() {
  return [](ShellContext& shell) -> Page* { return new T(shell); };
}

/// The case that "continue" would open.
QVariant nextCase(Workplace& workplace) {
  const auto next = reviewQueue(workplace).next;
  return next ? QVariant(words(*next)) : QVariant();
}

constexpr double kPictureAt = 0.6;  // of the recording: something happens there

/// Waits for the recording and shows a moment of it.
void showMoment(ReplayPanel& replay) {
  if (replay.ready())
    replay.seek_us(static_cast<std::int64_t>(
        kPictureAt * static_cast<double>(replay.recording()->playback.duration_us())));
}

}  // namespace

std::vector<PageEntry> reviewPages() {
  const std::vector<Operation> score{Operation::kMarkSubmit};
  return {
      {"review.queue", "open", [] { return title(QT_TRANSLATE_NOOP("torsio::gui::ReviewPages", "Queue")); },
       score, maker<QueuePage>()},
      {"review.warmup",
       "practice",
       [] { return title(QT_TRANSLATE_NOOP("torsio::gui::ReviewPages", "Warm-up")); },
       {Operation::kMarkSubmit, Operation::kTrialViewAssigned},
       maker<WarmUpPage>()},
      {"review.live", "record",
       [] { return title(QT_TRANSLATE_NOOP("torsio::gui::ReviewPages", "Live sheet")); }, score,
       maker<LivePage>()},
      {"review.alignment", "compare",
       [] { return title(QT_TRANSLATE_NOOP("torsio::gui::ReviewPages", "Alignment")); }, score,
       maker<AlignmentPage>()},
      {"review.severity", "user",
       [] { return title(QT_TRANSLATE_NOOP("torsio::gui::ReviewPages", "My severity")); }, score,
       maker<SeverityPage>()},
      {"review.evaluation",
       "check",
       [] { return title(QT_TRANSLATE_NOOP("torsio::gui::ReviewPages", "Evaluation")); },
       {Operation::kMarkSubmit, Operation::kEvaluationSubmit},
       maker<EvaluationPage>()},
      {"review.case",
       "",
       [] { return title(QT_TRANSLATE_NOOP("torsio::gui::ReviewPages", "Case")); },
       {Operation::kMarkSubmit, Operation::kTrialViewAssigned},
       maker<CasePage>()},
  };
}

std::vector<ScreenEntry> reviewScreens() {
  return {
      {"review-queue", "rater", "review.queue", {}, {}},
      {"review-case", "rater", "review.case", nextCase,
       [](Page& page) { showMoment(static_cast<CasePage&>(page).replay()); }},
      {"review-warmup",
       "rater",
       "review.warmup",
       {},
       [](Page& page) { showMoment(static_cast<WarmUpPage&>(page).replay()); }},
      {"review-live", "rater", "review.live", {}, {}},
      {"review-alignment", "rater", "review.alignment", {}, {}},
      {"review-severity", "rater", "review.severity", {}, {}},
      {"review-evaluation", "rater", "review.evaluation", {}, {}},
  };
}

}  // namespace torsio::gui
