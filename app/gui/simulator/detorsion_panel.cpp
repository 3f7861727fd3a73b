// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/detorsion_panel.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/simulation_controller.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "sim/core/angle.h"
#include "sim/core/organ_pose.h"
#include "sim/core/time_units.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/detorsion.h"

namespace torsio::gui {

namespace {

constexpr double kDegreesPerTurn = 360.0;
constexpr double kOpenFrom = 0.8;
constexpr int kBar = 1000;
constexpr std::int64_t kAgeStep_s = 10;          // step of the age shown of a check
constexpr double kWrongWay_rad = radians(10.0);  // more than a hand drifts while holding
constexpr double kNearEnd_rad = radians(1.0);    // of the hand's turn
constexpr FlowCheck kChecks[] = {FlowCheck::kLook, FlowCheck::kTouch, FlowCheck::kDoppler};

QString percent(double share) {
  return QLocale().toString(100.0 * share, 'f', 0);
}

void setText(QLabel* label, const QString& text) {
  if (label->text() != text) {
    label->setText(text);
  }
}

}  // namespace

DetorsionPanel::DetorsionPanel(QWidget* parent) : QWidget(parent), card_(new Card(QString(), this)) {
  setObjectName(QStringLiteral("detorsion"));
  auto* column = bareLayout<QVBoxLayout>(this);
  column->addWidget(card_);
  auto* grid = new QGridLayout;
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  const std::pair<Row*, const char*> rows[] = {{&angle_, "angleLeft"},
                                               {&lumen_, "lumen"},
                                               {&pressure_, "pressure"},
                                               {&time_, "tissueTime"},
                                               {&flow_, "flowTold"}};
  for (const auto& [row, id] : rows) {
    const int at = grid->rowCount();
    row->name = new QLabel(card_);
    row->name->setProperty("quiet", true);
    row->value = new QLabel(card_);
    row->value->setObjectName(QLatin1String(id));
    row->value->setAlignment(Qt::AlignRight | Qt::AlignTop);
    row->value->setWordWrap(true);
    grid->addWidget(row->name, at, 0, Qt::AlignTop);
    grid->addWidget(row->value, at, 1);
  }
  card_->content()->addLayout(grid);
  compression_ = new QLabel(card_);
  compression_->setObjectName(QStringLiteral("compression"));
  compression_->setProperty("quiet", true);
  compression_->setWordWrap(true);
  card_->content()->addWidget(compression_);
  createButtons();
  restText_ = new QLabel(card_);
  restText_->setObjectName(QStringLiteral("restText"));
  restText_->setWordWrap(true);
  rest_ = new QProgressBar(card_);
  rest_->setObjectName(QStringLiteral("rest"));
  rest_->setTextVisible(false);
  rest_->setRange(0, kBar);
  handsOffText_ = new QLabel(card_);
  handsOffText_->setObjectName(QStringLiteral("handsOffText"));
  handsOffText_->setWordWrap(true);
  handsOff_ = new QProgressBar(card_);
  handsOff_->setObjectName(QStringLiteral("handsOff"));
  handsOff_->setTextVisible(false);
  handsOff_->setRange(0, kBar);
  warning_ = new QLabel(card_);
  warning_->setObjectName(QStringLiteral("tissueWarning"));
  warning_->setProperty("caution", true);
  warning_->setWordWrap(true);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{restText_, rest_, handsOffText_, handsOff_, warning_}) {
    card_->content()->addWidget(widget);
    widget->hide();
  }
  retranslate();
  setVisible(false);
}

void DetorsionPanel::createButtons() {
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kSpace);
  clip_ = new QPushButton(card_);
  clip_->setObjectName(QStringLiteral("clip"));
  clip_->setCheckable(true);
  vent_ = new QPushButton(card_);
  vent_->setObjectName(QStringLiteral("vent"));
  vent_->setCheckable(true);
  check_ = new QPushButton(card_);
  check_->setObjectName(QStringLiteral("check"));
  auto* menu = new QMenu(check_);
  check_->setMenu(menu);
  for (QPushButton* button : {clip_, vent_}) {
    button->setFocusPolicy(Qt::TabFocus);
    buttons->addWidget(button, 1);
  }
  check_->setFocusPolicy(Qt::TabFocus);
  card_->content()->addLayout(buttons);
  card_->content()->addWidget(check_);
  checking_ = new QProgressBar(card_);
  checking_->setObjectName(QStringLiteral("checking"));
  checking_->setTextVisible(false);
  checking_->setRange(0, kBar);
  checking_->hide();
  card_->content()->addWidget(checking_);

  // The requested state is assumed until the next frame reports, so that two quick presses undo each other.
  const auto hold = [this] {
    shown_.hollow.clipped = !shown_.hollow.clipped;
    Q_EMIT asked({.kind = ServoCommand::Kind::kHoldOrgan, .value = shown_.hollow.clipped ? 1.0 : 0.0});
  };
  const auto vent = [this] {
    shown_.hollow.venting = !shown_.hollow.venting;
    Q_EMIT asked({.kind = ServoCommand::Kind::kVent, .value = shown_.hollow.venting ? 1.0 : 0.0});
  };
  connect(clip_, &QPushButton::clicked, this, hold);
  connect(vent_, &QPushButton::clicked, this, vent);
  addKey(Qt::Key_C, hold);
  addKey(Qt::Key_V, [this, vent] {
    if (detorsion_.wall.vent) {
      vent();
    }
  });
  int key = Qt::Key_1;
  for (const FlowCheck check : kChecks) {
    const auto ask = [this, check] {
      Q_EMIT asked({.kind = ServoCommand::Kind::kCheckFlow, .value = static_cast<double>(check)});
    };
    QAction* action = menu->addAction(QString());
    connect(action, &QAction::triggered, this, ask);
    checks_.emplace_back(check, action);
    addKey(key++, ask);
  }
}

