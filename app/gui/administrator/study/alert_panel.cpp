// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/alert_panel.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QCoreApplication>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/administrator/study/day_plan_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/study/day_board.h"

namespace torsio::gui {

namespace {

constexpr qsizetype kAlertsSeen = 4;  // before the list scrolls

struct AlertWords {
  Q_DECLARE_TR_FUNCTIONS(AlertPanel)
};

/// Returns the number of alerts of a kind, in words; kinds in order of urgency.
QString countText(DayAlert::Kind kind, std::size_t count) {
  using Kind = DayAlert::Kind;
  switch (kind) {
    case Kind::kTrialOpen:
      return AlertWords::tr("recordings cut off: %1").arg(count);
    case Kind::kStationSilent:
      return AlertWords::tr("stations that do not answer: %1").arg(count);
    case Kind::kDeviceUnfit:
      return AlertWords::tr("devices not fit: %1").arg(count);
    case Kind::kServoUneven:
      return AlertWords::tr("uneven runs: %1").arg(count);
    case Kind::kSlotOverdue:
      return AlertWords::tr("overdue: %1").arg(count);
    case Kind::kRestTooLong:
      return AlertWords::tr("rests too long: %1").arg(count);
    case Kind::kSheetsMissing:
      return AlertWords::tr("sheets due and missing: %1").arg(count);
    case Kind::kNoGroup:
      return AlertWords::tr("without a group: %1").arg(count);
  }
  return {};
}

}  // namespace

AlertPanel::AlertPanel(QWidget* parent)
    : QWidget(parent), line_(new FoldLine(this)), scroll_(new QScrollArea(this)), lines_(new QLabel) {
  setObjectName(QStringLiteral("alertPanel"));
  line_->label()->setObjectName(QStringLiteral("alertCounts"));
  lines_->setObjectName(QStringLiteral("alerts"));
  lines_->setTextFormat(Qt::PlainText);
  lines_->setWordWrap(true);
  lines_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  setLook(line_->label(), "caution", true);
  setLook(lines_, "caution", true);
  scroll_->setWidget(lines_);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpace);
  column->addWidget(line_);
  column->addWidget(scroll_);
  connect(line_, &FoldLine::toggled, scroll_, &QWidget::setVisible);
  hide();
}

QString AlertPanel::textOf(const DayAlert& alert) const {
  const QString since = alert.kind == DayAlert::Kind::kSlotOverdue ? slotTime(alert.sinceUtc_us, locale())
                                                                   : shownTime(alert.sinceUtc_us, locale());
  return toQString(alertText(alert, since.toStdString(), Text(occasionName(alert.occasion).toStdString())));
}

void AlertPanel::showAlerts(const std::vector<DayAlert>& alerts) {
  QStringList lines;
  std::vector<std::pair<DayAlert::Kind, std::size_t>> kinds;
  for (const DayAlert& alert : alerts) {
    lines << QStringLiteral("\u26A0 ") + textOf(alert);
    auto known =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.first == alert.kind; });
    if (known == kinds.end()) {
      known = kinds.insert(kinds.end(), {alert.kind, 0});
    }
    known->second += std::max<std::size_t>(alert.count, 1);
  }
  QStringList counts;
  for (const auto& [kind, count] : kinds) {
    counts << countText(kind, count);
  }
  line_->setText(lines.size() == 1 ? lines.front()
                                   : QStringLiteral("\u26A0 ") + counts.join(QStringLiteral(" \u00B7 ")));
  line_->setFoldable(lines.size() > 1);
  scroll_->setVisible(line_->isOpen() && lines.size() > 1);
  if (const QString text = lines.join(QLatin1Char('\n')); text != lines_->text()) {
    lines_->setText(text);  // keeps the scroll position while nothing changes
  }
  scroll_->setFocusPolicy(lines.size() > kAlertsSeen ? Qt::StrongFocus : Qt::NoFocus);
  scroll_->setAccessibleName(AlertWords::tr("What needs attention"));
  const auto seen = static_cast<int>(std::clamp<qsizetype>(lines.size(), 1, kAlertsSeen));
  scroll_->setFixedHeight(seen * lines_->fontMetrics().lineSpacing() + kSpace);
  setVisible(!lines.isEmpty());
}

void AlertPanel::retranslate() {
  line_->retranslate();
}

}  // namespace torsio::gui
