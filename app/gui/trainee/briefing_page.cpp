// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/briefing_page.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStringList>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/recording/recorded_run.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/load_decimals.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"

namespace torsio::gui {

namespace {

/// Returns the untwisting of a module; null: a twist to a target.
std::shared_ptr<const Detorsion> untwistingOf(const std::filesystem::path& assets,
                                              const TrainingModule& module) {
  try {
    for (const PatternDescription& one : readSceneFile(assets, module.sceneId).patterns) {
      if (one.pattern.id == module.patternId) {
        return one.pattern.detorsion;
      }
    }
  } catch (const Error&) {
    // A scene of another installation: the view beside the text reports the problem.
  }
  return nullptr;
}

QStringList twist(const TrainingModule& module) {
  QStringList task{
      BriefingPage::tr("Twist to %1\u00B0 and release within %2\u00B0.")
          .arg(numberText(degrees(module.targetAngle_rad), 0), numberText(degrees(module.tolerance_rad), 0))};
  if (module.hold_us > 0) {
    task << BriefingPage::tr("Hold for %1 s before releasing.")
                .arg(numberText(static_cast<double>(module.hold_us) * 1e-6, 1));
  }
  if (module.leastTwists > 1) {
    task << BriefingPage::tr("Twist at least %n time(s).", nullptr, static_cast<int>(module.leastTwists));
  }
  return task;
}

constexpr int kBriefingWidth = 340;
constexpr double kSlowMotion = 0.25;

/// Describes the hand's present action, for a viewer.
QString presentAction(const LiveState& state, const TrainingModule& module, bool undone) {
  switch (state.phase) {
    case ExercisePhase::kTracking:
      return state.times.released_us >= 0 ? BriefingPage::tr("the organ is released, and the jaw draws back.")
                                          : BriefingPage::tr("the jaw goes to the marked band.");
    case ExercisePhase::kContact:
      return BriefingPage::tr("it touches, and the jaw closes.");
    case ExercisePhase::kTwisting:
      if (undone) {
        return BriefingPage::tr("it holds the turned part and turns it back.");
      }
      return std::abs(state.response.angle_rad - module.targetAngle_rad) <= module.tolerance_rad
                 ? BriefingPage::tr("on target; it holds still before it releases.")
                 : BriefingPage::tr("one even turn, slower towards the target.");
    case ExercisePhase::kReleased:
      return undone ? BriefingPage::tr("hands off: does it stay untwisted, does blood flow?")
                    : BriefingPage::tr("the jaw opens gently; the organ turns back by itself.");
  }
  return {};
}

/// Describes the start and the goal of an untwisting. The initial angle is drawn when it starts.
QStringList untwistingTask(const Detorsion& detorsion) {
  const DetorsionLimits& limits = detorsion.limits;
  const auto figure = [](double value) { return numberText(value, 0); };
  const double least_deg = degrees(detorsion.start.least_rad);
  const double most_deg = degrees(detorsion.start.most_rad);
  QStringList task;
  if (!detorsion.briefing.empty()) {
    task << toQString(Text(detorsion.briefing));
  }
  task << (most_deg > least_deg
               ? BriefingPage::tr("The organ came twisted by %1\u00b0 to %2\u00b0. Untwist it.")
                     .arg(figure(least_deg), figure(most_deg))
               : BriefingPage::tr("The organ came twisted by %1\u00b0. Untwist it.").arg(figure(most_deg)));
  const QString flow = figure(100.0 * limits.flow);
  task << BriefingPage::tr(
              "Done: at most %1\u00b0 left and blood flow of %2 % or more, for %3 s with hands off.")
              .arg(figure(degrees(limits.residual_rad)), flow, figure(limits.handsOff_s));
  if (!detorsion.wall.thickness_m.empty()) {
    task << BriefingPage::tr("The lumen must be open to %1 %.").arg(figure(100.0 * limits.patency));
  }
  task << BriefingPage::tr("The jaw bruises the wall from %1 kPa; tissue without blood bears less.")
              .arg(figure(limits.bruise_Pa * 1e-3));
  task << BriefingPage::tr("Meanwhile %1 s of the tissue pass each second.").arg(figure(detorsion.timeScale));
  return task;
}

}  // namespace

BriefingPage::BriefingPage(ShellContext& context, StationDesk& desk, QWidget* parent)
    : Page(context, parent),
      desk_(desk),
      scene_(named(new LiveScene(desk.loader, context.assets(), this), "scene")) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  left->addWidget(scene_, 1);
  left->addLayout(createBar());
  row->addLayout(left, 1);

