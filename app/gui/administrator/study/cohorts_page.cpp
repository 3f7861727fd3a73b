// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/cohorts_page.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include <QCheckBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/study/cohort_dialogs.h"
#include "app/gui/administrator/study/statements_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/access/all_or_none.h"
#include "app/services/study/study_statements.h"

namespace torsio::gui {

namespace {

constexpr int kCohortPeople = 9;  // column

bool takesNew(const CohortRow& row) {
  return row.cohort.state == CohortState::kDraft || row.cohort.state == CohortState::kRunning;
}

QString namesShown(const std::vector<const CohortRow*>& rows) {
  return firstFew(namesOf(rows, [](const CohortRow& row) { return Text(row.cohort.name); }));
}

}  // namespace

CohortsPage::CohortsPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      add_(primaryButton(this)),
      power_(named(new QPushButton(this), "power")),
      table_(named(new DataTable(QStringLiteral("cohorts"), this), "cohorts")),
      enrol_(listButton(table_)),
      follow_(listButton(table_)),
      allocate_(listButton(table_)),
      rename_(named(listButton(table_), "renameCohort")),
      life_(named(listButton(table_), "cohortState")),
      about_(named(listButton(table_), "aboutStudy")),
      archived_(named(new QCheckBox(this), "archived")),
      membersTitle_(named(new QLabel(this), "cardTitle")),
      members_(named(new DataTable(QStringLiteral("cohort-members"), this), "members")),
      state_(listButton(members_)) {
  table_->wrapWhatIsCut();
  table_->addTool(archived_);
  heading_->addAction(power_);
  heading_->addAction(add_);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(table_, 1);
  column->addWidget(membersTitle_);
  column->addWidget(members_, 1);

  connect(power_, &QPushButton::clicked, this, [this] { PowerDialog(this).exec(); });
  connect(add_, &QPushButton::clicked, this, &CohortsPage::addNew);
  connect(enrol_, &QPushButton::clicked, this, &CohortsPage::enrol);
  connect(follow_, &QPushButton::clicked, this, &CohortsPage::follow);
  connect(allocate_, &QPushButton::clicked, this, [this] {
    if (const CohortRow* row = current()) {
      this->shell().open(PageId::kAllocation, toQString(row->cohort.id));
    }
  });
  connect(rename_, &QPushButton::clicked, this, &CohortsPage::rename);
  connect(life_, &QPushButton::clicked, this, &CohortsPage::changeLife);
  connect(about_, &QPushButton::clicked, this, &CohortsPage::state);
  connect(archived_, &QCheckBox::toggled, this, &CohortsPage::showContent);
  connect(state_, &QPushButton::clicked, this, &CohortsPage::changeState);
  connect(table_, &DataTable::currentChanged, this, &CohortsPage::showMembers);
  connect(members_, &DataTable::currentChanged, this, [this](const QString& id) {
    state_->setEnabled(!id.isEmpty() && this->shell().may(Operation::kStudyEnrol));
  });
  retranslate();
}

void CohortsPage::enter(const QVariant& argument) {
  read();
  if (argument.isValid()) {
    table_->select(argument.toString());
  }
  if (table_->currentId().isEmpty() && !rows_.empty()) {
    table_->select(toQString(rows_.back().cohort.id));
  }
}

void CohortsPage::read() {
  attempt(shell(), [&] {
    rows_ = torsio::cohorts(shell().session());
    showContent();
  });
}

void CohortsPage::showContent() {
  std::vector<Row> rows;
  for (const CohortRow& row : rows_) {
    if (row.cohort.state == CohortState::kArchived && !archived_->isChecked()) {
      continue;
    }
    rows.push_back(
        {toQString(row.cohort.id),
         {{toQString(Text(row.cohort.name))},
          {toQString(labelOf(row.cohort.state)), static_cast<int>(row.cohort.state)},
          {row.curriculumName.empty()
               ? tr("none yet")
               : tr("%1, version %2").arg(toQString(Text(row.curriculumName))).arg(row.curriculumNumber)},
          {QString::number(row.groups.size()), static_cast<qlonglong>(row.groups.size())},
          {QString::number(row.enrolled), static_cast<qlonglong>(row.enrolled)},
          {QString::number(row.allocated), static_cast<qlonglong>(row.allocated)},
          {QString::number(row.withdrawn), static_cast<qlonglong>(row.withdrawn)},
          {row.cohort.demonstration ? tr("demonstration") : QStringLiteral("\u2013")},
          timeCell(row.cohort.createdUtc_us),
          {listOf(row.traineeCodes).join(QStringLiteral(", "))}}});
  }
  table_->setRows(std::move(rows));
  showMembers();
}

const CohortRow* CohortsPage::current() const {
  const CohortId id = table_->currentId().toStdString();
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [&](const CohortRow& row) { return row.cohort.id == id; });
  return found == rows_.end() ? nullptr : &*found;
}

