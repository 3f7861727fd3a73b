// SPDX-License-Identifier: GPL-3.0-or-later
// Of RunPage: the widgets it is made of.
#include <algorithm>
#include <initializer_list>

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/simulator/validity_button.h"
#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/run_page.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/tracker_panel.h"
#include "app/gui/trainee/twist_guide.h"
#include "app/gui/widgets/angle_dial.h"
#include "app/gui/widgets/card.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/level_bar.h"
#include "sim/core/load_decimals.h"

namespace torsio::gui {

namespace {

constexpr int kPanelWidth = 316;
constexpr int kTrackerWidth = 620;
constexpr double kCountdown_pt = 30.0;
constexpr double kNotice_pt = 64.0;

/// As high as what it holds where there is room, so that what follows stands close below; lower where there
/// is none.
class ShrinkingArea : public QScrollArea {
 public:
  explicit ShrinkingArea(QWidget* parent) : QScrollArea(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  }
  [[nodiscard]] QSize sizeHint() const override {
    const QSize held = widget()->sizeHint();
    const int high = widget()->hasHeightForWidth() ? widget()->heightForWidth(width()) : held.height();
    return {held.width(), std::max(held.height(), high)};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
      updateGeometry();
    }
    return QScrollArea::eventFilter(watched, event);
  }
};

}  // namespace

QWidget* RunPage::createNotice() {
  auto* ground = new QWidget(this);
  auto* column = new QVBoxLayout(ground);
  column->setContentsMargins(6 * kSpace, 6 * kSpace, 6 * kSpace, 6 * kSpace);
  column->setSpacing(2 * kSpace);
  noticeTitle_ = plainLabel(ground, "heading");
  noticeFigure_ = plainLabel(ground);
  makeHuge(noticeFigure_, kNotice_pt);
  noticeText_ = plainLabel(ground, "quiet");
  goOn_ = primaryButton(ground);
  goOn_->setObjectName(QStringLiteral("goOn"));
  column->addStretch(2);
  for (QLabel* label : {noticeTitle_, noticeFigure_, noticeText_}) {
    label->setAlignment(Qt::AlignHCenter);
    column->addWidget(label);
  }
  column->addWidget(goOn_, 0, Qt::AlignHCenter);
  tracker_ = new TrackerPanel(shell(), ground);
  tracker_->setFixedWidth(kTrackerWidth);
  tracker_->hide();
  column->addSpacing(2 * kSpace);
  column->addWidget(tracker_, 0, Qt::AlignHCenter);
  column->addStretch(3);
  connect(tracker_, &TrackerPanel::lettingGo, this, [this] { endTracked(TrialOutcome::kCompleted); });
  connect(goOn_, &QPushButton::clicked, this, [this] {
    if (waiting_) {
      cancelWaiting();
    } else if (runSession_) {
      follow(runSession_->resume());
    }
  });
  return ground;
}

QVBoxLayout* RunPage::createHeading(QWidget* panel) {
  auto* column = new QVBoxLayout;
  column->setSpacing(kSpace);
  title_ = plainLabel(panel, "subheading");
  mode_ = plainLabel(panel, "quiet");
  validity_ = new ValidityButton(panel);
  auto* heading = new QHBoxLayout;
  heading->addWidget(title_, 1);
  heading->addWidget(validity_, 0, Qt::AlignTop);
  column->addLayout(heading);
  guideMe_ = linkButton(panel);
  guideMe_->setObjectName(QStringLiteral("guideMe"));
  guideMe_->setStyleSheet(QStringLiteral("padding: 0;"));  // stands in line with the sentence beside it
  auto* kind = new QHBoxLayout;
  kind->addWidget(mode_, 1);
  kind->addWidget(guideMe_);
  column->addLayout(kind);
  return column;
}

