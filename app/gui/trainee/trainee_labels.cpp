// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/trainee_labels.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"
#include "app/services/recording/competence.h"
#include "assessment/catalogue/quantity.h"

namespace torsio::gui {

QString StationLabels::minutes(std::int64_t span_us) {
  if (span_us < 60'000'000) {
    return clockTimeLeft(span_us);
  }
  return tr("%1 min").arg((span_us + 59'999'999) / 60'000'000);
}

QString StationLabels::waited(std::int64_t span_us) {
  const std::int64_t minutes = span_us / 60'000'000;
  if (minutes < 1) {
    return tr("a moment");
  }
  if (minutes < 60) {
    return tr("%1 min").arg(minutes);
  }
  if (minutes < 48 * 60) {
    return tr("%1 h").arg(minutes / 60);
  }
  return tr("%n day(s)", nullptr, static_cast<int>(minutes / (24 * 60)));
}

QString StationLabels::state(StepState state) {
  switch (state) {
    case StepState::kLocked:
      return tr("Locked");
    case StepState::kOpen:
      return tr("Open");
    case StepState::kMastered:
      return tr("Mastered");
    case StepState::kUsedUp:
      return tr("No attempt left");
  }
  return {};
}

QString StationLabels::why(const ModuleStep& step) {
  if (step.state == StepState::kLocked) {
    QStringList titles;
    for (const std::string& title : step.missing) {
      titles << toQString(Text(title));
    }
    return tr("Master first: %1").arg(titles.join(tr(", ", "between titles")));
  }
  if (step.state == StepState::kUsedUp) {
    return tr("Ask an administrator for another attempt.");
  }
  QStringList parts;
  for (const RuleProgress& progress : step.rules) {
    parts << toQString(progress.text());
  }
  if (step.competence) {
    parts << tr("Level: %1").arg(level(*step.competence));
  }
  return parts.join(QLatin1Char('\n'));
}

QString StationLabels::lastResult(const ModuleStep& step) {
  if (!step.last) {
    return tr("Not tried yet");
  }
  const Attempt& last = *step.last;
  return last.interrupted() ? tr("Last time: interrupted after %1").arg(clockTenths(last.duration_s))
                            : tr("Last time: %1").arg(toQString(last.result()));
}

QString StationLabels::unlocks(const ModuleStep& step) {
  if (step.unlocks.empty()) {
    return {};
  }
  QStringList titles;
  for (const std::string& title : step.unlocks) {
    titles << toQString(Text(title));
  }
  return tr("Unlocks: %1").arg(titles.join(tr(", ", "between titles")));
}

QString StationLabels::earlier(const EarlierMeasure& earlier) {
  const QString force = toQString(shownValue(Quantity::kPeakForce, earlier.peakForce_N));
  return earlier.withinLimits ? tr("Measured before by version %1 of the definitions: peak force %2, within "
                                   "the limits. That is kept and no longer counts.")
                                    .arg(earlier.version)
                                    .arg(force)
                              : tr("Measured before by version %1 of the definitions: peak force %2, beyond "
                                   "the limits. That is kept and no longer counts.")
                                    .arg(earlier.version)
                                    .arg(force);
}

QString StationLabels::level(const CompetenceVerdict& verdict) {
  return capitalised(toQString(competenceLevelText(verdict)));
}

QString StationLabels::levelMeaning(const CompetenceVerdict& verdict) {
  switch (verdict.level) {
    case SkillLevel::kNotShown:
      return tr("Too few runs to show competence.");
    case SkillLevel::kLearning:
      return tr("Competence not shown yet. %n successful run(s) in a row would show it.", nullptr,
                static_cast<int>(fewestForAble(verdict.design)));
    case SkillLevel::kSteady:
      return tr("Competent, and stable.");
    case SkillLevel::kWatch:
      return tr("Previously competent; the latest runs raise doubts.");
    case SkillLevel::kRelapsed:
      return tr("Previously competent, but not now. Practise until you are competent again.");
    case SkillLevel::kExpired:
      return tr("Competent before, but too long without a run. Show it again.");
  }
  return {};
}

QString StationLabels::competenceRule(const CompetenceVerdict& verdict) {
  return toQString(competenceRuleText(verdict));
}

QString StationLabels::competenceErrors(const CompetenceVerdict& verdict) {
  return toQString(competenceErrorText(verdict));
}

QString StationLabels::competenceBeside(const CompetenceVerdict& verdict) {
  return joinedSentences({competenceRule(verdict), toQString(competenceChanceText(verdict.design))});
}

QString StationLabels::howOftenWrong() {
  return tr("How often is this wrong?");
}

QString StationLabels::readiness(const ReadinessFinding& finding) {
  if (finding.code == "connected") {
    return tr("Connected");
  }
  if (finding.code == "docked") {
    return tr("Stylus docked");
  }
  if (finding.code == "calibrated") {
    return tr("Calibrated");
  }
  if (finding.code == "force") {
    return tr("Force");
  }
  if (finding.code == "rate") {
    return tr("Update rate");
  }
  if (finding.code == "seat") {
    return tr("Hand and seat");
  }
  return toQString(finding.code);
}

QString StationLabels::light(Light light) {
  switch (light) {
    case Light::kGreen:
      return tr("Ready");
    case Light::kAmber:
      return tr("Practice only");
    case Light::kRed:
      return tr("Not ready");
  }
  return {};
}

namespace {

constexpr int kFieldHeight = 72;

}  // namespace

RemarkWords::RemarkWords(QWidget* parent)
    : QWidget(parent),
      text_(plainLabel(this)),
      history_(named(linkButton(this), "edited")),
      edit_(named(linkButton(this), "editWords")),
      earlier_(plainLabel(this, "quiet")),
      editor_(new QWidget(this)),
      field_(named(new QPlainTextEdit(editor_), "newWords")),
      save_(named(new QPushButton(tr("Save"), editor_), "saveWords")) {
  text_->setObjectName(QStringLiteral("words"));
  earlier_->setObjectName(QStringLiteral("earlierWords"));
  QVBoxLayout* column = columnOf(this, {}, kSpace / 2);
  QHBoxLayout* row = rowOf();
  row->addWidget(text_, 1);
  row->addWidget(history_, 0, Qt::AlignTop);
  row->addWidget(edit_, 0, Qt::AlignTop);
  column->addLayout(row);
  column->addWidget(earlier_);
  auto* editorRow = new QHBoxLayout(editor_);
  editorRow->setContentsMargins(0, 0, 0, 0);
  editorRow->setSpacing(kSpace);
  editorRow->addWidget(field_, 1);
  editorRow->addWidget(save_, 0, Qt::AlignTop);
  auto* leave = linkButton(editor_);
  leave->setText(tr("Cancel"));
  editorRow->addWidget(leave, 0, Qt::AlignTop);
  column->addWidget(editor_);
  edit_->setText(tr("Edit"));
  history_->setCheckable(true);
  field_->setTabChangesFocus(true);
  field_->setFixedHeight(kFieldHeight);
  field_->setAccessibleName(tr("New wording; the earlier one is kept"));
  field_->installEventFilter(this);
  earlier_->hide();
  editor_->hide();
  connect(history_, &QPushButton::toggled, earlier_, &QLabel::setVisible);
  connect(edit_, &QPushButton::clicked, this, [this] { setEditing(true); });
  connect(leave, &QPushButton::clicked, this, [this] { setEditing(false); });
  connect(save_, &QPushButton::clicked, this, &RemarkWords::save);
  connect(field_, &QPlainTextEdit::textChanged, save_, [this] {
    const QString now = field_->toPlainText().trimmed();
    save_->setEnabled(!now.isEmpty() && now != words_);
  });
}

void RemarkWords::setWords(const QString& text, std::int64_t editedUtc_us,
                           const std::vector<RemarkWording>& earlier, bool own) {
  words_ = text;
  showText();
  history_->setVisible(editedUtc_us != 0);
  history_->setText(tr("edited %1").arg(shownTime(editedUtc_us)));
  history_->setToolTip(tr("Shows the earlier wording"));
  edit_->setVisible(own && !text.isEmpty());
  QStringList lines;
  for (const RemarkWording& one : earlier) {
    lines << tr("%1: %2").arg(shownTime(one.writtenUtc_us), toQString(one.text));
  }
  earlier_->setText(lines.join(QLatin1Char('\n')));
  setEditing(false);
}

void RemarkWords::setLead(const QString& lead) {
  lead_ = lead;
  showText();
}

void RemarkWords::showText() {
  text_->setText(lead_.isEmpty() ? words_ : tr("%1: %2").arg(lead_, words_));
}

void RemarkWords::setEditing(bool editing) {
  editor_->setVisible(editing);
  text_->setVisible(!editing);
  edit_->setEnabled(!editing);
  if (editing) {
    field_->setPlainText(words_);
    field_->selectAll();
    field_->setFocus(Qt::OtherFocusReason);
  }
}

void RemarkWords::save() {
  if (save_->isEnabled()) {
    Q_EMIT edited(field_->toPlainText().trimmed());
  }
}

bool RemarkWords::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress) {
    auto* key = static_cast<QKeyEvent*>(event);
    const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (enter && (key->modifiers() & Qt::ControlModifier) != 0) {
      save();
      return true;
    }
    if (key->key() == Qt::Key_Escape) {
      setEditing(false);
      edit_->setFocus(Qt::OtherFocusReason);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace torsio::gui