std::vector<const CohortRow*> CohortsPage::chosen(const std::function<bool(const CohortRow&)>& fits) const {
  std::vector<const CohortRow*> rows =
      chosenRows(*table_, rows_, [](const CohortRow& row) { return row.cohort.id; });
  std::erase_if(rows, [&fits](const CohortRow* row) { return !fits(*row); });
  return rows;
}

void CohortsPage::showMembers() {
  const CohortRow* row = current();
  SessionContext& session = shell().session();
  add_->setEnabled(shell().may(Operation::kStudySetup));
  const bool one = row != nullptr && table_->selectedIds().size() == 1;
  enrol_->setEnabled(one && takesNew(*row) && shell().may(Operation::kStudyEnrol));
  follow_->setEnabled(!chosen(takesNew).empty() && shell().may(Operation::kStudySetup));
  rename_->setEnabled(one && shell().may(Operation::kStudySetup));
  life_->setEnabled(row != nullptr && row->cohort.state != CohortState::kDraft &&
                    shell().may(Operation::kStudySetup));
  about_->setEnabled(one);
  allocate_->setEnabled(one && shell().may(Operation::kAllocationView));
  state_->setEnabled(false);
  membersTitle_->setText(row == nullptr ? QString()
                         : row->cohort.equivalenceMargin
                             ? tr("Trainees of %1 (planned: differences up to %2 points do not matter)")
                                   .arg(toQString(Text(row->cohort.name)))
                                   .arg(*row->cohort.equivalenceMargin)
                             : tr("Trainees of %1").arg(toQString(Text(row->cohort.name))));
  enrolments_.clear();
  if (row != nullptr) {
    attempt(shell(), [&] { enrolments_ = enrolments(session, row->cohort.id); });
  }
  std::vector<Row> rows;
  for (const Enrolment& enrolment : enrolments_) {
    rows.push_back(
        {toQString(enrolment.id),
         {{toQString(enrolment.traineeCode)},
          {orDash(enrolment.groupCode)},
          {enrolment.numberInGroup > 0 ? QString::number(enrolment.numberInGroup) : QStringLiteral("\u2013"),
           static_cast<qlonglong>(enrolment.numberInGroup)},
          {toQString(labelOf(enrolment.state))},
          timeCell(enrolment.enrolledUtc_us)}});
  }
  members_->setRows(std::move(rows));
}

void CohortsPage::addNew() {
  attempt(shell(), [&] {
    CohortDialog dialog(curricula(shell().session()), this);
    if (dialog.exec() != QDialog::Accepted) {
      return;
    }
    const CohortId id = addCohort(shell().session(), dialog.cohort());
    read();
    table_->select(toQString(id));
  });
}

void CohortsPage::enrol() {
  const CohortRow* row = current();
  if (row == nullptr) {
    return;
  }
  attempt(shell(), [&] {
    std::set<std::string> there;
    for (const Enrolment& enrolment : enrolments_) {
      there.insert(enrolment.traineeId);
    }
    std::vector<PersonRow> free;
    for (PersonRow& person : people(shell().session())) {
      if (person.trainee && person.person.state == PersonState::kActive &&
          !there.contains(person.person.id) && person.person.demonstration == row->cohort.demonstration) {
        free.push_back(std::move(person));
      }
    }
    PeopleDialog dialog(
        tr("Enrol trainees"),
        tr("Who takes part in %1? Groups are drawn later.").arg(toQString(Text(row->cohort.name))), free,
        this);
    if (dialog.exec() != QDialog::Accepted || dialog.chosen().empty()) {
      return;
    }
    const CohortId cohort = row->cohort.id;
    enrolTrainees(shell().session(), cohort, dialog.chosen());
    read();
    table_->select(toQString(cohort));
  });
}

void CohortsPage::follow() {
  const std::vector<const CohortRow*> open = chosen(takesNew);
  if (open.empty()) {
    return;
  }
  attempt(shell(), [&] {
    const std::vector<CurriculumRow> all = curricula(shell().session());
    if (runningVersions(all).empty()) {
      QMessageBox::information(this, tr("Follow a curriculum"),
                               tr("No curriculum is running. Publish one under Curricula and begin it."));
      return;
    }
    const std::optional<std::string> version = askCurriculum(this, namesShown(open), all);
    if (!version) {
      return;
    }
    allOrNone(shell().session(), open,
              [&](const CohortRow* one) { assignCurriculum(shell().session(), one->cohort.id, *version); });
    read();
  });
}

