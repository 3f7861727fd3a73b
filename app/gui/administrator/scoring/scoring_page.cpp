// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/scoring/scoring_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/base/reminder_text.h"
#include "app/gui/administrator/scoring/rater_calibration_dialog.h"
#include "app/gui/administrator/scoring/remind_dialog.h"
#include "app/gui/administrator/scoring/rubric_dialog.h"
#include "app/gui/administrator/scoring/scoring_dialogs.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/access/all_or_none.h"
#include "app/services/people/people_service.h"
#include "app/services/study/open_sheets.h"
#include "app/services/study/rubric_service.h"
#include "assessment/domain/people/person.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

/// Returns a symbol distinguishable by shape as well as colour; the tool tip explains it.
QString stateSign(const ScoringCell& cell) {
  if (cell.assignmentId.empty()) {
    return QString();
  }
  switch (cell.state) {
    case SheetState::kOpen:
      return QStringLiteral("\u25CB");
    case SheetState::kDraft:
      return QStringLiteral("\u25D0");
    case SheetState::kSubmitted:
      return QStringLiteral("\u25CF");
    case SheetState::kWithdrawn:
      return QStringLiteral("\u00D7");
  }
  return {};
}

}  // namespace

ScoringPage::ScoringPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      calibration_(new QPushButton(this)),
      revise_(named(new QPushButton(this), "reviseRubric")),
      invite_(primaryButton(this)),
      cohort_(new QComboBox(this)),
      summary_(new QLabel(this)),
      table_(named(new DataTable(QStringLiteral("scoring-matrix"), this), "matrix")),
      reassign_(listButton(table_)),
      remind_(listButton(table_)),
      mail_(listButton(table_)),
      release_(listButton(table_)),
      adjudicator_(listButton(table_)) {
  heading_->addAction(revise_);
  heading_->addAction(calibration_);
  heading_->addAction(invite_);
  QHBoxLayout* choices = rowOf();
  cohortLabel_ = addField(choices, cohort_);
  choices->addSpacing(2 * kSpace);
  choices->addWidget(summary_, 1);
  cohort_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addLayout(choices);
  column->addWidget(table_, 1);

  connect(cohort_, &QComboBox::currentIndexChanged, this, &ScoringPage::read);
  connect(invite_, &QPushButton::clicked, this, &ScoringPage::inviteRaters);
  connect(reassign_, &QPushButton::clicked, this, &ScoringPage::reassignSheets);
  connect(remind_, &QPushButton::clicked, this, &ScoringPage::copyReminders);
  connect(mail_, &QPushButton::clicked, this, [this] {
    attempt(this->shell(), [this] { RemindDialog(this->shell(), chosenId(cohort_), this).exec(); });
  });
  connect(release_, &QPushButton::clicked, this, &ScoringPage::release);
  connect(adjudicator_, &QPushButton::clicked, this, &ScoringPage::assignAdjudicators);
  connect(revise_, &QPushButton::clicked, this, &ScoringPage::showSheet);
  connect(calibration_, &QPushButton::clicked, this, &ScoringPage::showCalibration);
  connect(table_, &DataTable::currentChanged, this, &ScoringPage::showButtons);
  retranslate();
}

void ScoringPage::enter(const QVariant& argument) {
  attempt(shell(), [&] {
    fillCohorts(cohort_, shell().session(), CohortFirst::kOfToday);
    if (argument.isValid()) {
      chooseId(cohort_, argument.toString().toStdString());
    }
    read();
  });
}

void ScoringPage::read() {
  attempt(shell(), [&] {
    const std::string cohort = chosenId(cohort_);
    matrix_.reset();
    releases_.clear();
    adjudicatorRequests_.clear();
    if (!cohort.empty()) {
      matrix_ = scoringMatrix(shell().session(), cohort);
      adjudicatorRequests_ = adjudicatorRequests(shell().session(), cohort);
      if (shell().may(Operation::kMarkRelease)) {
        releases_ = releaseStates(shell().session(), cohort);
      }
    }
    showContent();
  });
}