void DetorsionPanel::addKey(int key, const std::function<void()>& action) {
  auto* shortcut = new QShortcut(QKeySequence(key), this);
  shortcut->setAutoRepeat(false);
  connect(shortcut, &QShortcut::activated, this, [this, action] {
    if (present_ && usable_) {
      action();
    }
  });
}

void DetorsionPanel::steer(SimulationController& controller) {
  connect(this, &DetorsionPanel::asked, &controller, &SimulationController::command);
}

void DetorsionPanel::setScene(const Scene* scene) {
  present_ = scene != nullptr && scene->comesTwisted();
  if (present_) {
    detorsion_ = scene->hollow->detorsion();
  }
  shown_ = {};
  stages_ = StagedTurn(detorsion_.stages, detorsion_.timeScale);
  handsOffSince_us_ = -1;
  retranslate();
  setVisible(present_);
}

void DetorsionPanel::setUsable(bool usable) {
  usable_ = usable;
  enable();
}

void DetorsionPanel::enable() {
  clip_->setEnabled(usable_);
  vent_->setEnabled(usable_);
  check_->setEnabled(usable_ && shown_.hollow.check.running == FlowCheck::kNone);
}

void DetorsionPanel::retranslate() {
  card_->setTitle(tr("Untwisting"));
  const std::pair<Row*, QString> names[] = {{&angle_, tr("Twist left")},
                                            {&lumen_, tr("Lumen")},
                                            {&pressure_, tr("Gas pressure")},
                                            {&time_, tr("Tissue time")},
                                            {&flow_, tr("Blood flow, last check")}};
  for (const auto& [row, text] : names) {
    row->name->setText(text);
    row->value->setAccessibleName(text);
  }
  const bool wall = !detorsion_.wall.thickness_m.empty();
  for (const Row* row : {&lumen_, &pressure_}) {
    row->name->setVisible(wall);
    row->value->setVisible(wall);
  }
  vent_->setVisible(detorsion_.wall.vent);
  compression_->setText(tr("1 s here = %1 s of the tissue").arg(QLocale().toString(detorsion_.timeScale)));
  if (detorsion_.timeScale == 60.0) {
    compression_->setText(tr("1 s here = 1 min of the tissue"));
  }
  clip_->setToolTip(tr("A clip or an assistant holds the organ while you re-grip"));
  vent_->setToolTip(tr("Let gas out: the organ turns more easily and its lumen closes sooner"));
  check_->setText(tr("Check the blood flow"));
  for (QPushButton* button : {clip_, vent_, check_}) {
    button->setAccessibleDescription(button->toolTip());
  }
  int key = 1;
  for (const auto& [check, action] : checks_) {
    const FlowCheckCost cost = flowCheckCost(check);
    action->setText(tr("%1 (%2): %3 s, ± %4 %")
                        .arg(checkName(check))
                        .arg(key++)
                        .arg(static_cast<double>(cost.time_us) * 1e-6, 0, 'f', 0)
                        .arg(percent(cost.deviation)));
  }
  checking_->setAccessibleName(tr("Progress of the check"));
  rest_->setAccessibleName(tr("Rest of the tissue"));
  handsOff_->setAccessibleName(tr("Time with hands off"));
  warning_->setAccessibleName(tr("Warning"));
  show(shown_);
}

std::vector<std::pair<QString, QString>> DetorsionPanel::keys() {
  return {{tr("Untwisting: clip"), tr("C")},
          {tr("Untwisting: let gas out"), tr("V")},
          {tr("Untwisting: look, feel the pulse, Doppler"), tr("1, 2, 3")}};
}

