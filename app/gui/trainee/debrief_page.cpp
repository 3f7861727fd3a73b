// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/debrief_page.h"

#include <algorithm>
#include <memory>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/debrief_plot.h"
#include "app/gui/trainee/debrief_replay.h"
#include "app/gui/trainee/detorsion_card.h"
#include "app/gui/trainee/remarks_page.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"
#include "app/services/recording/competence.h"
#include "assessment/domain/ids.h"
#include "sim/core/load_decimals.h"

namespace torsio::gui {

namespace {

constexpr int kLaidOut_ms = 300;
constexpr std::size_t kMaxGapsShown = 5;

}  // namespace

DebriefPage::DebriefPage(ShellContext& context, StationDesk& desk, QWidget* parent)
    : Page(context, parent), desk_(desk), theme_(&theme(context.themeKind())) {
  const PageColumn page = pageColumn(this);
  heading_ = page.heading;
  verdict_ = named(plainLabel(this, "subheading"), "verdict");
  page.column->addWidget(verdict_);
  competence_ = named(plainLabel(this, "quiet"), "competence");
  page.column->addWidget(competence_);
  rates_ = named(new FoldedText(this), "rates");
  page.column->addWidget(rates_);

  targets_ = new Card(QString(), this);
  good_ = new Card(QString(), this);
  better_ = new Card(QString(), this);
  QHBoxLayout* cards = rowOf({}, 2 * kSpace);
  const auto into = [cards](Card* card) {
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpace);
    card->content()->addLayout(column);
    card->content()->addStretch(1);
    cards->addWidget(card, 1);
    return column;
  };
  checks_ = into(targets_);
  strengths_ = into(good_);
  weaknesses_ = into(better_);
  page.column->addLayout(cards);

  inThree_ = new Card(QString(), this);
  replay_ = named(new DebriefReplay(context.assets(), inThree_), "replay");
  inThree_->content()->addWidget(replay_, 1);
  trace_ = new Card(QString(), this);
  auto* tools = new QHBoxLayout;
  expert_ = named(new QCheckBox(trace_), "expert");
  expert_->setChecked(true);
  bookmark_ = new QPushButton(trace_);
  whole_ = new QPushButton(trace_);
  tools->addWidget(expert_);
  tools->addStretch(1);
  tools->addWidget(bookmark_);
  tools->addWidget(whole_);
  trace_->content()->addLayout(tools);
  plot_ = named(new DebriefPlot(trace_), "plot");
  trace_->content()->addWidget(plot_, 1);
  looks_ = new QBoxLayout(QBoxLayout::LeftToRight);
  looks_->setSpacing(2 * kSpace);
  looks_->addWidget(inThree_, 2);
  looks_->addWidget(trace_, 3);
  page.column->addLayout(looks_, 2);
  untwisting_ = new DetorsionCard(this);
  page.column->addWidget(untwisting_, 3);  // four stacked curves
  ask_ = new AskCard(context, this);
  page.column->addWidget(ask_);
  page.column->addStretch(0);

  again_ = new QPushButton(this);
  trend_ = named(new QPushButton(this), "trend");
  next_ = primaryButton(this);
  for (QPushButton* button : {again_, trend_, next_}) {
    heading_->addAction(button);
  }
  connectParts();
}

void DebriefPage::connectParts() {
  connect(expert_, &QCheckBox::toggled, plot_, &DebriefPlot::setExpertVisible);
  connect(expert_, &QCheckBox::toggled, replay_, &DebriefReplay::setExpertVisible);
  connect(replay_, &DebriefReplay::moved, this, &DebriefPage::setMoment);
  connect(plot_, &DebriefPlot::soughtTo, this, &DebriefPage::seek);
  connect(whole_, &QPushButton::clicked, plot_, &DebriefPlot::showAll);
  connect(bookmark_, &QPushButton::clicked, this, [this] { addBookmarkAt(moment_s_); });
  connect(plot_, &DebriefPlot::bookmarkWanted, this, &DebriefPage::addBookmarkAt);
  connect(ask_, &AskCard::asked, this, &DebriefPage::showBookmark);
  connect(next_, &QPushButton::clicked, this, [this] { shell().open(PageId::kNextStep); });
  connect(trend_, &QPushButton::clicked, this,
          [this] { shell().open(PageId::kTrend, toQString(debrief_.moduleId)); });
  connect(again_, &QPushButton::clicked, this, [this] {
    desk_.chosen = true;
    desk_.moduleId = debrief_.moduleId;
    shell().open(desk_.readiness ? PageId::kBriefing : PageId::kDeviceCheck);
  });
}

