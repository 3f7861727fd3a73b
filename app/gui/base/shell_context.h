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

#include "app/gui/base/page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "sim/core/error.h"

namespace torsio {
class StationWriter;
}

namespace torsio::gui {

/// Thrown by a job's progress callback after the user pressed Cancel; jobs must not catch it.
struct Cancelled {};

/// A change of this station's record for everybody: replaced by a backup, or moved elsewhere.
struct RecordChange {
  std::function<void()> swap{};  ///< called while the record is closed; if it throws, nothing has changed
  QString locator{};             ///< new location; empty: unchanged
  QString sentence{};            ///< shown at the following sign-in
};

/// Services of the shell for its pages. GUI thread.
class ShellContext : public QObject {
  Q_OBJECT

 public:
  /// `session` must outlive the context.
  ShellContext(SessionContext& session, std::filesystem::path assets, ThemeKind theme);
  ~ShellContext() override;

  [[nodiscard]] SessionContext& session() const noexcept {
    session_.beginCall();
    return session_;
  }
  [[nodiscard]] const std::filesystem::path& assets() const noexcept { return assets_; }
  [[nodiscard]] ThemeKind themeKind() const noexcept { return theme_; }
  void setThemeKind(ThemeKind kind);

  /// Whether the actor had this right when rights were last read, to show and enable controls; of a moved
  /// record only what adds nothing. Does not access the database, services check again. A guest may practise.
  [[nodiscard]] bool may(Operation operation);
  /// Reads the actor's rights: at sign-in, and to be called after roles may have changed. Throws DbError.
  void readRights();

  /// Writer for data that nobody waits for (heartbeats, training time); null: the session writes immediately.
  /// Must outlive the context.
  [[nodiscard]] StationWriter* line() const noexcept { return line_; }
  void setLine(StationWriter* line) noexcept { line_ = line; }
  /// Returns whether the database is known to be away; then the GUI thread must not access it.
  [[nodiscard]] bool databaseAway() const;

  /// Opens another page and passes `argument` to its enter().
  void open(PageId id, const QVariant& argument = {}) { Q_EMIT pageWanted(id, argument); }
  /// Shows a short notification at the lower edge.
  void notify(const QString& sentence) { Q_EMIT noticed(sentence); }
  /// Tells the user in plain words what went wrong and what to do, with folded details. Call it in a catch
  /// block.
  void report(const std::exception_ptr& thrown);
  /// Shows a problem without an exception.
  void tell(const Problem& problem);

  /// Runs a long job in the background on its own connection for the same actor; jobs run one after another.
  /// Shows title, progress, remaining time and a cancel button. `work(session, progress)` reports progress,
  /// which throws Cancelled after the user has cancelled, so that the job unwinds and leaves no half-written
  /// file. `then(result)` receives the result, moved, in the GUI thread. `refused(error)` receives an Error
  /// instead of the usual message; it may return false to show that message after all. If `owner` has been
  /// destroyed by then, neither is called, and errors are shown as usual. `owner` is the object that both
  /// use.
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
  /// Closes desk and record, carries out the change, and returns to sign-in. The calling page is destroyed
  /// soon after.
  void changeRecord(const RecordChange& change) { Q_EMIT recordChangeWanted(change); }
  /// Waits for all jobs, for tests and at exit.
  void waitForJobs();
  /// Cancels all jobs started so far.
  void cancelJobs() noexcept { cancelledUpTo_.store(started_); }

 Q_SIGNALS:
  void pageWanted(torsio::gui::PageId id, const QVariant& argument);
  void noticed(const QString& sentence);
  void problemMet(const torsio::gui::Problem& problem);
  /// Emitted with problemMet, in the present language.
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
  std::optional<std::string> rightsOf_;  ///< user id whose rights were read
  StationWriter* line_ = nullptr;
  QThreadPool workers_;
  int jobs_ = 0;
  std::uint64_t started_ = 0;
  std::atomic<std::uint64_t> cancelledUpTo_{0};
};

/// Runs a user's action and reports exceptions in plain words; shows `cancelled` on Cancelled (empty: nothing
/// was changed). Returns true on success. The only place where pages catch. GUI thread.
bool attempt(ShellContext& shell, const std::function<void()>& action, const QString& cancelled = {});

}  // namespace torsio::gui