QString DetorsionPanel::checkName(FlowCheck check) {
  switch (check) {
    case FlowCheck::kLook:
      return tr("Look");
    case FlowCheck::kTouch:
      return tr("Feel the pulse");
    case FlowCheck::kDoppler:
      return tr("Doppler");
    case FlowCheck::kNone:
      break;
  }
  return {};
}

QString DetorsionPanel::angleText(double angle_rad) {
  const double angle_deg = std::abs(degrees(angle_rad));
  const QLocale locale;
  const QString size =
      tr("%1° · %2 turns")
          .arg(locale.toString(angle_deg, 'f', 0), locale.toString(angle_deg / kDegreesPerTurn, 'f', 2));
  if (angle_deg < 0.5) {
    return size;
  }
  return angle_rad < 0.0 ? tr("%1 clockwise").arg(size) : tr("%1 counterclockwise").arg(size);
}

QString DetorsionPanel::clockText(double scaled_s) {
  const auto minutes = static_cast<std::int64_t>(scaled_s / 60.0);
  return tr("%1:%2 h").arg(minutes / 60).arg(minutes % 60, 2, 10, QLatin1Char('0'));
}

void DetorsionPanel::show(const LiveState& state) {
  shown_ = state;
  const double angle_rad = state.response.angle_rad;
  if (state.phase != ExercisePhase::kTwisting) {
    heldFrom_rad_ = heldLeast_rad_ = heldMost_rad_ = angle_rad;
  }
  heldLeast_rad_ = std::min(heldLeast_rad_, angle_rad);
  heldMost_rad_ = std::max(heldMost_rad_, angle_rad);
  if (!present_) {
    return;
  }
  showRows();
  showCheck();
  showRest();
  showHandsOff();
  showWarning();
  enable();
}

void DetorsionPanel::showRows() {
  const HollowPose& pose = shown_.hollow;
  setText(angle_.value, angleText(shown_.response.angle_rad));
  const double patency = pose.reading.patency;
  setText(lumen_.value, patency >= kOpenFrom      ? tr("open, %1 %").arg(percent(patency))
                        : patency <= kShutPatency ? tr("closed, %1 %").arg(percent(patency))
                                                  : tr("narrow, %1 %").arg(percent(patency)));
  setText(pressure_.value,
          tr("%1 mmHg").arg(QLocale().toString(pose.reading.pressure_Pa / kPascalsPerMmHg, 'f', 1)));
  setText(time_.value, clockText(pose.scaled_s));
  clip_->setChecked(pose.clipped);
  clip_->setText(pose.clipped ? tr("Clip off (C)") : tr("Clip (C)"));
  vent_->setChecked(pose.venting);
  vent_->setText(pose.venting ? tr("Gas stop (V)") : tr("Gas out (V)"));
}

void DetorsionPanel::showCheck() {
  const FlowReading& check = shown_.hollow.check;
  const bool runs = check.running != FlowCheck::kNone;
  checking_->setVisible(runs);
  if (runs) {
    const std::int64_t whole_us = flowCheckCost(check.running).time_us;
    const std::int64_t left_us = std::clamp<std::int64_t>(check.ready_us - shown_.time_us, 0, whole_us);
    checking_->setValue(static_cast<int>((whole_us - left_us) * kBar / std::max<std::int64_t>(1, whole_us)));
    setText(flow_.value, tr("%1\u2026").arg(checkName(check.running)));
  } else if (check.done == FlowCheck::kNone) {
    setText(flow_.value, tr("not checked"));
  } else {
    const QString told =
        tr("%1: %2 % ± %3 %")
            .arg(checkName(check.done), percent(check.flow), percent(flowCheckCost(check.done).deviation));
    // An old result says nothing about the organ's present state.
    const std::int64_t age_s = (shown_.time_us - check.done_us) / kSecond_us / kAgeStep_s * kAgeStep_s;
    setText(flow_.value, age_s > 0 ? tr("%1, %2 ago").arg(told, clockTime(age_s * kSecond_us)) : told);
  }
}

/// Flow is not a condition: it would reveal what only a check may.
bool DetorsionPanel::liesWithinLimits() const {
  const HollowPose& pose = shown_.hollow;
  return pose.present && std::abs(shown_.response.angle_rad) <= detorsion_.limits.residual_rad &&
         pose.reading.patency >= detorsion_.limits.patency;
}