  auto* panel = new QWidget(this);
  panel->setFixedWidth(kBriefingWidth);
  QVBoxLayout* column = columnOf(panel, {2 * kSpace, 2 * kSpace, 2 * kSpace, 2 * kSpace}, kSpace + 4);
  title_ = plainLabel(panel, "heading");
  mode_ = plainLabel(panel, "quiet");
  what_ = new Card(QString(), panel);
  task_ = plainLabel(what_);
  goals_ = plainLabel(what_);
  what_->content()->addWidget(task_);
  what_->content()->addWidget(goals_);
  how_ = new Card(QString(), panel);
  hints_ = plainLabel(how_);
  how_->content()->addWidget(hints_);
  able_ = new Card(QString(), panel);
  design_ = named(plainLabel(able_), "competence");
  errors_ = named(plainLabel(able_, "quiet"), "competence-errors");
  able_->content()->addWidget(design_);
  able_->content()->addWidget(errors_);
  start_ = named(primaryButton(panel), "start");
  back_ = new QPushButton(panel);
  // The buttons below are always visible; longer text scrolls on a small screen.
  auto* words = new QWidget(panel);
  QVBoxLayout* reading = columnOf(words, {}, kSpace + 4);
  for (QWidget* part : std::initializer_list<QWidget*>{title_, mode_, what_, how_, able_}) {
    reading->addWidget(part);
  }
  reading->addStretch(1);
  auto* scroll = new QScrollArea(panel);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(words);
  column->addWidget(scroll, 1);
  column->addWidget(start_);
  column->addWidget(back_);
  row->addWidget(panel);

  connect(start_, &QPushButton::clicked, this, [this] { shell().open(PageId::kRun); });
  connect(back_, &QPushButton::clicked, this, [this] { shell().open(PageId::kNextStep); });
  connect(again_, &QPushButton::clicked, this, &BriefingPage::showExpert);
  connect(slow_, &QPushButton::toggled, this, [this](bool slow) {
    const TrialPlayback* expert = scene_->controller().playback();
    if (slow && expert != nullptr && expert->position_us() >= expert->duration_us()) {
      showExpert();  // nothing left to slow down
    }
  });
  connect(scene_, &LiveScene::shown, this, &BriefingPage::follow);
  connect(&scene_->controller(), &SimulationController::sceneChanged, this, [this] {
    fill();
    if (!asked_) {
      showExpert();
    }
  });
  connect(&scene_->controller(), &SimulationController::failed, this,
          [this](const QString& happened, const QString&, const QString&) { shell().notify(happened); });
}

QLayout* BriefingPage::createBar() {
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(2 * kSpace, kSpace, 2 * kSpace, kSpace);
  bar->setSpacing(kSpace);
  caption_ = named(plainLabel(this, "quiet"), "caption");
  slow_ = named(new QPushButton(this), "slow");
  slow_->setCheckable(true);
  again_ = named(new QPushButton(this), "again");
  bar->addWidget(caption_, 1);
  bar->addWidget(slow_);
  bar->addWidget(again_);
  return bar;
}

BriefingPage::~BriefingPage() = default;

void BriefingPage::enter(const QVariant& argument) {
  if (argument == QStringLiteral("later")) {
    return;
  }
  attempt(shell(), [&] {
    const NextSteps steps = nextSteps(shell().session(), shell().session().actor().personId);
    step_ = stepOf(steps, desk_.moduleId);
    competence_ = trend(shell().session(), steps.personId, desk_.moduleId).competence;
    // Before the first attempt, only the scene tells the task.
    competence_.untwisting =
        competence_.untwisting || untwistingOf(shell().assets(), step_.module) != nullptr;
    asked_ = false;
    seen_ = false;
    SceneRequest request;
    request.assets = shell().assets();
    request.id = step_.module.sceneId;
    request.pattern = step_.module.patternId;
    scene_->controller().load(request);
  });
  fill();
  start_->setFocus();
}

