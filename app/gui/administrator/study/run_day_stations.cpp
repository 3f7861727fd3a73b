// SPDX-License-Identifier: GPL-3.0-or-later
// Of RunDayPage: what needs attention, and the stations.
#include <algorithm>

#include <QDateTime>
#include <QLabel>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/administrator/study/day_plan_dialog.h"
#include "app/gui/administrator/study/run_day_page.h"
#include "app/gui/base/clock_time.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "assessment/study/station_state.h"

namespace torsio::gui {

namespace {

constexpr int kStationsFrame = 74;  // count of rows, headings, borders
constexpr int kStationHeight = 32;
constexpr std::size_t kMostStations = 4;
constexpr qsizetype kMostAlerts = 3;

}  // namespace

QString RunDayPage::alertText(const RunDayAlert& alert) const {
  using Kind = RunDayAlert::Kind;
  switch (alert.kind) {
    case Kind::kTrialOpen:
      return tr("%1 was recording at %2, which does not answer since %3. Go and look.")
          .arg(toQString(alert.subject), toQString(alert.station), shownTime(alert.sinceUtc_us, locale()));
    case Kind::kStationSilent:
      return tr("%1 does not answer since %2.")
          .arg(toQString(alert.subject), shownTime(alert.sinceUtc_us, locale()));
    case Kind::kDeviceUnfit:
      return tr("%1: the device is not fit for graded runs: %2.")
          .arg(toQString(alert.subject), toQString(alert.reason));
    case Kind::kServoUneven:
      return tr("%1, last run: %2. %3.")
          .arg(toQString(alert.subject), toQString(alert.reason), toQString(alert.remedy));
    case Kind::kSlotOverdue:
      return tr("%1 was expected at %2, %3, and has not begun.")
          .arg(toQString(alert.subject), slotTime(alert.sinceUtc_us, locale()), toQString(alert.station));
    case Kind::kRestTooLong:
      return tr("%1 has rested longer than allowed.").arg(toQString(alert.subject));
    case Kind::kSheetsMissing:
      return tr("%1: sheets still missing: %2.").arg(occasionName(alert.occasion)).arg(alert.count);
    case Kind::kNoGroup:
      return tr("Trainees without a group: %1. Draw them under Allocation.").arg(alert.count);
  }
  return {};
}

void RunDayPage::showAlerts() {
  QStringList lines;
  if (board_) {
    for (const RunDayAlert& alert : runDayAlerts(*board_)) {
      lines << alertText(alert);
    }
  }
  const qsizetype more = lines.size() - kMostAlerts;
  if (more > 0) {
    lines.resize(kMostAlerts);
    lines << tr("and %n more", nullptr, static_cast<int>(more));
  }
  alerts_->setText(lines.isEmpty() ? QString()
                                   : QStringLiteral("\u26A0 ") + lines.join(QStringLiteral("\n\u26A0 ")));
  alerts_->setVisible(!lines.isEmpty());
}

QString RunDayPage::checkText(const StationDevice& device) const {
  if (device.device.empty()) {
    return QStringLiteral("\u2013");
  }
  const QDateTime checked = QDateTime::fromMSecsSinceEpoch(device.checkedUtc_us / 1000);
  const QDateTime now = QDateTime::fromMSecsSinceEpoch(board_->asOfUtc_us / 1000);
  if (!device.light) {
    return tr("\u25CB not checked yet");
  }
  if (checked.date() != now.date()) {
    return tr("\u25CB not checked today, last on %1")
        .arg(locale().toString(checked.date(), QLocale::ShortFormat));
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

void RunDayPage::showStations() {
  std::vector<Row> rows;
  if (board_) {
    for (const StationState& station : board_->stations) {
      const bool silent = board_->asOfUtc_us - station.heartbeatUtc_us > kStationSilence_us;
      const bool records = !station.trialId.empty() && !station.ended;
      const StationDevice device = storedDevice(station);
      const QString check = checkText(device);
      rows.push_back(
          {toQString(station.station),
           {{toQString(station.station)},
            {silent    ? tr("! does not answer")
             : records ? tr("\u25CF records")
                       : tr("\u25CB free")},
            {records ? toQString(station.traineeCode) : QStringLiteral("\u2013")},
            {records ? orDash(station.phaseLabel) : QStringLiteral("\u2013")},
            {records ? clockTime(board_->asOfUtc_us - station.startedUtc_us) : QStringLiteral("\u2013")},
            timeCell(station.heartbeatUtc_us),
            {orDash(station.softwareVersion)},
            {device.device.empty() ? orDash({}) : toQString(device.device)},
            {check, {}, check}}});
    }
  }
  const bool some = !rows.empty();
  stations_->setFixedHeight(kStationsFrame + kStationHeight * static_cast<int>(std::clamp<std::size_t>(
                                                                  rows.size(), 1, kMostStations)));
  stations_->setRows(std::move(rows));
  stations_->setVisible(some);
  stationsTitle_->setVisible(some);
}

}  // namespace torsio::gui
