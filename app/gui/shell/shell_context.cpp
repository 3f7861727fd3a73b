// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/shell_context.h"

#include <memory>
#include <utility>

#include <QCoreApplication>

#include "app/session/care/station_line.h"
#include "sim/base/error.h"

namespace torsio::gui {

ShellContext::ShellContext(Workplace& workplace, std::filesystem::path assets, ThemeKind theme)
    : workplace_(workplace), assets_(std::move(assets)), theme_(theme) {
  workers_.setMaxThreadCount(1);  // one long job after another: they share disk and database
}

ShellContext::~ShellContext() {
  cancelled_.store(true);
  workers_.waitForDone();
}

bool ShellContext::databaseAway() const {
  return line_ != nullptr && !line_->answers();
}

void ShellContext::setThemeKind(ThemeKind kind) {
  theme_ = kind;
  Q_EMIT themeChanged(kind);
}

void ShellContext::report(const std::exception_ptr& problem) {
  try {
    std::rethrow_exception(problem);
  } catch (const Error& error) {
    Q_EMIT failed(QString::fromStdString(error.happened()), QString::fromStdString(error.remedy()),
                  QString::fromStdString(error.where()));
  } catch (const std::exception& error) {
    Q_EMIT failed(tr("Something unexpected happened"), tr("Nothing was lost; please try again"),
                  QString::fromLocal8Bit(error.what()));
  }
}

void ShellContext::run(const QString& title, Work work, std::function<void()> done) {
  ++jobs_;
  cancelled_.store(false);
  Q_EMIT jobStarted(title);
  const auto finish = [this](const std::exception_ptr& problem, const std::function<void()>& success) {
    --jobs_;
    Q_EMIT jobEnded();
    if (problem) {
      try {
        std::rethrow_exception(problem);
      } catch (const Cancelled&) {
        notify(tr("Cancelled; nothing was changed"));
      } catch (...) {
        report(std::current_exception());
      }
    } else if (success) {
      success();
    }
  };
  workers_.start([this, key = workplace_.key(), work = std::move(work), done = std::move(done), finish] {
    std::exception_ptr problem;
    try {
      Workplace own(key);
      work(own, [this](const Progress& progress) {
        if (cancelled_.load()) throw Cancelled{};
        QMetaObject::invokeMethod(this, [this, progress] {
          Q_EMIT jobMoved(QString::fromStdString(progress.step), progress.fraction, progress.remaining_s);
        });
      });
    } catch (...) {
      problem = std::current_exception();
    }
    QMetaObject::invokeMethod(this, [finish, problem, done] { finish(problem, done); });
  });
}

void ShellContext::waitForJobs() {
  while (jobs_ > 0) {
    workers_.waitForDone(10);
    QCoreApplication::processEvents();
  }
}

}  // namespace torsio::gui
