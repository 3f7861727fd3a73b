// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/readout_panel.h"

#include <tuple>
#include <utility>

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/gauges.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/load_decimals.h"
#include "sim/core/time_units.h"
#include "sim/servo/surface_proxy.h"

namespace torsio::gui {

namespace {

constexpr auto kTickBudget_us = static_cast<double>(kTickPeriod_us);
constexpr double kSlightForce_N = 0.05;  // less is shown as none, and nobody feels it

/// Sets the text only if different: labels would otherwise lay themselves out in every frame.
void setIfNew(QLabel* label, const QString& text) {
  if (label->text() != text) {
    label->setText(text);
  }
}

/// Adds a muted name with its value.
std::pair<QLabel*, QLabel*> addRow(QGridLayout* grid, QWidget* parent) {
  const int row = grid->rowCount();
  auto* title = new QLabel(parent);
  title->setProperty("quiet", true);
  auto* value = new QLabel(parent);
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(title, row, 0);
  grid->addWidget(value, row, 1);
  return {title, value};
}

void nameRow(QLabel* title, QLabel* value, const QString& name, const QString& tip) {
  title->setText(name);
  value->setAccessibleName(name);
  title->setToolTip(tip);
  value->setToolTip(tip);
}

}  // namespace

ReadoutPanel::ReadoutPanel(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  auto* column = bareLayout<QVBoxLayout>(this, kSpace + 2);

  twist_ = new Card(QString(), this);
  dial_ = new AngleDial(twist_);
  phase_ = new QLabel(twist_);
  phase_->setAlignment(Qt::AlignCenter);
  twist_->content()->addWidget(dial_, 0, Qt::AlignHCenter);
  twist_->content()->addWidget(phase_);
  column->addWidget(twist_);

  load_ = new Card(QString(), this);
  torque_ = new LevelBar(QString(), QString(), kTorqueDecimals, load_);
  force_ = new LevelBar(QString(), QString(), kForceDecimals, load_);
  load_->content()->addWidget(torque_);
  load_->content()->addWidget(force_);
  column->addWidget(load_);

  timing_ = new Card(QString(), this);
  auto* grid = new QGridLayout;
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  std::tie(tickName_, tick_) = addRow(grid, timing_);
  std::tie(framesName_, frames_) = addRow(grid, timing_);
  timing_->content()->addLayout(grid);
  column->addWidget(timing_);
  // A card keeps the height of its content even if the panel has more room.
  for (Card* card : {twist_, load_, timing_}) {
    card->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  }
  column->addStretch(1);

  retranslate();
}

void ReadoutPanel::retranslate() {
  twist_->setTitle(tr("Twist"));
  load_->setTitle(tr("Load"));
  timing_->setTitle(tr("Timing"));
  phase_->setAccessibleName(tr("Phase"));
  torque_->setName(tr("Torque"), tr("N m"));
  force_->setName(tr("Force"), tr("N"));
  nameRow(tickName_, tick_, tr("Servo tick"),
          tr("Time that one step of the 1 kHz loop takes, of 1000 µs; how many steps came late"));
  nameRow(framesName_, frames_, tr("Frame rate"), tr("Pictures drawn in one second"));
  dial_->retranslate();
  show(shown_, rate_);
}

void ReadoutPanel::setTheme(const Theme& theme) {
  theme_ = &theme;
  dial_->setTheme(theme);
  torque_->setTheme(theme);
  force_->setTheme(theme);
}

void ReadoutPanel::setLimits(const ReadoutLimits& limits) {
  limits_ = limits;
  torque_->setLimit(limits.torque_Nm);
  force_->setLimit(limits.force_N);
}

QString ReadoutPanel::phaseName(ExercisePhase phase) {
  switch (phase) {
    case ExercisePhase::kTracking:
      return tr("Free");
    case ExercisePhase::kContact:
      return tr("Contact");
    case ExercisePhase::kTwisting:
      return tr("Twisting");
    case ExercisePhase::kReleased:
      return tr("Released");
  }
  return {};
}

QString ReadoutPanel::releaseText(const LiveState& state) {
  const auto endedBy = [&state](std::int64_t time_us) {
    return time_us >= 0 && time_us == state.times.released_us;
  };
  if (endedBy(state.times.folded_us)) {
    return tr(
        "The tissue would have folded or slipped back by a whole turn, so the jaw opened. Turn less far.");
  }
  if (endedBy(state.times.slipped_us)) {
    return tr("The jaw slipped off: it was pulled too far. The tissue returns to rest.");
  }
  return tr("The tissue returns to rest.");
}

void ReadoutPanel::showPhase(ExercisePhase phase) {
  // The symbol also changes with the phase, because it is noticed peripherally.
  static const QChar kSigns[] = {QChar(0x25CB), QChar(0x25D0), QChar(0x25CF), QChar(0x25CC)};
  setIfNew(phase_, kSigns[static_cast<int>(phase)] + QStringLiteral("  ") + phaseName(phase));
}

void ReadoutPanel::showTiming(const LiveState& state, double framesPerSecond) {
  const QLocale locale;
  const QString none = QStringLiteral("\u2013");
  QString tick = tr("%1 µs").arg(locale.toString(state.tickDuration_us, 'f', 0));
  if (state.tickDuration_us > kTickBudget_us) {
    tick = tr("%1, too long").arg(tick);
  }
  if (state.lateTicks > 0) {
    tick = tr("%1, %n late", nullptr, static_cast<int>(state.lateTicks)).arg(tick);
  }
  setIfNew(tick_, state.tickDuration_us > 0.0 ? tick : none);
  setIfNew(frames_, framesPerSecond > 0.0 ? tr("%1 /s").arg(locale.toString(framesPerSecond, 'f', 0)) : none);
}

bool ReadoutPanel::pressesTooDeep(const LiveState& state) {
  return state.phase != ExercisePhase::kTwisting && state.response.depth_m > kTooDeep_m &&
         norm(state.response.force_N) > kSlightForce_N;
}

void ReadoutPanel::show(const LiveState& state, double framesPerSecond) {
  shown_ = state;
  rate_ = framesPerSecond;
  dial_->setVisible(!state.hollow.present);  // the target of a twisted organ is always the untwisted state
  dial_->setTarget(state.targetAngle_rad, limits_.tolerance_rad);
  dial_->setAngle(state.response.angle_rad);
  torque_->setValue(std::abs(state.response.torque_Nm));
  force_->setValue(norm(state.response.force_N));
  showPhase(state.phase);
  if (pressesTooDeep(state)) {
    setIfNew(phase_, tr("You are pressing too deep: draw back"));
  }
  showTiming(state, framesPerSecond);
}

}  // namespace torsio::gui
