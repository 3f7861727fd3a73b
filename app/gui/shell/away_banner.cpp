// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/away_banner.h"

#include <utility>

#include <QEvent>

#include "app/services/recording/station_writer.h"

namespace torsio::gui {

AwayBanner::AwayBanner(std::function<bool()> reconnect, QWidget* parent)
    : QLabel(parent), reconnect_(std::move(reconnect)) {
  setObjectName(QStringLiteral("databaseAway"));
  setAccessibleName(tr("State of the database"));
  setAlignment(Qt::AlignCenter);
  setWordWrap(true);
  hide();
}

void AwayBanner::reset() {
  answered_ = true;
  settleDue_ = false;
}

void AwayBanner::follow(const StationWriter& line, bool running) {
  const bool answers = line.answers();
  setVisible(!answers);
  if (!answers) {
    QString said = running
                       ? tr("The database does not answer. Your run continues; it is kept on this computer "
                            "and stored as soon as the database answers")
                       : tr("The database does not answer. Torsio tries again by itself; what is stored is "
                            "safe");
    if (const std::size_t waiting = line.waiting(); waiting > 0) {
      said = tr("%1. Waiting to be stored: %2").arg(said).arg(waiting);
    }
    setText(said);
    settleDue_ = true;
  }
  answered_ = answers && (answered_ || reconnect_());
  if (answers && settleDue_ && !running) {
    Q_EMIT settleWanted();
  }
  if (const std::size_t now = line.refused(); now != refusedTold_) {
    refusedTold_ = now;
    if (now > 0) {
      Q_EMIT refused(static_cast<int>(now));
    }
  }
}

void AwayBanner::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    setAccessibleName(tr("State of the database"));
  }
  QLabel::changeEvent(event);
}

}  // namespace torsio::gui