void ScoringPage::showContent() {
  std::vector<Column> columns = {{tr("Trainee")}, {tr("Occasion")}, {tr("Not in yet"), true, true}};
  std::vector<Row> rows;
  std::size_t open = 0;
  std::size_t submitted = 0;
  if (matrix_) {
    for (const ScoringMatrix::Rater& rater : matrix_->raters) {
      columns.push_back({toQString(rater.code)});
      open += rater.open;
      submitted += rater.submitted;
    }
    for (std::size_t i = 0; i < matrix_->lines.size(); ++i) {
      const ScoringMatrix::Line& line = matrix_->lines[i];
      Row row{QString::number(i),
              {{toQString(line.traineeCode)},
               {occasionName(line.occasion), toQString(line.occasion.code)},
               {line.missing == 0 ? QStringLiteral("\u2013") : QString::number(line.missing),
                static_cast<qlonglong>(line.missing)}}};
      for (const ScoringCell& cell : line.cells) {
        row.cells.push_back({stateSign(cell), static_cast<int>(cell.state),
                             cell.assignmentId.empty() ? tr("not asked") : cellText(cell)});
      }
      rows.push_back(std::move(row));
    }
  }
  table_->setColumns(columns);
  table_->setRows(std::move(rows));
  summary_->setText(matrix_ ? tr("Of all occasions, also those still to come: \u25CF submitted %1 \u00B7 "
                                 "\u25CB open or \u25D0 draft "
                                 "%2")
                                  .arg(countText(submitted), countText(open))
                            : QString());
  showButtons();
}

QString ScoringPage::cellText(const ScoringCell& cell) const {
  const QString text = tr("case %1: %2").arg(toQString(cell.caseLabel), toQString(labelOf(cell.state)));
  const bool waits = cell.state == SheetState::kOpen || cell.state == SheetState::kDraft;
  return cell.dueUtc_us && waits ? tr("%1, due %2").arg(text, shownTime(*cell.dueUtc_us, locale())) : text;
}

void ScoringPage::copyReminders() {
  attempt(shell(), [&] { gui::copyReminders(shell(), chosenId(cohort_), locale()); });
}

void ScoringPage::showButtons() {
  invite_->setEnabled(cohort_->count() > 0 && shell().may(Operation::kStudySetup));
  reassign_->setEnabled(matrix_ && !matrix_->lines.empty() && shell().may(Operation::kStudySetup));
  remind_->setEnabled(matrix_ && !matrix_->lines.empty());
  mail_->setEnabled(remind_->isEnabled());
  release_->setEnabled(!releases_.empty());
  revise_->setEnabled(shell().may(Operation::kCurriculumEdit));
  calibration_->setEnabled(shell().may(Operation::kStudySetup));
  // Visible only with open requests; its number attracts attention.
  adjudicator_->setVisible(!adjudicatorRequests_.empty());
  adjudicator_->setText(tr("Ad&judicator (%1)\u2026").arg(adjudicatorRequests_.size()));
}

std::string ScoringPage::rubricRevision() {
  std::vector<RubricRow> all = rubrics(shell().session());
  if (all.empty()) {
    const std::vector<RubricTemplate> templates = rubricTemplates(shell().assets());
    if (templates.empty()) {
      throw Error(ErrorCode::kBadData, Text::tr("there is no rubric"), Text::verbatim("assets/rubrics"),
                  Text::tr("Add a rubric first"));
    }
    return addRubric(shell().session(), templates.front().title, templates.front().revision);
  }
  return all.front().revisions.back().id;
}

void ScoringPage::showSheet() {
  attempt(shell(), [&] {
    static_cast<void>(rubricRevision());  // stores the shipped one if there is none
    RubricDialog(shell(), this).exec();
  });
}

bool ScoringPage::ask(const std::vector<RaterId>& raterIds, const std::vector<std::string>& occasionCodes,
                      std::optional<std::int64_t> dueUtc_us) {
  return attempt(shell(), [&] {
    ScoringPlan plan{.cohortId = chosenId(cohort_),
                     .occasionCodes = occasionCodes,
                     .raterIds = raterIds,
                     .rubricRevisionId = rubricRevision(),
                     .dueUtc_us = dueUtc_us};
    const ScoringPlanOutcome done = createAssignments(shell().session(), plan);
    read();
    shell().notify(tr("%n sheet(s) asked for", nullptr, static_cast<int>(done.created)));
  });
}