void CohortsPage::changeState() {
  const CohortRow* row = current();
  const EnrolmentId id = members_->currentId().toStdString();
  const auto enrolment =
      std::find_if(enrolments_.begin(), enrolments_.end(), [&](const Enrolment& e) { return e.id == id; });
  if (row == nullptr || enrolment == enrolments_.end()) {
    return;
  }
  // All selected enrolments with the same state as the current one.
  const bool back = enrolment->state == EnrolmentState::kWithdrawn;
  std::vector<const Enrolment*> alike =
      chosenRows(*members_, enrolments_, [](const Enrolment& one) { return one.id; });
  std::erase_if(alike,
                [back](const Enrolment* one) { return (one->state == EnrolmentState::kWithdrawn) != back; });
  const QString codes = firstFew(namesOf(alike, [](const Enrolment& one) { return one.traineeCode; }));
  const std::optional<std::string> reason =
      askReason(this, back ? tr("Return to the study") : tr("Withdraw from the study"),
                back ? tr("%1 takes part again.").arg(codes)
                     : tr("%1 stops training; existing records are kept.").arg(codes));
  if (!reason) {
    return;
  }
  const CohortId cohort = row->cohort.id;
  attempt(shell(), [&] {
    allOrNone(shell().session(), alike, [&](const Enrolment* one) {
      setEnrolmentState(shell().session(), cohort, one->id,
                        back ? EnrolmentState::kEnrolled : EnrolmentState::kWithdrawn, *reason);
    });
    read();
  });
}

void CohortsPage::rename() {
  const CohortRow* row = current();
  if (row == nullptr) {
    return;
  }
  const CohortId id = row->cohort.id;
  if (const std::optional<std::string> name = askCohortName(this, row->cohort.name)) {
    attempt(shell(), [&] {
      renameCohort(shell().session(), id, *name);
      read();
      table_->select(toQString(id));
    });
  }
}

void CohortsPage::state() {
  const CohortRow* row = current();
  if (row == nullptr) {
    return;
  }
  const CohortId id = row->cohort.id;
  attempt(shell(), [&] {
    StatementsDialog dialog(toQString(Text(row->cohort.name)), studyStatements(shell().session(), id),
                            shell().may(Operation::kStudySetup), this);
    if (dialog.exec() == QDialog::Accepted) {
      setStudyStatements(shell().session(), id, dialog.statements());
    }
  });
}

void CohortsPage::changeLife() {
  const CohortRow* row = current();
  if (row == nullptr) {
    return;
  }
  // All selected cohorts with the same state as the current one.
  const CohortState now = row->cohort.state;
  const std::vector<const CohortRow*> alike =
      chosen([now](const CohortRow& one) { return one.cohort.state == now; });
  if (const std::optional<CohortStateChange> change = askCohortState(this, namesShown(alike), now)) {
    attempt(shell(), [&] {
      allOrNone(shell().session(), alike, [&](const CohortRow* one) {
        setCohortState(shell().session(), one->cohort.id, change->state, change->reason);
      });
      read();
    });
  }
}

void CohortsPage::retranslate() {
  heading_->setTexts(tr("Cohorts"), tr("Who trains together, by which curriculum, and in which group."));
  power_->setText(tr("How many &trainees\u2026"));
  add_->setText(tr("&New cohort\u2026"));
  enrol_->setText(tr("&Enrol trainees\u2026"));
  follow_->setText(tr("&Curriculum\u2026"));
  allocate_->setText(tr("&Allocation"));
  rename_->setText(tr("&Rename\u2026"));
  life_->setText(tr("Clo&se or archive\u2026"));
  about_->setText(tr("A&bout the study\u2026"));
  about_->setToolTip(tr("Registration, ethics approval, eligibility and what else a reviewer asks"));
  archived_->setText(tr("Show arch&ived"));
  state_->setText(tr("&Withdraw or reinstate\u2026"));
  table_->setColumns({{tr("Name")},
                      {tr("State")},
                      {tr("Curriculum")},
                      {tr("Groups"), true},
                      {tr("Enrolled"), true, true},
                      {tr("In a group"), true, true},
                      {tr("Withdrew"), true, true},
                      {tr("Kind")},
                      {tr("Since")},
                      {tr("Everybody")}});
  table_->hideAtFirst(kCohortPeople);  // a search for a code finds the cohort
  table_->setEmptyText(tr("No cohort yet. A cohort is a group of trainees who go through one study."));
  members_->setColumns(
      {{tr("Trainee")}, {tr("Group")}, {tr("Number"), true}, {tr("State")}, {tr("Enrolled on")}});
  members_->setEmptyText(tr("Nobody is enrolled yet."));
  showContent();
}

}  // namespace torsio::gui
