// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/allocation_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/cohort.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr AllocationMethod kMethods[] = {AllocationMethod::kCompletePermutation,
                                         AllocationMethod::kStratifiedBlocks,
                                         AllocationMethod::kPermutedBlocks, AllocationMethod::kMinimisation};

}  // namespace

AllocationPage::AllocationPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      cohort_(new QComboBox(this)),
      design_(new Card(QString(), this)),
      methodLabel_(new QLabel(this)),
      method_(named(new QComboBox(this), "method")),
      factorsLabel_(new QLabel(this)),
      blocksLabel_(new QLabel(this)),
      blocks_(named(new QLineEdit(QStringLiteral("3, 6"), this), "blocks")),
      previewButton_(new QPushButton(this)),
      lock_(named(primaryButton(this), "lockButton")),
      state_(new Card(QString(), this)),
      stateText_(sentence(this, false)),
      allocate_(named(new QPushButton(this), "allocateButton")),
      reveal_(new QPushButton(this)),
      check_(new QPushButton(this)),
      cards_(new QPushButton(this)),
      balanceTitle_(new QLabel(this)),
      balance_(named(new DataTable(QStringLiteral("allocation-balance"), this), "balance")),
      recordsTitle_(new QLabel(this)),
      records_(named(new DataTable(QStringLiteral("allocation-records"), this), "records")),
      move_(named(listButton(records_), "moveByHand")) {
  for (const AllocationMethod method : kMethods) {
    method_->addItem(QString(), static_cast<int>(method));
  }
  for (const Term<BalanceFactor>& factor : kBalanceFactors) {
    factors_[factor.value] = new QCheckBox(this);
  }
  QHBoxLayout* choices = rowOf();
  cohortLabel_ = addField(choices, cohort_);
  choices->addStretch(1);
  cohort_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  QHBoxLayout* cards = rowOf({}, 2 * kSpace);
  cards->addWidget(designForm(), 1);
  stateText_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  state_->content()->addWidget(stateText_, 1);
  auto* acts = new QHBoxLayout;
  for (QPushButton* button : {allocate_, cards_, reveal_, check_}) {
    acts->addWidget(button);
  }
  acts->addStretch(1);
  state_->content()->addLayout(acts);
  cards->addWidget(state_, 1);
  for (QLabel* title : {balanceTitle_, recordsTitle_}) {
    title->setObjectName(QStringLiteral("cardTitle"));
  }
  auto* lists = new QGridLayout;
  lists->setHorizontalSpacing(2 * kSpace);
  lists->setVerticalSpacing(kSpace);
  lists->addWidget(balanceTitle_, 0, 0);
  lists->addWidget(recordsTitle_, 0, 1);
  lists->addWidget(balance_, 1, 0);
  lists->addWidget(records_, 1, 1);
  lists->setColumnStretch(0, 1);
  lists->setColumnStretch(1, 1);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addLayout(choices);
  column->addLayout(cards);
  column->addLayout(lists, 1);

  connect(cohort_, &QComboBox::currentIndexChanged, this, &AllocationPage::read);
  connect(method_, &QComboBox::currentIndexChanged, this, &AllocationPage::showFields);
  connect(previewButton_, &QPushButton::clicked, this, &AllocationPage::preview);
  connect(lock_, &QPushButton::clicked, this, &AllocationPage::askLock);
  connect(allocate_, &QPushButton::clicked, this, &AllocationPage::allocateEverybody);
  connect(reveal_, &QPushButton::clicked, this, &AllocationPage::askReveal);
  connect(cards_, &QPushButton::clicked, this, &AllocationPage::askCards);
  connect(check_, &QPushButton::clicked, this, &AllocationPage::check);
  connect(move_, &QPushButton::clicked, this, &AllocationPage::askMove);
  connect(records_, &DataTable::currentChanged, this, &AllocationPage::showFields);
  retranslate();
}

