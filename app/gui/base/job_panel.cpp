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
constexpr int kThinBar_px = 4;
constexpr int kWidestInHeader_px = 480;

/// Ends what is too long with an ellipsis, if the label may be narrower than its text.
void sayIn(QLabel& label, const QString& text) {
  const bool fits = label.sizePolicy().horizontalPolicy() != QSizePolicy::Ignored || !label.isVisible();
  const QString shown = fits ? text : label.fontMetrics().elidedText(text, Qt::ElideRight, label.width());
  label.setText(shown);
  label.setToolTip(shown == text ? QString() : text);
  label.setAccessibleName(text);
}

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

JobPanel::JobPanel(QWidget* parent, Place place)
    : QFrame(parent),
      title_(new QLabel(this)),
      step_(new QLabel(this)),
      left_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(this)) {
  title_->setProperty("subheading", true);
  step_->setProperty("quiet", true);
  left_->setProperty("quiet", true);
  left_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  bar_->setTextVisible(false);
  fitInto(place);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancel_->setEnabled(false);
    step_->setText(tr("Stopping\u2026"));
    Q_EMIT cancelled();
  });
  followLanguage(this, [this] { retranslate(); });
  hide();
}

void JobPanel::fitInto(Place place) {
  auto* grid = new QGridLayout(this);
  grid->setHorizontalSpacing(2 * kSpace);
  if (place == Place::kHeader) {
    setObjectName(QStringLiteral("jobInHeader"));
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(0);
    bar_->setFixedHeight(kThinBar_px);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    step_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    setMaximumWidth(kWidestInHeader_px);
  } else {
    setObjectName(QStringLiteral("job"));
    grid->setContentsMargins(2 * kSpace, kSpace + 2, 2 * kSpace, kSpace + 2);
    grid->setVerticalSpacing(4);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  }
  grid->addWidget(title_, 0, 0);
  grid->addWidget(left_, 0, 1);
  grid->addWidget(step_, 1, 0, 1, 2);
  grid->addWidget(bar_, 2, 0, 1, 2);
  grid->addWidget(cancel_, 0, 2, 3, 1, Qt::AlignVCenter);
  grid->setColumnStretch(0, 1);
}

void JobPanel::begin(const QString& title) {
  sayIn(*title_, title);
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
  sayIn(*title_, title_->accessibleName());  // by now it has its width
  const double share = std::clamp(fraction, 0.0, 1.0);
  bar_->setRange(0, kSteps);
  bar_->setValue(static_cast<int>(std::lround(share * kSteps)));
  sayIn(*step_, step);
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
