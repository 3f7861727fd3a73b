// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/founding.h"

#include <optional>
#include <utility>

#include <QUrl>

#include "app/gui/base/job_panel.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/services/demonstration/demonstration_people.h"

namespace torsio::gui {

Founding::Founding(Background& background, OpenRecord& record, const ShellSetup& setup, QWidget* window)
    : QObject(window),
      background_(background),
      record_(record),
      setup_(setup),
      panel_(new FirstRunPanel(setup.locator, setup.recordSetBy, window)) {
  connect(panel_, &FirstRunPanel::chosen, this, &Founding::begin);
  connect(&panel_->job(), &JobPanel::cancelled, this, [this] { cancelled_.store(true); });
}

void Founding::begin(const FirstRunChoice& choice) {
  if (!QUrl(choice.locator).password().isEmpty()) {
    panel_->say(tr(
        "Leave the password out of the address; it would be stored in a settings file. Put it into .pgpass"));
    return;
  }
  record_.close();
  record_.setLocator(choice.locator);
  cancelled_.store(false);
  panel_->job().begin(tr("Setting up the centre"));
  struct Founded {
    Actor founder{};
    std::vector<StartAccount> accounts{};
  };
  background_.run(
      record_.key(),
      [this, first = choice.first](SessionContext& own) -> std::optional<Founded> {
        own.setPasswordCost(setup_.passwordCost);
        if (!needsFirstRun(own.connectionWithoutRight())) {
          return std::nullopt;
        }
        std::vector<StartAccount> accounts =
            performFirstRun(own, first, [this](SessionContext& session) { return addPeople(session); });
        return Founded{own.actor(), std::move(accounts)};
      },
      [this, choice](const std::optional<Founded>& made) {
        panel_->job().end();
        if (!made) {  // a centre exists already: its people sign in
          Q_EMIT foundThere(choice.locator);
          return;
        }
        record_.open();
        record_.session()->setActor(made->founder);
        Q_EMIT founded(choice, made->accounts);
      },
      [this](const std::exception_ptr& problem) {
        panel_->job().end();
        Q_EMIT failed();
        try {
          std::rethrow_exception(problem);
        } catch (const Cancelled&) {
          panel_->say(tr("Cancelled; nothing was set up"));
        } catch (...) {
          panel_->say(problemSentence(problem));
        }
      });
}

std::vector<StartAccount> Founding::addPeople(SessionContext& session) {
  const ProgressCallback told = [this](const Progress& progress) {
    if (cancelled_.load()) {
      throw Cancelled{};
    }
    QMetaObject::invokeMethod(this, [this, progress] {
      panel_->job().move(toQString(Text(progress.step)), progress.fraction, progress.remaining_s);
    });
  };
  return setup_.simulatedPeople ? setup_.simulatedPeople(session, told)
                                : addDemonstration(session, setup_.assets, told);
}

}  // namespace torsio::gui
