// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QMetaType>
#include <QString>

#include "app/services/access/operation.h"

namespace torsio::gui {

/// Every page of the program, in the order of the navigation.
enum class PageId {
  // The trainee, and free practice.
  kNextStep,
  kDebrief,
  kTrend,
  kRemarks,
  kTranscript,
  kDeviceCheck,
  kConsent,
  kBriefing,
  kRun,
  kPractice,
  kCompare,
  // The physician.
  kQueue,
  kRaterCalibration,
  kLiveSheet,
  kDiscrepancyReview,
  kSeverity,
  kEvaluation,
  kCase,
  // The administrator.
  kTodaysSessions,
  kRoster,
  kCurricula,
  kCohorts,
  kAllocation,
  kScoring,
  kCampaigns,
  kResults,
  kReports,
  kUsers,
  kAudit,
  kHeads,
  kMaintenance,
  kRestore,
  kMove,
  kDevices,
};

/// What the program knows of a page without making one.
struct PageFacts {
  PageId id;
  const char* text;   ///< "station.next": object name of the page, and how tests and messages name it
  const char* icon;   ///< of assets/icons; "": reached through other pages only
  const char* title;  ///< English; pageTitle() translates it
  Operation needs;
  std::optional<Operation> alsoNeeds = std::nullopt;
  bool needsDatabase = true;  ///< false: it can be opened while the database is away
};

/// Looks a page up in the one table of pages. Any thread.
[[nodiscard]] const PageFacts& factsOf(PageId id) noexcept;
/// Names a page in the language of the window. GUI thread.
[[nodiscard]] QString pageTitle(PageId id);
/// Names a page for messages, tests and findChild(): "station.next". Any thread.
[[nodiscard]] QString pageText(PageId id);

}  // namespace torsio::gui

Q_DECLARE_METATYPE(torsio::gui::PageId)
