// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QMetaType>
#include <QString>

#include "app/services/access/operation.h"

namespace torsio::gui {

/// All pages, in the order of the navigation.
enum class PageId {
  // Trainee and free practice.
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
  // Physician.
  kQueue,
  kRaterCalibration,
  kLiveSheet,
  kDiscrepancyReview,
  kSeverity,
  kEvaluation,
  kCase,
  // Administrator.
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

/// Static properties of a page.
struct PageFacts {
  PageId id;
  const char* text;   ///< "station.next": object name of the page, also used by tests and messages
  const char* icon;   ///< of assets/icons; "": only reached through other pages
  const char* title;  ///< English; translated by pageTitle()
  Operation needs;
  std::optional<Operation> alsoNeeds = std::nullopt;
  bool needsDatabase = true;  ///< false: available without the database
};

/// Looks a page up in the table of pages. Thread-safe.
[[nodiscard]] const PageFacts& factsOf(PageId id) noexcept;
/// Returns a page's title in the window's language. GUI thread.
[[nodiscard]] QString pageTitle(PageId id);
/// Returns a page's id for messages, tests and findChild(): "station.next". Thread-safe.
[[nodiscard]] QString pageText(PageId id);

}  // namespace torsio::gui

Q_DECLARE_METATYPE(torsio::gui::PageId)
