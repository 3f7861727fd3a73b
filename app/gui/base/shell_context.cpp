// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/shell_context.h"

#include <utility>

#include <QCoreApplication>
#include <QElapsedTimer>

#include "app/gui/base/translated_text.h"
#include "app/services/access/database_away.h"
#include "app/services/access/move_notice.h"
#include "app/services/recording/station_writer.h"

namespace torsio::gui {

namespace {

/// Estimates the remaining time, s, at the average rate so far; negative (unknown) at first.
double estimatedRemaining_s(double elapsed_s, double fraction) {
  constexpr double kSomething = 0.05;
  constexpr double kLongEnough_s = 2.0;
  if (fraction < kSomething || fraction > 1.0 || elapsed_s < kLongEnough_s) {
    return -1.0;
  }
  return elapsed_s * (1.0 - fraction) / fraction;
}

}  // namespace

ShellContext::ShellContext(SessionContext& session, std::filesystem::path assets, ThemeKind theme)
    : session_(session), assets_(std::move(assets)), theme_(theme) {
  workers_.setMaxThreadCount(1);  // one long job at a time: they share disk and database
}

ShellContext::~ShellContext() {
  cancelJobs();
  workers_.waitForDone();
}

bool ShellContext::may(Operation operation) {
  if (rightsOf_ != session_.actor().userId) {
    readRights();
  }
  return rights_.contains(operation);
}

void ShellContext::readRights() {
  const Actor& actor = session_.actor();
  const bool living = moveNotice(session_.connectionWithoutRight()).empty();
  std::set<Operation> rights;
  // A guest has no account and may only practise.
  if (actor.practiceOnly && actor.userId.empty()) {
    rights.insert(Operation::kPractice);
  }
  for (std::size_t i = 0; i < kOperationCodes.size(); ++i) {
    const auto operation = static_cast<Operation>(i);
    if (session_.may(operation) && (living || !addsToTheRecord(operation))) {
      rights.insert(operation);
    }
  }
  rights_ = std::move(rights);
  rightsOf_ = actor.userId;
}

bool ShellContext::databaseAway() const {
  return line_ != nullptr && !line_->answers();
}

void ShellContext::setThemeKind(ThemeKind kind) {
  theme_ = kind;
  Q_EMIT themeChanged(kind);
}

void ShellContext::report(const std::exception_ptr& thrown) {
  setProperty("toldAway", saysDatabaseAway(thrown));  // dismissed automatically when the database is back
  tell(problemOf(thrown, {[] { return tr("Something unexpected happened"); },
                          [] { return tr("Nothing was lost; please try again"); }}));
}

void ShellContext::tell(const Problem& problem) {
  Q_EMIT problemMet(problem);
  const TranslatedError said = problem();
  Q_EMIT failed(said.happened, said.remedy, said.details);
}

void ShellContext::start(Job job) {
  ++jobs_;
  const std::uint64_t number = ++started_;
  Q_EMIT jobStarted(job.title);
  workers_.start([this, number, key = session_.key(), job = std::move(job)]() mutable {
    std::exception_ptr problem;
    try {
      const auto passOn = [this, number] {
        if (number <= cancelledUpTo_.load()) {
          throw Cancelled{};
        }
      };
      passOn();
      SessionContext own(key);
      QElapsedTimer since;
      since.start();
      job.work(own, [this, since, passOn](const Progress& progress) {
        passOn();
        const double left_s =
            progress.remaining_s >= 0.0
                ? progress.remaining_s
                : estimatedRemaining_s(static_cast<double>(since.elapsed()) / 1000.0, progress.fraction);
        QMetaObject::invokeMethod(this, [this, progress, left_s] {
          Q_EMIT jobMoved(toQString(progress.step), progress.fraction, left_s);
        });
      });
    } catch (...) {
      problem = std::current_exception();
    }
    QMetaObject::invokeMethod(this, [this, job = std::move(job), problem] { finish(job, problem); });
  });
}

void ShellContext::finish(const Job& job, const std::exception_ptr& problem) {
  --jobs_;
  Q_EMIT jobEnded();
  attempt(*this, [&] {
    try {
      if (problem) {
        std::rethrow_exception(problem);
      }
    } catch (const Error& error) {
      if (job.owner && job.refused(error)) {
        return;
      }
      throw;
    }
    if (job.owner) {
      job.then();
    }
  });
}

void ShellContext::waitForJobs() {
  while (jobs_ > 0) {
    workers_.waitForDone(10);
    QCoreApplication::processEvents();
  }
}

bool attempt(ShellContext& shell, const std::function<void()>& action, const QString& cancelled) {
  try {
    action();
    return true;
  } catch (const Cancelled&) {
    shell.notify(cancelled.isEmpty() ? ShellContext::tr("Cancelled; nothing was changed") : cancelled);
  } catch (...) {
    shell.report(std::current_exception());
  }
  return false;
}

}  // namespace torsio::gui
