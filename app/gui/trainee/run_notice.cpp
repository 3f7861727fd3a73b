// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/run_notice.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/connectors/built_in.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/tracker_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/training/training_run.h"

namespace torsio::gui {

namespace {

constexpr int kTrackerWidth = 620;
constexpr double kFigure_pt = 64.0;

}  // namespace

RunNotice::RunNotice(ShellContext& shell, QWidget* parent)
    : QWidget(parent),
      title_(plainLabel(this, "heading")),
      figure_(plainLabel(this)),
      text_(plainLabel(this, "quiet")),
      goOn_(primaryButton(this)),
      tracker_(new TrackerPanel(shell, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6 * kSpace, 6 * kSpace, 6 * kSpace, 6 * kSpace);
  column->setSpacing(2 * kSpace);
  makeHuge(figure_, kFigure_pt);
  goOn_->setObjectName(QStringLiteral("goOn"));
  column->addStretch(2);
  for (QLabel* label : {title_, figure_, text_}) {
    label->setAlignment(Qt::AlignHCenter);
    column->addWidget(label);
  }
  column->addWidget(goOn_, 0, Qt::AlignHCenter);
  tracker_->setFixedWidth(kTrackerWidth);
  tracker_->hide();
  column->addSpacing(2 * kSpace);
  column->addWidget(tracker_, 0, Qt::AlignHCenter);
  column->addStretch(3);
  connect(goOn_, &QPushButton::clicked, this, &RunNotice::goOn);
}

void RunNotice::say(const QString& title, const QString& figure, const QString& text, const QString& button) {
  title_->setText(title);
  figure_->setText(figure);
  figure_->setVisible(!figure.isEmpty());
  text_->setText(text);
  goOn_->setText(button);
  goOn_->setVisible(!button.isEmpty());
}

void RunNotice::showNoRun(bool inFile) {
  tracker_->hide();
  if (inFile) {
    say(tr("Your run is safe"), {},
        tr("The database did not answer. The recording is kept, on this computer where need be; as soon as "
           "the "
           "database answers you find its debrief on the page \u201c"
           "Debrief\u201d."),
        {});
  } else {
    say(tr("No run in progress"), {}, tr("Choose a module on the page \u201cMy next step\u201d."), {});
  }
}

bool RunNotice::showRun(const TrainingRun& run, Device device, bool tracked) {
  const bool real = run.phase().arm == PhaseKind::kReal;
  tracker_->setVisible(kTrackerBuiltIn && real && device != Device::kFetchedBeforeStart);
  tracker_->follow(tracked);
  setLook(goOn_, "primary", device == Device::kReady);
  if (device != Device::kReady) {
    const bool before = device == Device::kFetchedBeforeStart;
    say(tr("Getting the haptic device ready"), {},
        before ? tr("This takes a few seconds. Your time has not begun yet.")
               : tr("This takes a few seconds. Your training clock is paused."),
        before ? tr("&Cancel") : QString());
    return true;
  }
  if (run.state() == RunState::kResting) {
    say(tr("Rest"), clockTimeLeft(run.restLeft_us()),
        tr("Your training clock is paused. Training resumes automatically when the rest is used up."),
        tr("&Go on now"));
    return true;
  }
  if (run.state() == RunState::kHandOver) {
    say(real ? tr("Go to the real arm") : tr("Come to the simulator"), clockTimeLeft(run.handOverLeft_us()),
        tr("The next phase starts automatically: %1").arg(toQString(run.phase().label)), tr("I am &ready"));
    return true;
  }
  if (real) {
    say(tr("Train on the real arm"), clockTimeLeft(run.remainingInPhase_us()),
        tracked ? tr("This timer logs your training time. The tracker records the instrument.")
                : tr("This timer logs your training time. Nothing is recorded."),
        {});
  }
  return real;
}

}  // namespace torsio::gui
