// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <QEvent>
#include <QMetaType>
#include <QString>
#include <QVariant>
#include <QWidget>

#include "app/services/access/operation.h"

namespace torsio {
class SessionContext;
}

namespace torsio::gui {

class ShellContext;
struct Theme;

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

/// A page of the navigation, such as a trainee's "Next step", a physician's "Queue", the administrator's
/// "Roster". Pages contain no logic: they show what the services provide, through ShellContext::session().
/// retranslate() sets the texts, applyTheme() the colours outside the style sheet; both are called after
/// construction and on each change of language or theme.
class Page : public QWidget {
  Q_OBJECT

 public:
  /// Lists on the page store their columns by role: the property "role" names the page's role.
  explicit Page(ShellContext& shell, QWidget* parent = nullptr);

  /// Called whenever the page is shown: rereads its content. `argument`: from ShellContext::open().
  virtual void enter(const QVariant& argument) { static_cast<void>(argument); }
  /// Called before the page is left or closed. False: something must be finished first (the page has told the
  /// user).
  [[nodiscard]] virtual bool leave() { return true; }
  /// True during a scored run: no idle lock, sign-out or change of page.
  [[nodiscard]] virtual bool busy() const { return false; }
  /// Returns keys that are not shortcuts of a menu or button, for the help on F1: key and effect.
  [[nodiscard]] virtual std::vector<std::pair<QString, QString>> keys() const { return {}; }
  virtual void retranslate() = 0;
  virtual void applyTheme(const Theme& theme) { static_cast<void>(theme); }

 protected:
  [[nodiscard]] ShellContext& shell() const noexcept { return shell_; }
  void changeEvent(QEvent* event) override;

 private:
  ShellContext& shell_;
};

/// How the shell creates a page; everything else about it is in its PageFacts.
struct PageEntry {
  PageId id;
  std::function<Page*(ShellContext&)> make;
};

/// A screenshot for the user guide: a page in a meaningful state, with the demonstration cohort.
struct ScreenEntry {
  QString name;  ///< file name without language, theme, size and extension: "station-debrief"
  QString role;  ///< "trainee", "rater", "administrator": role signed in
  PageId pageId;
  std::function<QVariant(SessionContext&)> argument;  ///< argument of Page::enter; may be empty
  std::function<void(Page&)> prepare;                 ///< called after enter(); may be empty
};

/// Sent to the current page when the database answers again after an outage, so that it retries what it could
/// not read or store.
[[nodiscard]] inline QEvent::Type databaseAnsweredEvent() {
  static const auto kType = static_cast<QEvent::Type>(QEvent::registerEventType());
  return kType;
}

}  // namespace torsio::gui

Q_DECLARE_METATYPE(torsio::gui::PageId)