QWidget* AllocationPage::designForm() {
  methodLabel_->setBuddy(method_);
  blocksLabel_->setBuddy(blocks_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setVerticalSpacing(kSpace);
  grid->setColumnStretch(1, 1);
  grid->addWidget(methodLabel_, 0, 0);
  grid->addWidget(method_, 0, 1);
  grid->addWidget(factorsLabel_, 1, 0);
  QHBoxLayout* checks = rowOf({}, 2 * kSpace);
  for (const auto& [factor, box] : factors_) {
    checks->addWidget(box);
  }
  checks->addStretch(1);
  grid->addLayout(checks, 1, 1);
  grid->addWidget(blocksLabel_, 2, 0);
  grid->addWidget(blocks_, 2, 1);
  blocksHint_ = fieldHint();
  grid->addWidget(blocksHint_, 3, 1);
  connect(blocks_, &QLineEdit::textChanged, this, &AllocationPage::showFields);
  design_->content()->addLayout(grid);
  design_->content()->addStretch(1);
  auto* acts = new QHBoxLayout;
  acts->addWidget(previewButton_);
  acts->addWidget(lock_);
  acts->addStretch(1);
  design_->content()->addLayout(acts);
  return design_;
}

void AllocationPage::enter(const QVariant& argument) {
  attempt(shell(), [&] {
    fillCohorts(cohort_, shell().session(), CohortFirst::kStudy);
    if (argument.isValid()) {
      chooseId(cohort_, argument.toString().toStdString());
    }
    read();
  });
}

void AllocationPage::read() {
  attempt(shell(), [&] {
    const std::string cohort = chosenId(cohort_);
    designs_ =
        cohort.empty() ? std::vector<AllocationDesignRow>{} : allocationDesigns(shell().session(), cohort);
    arms_ = 0;
    for (const CohortRow& row : cohorts(shell().session())) {
      arms_ = row.cohort.id == cohort ? row.groups.size() : arms_;
    }
    preview_.reset();
    showFields();
    showDesign();
    showBalance();
  });
}

AllocationPlan AllocationPage::plan() const {
  AllocationPlan plan{.cohortId = chosenId(cohort_),
                      .method = static_cast<AllocationMethod>(method_->currentData().toInt())};
  if (usesFactors(plan.method)) {
    for (const auto& [factor, box] : factors_) {
      if (box->isChecked()) {
        plan.factors.emplace_back(storedText(factor));
      }
    }
  }
  if (usesBlocks(plan.method)) {
    for (const QString& size : blocks_->text().split(QLatin1Char(','))) {
      plan.blockSizes.push_back(static_cast<std::size_t>(size.trimmed().toUInt()));
    }
  }
  return plan;
}

QString AllocationPage::flawOfBlocks() const {
  const AllocationPlan planned = plan();
  if (planned.blockSizes.empty() || arms_ < 2) {
    return {};
  }
  try {
    checkBlockSizes(planned.blockSizes, arms_);
  } catch (const Error& refused) {
    return translatedLine(refused);
  }
  return {};
}

void AllocationPage::showFields() {
  const auto method = static_cast<AllocationMethod>(method_->currentData().toInt());
  const QString flaw = flawOfBlocks();
  sayHint(blocksHint_, flaw);
  for (const auto& [name, box] : factors_) {
    box->setEnabled(usesFactors(method));
  }
  blocks_->setEnabled(usesBlocks(method));
  const bool some = cohort_->count() > 0;
  const bool run = shell().may(Operation::kAllocationRun);
  for (QPushButton* button : {previewButton_, lock_}) {
    button->setEnabled(some && run && flaw.isEmpty());
    button->setToolTip(flaw);
  }
  allocate_->setEnabled(!designs_.empty() && run);
  reveal_->setEnabled(!designs_.empty() && designs_.back().stored.seed.empty() &&
                      shell().may(Operation::kAllocationReveal));
  cards_->setEnabled(!designs_.empty() && designs_.back().records > 0 && run);
  check_->setEnabled(!designs_.empty());
  move_->setEnabled(run && !records_->currentId().isEmpty());
}

bool AllocationPage::preview() {
  return attempt(shell(), [&] {
    preview_ = previewBalance(shell().session(), plan());
    showBalance();
  });
}

void AllocationPage::showBalance() {
  std::vector<Row> rows;
  if (preview_) {
    for (const BalancePreview::Level& level : preview_->levels) {
      QStringList expected;
      for (const double people : level.expected) {
        expected << locale().toString(people, 'f', 1);
      }
      rows.push_back(
          {QStringLiteral("%1/%2").arg(toQString(level.factor), toQString(level.level)),
           {{toQString(labelOfStored<BalanceFactor>(level.factor))},
            {levelName(level.level)},
            {QString::number(level.people), static_cast<qlonglong>(level.people)},
            {expected.join(QStringLiteral("  "))},
            {locale().toString(level.meanDifference, 'f', 1), level.meanDifference},
            {QString::number(level.worstDifference), static_cast<qlonglong>(level.worstDifference)}}});
    }
  }
  balance_->setRows(std::move(rows));
  QString title = tr("Balance preview");
  if (preview_) {
    title = tr("Balance preview, over %1 draws with other seeds").arg(preview_->tries);
    if (!preview_->missing.empty()) {
      title = tr("%n trainee(s) lack one of these details: %1", nullptr,
                 static_cast<int>(preview_->missing.size()))
                  .arg(toQString(preview_->missing.front()));
    }
  }
  balanceTitle_->setText(title);
}

void AllocationPage::showDesign() {
  drawn_.clear();
  std::vector<Row> rows;
  QString text =
      tr("No design is locked yet. Preview the balance, then lock: the seed is drawn and sealed at that "
         "moment.");
  if (!designs_.empty()) {
    const AllocationDesignRow& row = designs_.back();
    constexpr qsizetype kDigits = 32;  // per line
    const QString commitment = toQString(row.stored.seedCommitment);
    text = tr("Locked %1 \u00B7 %2 allocated, %3 moved by hand\n%4\nCommitment: %5\nSeed: %6")
               .arg(shownTime(row.stored.lockedUtc_us, locale()))
               .arg(row.records)
               .arg(row.overrides)
               .arg(toQString(labelOf(row.design.method)),
                    commitment.left(kDigits) + QLatin1Char('\n') + commitment.mid(kDigits),
                    row.stored.seed.empty()
                        ? tr("sealed")
                        : tr("%1 (salt %2)").arg(toQString(row.stored.seed), toQString(row.stored.salt)));
    std::map<std::string, std::string> codes;
    std::map<std::string, std::string> groups;
    for (const Enrolment& enrolment : enrolments(shell().session(), chosenId(cohort_))) {
      codes[enrolment.id] = enrolment.traineeCode;
    }
    for (const CohortRow& cohort : cohorts(shell().session())) {
      for (const StudyGroup& group : cohort.groups) {
        groups[group.id] = group.code;
      }
    }
    drawn_ = allocations(shell().session(), row.stored.id);
    for (const AllocationEntry& record : drawn_) {
      rows.push_back({toQString(record.id),
                      {{QString::number(record.sequence), static_cast<qlonglong>(record.sequence)},
                       {toQString(codes[record.enrolmentId])},
                       {toQString(groups[record.groupId])},
                       {QString::number(record.numberInGroup), static_cast<qlonglong>(record.numberInGroup)},
                       {record.overrideReason.empty() ? tr("as drawn") : toQString(record.overrideReason)},
                       {toQString(record.recordHash.substr(0, 12))}}});
    }
  }
  if (cohort_->count() == 0) {
    text = tr("There is no cohort yet. Make one under Cohorts and enrol its trainees.");
  } else if (!shell().may(Operation::kAllocationRun)) {
    text = tr("%1\n\nOnly an allocator previews, locks and draws. An administrator gives this role to "
              "somebody under Users.")
               .arg(text);
  }
  stateText_->setText(text);
  records_->setRows(std::move(rows));
}

void AllocationPage::retranslate() {
  heading_->setTexts(tr("Allocation"),
                     tr("Random allocation that anybody can verify afterwards: design, lock, draw, check."));
  cohortLabel_->setText(tr("&Cohort"));
  design_->setTitle(tr("Design"));
  methodLabel_->setText(tr("&Method"));
  factorsLabel_->setText(tr("Balanced by"));
  blocksLabel_->setText(tr("&Block sizes"));
  blocks_->setToolTip(tr("Multiples of the number of groups; several are mixed at random"));
  for (const auto& [factor, box] : factors_) {
    box->setText(toQString(labelOf(factor)));
  }
  for (int i = 0; i < method_->count(); ++i) {
    method_->setItemText(i, toQString(labelOf(static_cast<AllocationMethod>(method_->itemData(i).toInt()))));
  }
  previewButton_->setText(tr("&Preview balance"));
  lock_->setText(tr("&Lock design\u2026"));
  state_->setTitle(tr("Current design"));
  allocate_->setText(tr("&Allocate everybody"));
  cards_->setText(tr("Ca&rds\u2026"));
  cards_->setToolTip(tr("A printable page with a label and a card for each envelope"));
  reveal_->setText(tr("&Open the seal\u2026"));
  check_->setText(tr("Chec&k the draw"));
  move_->setText(tr("Mo&ve by hand\u2026"));
  move_->setToolTip(tr("Moves a trainee to a group other than the one drawn, with a reason"));
  balance_->setColumns({{tr("Detail")},
                        {tr("Value")},
                        {tr("Trainees"), true},
                        {tr("Expected")},
                        {tr("Usual difference"), true},
                        {tr("Worst"), true}});
  balance_->setEmptyText(tr("Preview the balance to see how even the groups would be."));
  records_->setColumns(
      {{tr("No."), true}, {tr("Trainee")}, {tr("Group")}, {tr("Number"), true}, {tr("How")}, {tr("Hash")}});
  records_->setEmptyText(tr("Nobody is allocated yet."));
  recordsTitle_->setText(tr("Allocations"));
  showBalance();
  attempt(shell(), [&] { showDesign(); });
}

}  // namespace torsio::gui
