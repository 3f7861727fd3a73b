// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/review_pages.h"

#include <QCoreApplication>

#include "app/gui/physician/case_page.h"
#include "app/gui/physician/discrepancy_review_page.h"
#include "app/gui/physician/evaluation_page.h"
#include "app/gui/physician/live_page.h"
#include "app/gui/physician/queue_page.h"
#include "app/gui/physician/rater_calibration_page.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/physician/severity_page.h"
#include "app/gui/widgets/child.h"
#include "app/services/review/review_queue.h"

namespace torsio::gui {

namespace {

template <class T>
std::function<Page*(ShellContext&)> maker() {
  return [](ShellContext& shell) -> Page* { return new T(shell); };
}

/// Returns the case that "continue" would open.
QVariant nextCase(SessionContext& session) {
  const auto next = reviewQueue(session).next;
  return next ? QVariant(toQString(*next)) : QVariant();
}

constexpr double kPictureAt = 0.6;  // fraction of the recording with something to see

/// Waits for the recording and shows a moment of it.
void showMoment(ReplayPanel& replay) {
  if (replay.ready()) {
    replay.seek_us(static_cast<std::int64_t>(
        kPictureAt * static_cast<double>(replay.recording()->playback.duration_us())));
  }
}

}  // namespace

std::vector<PageEntry> reviewPages() {
  return {{PageId::kQueue, maker<QueuePage>()},
          {PageId::kRaterCalibration, maker<RaterCalibrationPage>()},
          {PageId::kLiveSheet, maker<LivePage>()},
          {PageId::kDiscrepancyReview, maker<DiscrepancyReviewPage>()},
          {PageId::kSeverity, maker<SeverityPage>()},
          {PageId::kEvaluation, maker<EvaluationPage>()},
          {PageId::kCase, maker<CasePage>()}};
}

std::vector<ScreenEntry> reviewScreens() {
  return {
      {"review-queue", "rater", PageId::kQueue, {}, {}},
      {"review-case", "rater", PageId::kCase, nextCase,
       [](Page& page) { showMoment(child<ReplayPanel>(static_cast<CasePage&>(page), "replay")); }},
      {"review-calibration",
       "rater",
       PageId::kRaterCalibration,
       {},
       [](Page& page) {
         showMoment(child<ReplayPanel>(static_cast<RaterCalibrationPage&>(page), "replay"));
       }},
      {"review-live", "rater", PageId::kLiveSheet, {}, {}},
      {"review-discrepancies", "rater", PageId::kDiscrepancyReview, {}, {}},
      {"review-severity", "rater", PageId::kSeverity, {}, {}},
      {"review-evaluation", "rater", PageId::kEvaluation, {}, {}},
  };
}

}  // namespace torsio::gui