void RunPage::createTime(QWidget* panel) {
  time_ = new Card(QString(), panel);
  countdown_ = plainLabel(time_);
  countdown_->setObjectName(QStringLiteral("countdown"));
  makeHuge(countdown_, kCountdown_pt);
  progress_ = new QProgressBar(time_);
  progress_->setObjectName(QStringLiteral("timeLeft"));
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  phase_ = plainLabel(time_, "quiet");
  timeName_ = plainLabel(time_, "quiet");
  auto* left = new QHBoxLayout;
  left->addWidget(countdown_);
  left->addWidget(timeName_, 1, Qt::AlignBottom);
  time_->content()->addLayout(left);
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, phase_}) {
    time_->content()->addWidget(widget);
  }
}

void RunPage::createAngle(QWidget* panel) {
  angle_ = new Card(QString(), panel);
  dial_ = new AngleDial(angle_);
  angle_->content()->addWidget(dial_, 0, Qt::AlignHCenter);
  goal_ = plainLabel(angle_, "quiet");
  goal_->setObjectName(QStringLiteral("goal"));
  goal_->setAlignment(Qt::AlignHCenter);
  angle_->content()->addWidget(goal_);
  count_ = plainLabel(angle_, "subheading");
  count_->setObjectName(QStringLiteral("twistCount"));
  count_->setAlignment(Qt::AlignHCenter);
  angle_->content()->addWidget(count_);
}

QLayout* RunPage::createButtons(QWidget* side) {
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(kSpace + 4, kSpace, kSpace + 4, kSpace + 4);  // as wide as the cards above
  buttons->setSpacing(kSpace);
  rest_ = new QPushButton(side);
  rest_->setObjectName(QStringLiteral("rest"));
  stop_ = new QPushButton(side);
  stop_->setObjectName(QStringLiteral("stop"));
  buttons->addWidget(rest_);
  buttons->addWidget(stop_);
  connect(rest_, &QPushButton::clicked, this, [this] {
    if (!runSession_ || !runSession_->rest()) {
      return;
    }
    endRecording(TrialOutcome::kCompleted);
    tick();
  });
  connect(stop_, &QPushButton::clicked, this, &RunPage::askToStop);
  return buttons;
}

QWidget* RunPage::createPanel() {
  // What must always be in reach stands below; what is taller than a small screen scrolls.
  auto* side = new QWidget(this);
  side->setFixedWidth(kPanelWidth);
  auto* whole = new QVBoxLayout(side);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  auto* scroll = new ShrinkingArea(side);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* panel = new QWidget;
  scroll->setWidget(panel);
  whole->addWidget(scroll);
  auto* told = new QVBoxLayout;
  told->setContentsMargins(kSpace + 4, kSpace / 2, kSpace + 4, 0);
  warning_ = plainLabel(side, "caution");
  warning_->setObjectName(QStringLiteral("warning"));
  warning_->hide();
  verdict_ = plainLabel(side);
  verdict_->setObjectName(QStringLiteral("verdict"));
  verdict_->hide();
  cue_ = plainLabel(side, "quiet");
  cue_->setObjectName(QStringLiteral("cue"));
  told->addWidget(warning_);
  told->addWidget(verdict_);
  told->addWidget(cue_);
  whole->addLayout(told);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(kSpace + 4, kSpace + 4, kSpace + 4, 0);
  column->setSpacing(kSpace);
  column->addLayout(createHeading(panel));
  createTime(panel);
  column->addWidget(time_);
  createAngle(panel);
  column->addWidget(angle_);
  detorsion_ = new DetorsionPanel(panel);
  detorsion_->steer(scene_->controller());
  column->addWidget(detorsion_);
  load_ = new Card(QString(), panel);
  torque_ = new LevelBar(QString(), QString(), kTorqueDecimals, load_);
  force_ = new LevelBar(QString(), QString(), kForceDecimals, load_);
  load_->content()->addWidget(torque_);
  load_->content()->addWidget(force_);
  column->addWidget(load_);
  guide_ = new TwistGuide(scene_);
  guide_->setObjectName(QStringLiteral("guide"));
  connect(guideMe_, &QPushButton::clicked, this, &RunPage::guide);
  column->addStretch(1);
  whole->addStretch(1);
  whole->addLayout(createButtons(side));
  return side;
}

}  // namespace torsio::gui
