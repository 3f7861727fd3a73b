// SPDX-License-Identifier: GPL-3.0-or-later
// The stations of TodaysSessionsPage.
#include <algorithm>

#include <QDateTime>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/clock_time.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/date_text.h"
#include "app/gui/widgets/fold_line.h"
#include "assessment/domain/study/station_state.h"

namespace torsio::gui {

namespace {

constexpr int kStationsFrame = 74;  // height of summary, headings, borders
constexpr int kStationHeight = 32;
constexpr std::size_t kMaxStations = 4;

}  // namespace

QString TodaysSessionsPage::checkText(const StationDevice& device) const {
  if (device.device.empty()) {
    return QStringLiteral("\u2013");
  }
  const QDateTime checked = QDateTime::fromMSecsSinceEpoch(device.checkedUtc_us / 1000);
  const QDateTime now = QDateTime::fromMSecsSinceEpoch(board_->asOfUtc_us / 1000);
  if (!device.light) {
    return tr("\u25CB not checked yet");
  }
  if (checked.date() != now.date()) {
    return tr("\u25CB not checked today, last on %1").arg(dateText(checked.date(), locale()));
  }
  const QString time = locale().toString(checked.time(), QLocale::ShortFormat);
  switch (*device.light) {
    case Light::kGreen:
      return tr("\u2713 fit at %1").arg(time);
    case Light::kAmber:
      return tr("! practice only at %1: %2").arg(time, toQString(device.problem));
    case Light::kRed:
      break;
  }
  return tr("\u2717 not fit at %1: %2").arg(time, toQString(device.problem));
}

void TodaysSessionsPage::showStations() {
  std::vector<Row> rows;
  int recording = 0;
  int lost = 0;
  if (board_) {
    for (const StationState& station : board_->stations) {
      const bool silent = board_->asOfUtc_us - station.heartbeatUtc_us > kStationSilence_us;
      const bool records = !station.trialId.empty() && !station.ended;
      recording += records && !silent ? 1 : 0;
      lost += silent ? 1 : 0;
      const StationDevice device = storedDevice(station);
      const QString check = checkText(device);
      rows.push_back(
          {toQString(station.station),
           {{toQString(station.station)},
            {silent    ? tr("! does not answer")
             : records ? tr("\u25CF records")
                       : tr("\u25CB free")},
            {records ? toQString(station.traineeCode) : QStringLiteral("\u2013")},
            {records && !station.phaseLabel.empty() ? toQString(Text(station.phaseLabel))
                                                    : QStringLiteral("\u2013")},
            {records ? clockTime(board_->asOfUtc_us - station.startedUtc_us) : QStringLiteral("\u2013")},
            timeCell(station.heartbeatUtc_us),
            {orDash(station.softwareVersion)},
            {device.device.empty() ? orDash({}) : toQString(device.device)},
            {check, {}, check}}});
    }
  }
  const bool some = !rows.empty();
  stationsLine_->setText(tr("Stations: %1 \u00b7 recording: %2 \u00b7 not answering: %3")
                             .arg(rows.size())
                             .arg(recording)
                             .arg(lost));
  stations_->setFixedHeight(kStationsFrame + kStationHeight * static_cast<int>(std::clamp<std::size_t>(
                                                                  rows.size(), 1, kMaxStations)));
  stations_->setRows(std::move(rows));
  stations_->setVisible(some && stationsLine_->isOpen());
  stationsLine_->setVisible(some);
}

}  // namespace torsio::gui
