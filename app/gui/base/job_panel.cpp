// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/job_panel.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>

#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/gui/widgets/window_events.h"

namespace torsio::gui {

namespace {

constexpr int kSteps = 1000;
constexpr double kMinute_s = 60.0;

}  // namespace

QString timeLeft(double remaining_s) {
  if (remaining_s < 0.0 || !std::isfinite(remaining_s)) {
    return {};
  }
  if (remaining_s >= 2.0 * kMinute_s) {
    return JobPanel::tr("%1 min left").arg(std::lround(remaining_s / kMinute_s));
  }
  return JobPanel::tr("%1 left").arg(clockTimeLeft(std::llround(remaining_s * 1e6)));
}

JobPanel::JobPanel(QWidget* parent)
    : QFrame(parent),
      title_(new QLabel(this)),
      step_(new QLabel(this)),
      left_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(this)) {
  setObjectName(QStringLiteral("job"));
  title_->setProperty("subheading", true);
  step_->setProperty("quiet", true);
  left_->setProperty("quiet", true);
  left_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  bar_->setTextVisible(false);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(2 * kSpace, kSpace + 2, 2 * kSpace, kSpace + 2);
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setVerticalSpacing(4);
  grid->addWidget(title_, 0, 0);
  grid->addWidget(left_, 0, 1);
  grid->addWidget(step_, 1, 0, 1, 2);
  grid->addWidget(bar_, 2, 0, 1, 2);
  grid->addWidget(cancel_, 0, 2, 3, 1, Qt::AlignVCenter);
  grid->setColumnStretch(0, 1);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancel_->setEnabled(false);
    step_->setText(tr("Stopping\u2026"));
    Q_EMIT cancelled();
  });
  followLanguage(this, [this] { retranslate(); });
  hide();
}

void JobPanel::begin(const QString& title) {
  title_->setText(title);
  step_->clear();
  left_->clear();
  bar_->setRange(0, 0);  // indeterminate until the first progress
  cancel_->setEnabled(true);
  show();
}

void JobPanel::move(const QString& step, double fraction, double remaining_s) {
  if (isHidden() || !cancel_->isEnabled()) {
    return;
  }
  const double share = std::clamp(fraction, 0.0, 1.0);
  bar_->setRange(0, kSteps);
  bar_->setValue(static_cast<int>(std::lround(share * kSteps)));
  step_->setText(step);
  const QString percent = QLocale().toString(share * 100.0, 'f', 0);
  const QString left = timeLeft(remaining_s);
  left_->setText(left.isEmpty() ? tr("%1 %").arg(percent) : tr("%1 %, %2").arg(percent, left));
  bar_->setAccessibleDescription(left_->text());
}

void JobPanel::end() {
  hide();
}

void JobPanel::retranslate() {
  setAccessibleName(tr("Work in progress"));
  bar_->setAccessibleName(tr("Progress"));
  cancel_->setText(tr("Cancel"));
}

}  // namespace torsio::gui
