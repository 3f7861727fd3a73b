// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/settling.h"

#include <utility>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/open_record.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/interrupted_move.h"
#include "app/services/recording/station_start.h"

namespace torsio::gui {

Settling::Settling(Background& background, const OpenRecord& record, const ShellSetup& setup, QObject* parent)
    : QObject(parent), background_(background), record_(record), setup_(setup) {}

std::filesystem::path Settling::folder() const {
  return setup_.unstored.empty() ? unstoredFolder() : setup_.unstored;
}

void Settling::begin() {
  struct Done {
    std::vector<Text> closed{};
    std::vector<Text> kept{};
  };
  background_.run(
      [first = !std::exchange(filesClosed_, true), key = record_.key(), folder = folder()] {
        Done done;
        sweepLeftovers(key.locator);
        if (first) {
          done.closed = closeRecordFiles(key.locator, folder);
        }
        SessionContext own(key);
        if (first) {
          const std::vector<Text> copies = closeKnownCopies(own.connectionWithoutRight());
          done.closed.insert(done.closed.end(), copies.begin(), copies.end());
        }
        done.kept = settleStation(own, folder).kept;
        if (Text moved = settleMove(own); !moved.empty()) {
          done.closed.push_back(std::move(moved));
        }
        return done;
      },
      [this](Done done) {
        kept_ = std::move(done.kept);
        Q_EMIT ended(translatedLines(kept_.empty() ? done.closed : kept_), !kept_.empty());
      },
      [this](const std::exception_ptr& problem) { Q_EMIT ended(problemSentence(problem), true); });
}

void Settling::again() {
  if (background_.working()) {
    return;
  }
  Q_EMIT dueChanged(false);
  background_.run(
      record_.key(),
      [folder = folder()](SessionContext& own) { return !settleStation(own, folder).trials.empty(); },
      [this](bool any) {
        if (any) {
          Q_EMIT stored();
        }
      },
      [this](const std::exception_ptr&) { Q_EMIT dueChanged(true); });
}

void Settling::tellKept(ShellContext& shell) {
  if (kept_.empty() || shell.session().actor().practiceOnly) {
    return;
  }
  shell.tell([kept = std::exchange(kept_, {})] {
    return TranslatedError{
        tr("%n recording(s) of this station could not be stored", nullptr, static_cast<int>(kept.size())),
        tr("The files are kept. Please show this to your administrator"), translatedLines(kept)};
  });
}

}  // namespace torsio::gui