void DebriefPage::seek(double at_s) {
  if (haveReplay_) {
    replay_->seek(at_s);  // reports the resulting position
  } else {
    setMoment(std::clamp(at_s, 0.0, debrief_.duration_s));
  }
}

void DebriefPage::setMoment(double at_s) {
  moment_s_ = at_s;
  plot_->setPosition(at_s);
  ask_->setMoment(at_s);
}

void DebriefPage::enter(const QVariant& argument) {
  attempt(shell(), [&] {
    TrialId trialId = argument.toString().toStdString();
    if (trialId.empty()) {
      const auto all = attemptsOf(shell().session(), shell().session().actor().personId);
      for (const Attempt& attempt : all) {
        if (attempt.ended) {
          trialId = attempt.trialId;
        }
      }
    }
    if (trialId.empty()) {
      debrief_ = {};
      computing_ = false;
      fill();
      return;
    }
    if (trialId != debrief_.trialId) {
      compute(trialId);
    } else {
      readQuestions();  // there may be an answer
    }
  });
}

void DebriefPage::compute(const TrialId& trialId) {
  debrief_ = {};
  haveReplay_ = false;
  replay_->show(nullptr);
  computing_ = true;
  ask_->setRun({});
  fill();
  shell().run(
      this, tr("Analysing your run"),
      [trialId, assets = shell().assets(), scene = desk_.lastScene](SessionContext& session,
                                                                    const ProgressCallback&) {
        Debrief run = torsio::debrief(session, trialId, assets, scene.get());
        std::shared_ptr<DebriefRecordings> recordings = loadForDebrief(run, assets, scene);
        return std::pair(std::move(run), std::move(recordings));
      },
      [this](std::pair<Debrief, std::shared_ptr<DebriefRecordings>> analysed) {
        debrief_ = std::move(analysed.first);
        computing_ = false;
        plot_->setDebrief(debrief_);
        haveReplay_ = analysed.second != nullptr;
        replay_->show(std::move(analysed.second));
        setMoment(0.0);
        tellStory();
        untwisting_->setStory(debrief_.detorsion.value_or(DetorsionStory{}));
        fill();
        readQuestions();
        next_->setFocus();
      });
}

void DebriefPage::tellStory() {
  if (debrief_.realArm || !desk_.story.add(debrief_) || !haveReplay_) {
    return;
  }
  // The view must be laid out before it can be drawn at its size.
  QTimer::singleShot(kLaidOut_ms, this, [this, trialId = debrief_.trialId] {
    const std::optional<BestTwist>& best = desk_.story.best();
    if (best && best->trialId == trialId && debrief_.trialId == trialId) {
      desk_.story.setPicture(replay_->pictureAt(best->twist.when.to_s));
    }
  });
}

void DebriefPage::addBookmarkAt(double at_s) {
  if (debrief_.trialId.empty()) {
    return;
  }
  attempt(shell(), [&] {
    addBookmark(shell().session(), debrief_.trialId, at_s, {});
    showBookmark(at_s);
    shell().notify(tr("Bookmark at %1").arg(clockTenths(at_s)));
  });
}

void DebriefPage::showBookmark(double at_s) {
  debrief_.bookmarks.push_back({{}, at_s, {}});
  plot_->addBookmark(debrief_.bookmarks.back());
}

void DebriefPage::addAdvice(QVBoxLayout* column, const Text& advice) {
  if (!advice.empty()) {
    auto* words = named(plainLabel(this, "quiet"), "advice");
    words->setText(toQString(advice));
    column->addWidget(words);
  }
}

void DebriefPage::addLook(QVBoxLayout* column, const Seconds& when) {
  auto* look = named(linkButton(this), "look");
  look->setStyleSheet(QStringLiteral("padding: 1px 0;"));  // aligned with the sentence above
  look->setText(tr("Look at %1 to %2").arg(clockTenths(when.from_s), clockTenths(when.to_s)));
  connect(look, &QPushButton::clicked, this, [this, when] {
    plot_->show(when);
    seek(when.from_s);
  });
  column->addWidget(look, 0, Qt::AlignLeft);
}

void DebriefPage::addFinding(QVBoxLayout* column, const DebriefFinding& finding) {
  auto* words = plainLabel(this);
  words->setText(toQString(finding.text()));
  column->addWidget(words);
  addAdvice(column, finding.advice());
  addLook(column, finding.when);
}