std::vector<PersonRow> ScoringPage::activeRaters() {
  std::vector<PersonRow> raters;
  for (PersonRow& person : people(shell().session())) {
    if (person.rater && person.person.state == PersonState::kActive) {
      raters.push_back(std::move(person));
    }
  }
  return raters;
}

void ScoringPage::inviteRaters() {
  attempt(shell(), [&] {
    if (const std::optional<RatersInvited> asked =
            chooseInvitedRaters(this, activeRaters(), matrix_.value_or(ScoringMatrix{}))) {
      ask(asked->raterIds, asked->occasionCodes, asked->dueUtc_us);
    }
  });
}

void ScoringPage::reassignSheets() {
  if (!matrix_) {
    return;
  }
  const QStringList ids = table_->selectedIds();
  std::vector<std::size_t> lines;  // without a selection, all of them
  for (std::size_t i = 0; i < matrix_->lines.size(); ++i) {
    if (ids.isEmpty() || ids.contains(QString::number(i))) {
      lines.push_back(i);
    }
  }
  attempt(shell(), [&] {
    const std::vector<PersonRow> raters = activeRaters();
    const std::optional<SheetsChosen> chosen = askReassignment(this, *matrix_, lines, raters);
    if (!chosen) {
      return;
    }
    const SheetsMoved moved =
        reassignAll(shell().session(), chosen->sheets, chosen->newRaterId, chosen->reason);
    read();
    shell().notify(
        tr("%n sheet(s) reassigned. Reassign can also return them.", nullptr, static_cast<int>(moved.moved)));
  });
}

void ScoringPage::release() {
  const std::optional<ReleaseChange> change = askRelease(this, releases_);
  if (!change) {
    return;
  }
  attempt(shell(), [&] {
    if (change->release) {
      releaseMarks(shell().session(), chosenId(cohort_), change->occasionCode, change->reason);
    } else {
      retractMarks(shell().session(), chosenId(cohort_), change->occasionCode, change->reason);
    }
    read();
  });
}

void ScoringPage::assignAdjudicators() {
  if (adjudicatorRequests_.empty()) {
    return;
  }
  const std::vector<AdjudicatorChosen> chosen = chooseAdjudicators(this, adjudicatorRequests_);
  if (chosen.empty()) {
    return;
  }
  attempt(shell(), [&] {
    allOrNone(shell().session(), chosen, [&](const AdjudicatorChosen& one) {
      assignAdjudicator(shell().session(), chosenId(cohort_), one.assignmentId, one.raterId);
    });
    read();
    shell().notify(chosen.size() == 1 ? tr("The adjudicator finds the case in their queue")
                                      : tr("The adjudicators find the cases in their queues"));
  });
}

void ScoringPage::showCalibration() {
  attempt(shell(), [&] {
    static_cast<void>(rubricRevision());  // the first revision is the shipped one
    RaterCalibrationDialog dialog(shell(), rubrics(shell().session()), this);
    dialog.exec();
  });
}

void ScoringPage::retranslate() {
  heading_->setTexts(tr("Scoring"), tr("Who scores whom, and progress so far. Marks are not shown here."));
  calibration_->setText(tr("Rater cali&bration\u2026"));
  revise_->setText(tr("Scoring &sheet\u2026"));
  revise_->setToolTip(tr("What raters fill in: criteria, scales, anchors and weights"));
  calibration_->setToolTip(tr("The reference runs that every physician scores first"));
  invite_->setText(tr("&Invite raters\u2026"));
  adjudicator_->setToolTip(tr("Physicians could not agree and ask for another opinion"));
  cohortLabel_->setText(tr("&Cohort"));
  reassign_->setText(tr("&Reassign\u2026"));
  reassign_->setToolTip(tr("The sheets of the chosen rows, or of all: to another rater, or back"));
  remind_->setText(tr("Copy re&minders"));
  remind_->setToolTip(tr("Which raters still owe which cases, ready to paste into an email"));
  mail_->setText(tr("Sen&d reminders\u2026"));
  mail_->setToolTip(
      tr("Through the centre's mail server, to all raters with outstanding sheets or some of them"));
  release_->setText(tr("Re&lease marks\u2026"));
  table_->setEmptyText(
      tr("No rater has been invited yet. Press Invite raters: each gets the cases in a different order."));
  showContent();
}

}  // namespace torsio::gui
