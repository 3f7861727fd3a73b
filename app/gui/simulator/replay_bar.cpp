// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/replay_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "app/gui/base/clock_time.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/theme.h"
#include "app/services/recording/trial_playback.h"

namespace torsio::gui {

namespace {

constexpr double kSpeeds[] = {0.25, 0.5, 1.0, 2.0, 4.0};
constexpr int kSliderStep_us = 10'000;

}  // namespace

ReplayBar::ReplayBar(QWidget* parent)
    : QWidget(parent),
      theme_(&theme(ThemeKind::kLight)),
      play_(new QToolButton(this)),
      position_(new QSlider(Qt::Horizontal, this)),
      time_(new QLabel(this)),
      speed_(new QComboBox(this)),
      close_(new QToolButton(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * kSpace, kSpace, 2 * kSpace, kSpace);
  row->setSpacing(kSpace + 4);
  play_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  close_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  position_->setPageStep(100);
  for (const double speed : kSpeeds) {
    speed_->addItem(QString(), speed);
  }
  speed_->setCurrentIndex(2);
  row->addWidget(play_);
  row->addWidget(position_, 1);
  row->addWidget(time_);
  row->addWidget(speed_);
  row->addWidget(close_);

  connect(play_, &QToolButton::clicked, this, &ReplayBar::playToggled);
  connect(close_, &QToolButton::clicked, this, &ReplayBar::closed);
  connect(position_, &QSlider::valueChanged, this,
          [this](int step) { Q_EMIT soughtTo(static_cast<qint64>(step) * kSliderStep_us); });
  connect(speed_, &QComboBox::activated, this,
          [this](int index) { Q_EMIT speedChosen(speed_->itemData(index).toDouble()); });
  retranslate();
}

void ReplayBar::retranslate() {
  close_->setText(tr("Close replay"));
  position_->setAccessibleName(tr("Position in the recording"));
  time_->setAccessibleName(tr("Time"));
  speed_->setAccessibleName(tr("Speed"));
  for (int i = 0; i < speed_->count(); ++i) {
    speed_->setItemText(i, tr("%1 \u00d7 speed").arg(QLocale().toString(speed_->itemData(i).toDouble())));
  }
  setTheme(*theme_);
}

void ReplayBar::setTheme(const Theme& theme) {
  theme_ = &theme;
  play_->setIcon(icon(playing_ ? QStringLiteral("pause") : QStringLiteral("play"), theme));
  play_->setText(playing_ ? tr("Pause") : tr("Play"));
  close_->setIcon(icon(QStringLiteral("close"), theme));
}

void ReplayBar::show(const TrialPlayback* playback) {
  if (playback == nullptr) {
    return;
  }
  if (playing_ != playback->playing()) {
    playing_ = playback->playing();
    setTheme(*theme_);
  }
  const QSignalBlocker quiet(position_);
  position_->setRange(0, static_cast<int>(playback->duration_us() / kSliderStep_us));
  if (!position_->isSliderDown()) {
    position_->setValue(static_cast<int>(playback->position_us() / kSliderStep_us));
  }
  const QString text =
      clockTenthsOf(playback->position_us()) + QStringLiteral(" / ") + clockTenthsOf(playback->duration_us());
  if (time_->text() != text) {
    time_->setText(text);
  }
}

}  // namespace torsio::gui