QString DetorsionPanel::cue() const {
  const bool holds = shown_.phase == ExercisePhase::kTwisting;
  if (!shown_.hollow.present || shown_.phase == ExercisePhase::kReleased) {
    return {};
  }
  if (shown_.hollow.clipped) {
    return holds ? tr("The clip holds the organ. Remove the clip (C), then turn further.")
                 : tr("The clip holds the organ. Re-grip, then remove the clip (C).");
  }
  if (!holds) {
    return liesWithinLimits() ? tr("Within the limits. Keep your hands off and check the blood flow.")
                              : QString();
  }
  if (liesWithinLimits()) {
    return tr("Within the limits. Open the jaw.");
  }
  if (std::abs(shown_.response.angle_rad) > std::abs(heldFrom_rad_) + kWrongWay_rad) {
    return tr("The twist is increasing. Turn in the opposite direction.");
  }
  if (handAtItsEnd()) {
    return tr("Your hand has reached its limit. Set the clip (C), open the jaw and re-grip.");
  }
  return tr("Holding. Turn, set the clip (C), then re-grip.");
}

bool DetorsionPanel::handAtItsEnd() const {
  const double angle_rad = shown_.response.angle_rad;
  return heldMost_rad_ - heldLeast_rad_ > kHandTurn_rad - kNearEnd_rad &&
         (angle_rad < heldLeast_rad_ + kNearEnd_rad || angle_rad > heldMost_rad_ - kNearEnd_rad);
}

void DetorsionPanel::showRest() {
  const HollowPose& pose = shown_.hollow;
  if (!pose.present || !detorsion_.stages.asked()) {
    restText_->hide();
    rest_->hide();
    return;
  }
  const double now_s = static_cast<double>(shown_.time_us) * 1e-6;
  if (pose.scaled_s <= 0.0 || now_s < restTaken_s_) {
    stages_ = StagedTurn(detorsion_.stages, detorsion_.timeScale);  // new trial, or a replay seeks back
  }
  restTaken_s_ = now_s;
  stages_.take(now_s, shown_.response.angle_rad);
  const bool due = stages_.due();
  restText_->setVisible(due);
  rest_->setVisible(due);
  if (due) {
    const double whole_s = detorsion_.stages.rest_s / detorsion_.timeScale;
    const double still_s = std::min(stages_.still_s() / detorsion_.timeScale, whole_s);
    rest_->setValue(static_cast<int>(kBar * still_s / whole_s));
    setText(restText_,
            tr("Turned back by %1°. Set the clip and let it rest: %2 of %3")
                .arg(degrees(stages_.stage_rad()), 0, 'f', 0)
                .arg(clockTime(std::llround(still_s * 1e6)), clockTime(std::llround(whole_s * 1e6))));
  }
}

void DetorsionPanel::showHandsOff() {
  const DetorsionLimits& limits = detorsion_.limits;
  const HollowPose& pose = shown_.hollow;
  const bool lies = liesWithinLimits();
  const bool off = shown_.phase != ExercisePhase::kTwisting && !pose.clipped;
  if (!lies || !off) {
    handsOffSince_us_ = -1;
  } else if (handsOffSince_us_ < 0 || handsOffSince_us_ > shown_.time_us) {
    handsOffSince_us_ = shown_.time_us;
  }
  handsOff_->setVisible(lies && off);
  handsOffText_->setVisible(lies);
  if (!lies) {
    return;
  }
  if (!off) {
    setText(handsOffText_, tr("Within the limits. Open the jaw and remove the clip."));
    return;
  }
  const double gone_s = static_cast<double>(shown_.time_us - handsOffSince_us_) * 1e-6;
  const double share = limits.handsOff_s > 0.0 ? std::min(1.0, gone_s / limits.handsOff_s) : 1.0;
  handsOff_->setValue(static_cast<int>(share * kBar));
  setText(
      handsOffText_,
      share < 1.0
          ? tr("Hands off: %1 of %2 s").arg(std::floor(gone_s), 0, 'f', 0).arg(limits.handsOff_s, 0, 'f', 0)
          : tr("The position holds. Check the blood flow before you end."));
}

void DetorsionPanel::showWarning() {
  const HollowPose& pose = shown_.hollow;
  const double strength = 1.0 - kIschaemicWeakness * std::min(1.0, pose.reading.dose);
  const auto marks = pose.marks.begin();
  const auto torn = std::count_if(marks, marks + pose.markCount, [](const TissueMark& m) { return m.torn; });
  const std::int64_t bruised = pose.markCount - torn;
  QString text;
  if (torn > 0 || pose.leaking) {
    text = tr("The wall is torn: the content leaks.");
  } else if (pose.jaw_Pa > detorsion_.limits.bruise_Pa * strength) {
    text = tr("The jaw presses too hard: %1 kPa.").arg(pose.jaw_Pa * 1e-3, 0, 'f', 0);
  } else if (bruised > 0) {
    text = tr("Bruises of the wall: %1").arg(bruised);
  }
  warning_->setVisible(!text.isEmpty());
  setText(warning_, text);
}

}  // namespace torsio::gui
