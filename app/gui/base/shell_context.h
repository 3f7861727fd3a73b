// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QThreadPool>
#include <QVariant>

#include "app/gui/base/page_id.h"
#include "app/gui/base/problem.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "sim/core/error.h"

namespace torsio {
class StationWriter;
}

namespace torsio::gui {

/// Thrown by a job's progress callback after the user pressed Cancel; jobs let it pass.
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

  /// Runs work that takes time off the GUI thread, on a connection of its own for the same actor; one job
  /// after another. Title and progress are shown with the time left and a cancel button. `work(session,
  /// progress)` reports progress, which throws Cancelled once the user gives up, so that the work unwinds and
  /// leaves no half-written file. `then(result)` gets its result, by move, in the GUI thread.
  /// `refused(error)` gets an Error instead of the message that otherwise tells the user; it may return false
  /// to leave the error to that message after all. When `owner` is gone by then, neither is called, and
  /// errors are told as usual. `owner` is the object that both touch.
  template <typename Work, typename Then>
  void run(QObject* owner, const QString& title, Work work, Then then) {
    run(owner, title, std::move(work), std::move(then), [](const Error&) { return false; });
  }
  template <typename Work, typename Then, typename Refused>
  void run(QObject* owner, const QString& title, Work work, Then then, Refused refused) {
    using Result = std::invoke_result_t<Work&, SessionContext&, const ProgressCallback&>;
    Job job{.owner = owner, .title = title};
    if constexpr (std::is_void_v<Result>) {
      job.work = std::move(work);
      job.then = std::move(then);
    } else {
      const auto result = std::make_shared<std::optional<Result>>();
      job.work = [work = std::move(work), result](SessionContext& session,
                                                  const ProgressCallback& progress) mutable {
        result->emplace(work(session, progress));
      };
      job.then = [then = std::move(then), result]() mutable { then(std::move(**result)); };
    }
    if constexpr (std::is_void_v<std::invoke_result_t<Refused&, const Error&>>) {
      job.refused = [refused = std::move(refused)](const Error& error) mutable {
        refused(error);
        return true;
      };
    } else {
      job.refused = std::move(refused);
    }
    start(std::move(job));
  }
  [[nodiscard]] bool working() const noexcept { return jobs_ > 0; }
  /// Closes the desk and the record, carries out the change, and goes back to sign-in. The calling page dies
  /// soon after.
  void changeRecord(const RecordChange& change) { Q_EMIT recordChangeWanted(change); }
  /// Waits for all jobs: tests, and the end of the program.
  void waitForJobs();
  /// Cancels the jobs that were started until now.
  void cancelJobs() noexcept { cancelledUpTo_.store(started_); }

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
  struct Job {
    QPointer<QObject> owner{};
    QString title{};
    std::function<void(SessionContext&, const ProgressCallback&)> work{};
    std::function<void()> then{};
    std::function<bool(const Error&)> refused{};
  };
  void start(Job job);
  void finish(const Job& job, const std::exception_ptr& problem);

  SessionContext& session_;
  std::filesystem::path assets_;
  ThemeKind theme_;
  std::set<Operation> rights_;
  std::optional<std::string> rightsOf_;  ///< user id
  StationWriter* line_ = nullptr;
  QThreadPool workers_;
  int jobs_ = 0;
  std::uint64_t started_ = 0;
  std::atomic<std::uint64_t> cancelledUpTo_{0};
};

/// Does something the user asked for, once: what it throws is reported in plain words, Cancelled is answered
/// with `cancelled` (empty: nothing was changed). True when it went well. Pages catch here and nowhere else.
/// GUI thread.
bool attempt(ShellContext& shell, const std::function<void()>& action, const QString& cancelled = {});

}  // namespace torsio::gui
