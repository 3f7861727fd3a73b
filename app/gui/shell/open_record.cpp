// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/open_record.h"

#include <iostream>

#include <QGuiApplication>

#include "app/connectors/built_in.h"
#include "app/connectors/xapi/lrs_delivery.h"
#include "app/services/access/access_service.h"
#include "assessment/domain/people/account.h"
#include "sim/core/error.h"

namespace torsio::gui {

SessionKey OpenRecord::key() const {
  SessionKey key;
  key.locator = locator_.toStdString();
  key.station = setup_.station;
  return key;
}

void OpenRecord::open() {
  session_ = std::make_unique<SessionContext>(key());
  session_->setPasswordCost(setup_.passwordCost);
}

void OpenRecord::startLine() {
  line_ = std::make_unique<StationWriter>(key(), setup_.linePatience);
  if constexpr (kXapiBuiltIn) {
    lessons_ = std::make_shared<LrsWorker>(key(), setup_.lessonsAgain);
  }
}

void OpenRecord::stopLine() {
  line_.reset();
  lessons_.reset();
}

void OpenRecord::leave() {
  if (line_) {
    line_->leave();
  }
  stopLine();
}

void OpenRecord::close() {
  leave();
  session_.reset();
}

std::optional<LeftHead> OpenRecord::signOut() {
  if (!session_ || session_->actor().userId.empty()) {
    return std::nullopt;
  }
  const bool administrator = session_->actor().hasRole("administrator");
  const bool away = line_ && !line_->answers();
  try {
    if (away) {
      line_->write([](SessionContext& own) { torsio::signOut(own); });
      session_->setActor({});
    } else {
      torsio::signOut(*session_);
    }
  } catch (...) {
    session_->setActor({});  // the audit trail cannot be written; that must not keep anybody signed in
    return std::nullopt;
  }
  if (!administrator) {
    return std::nullopt;
  }
  if (away) {
    return LeftHead{.trouble = Text::tr("The database does not answer")};
  }
  try {
    return headOnLeaving(session_->connectionWithoutRight(), session_->now_us());
  } catch (const Error& error) {
    return LeftHead{.trouble = error.happenedText()};
  }
}

bool OpenRecord::reconnect() {
  try {
    session_->reconnect();
    return true;
  } catch (...) {
    return false;
  }
}

bool closesSilently(const LeftHead& head) {
  if (!head.witness.empty()) {
    std::cerr << "torsio: the head of the audit trail was added to " << head.witness.string() << ": "
              << head.line << "\n";
  }
  return head.trouble.empty() || qGuiApp->isSavingSession();  // a shutdown cannot wait
}

}  // namespace torsio::gui