void DebriefPage::addCheck(const TargetCheck& check, const std::optional<MissedTarget>& missed) {
  auto* mark = new QLabel(targets_);
  const bool lost = debrief_.verdict.torn && !check.value;
  showIcon(mark,
           lost           ? QStringLiteral("info")
           : check.passed ? QStringLiteral("check")
                          : QStringLiteral("close"),
           lost           ? theme_->quietText
           : check.passed ? theme_->good
                          : theme_->caution,
           16);
  mark->setAccessibleName(lost ? tr("not measured") : check.passed ? tr("passed") : tr("not passed"));
  auto* words = plainLabel(targets_);
  words->setText(toQString(check.text()));
  auto* told = new QVBoxLayout;
  told->addWidget(words);
  if (missed) {
    addAdvice(told, missed->advice);
    if (missed->when) {
      addLook(told, *missed->when);
    }
  }
  auto* row = new QHBoxLayout;
  row->addWidget(mark, 0, Qt::AlignTop);
  row->addLayout(told, 1);
  checks_->addLayout(row);
}

void DebriefPage::readQuestions() {
  attempt(shell(), [&] {
    const bool asked = !debrief_.realArm && debrief_.verdict.outcome != RunOutcome::kInterrupted;
    ask_->setRun(asked ? debrief_.trialId : TrialId());
  });
}

void DebriefPage::retranslate() {
  ask_->retranslate();
  plot_->retranslate();
  replay_->retranslate();
  untwisting_->retranslate();
  fill();
}

void DebriefPage::applyTheme(const Theme& theme) {
  theme_ = &theme;
  plot_->setTheme(theme);
  replay_->setTheme(theme);
  untwisting_->setTheme(theme);
  fill();
}

void DebriefPage::fillTexts(bool any) {
  targets_->setTitle(debrief_.realArm ? tr("What the tracker recorded") : tr("Targets"));
  good_->setTitle(tr("What went well"));
  better_->setTitle(tr("What to work on"));
  trace_->setTitle(tr("The run"));
  inThree_->setTitle(tr("Your run in 3D"));
  expert_->setText(tr("Show the &expert (dashed)"));
  expert_->setEnabled(!debrief_.expert.empty());
  bookmark_->setText(tr("Set &bookmark"));
  whole_->setText(tr("&Whole run"));
  again_->setText(tr("&Again"));
  trend_->setText(tr("&Trend"));
  next_->setText(tr("&Next step"));
  again_->setEnabled(any && !debrief_.moduleId.empty());
  trend_->setEnabled(any && !debrief_.moduleId.empty());
  const QString mode = debrief_.realArm                        ? tr("On the real arm")
                       : debrief_.mode == AttemptMode::kGraded ? tr("Graded run")
                                                               : tr("Practice");
  // A module of another enrolment is named by its trial's label.
  const std::string& title = debrief_.moduleTitle.empty() ? debrief_.phaseLabel : debrief_.moduleTitle;
  heading_->setTexts(any && !title.empty() ? toQString(Text(title)) : tr("Your run"),
                     any ? tr("%1  \u00b7  %2  \u00b7  %3")
                               .arg(mode, shownTime(debrief_.startedUtc_us), clockTenths(debrief_.duration_s))
                     : computing_
                         ? tr("One moment: your run is compared with the task and with an expert's.")
                         : tr("After your first run you see here what was good and what to work on."));
}