bool BriefingPage::leave() {
  scene_->controller().shutDown();
  return true;
}

void BriefingPage::showExpert() {
  if (scene_->controller().scene() == nullptr) {
    return;
  }
  if (TrialPlayback* expert = scene_->controller().playback(); asked_ && expert != nullptr) {
    expert->seek_us(0);
    expert->setPlaying(true);
    return;
  }
  asked_ = true;
  attempt(shell(), [&] {
    scene_->controller().openReplay(expertRun(*scene_->controller().scene(), step_.module.targetAngle_rad));
  });
}

void BriefingPage::follow(const LiveState& state) {
  TrialPlayback* expert = scene_->controller().playback();
  if (expert == nullptr) {
    return;
  }
  if (!seen_ && scene_->pictured()) {
    seen_ = true;  // nobody saw what was played meanwhile
    expert->seek_us(0);
    expert->setPlaying(true);
  }
  const double speed = slow_->isChecked() ? kSlowMotion : 1.0;
  if (expert->speed() != speed) {
    expert->setSpeed(speed);
  }
  const bool over = expert->position_us() >= expert->duration_us();
  const QString said = over ? tr("An expert's run: it is over. Watch again, or start.")
                            : tr("An expert's run: %1").arg(presentAction(state, step_.module, undone_));
  if (said != caption_->text()) {
    caption_->setText(said);
  }
}

void BriefingPage::retranslate() {
  fill();
}

void BriefingPage::applyTheme(const Theme& theme) {
  scene_->setTheme(theme);
}

void BriefingPage::fill() {
  const bool graded = desk_.graded;
  title_->setText(toQString(Text(step_.module.title)));
  mode_->setText(graded ? tr("Graded run: it counts as an attempt.") : tr("Practice: nothing is graded."));
  what_->setTitle(tr("Your task"));
  how_->setTitle(tr("How to do it"));
  const std::shared_ptr<const Detorsion> undone = untwistingOf(shell().assets(), step_.module);
  undone_ = undone != nullptr;
  QStringList task = undone ? untwistingTask(*undone) : twist(step_.module);
  if (step_.module.maxForce_N) {
    task << tr("Keep the force below %1 N.").arg(numberText(*step_.module.maxForce_N, kForceDecimals));
  }
  if (step_.module.maxTorque_Nm) {
    task << tr("Keep the torque below %1 N m.").arg(numberText(*step_.module.maxTorque_Nm, kTorqueDecimals));
  }
  task_->setText(task.join(QLatin1Char('\n')));
  QStringList goals;
  for (const RuleProgress& progress : step_.rules) {
    goals << toQString(progress.text());
  }
  goals_->setText(goals.isEmpty() ? QString() : tr("Mastered when:\n%1").arg(goals.join(QLatin1Char('\n'))));
  goals_->setVisible(!goals.isEmpty());
  able_->setTitle(tr("How competence is decided"));
  able_->setVisible(competence_.planned.attempts > 0);
  if (competence_.planned.attempts > 0) {
    design_->setText(StationLabels::competenceRule(competence_));
    errors_->setText(StationLabels::competenceErrors(competence_));
  }
  hints_->setText(
      tr("Bring the jaw to the marked band, close it, turn in one even movement, hold, and open the jaw "
         "gently.\nMouse: left button grips, dragging turns, the wheel moves nearer."));
  if (undone) {
    hints_->setText(
        tr("Grip the turned part and turn it back. Before you release to re-grip, set the clip, or it turns "
           "back. Let gas out first where it resists.\nC: clip. V: gas out. 1, 2, 3: look, feel the pulse, "
           "Doppler.\nMouse: left button grips, dragging turns, the wheel moves nearer."));
  }
  caption_->setText(undone ? tr("An expert untwists the same organ")
                           : tr("An expert's run of the same twist"));
  slow_->setText(tr("S&low motion"));
  again_->setText(tr("&Watch again"));
  start_->setText(graded ? tr("&Start the graded run") : tr("&Start"));
  back_->setText(tr("&Back"));
}

}  // namespace torsio::gui
