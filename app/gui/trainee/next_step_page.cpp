// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/next_step_page.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/domain/ids.h"
#include "sim/core/angle.h"

namespace torsio::gui {

namespace {

constexpr int kStepsWidest = 1080;
constexpr int kFactsWidth = 32 * kSpace;  // of one line beside a module; longer text takes several
constexpr QSize kBestPicture{240, 150};

const RunPhase* presentPhase(const RunPlan& plan) {
  const auto open = std::find_if(plan.phases.begin(), plan.phases.end(),
                                 [](const RunPhase& p) { return p.done_us < p.duration_us; });
  return open == plan.phases.end() ? nullptr : &*open;
}

QString iconOf(StepState state) {
  switch (state) {
    case StepState::kLocked:
      return QStringLiteral("lock");
    case StepState::kMastered:
      return QStringLiteral("check");
    case StepState::kUsedUp:
      return QStringLiteral("warning");
    case StepState::kOpen:
      break;
  }
  return QStringLiteral("play");
}

}  // namespace

NextStepPage::NextStepPage(ShellContext& context, StationDesk& desk, QWidget* parent)
    : Page(context, parent), desk_(desk), theme_(&theme(context.themeKind())) {
  const PageColumn page = pageColumn(this, kStepsWidest);
  heading_ = page.heading;
  consent_ = linkButton(this);
  heading_->addAction(consent_);
  connect(consent_, &QPushButton::clicked, this, [this] { shell().open(PageId::kConsent); });
  notices_ = new QVBoxLayout;
  notices_->setSpacing(kSpace);
  page.column->addLayout(notices_);
  visitor_ = named(new Card(QString(), this), "visitor");
  visitorWords_ = plainLabel(visitor_);
  tryTwist_ = named(primaryButton(visitor_), "tryTwist");
  auto* visitorRow = new QHBoxLayout;
  visitorRow->addWidget(visitorWords_, 1);
  visitorRow->addWidget(tryTwist_);
  visitor_->content()->addLayout(visitorRow);
  page.column->addWidget(visitor_);
  connect(tryTwist_, &QPushButton::clicked, this,
          [this] { begin(steps_.modules.front().module.id, false, true); });
  next_ = new Card(QString(), this);
  nextContent_ = new QVBoxLayout;
  nextContent_->setSpacing(kSpace);
  next_->content()->addLayout(nextContent_);
  page.column->addWidget(next_);
  session_ = named(new Card(QString(), this), "session");
  QHBoxLayout* told = rowOf({}, 2 * kSpace);
  bestPicture_ = named(new QLabel(session_), "bestPicture");
  sessionWords_ = named(plainLabel(session_), "sessionWords");
  lookAtBest_ = linkButton(session_);
  told->addWidget(bestPicture_);
  told->addWidget(sessionWords_, 1);
  told->addWidget(lookAtBest_);
  session_->content()->addLayout(told);
  page.column->addWidget(session_);
  connect(lookAtBest_, &QPushButton::clicked, this, [this] {
    if (const std::optional<BestTwist>& best = desk_.story.best()) {
      shell().open(PageId::kDebrief, toQString(best->trialId));
    }
  });
  listTitle_ = plainLabel(this, "subheading");
  page.column->addWidget(listTitle_);
  modules_ = new QVBoxLayout;
  modules_->setSpacing(kSpace);
  page.column->addLayout(modules_);
  page.column->addStretch(1);
}

void NextStepPage::enter(const QVariant&) {
  attempt(shell(), [&] {
    desk_.story.begin(shell().session().now_us());
    for (RecoveredTrial& trial : recoverInterrupted(shell().session())) {
      recovered_.push_back(std::move(trial));
    }
    steps_ = nextSteps(shell().session(), shell().session().actor().personId);
    fill();
    focusStart();
  });
}

/// The new button is not visible before layout; hidden widgets take no focus from a visible page.
void NextStepPage::focusStart() {
  if (QPushButton* start = startButton()) {
    start->show();
    start->setFocus();
  }
}

void NextStepPage::retranslate() {
  fill();
}

void NextStepPage::applyTheme(const Theme& theme) {
  theme_ = &theme;
  fill();
}

void NextStepPage::begin(const ModuleId& moduleId, bool graded, bool guided) {
  desk_.chosen = true;
  desk_.moduleId = moduleId;
  desk_.graded = graded;
  desk_.guided = guided;
  if (!steps_.recordingAllowed) {
    shell().open(PageId::kConsent, QVariant::fromValue(PageId::kDeviceCheck));
    return;
  }
  shell().open(desk_.readiness ? PageId::kBriefing : PageId::kDeviceCheck);
}

void NextStepPage::fillNotices() {
  emptyLayout(notices_);
  const auto add = [this](const QString& text, const QString& button, PageId page, const QVariant& argument) {
    auto* frame = named(new QFrame(this), "card");
    auto* row = new QHBoxLayout(frame);
    auto* mark = new QLabel(frame);
    showIcon(mark, QStringLiteral("info"), theme_->accent);
    auto* words = plainLabel(frame);
    words->setText(text);
    auto* go = linkButton(frame);
    go->setText(button);
    connect(go, &QPushButton::clicked, this, [this, page, argument] { shell().open(page, argument); });
    row->addWidget(mark, 0, Qt::AlignVCenter);
    row->addWidget(words, 1);
    row->addWidget(go);
    notices_->addWidget(frame);
  };
  for (const RecoveredTrial& trial : recovered_) {
    add(tr("Your run of %1 was interrupted. The %2 that were recorded count as training time; no attempt was "
           "used.")
            .arg(shownTime(trial.startedUtc_us), clockTenths(trial.recorded_s)),
        tr("Look at it"), PageId::kDebrief, toQString(trial.trialId));
  }
  if (steps_.unreadRemarks > 0) {
    add(tr("%n unread remark(s) from physicians", nullptr, static_cast<int>(steps_.unreadRemarks)),
        tr("Read"), PageId::kRemarks, {});
  }
}

bool NextStepPage::forVisitor() const {
  return steps_.demonstration && desk_.story.runs() == 0 && !steps_.allPhasesDone &&
         !steps_.modules.empty() && steps_.modules.front().module.mode == AttemptMode::kPractice;
}

void NextStepPage::fillVisitor() {
  visitor_->setVisible(forVisitor());
  if (!forVisitor()) {
    return;
  }
  visitor_->setTitle(tr("New here?"));
  visitorWords_->setText(tr("This simulated trainee has practised already. Begin with the first exercise, "
                            "\u201c%1\u201d. It shows one movement after the other and takes two "
                            "minutes; nothing is graded.")
                             .arg(toQString(Text(steps_.modules.front().module.title))));
  tryTwist_->setText(tr("&Try a first twist"));
}

void NextStepPage::fillNext() {
  emptyLayout(nextContent_);
  auto* title = plainLabel(next_, "heading");
  nextContent_->addWidget(title);
  auto* quiet = plainLabel(next_, "quiet");
  const RunPhase* phase = presentPhase(steps_.plan);
  const bool real = phase != nullptr && phase->arm == PhaseKind::kReal;
  if (steps_.enrolmentId.empty() || !steps_.hasCurriculum) {
    title->setText(tr("Nothing is planned for you yet"));
    quiet->setText(steps_.enrolmentId.empty()
                       ? tr("You are not in a cohort yet. An administrator has to add you; free practice is "
                            "available meanwhile.")
                       : tr("Your cohort has no curriculum yet. Free practice is available meanwhile."));
    nextContent_->addWidget(quiet);
    return;
  }
  if (steps_.allPhasesDone || (!steps_.next && !real)) {
    title->setText(steps_.allPhasesDone ? tr("Your training time is complete")
                                        : tr("Nothing is available now"));
    quiet->setText(tr("View your trend, or save your transcript."));
    nextContent_->addWidget(quiet);
    return;
  }
  auto* row = new QHBoxLayout;
  auto* texts = new QVBoxLayout;
  texts->setSpacing(kSpace / 2);
  row->addLayout(texts, 1);
  if (real) {
    title->setText(tr("On the real arm: %1").arg(toQString(phase->label)));
    quiet->setText(tr("%1 left. The timer logs your training time; nothing is recorded.")
                       .arg(StationLabels::minutes(phase->duration_us - phase->done_us)));
    texts->addWidget(quiet);
  } else {
    const ModuleStep& step = steps_.modules[*steps_.next];
    title->setText(toQString(Text(step.module.title)));
    QStringList facts;
    if (phase != nullptr) {
      facts << toQString(phase->label);
    }
    facts << tr("Takes at most %1").arg(StationLabels::minutes(step.needed_us))
          << StationLabels::lastResult(step);
    if (step.attemptsLeft) {
      facts << (*step.attemptsLeft == 1
                    ? tr("Last attempt")
                    : tr("%n attempt(s) left", nullptr, static_cast<int>(*step.attemptsLeft)));
    }
    quiet->setText(facts.join(QStringLiteral("  \u00b7  ")));
    texts->addWidget(quiet);
    auto* goal = plainLabel(next_);
    goal->setText(StationLabels::why(step));
    goal->setToolTip(step.competence ? StationLabels::competenceErrors(*step.competence) : QString());
    texts->addWidget(goal);
    auto* then = plainLabel(next_, "quiet");
    then->setText(StationLabels::unlocks(step));
    then->setVisible(!step.unlocks.empty());
    texts->addWidget(then);
  }
  const ModuleId id = steps_.next ? steps_.modules[*steps_.next].module.id : ModuleId();
  const bool graded = steps_.next && steps_.modules[*steps_.next].module.mode == AttemptMode::kGraded;
  auto* start = named(forVisitor() ? new QPushButton(next_) : primaryButton(next_), "begin");
  start->setText(real ? tr("&Begin on the real arm") : graded ? tr("&Begin graded run") : tr("&Begin"));
  connect(start, &QPushButton::clicked, this, [this, id, graded] { begin(id, graded); });
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(start);
  if (graded) {
    auto* practise = named(new QPushButton(tr("&Practise first"), next_), "practise");
    connect(practise, &QPushButton::clicked, this, [this, id] { begin(id, false); });
    buttons->addWidget(practise);
  }
  buttons->addStretch(1);
  row->addLayout(buttons);
  nextContent_->addLayout(row);
}

void NextStepPage::fillSession() {
  const SessionStory& story = desk_.story;
  session_->setVisible(story.runs() > 0);
  session_->setTitle(tr("This session"));
  QStringList lines{tr("%n run(s)", nullptr, static_cast<int>(story.runs())) + QStringLiteral("  \u00b7  ") +
                    tr("%n twist(s)", nullptr, static_cast<int>(story.twists())) +
                    QStringLiteral("  \u00b7  ") + tr("%1 released on target").arg(story.onTarget())};
  const std::optional<BestTwist>& best = story.best();
  if (best) {
    lines << tr("Your best twist: %1\u00b0 off a target of %2\u00b0, at %3 of \u201c%4\u201d.")
                 .arg(numberText(degrees(best->error_rad), 1), numberText(degrees(best->twist.target_rad), 0),
                      clockTenths(best->twist.when.to_s), toQString(Text(best->moduleTitle)));
  }
  sessionWords_->setText(lines.join(QLatin1Char('\n')));
  lookAtBest_->setText(tr("Look at it"));
  lookAtBest_->setVisible(best.has_value());
  const bool pictured = best && !best->picture.isNull();
  bestPicture_->setVisible(pictured);
  if (pictured) {
    bestPicture_->setAccessibleName(tr("The organ at your best twist"));
    bestPicture_->setPixmap(QPixmap::fromImage(
        best->picture.scaled(kBestPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
  }
}

void NextStepPage::addModule(const ModuleStep& step) {
  auto* frame = named(new QFrame(this), "card");
  frame->setAccessibleName(toQString(Text(step.module.title)));
  auto* row = new QHBoxLayout(frame);
  row->setContentsMargins(2 * kSpace, kSpace + 2, 2 * kSpace, kSpace + 2);
  row->setSpacing(2 * kSpace);
  const bool locked = step.state == StepState::kLocked;
  auto* mark = new QLabel(frame);
  showIcon(mark, iconOf(step.state),
           step.state == StepState::kMastered ? theme_->good
           : locked                           ? theme_->quietText
           : step.state == StepState::kUsedUp ? theme_->caution
                                              : theme_->accent);
  row->addWidget(mark, 0, Qt::AlignTop);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(2);
  auto* title = plainLabel(frame, locked ? "quiet" : nullptr);
  title->setText(
      tr("%1  \u00b7  %2").arg(toQString(Text(step.module.title)), StationLabels::state(step.state)));
  texts->addWidget(title);
  auto* why = named(plainLabel(frame, "quiet"), "why");
  why->setText(StationLabels::why(step));
  why->setToolTip(step.competence ? StationLabels::competenceErrors(*step.competence) : QString());
  why->setVisible(!why->text().isEmpty());
  texts->addWidget(why);
  row->addLayout(texts, 1);
  auto* facts = plainLabel(frame, "quiet");
  facts->setAlignment(Qt::AlignRight | Qt::AlignTop);
  facts->setText(step.last ? StationLabels::lastResult(step) : locked ? QString() : tr("Not tried yet"));
  if (const int line = facts->fontMetrics().horizontalAdvance(facts->text()) + kSpace; line <= kFactsWidth) {
    facts->setMinimumWidth(line);
  }
  row->addWidget(facts, 0, Qt::AlignTop);
  const ModuleId id = step.module.id;
  if (step.last) {
    auto* trend = linkButton(frame);
    trend->setText(tr("Trend"));
    connect(trend, &QPushButton::clicked, this, [this, id] { shell().open(PageId::kTrend, toQString(id)); });
    row->addWidget(trend, 0, Qt::AlignTop);
  }
  auto* start = new QPushButton(tr("Begin"), frame);
  start->setAccessibleName(tr("Begin %1").arg(toQString(Text(step.module.title))));
  start->setEnabled(!locked && !steps_.allPhasesDone);
  if (locked) {
    start->setToolTip(why->text());
  }
  const bool graded = step.module.mode == AttemptMode::kGraded && step.state != StepState::kUsedUp;
  connect(start, &QPushButton::clicked, this, [this, id, graded] { begin(id, graded); });
  row->addWidget(start, 0, Qt::AlignTop);
  modules_->addWidget(frame);
}

QPushButton* NextStepPage::startButton() const {
  return forVisitor() ? tryTwist_ : findChild<QPushButton*>(QStringLiteral("begin"));
}

void NextStepPage::fill() {
  const QPushButton* before = startButton();
  const bool atStart = before != nullptr && window()->focusWidget() == before;
  QString sentence = tr("Trainee %1").arg(toQString(steps_.traineeCode));
  if (steps_.exposureTotal_us > 0) {
    sentence = tr("%1  \u00b7  %2 of %3 trained")
                   .arg(sentence, StationLabels::minutes(steps_.exposureDone_us),
                        StationLabels::minutes(steps_.exposureTotal_us));
  }
  const QString place = toQString(Text(steps_.cohortName));
  heading_->setTexts(place.isEmpty() ? tr("Welcome") : place, sentence);
  consent_->setText(tr("&Consent"));
  next_->setTitle(tr("Next"));
  listTitle_->setText(tr("All modules"));
  listTitle_->setVisible(!steps_.modules.empty());
  fillNotices();
  fillVisitor();
  fillNext();
  fillSession();
  emptyLayout(modules_);
  for (const ModuleStep& step : steps_.modules) {
    addModule(step);
  }
  // The buttons are rebuilt: restores the focus.
  if (atStart) {
    focusStart();
  }
}

}  // namespace torsio::gui
