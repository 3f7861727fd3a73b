// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QVariant>

#include "app/gui/base/page_id.h"
#include "app/gui/base/problem.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"

namespace torsio {
class StationWriter;
}

namespace torsio::gui {

/// Thrown by a job's own progress call after the user pressed cancel; jobs let it pass.
struct Cancelled {};

/// The record of this station changes under everybody: it is replaced by a backup, or lies elsewhere from now
/// on.
struct RecordChange {
  std::function<void()> swap{};  ///< while nobody has the record open; may throw, then nothing has changed
  QString locator{};             ///< from now on; empty: as before
  QString sentence{};            ///< said at the sign-in that follows
};

/// What pages need from round them. GUI thread.
class ShellContext : public QObject {
  Q_OBJECT

 public:
  /// `session` outlives the context.
  ShellContext(SessionContext& session, std::filesystem::path assets, ThemeKind theme);
  ~ShellContext() override;

  [[nodiscard]] SessionContext& session() const noexcept {
    session_.beginCall();
    return session_;
  }
  [[nodiscard]] const std::filesystem::path& assets() const noexcept { return assets_; }
  [[nodiscard]] ThemeKind themeKind() const noexcept { return theme_; }
  void setThemeKind(ThemeKind kind);

  /// Whether the actor may do this, as far as was known when the rights were last read: for what is shown and
  /// enabled. Asks no database; the services ask anew and have the last word. A guest may practise.
  [[nodiscard]] bool may(Operation operation);
  /// Reads the actor's rights: done when somebody signs in; call it where roles may have changed. Throws
  /// DbError.
  void readRights();

  /// For what nobody waits for (heartbeats, training time); null: the session writes at once. It
  /// outlives the context.
  [[nodiscard]] StationWriter* line() const noexcept { return line_; }
  void setLine(StationWriter* line) noexcept { line_ = line; }
  /// Whether the database is known to be away: then the GUI thread must not ask it anything.
  [[nodiscard]] bool databaseAway() const;

  /// Goes to another page, which enters with `argument`.
  void open(PageId id, const QVariant& argument = {}) { Q_EMIT pageWanted(id, argument); }
  /// A sentence that passes by at the lower edge.
  void notify(const QString& sentence) { Q_EMIT noticed(sentence); }
  /// Says in plain words what went wrong, what to do, details folded. Call it in a catch block.
  void report(const std::exception_ptr& thrown);
  /// Shows a problem that no exception reports.
  void tell(const Problem& problem);

  /// Work that takes time, off the GUI thread, on a connection of its own for the same actor. `work` gets
  /// a session and a callback that it calls with its progress (which throws Cancelled when the user gave
  /// up, so that work unwinds and leaves no half file); `done` runs in the GUI thread after success. Title
  /// and progress are shown with time left and a cancel button. Failures are reported.
  using Work = std::function<void(SessionContext&, const ProgressCallback&)>;
  void run(const QString& title, Work work, std::function<void()> done);
  [[nodiscard]] bool working() const noexcept { return jobs_ > 0; }
  /// Closes the desk and the record, carries out the change, and goes back to sign-in. The calling page dies
  /// soon after.
  void changeRecord(const RecordChange& change) { Q_EMIT recordChangeWanted(change); }
  /// Waits for all jobs: tests, and the end of the program.
  void waitForJobs();
  void cancelJobs() noexcept { cancelled_.store(true); }

 Q_SIGNALS:
  void pageWanted(torsio::gui::PageId id, const QVariant& argument);
  void noticed(const QString& sentence);
  void problemMet(const torsio::gui::Problem& problem);
  /// Sent with problemMet, in the present language.
  void failed(const QString& happened, const QString& remedy, const QString& details);
  void themeChanged(ThemeKind kind);
  void recordChangeWanted(const torsio::gui::RecordChange& change);
  void jobStarted(const QString& title);
  void jobMoved(const QString& step, double fraction, double remaining_s);
  void jobEnded();

 private:
  SessionContext& session_;
  std::filesystem::path assets_;
  ThemeKind theme_;
  std::set<Operation> rights_;
  std::optional<std::string> rightsOf_;  ///< user id
  StationWriter* line_ = nullptr;
  QThreadPool workers_;
  int jobs_ = 0;
  std::atomic<bool> cancelled_{false};
};

/// Does something the user asked for, once: what it throws is reported in plain words, Cancelled is answered
/// with `cancelled` (empty: nothing was changed). True when it went well. Pages catch here and nowhere else.
/// GUI thread.
bool attempt(ShellContext& shell, const std::function<void()>& action, const QString& cancelled = {});

}  // namespace torsio::gui