void DebriefPage::arrangeLooks() {
  const int scrollBar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  const int room = width() - 2 * kPageMargin - scrollBar;
  const int wanted =
      inThree_->minimumSizeHint().width() + looks_->spacing() + trace_->minimumSizeHint().width();
  looks_->setDirection(wanted > room ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void DebriefPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  arrangeLooks();
}

/// Adds the notes below the checks: how to read the numbers above.
void DebriefPage::fillNotes() {
  const auto add = [this](const char* name, const QString& text) {
    auto* words = plainLabel(targets_, "quiet");
    words->setObjectName(QLatin1String(name));
    words->setText(text);
    checks_->addWidget(words);
  };
  if (debrief_.verdict.torn) {
    add("torn", joinedSentences({toQString(debrief_.verdict.cause()), toQString(debrief_.verdict.remedy())}));
  }
  if (debrief_.unfinishedTwists > 0) {
    add("unfinished", tr("%n twist(s) not completed and not counted.", nullptr,
                         static_cast<int>(debrief_.unfinishedTwists)));
  }
  if (debrief_.deviceForce_N && debrief_.forceFelt) {
    add("deviceForce", tr("The force on the tissue is judged. The device rendered at most %1 N of it.")
                           .arg(numberText(*debrief_.deviceForce_N, kForceDecimals)));
  }
  if (debrief_.earlier && debrief_.earlier->peakForce_N) {
    add("earlier", StationLabels::earlier(*debrief_.earlier));
  }
  if (!debrief_.forceFelt) {
    add("forceNotFelt", tr("No haptic device: force was computed, not felt."));
  }
  if (!debrief_.servoTrouble.empty()) {
    add("servoTrouble",
        (debrief_.forceFelt ? tr("The force felt did not match the computed force throughout: %1. %2.")
                            : tr("The computer could not keep up: %1. %2."))
            .arg(toQString(debrief_.servoTrouble), toQString(debrief_.servoRemedy)));
  }
}

void DebriefPage::fillRealArm() {
  for (const Text& one : debrief_.realArm->sentences) {
    auto* words = plainLabel(targets_);
    words->setText(toQString(one));
    checks_->addWidget(words);
  }
  std::vector<Seconds> longest = debrief_.realArm->unseen;
  if (longest.empty()) {
    return;
  }
  const auto length = [](const Seconds& one) { return one.to_s - one.from_s; };
  std::stable_sort(longest.begin(), longest.end(),
                   [&](const Seconds& a, const Seconds& b) { return length(a) > length(b); });
  longest.resize(std::min(longest.size(), kMaxGapsShown));
  std::sort(longest.begin(), longest.end(),
            [](const Seconds& a, const Seconds& b) { return a.from_s < b.from_s; });
  QStringList places;
  for (const Seconds& one : longest) {
    places << tr("%1 to %2").arg(clockTenths(one.from_s), clockTenths(one.to_s));
  }
  auto* where = named(plainLabel(targets_, "quiet"), "unseen");
  const QString joined = places.join(tr(", ", "between the items of a list"));
  where->setText(longest.size() < debrief_.realArm->unseen.size() ? tr("Longest out of view: %1.").arg(joined)
                                                                  : tr("Out of view: %1.").arg(joined));
  checks_->addWidget(where);
}

void DebriefPage::fill() {
  const bool any = !debrief_.trialId.empty();
  fillTexts(any);
  arrangeLooks();
  for (QWidget* widget : std::initializer_list<QWidget*>{targets_, good_, better_, trace_, verdict_}) {
    widget->setVisible(any);
  }
  const bool undone = debrief_.detorsion.has_value();
  const bool real = debrief_.realArm.has_value();
  verdict_->setVisible(any && !real);
  again_->setVisible(!real);
  trend_->setVisible(!real);
  bookmark_->setVisible(!real);
  inThree_->setVisible(any && haveReplay_);
  untwisting_->setVisible(any && undone);
  for (QWidget* ofLevel : std::initializer_list<QWidget*>{competence_, rates_}) {
    ofLevel->setVisible(any && debrief_.competence.planned.attempts > 0);
  }
  for (QWidget* ofTwists : std::initializer_list<QWidget*>{good_, better_, trace_}) {
    ofTwists->setVisible(any && !undone && !real);
  }
  emptyLayout(checks_);
  emptyLayout(strengths_);
  emptyLayout(weaknesses_);
  if (!any) {
    return;
  }
  if (real) {
    fillRealArm();
    return;
  }
  const RunVerdict& verdict = debrief_.verdict;
  verdict_->setText(toQString(verdict.sentence()));
  setLook(verdict_, "good", verdict.passed());
  setLook(verdict_, "caution", !verdict.passed());
  if (const CompetenceVerdict& all = debrief_.competence; all.planned.attempts > 0) {
    competence_->setText(tr("Your level (all runs): %1. %2")
                             .arg(toQString(competenceLevelText(all)), StationLabels::competenceBeside(all)));
    rates_->setTexts(StationLabels::howOftenWrong(), StationLabels::competenceErrors(all));
  }
  for (std::size_t i = 0; i < verdict.checks.size(); ++i) {
    addCheck(verdict.checks[i], debrief_.missed[i]);
  }
  fillNotes();
  for (const DebriefFinding& finding : debrief_.strengths) {
    addFinding(strengths_, finding);
  }
  for (const DebriefFinding& finding : debrief_.weaknesses) {
    addFinding(weaknesses_, finding);
  }
  if (debrief_.strengths.empty()) {
    const QString tooLittle =
        debrief_.verdict.torn
            ? tr("The computer was too busy to record your twists without gaps: they cannot be assessed.")
            : tr("Too little of this run could be measured to compare it with the expert's.");
    for (QVBoxLayout* column : {strengths_, weaknesses_}) {
      auto* none = plainLabel(this, "quiet");
      none->setText(debrief_.twists.empty()          ? tr("No twist was finished in this run.")
                    : debrief_.expert.time_s.empty() ? tr("There is no expert's run to compare with.")
                                                     : tooLittle);
      column->addWidget(none);
    }
  }
}

}  // namespace torsio::gui
