// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/reporting/trace_dialog.h"

#include <utility>

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/outputs/wording/printed_minus.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"

namespace torsio::gui {

namespace {

constexpr QSize kDialogSize(1100, 640);
constexpr int kStepWidth = 380;
constexpr int kOpened = 1;  // levels initially expanded

void addStep(const TraceStep& step, QTreeWidgetItem* item, int depth) {
  item->setText(0, toQString(step.what));
  item->setText(1, toQString(step.value));
  item->setToolTip(1, toQString(step.value));
  for (const TraceStep& part : step.madeOf) {
    addStep(part, new QTreeWidgetItem(item), depth + 1);
  }
  item->setExpanded(depth < kOpened);
}

}  // namespace

TraceDialog::TraceDialog(ShellContext& shell, const CohortId& cohortId,
                         std::shared_ptr<const CohortInputs> inputs, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      cohortId_(cohortId),
      inputs_(std::move(inputs)),
      numbers_(new DataTable(QStringLiteral("numbers"), this)),
      steps_(new QTreeWidget(this)) {
  setWindowTitle(tr("Where a number comes from"));
  resize(kDialogSize);
  numbers_->setObjectName(QStringLiteral("numbers"));
  steps_->setObjectName(QStringLiteral("steps"));
  steps_->setHeaderLabels({tr("Made of"), tr("Value")});
  steps_->setAccessibleName(tr("What the chosen number was made of"));
  steps_->setColumnWidth(0, kStepWidth);
  steps_->setAllColumnsShowFocus(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  auto* told = sentence(this);
  told->setText(
      tr("Choose a number; type a code such as T-07 to find those of a person. Below stands what it was made "
         "of: open a step to go on to marks, criteria, scoring sheet, recording and program."));
  column->addWidget(told);
  auto* split = new QSplitter(Qt::Vertical, this);
  split->addWidget(numbers_);
  split->addWidget(steps_);
  split->setChildrenCollapsible(false);
  column->addWidget(split, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(numbers_, &DataTable::currentChanged, this, [this](const QString& id) {
    wanted_ = id;
    start();
  });
  // Another number may have been chosen meanwhile.
  connect(&shell_, &ShellContext::jobEnded, this, [this] {
    running_ = false;
    start();
  });
  fill();
  numbers_->filter().setFocus();  // so that a code can be typed at once
}

void TraceDialog::fill() {
  numbers_->setColumns({{tr("Number")},
                        {tr("Of")},
                        {tr("Group")},
                        {tr("Model or criterion")},
                        {tr("Index or rater")},
                        {tr("Occasion")},
                        {tr("Value"), true}});
  std::vector<Row> rows;
  const Ledger ledger = analysedCohort(*inputs_).ledger;
  for (const Result& result : ledger.every()) {
    const auto [section, item, group, model, index, occasion, statistic] =
        keyCells(result.key, ledger.names());
    const QString value = toQString(resultText(result.value));
    const std::optional<double> number = numberIn(result.value);
    rows.push_back({toQString(keyAddress(result.key, ledger.names())),
                    {{toQString(statistic)},
                     {toQString(item)},
                     {toQString(group)},
                     {toQString(model)},
                     {toQString(index)},
                     {toQString(occasion)},
                     {printedMinus(value), number ? QVariant(*number) : QVariant(), value}}});
  }
  numbers_->setRows(std::move(rows));
}

void TraceDialog::follow(const QString& address) {
  numbers_->select(address);
  wanted_ = address;
  start();
}

void TraceDialog::start() {
  if (running_ || wanted_.isEmpty() || wanted_ == followed_) {
    return;
  }
  running_ = true;
  followed_ = wanted_;
  shell_.run(
      this, tr("Following the number"),
      [cohort = cohortId_, inputs = inputs_, cell = wanted_.toStdString()](SessionContext& session,
                                                                           const ProgressCallback&) {
        return traceNumber(session, cohort, *inputs, cell);
      },
      [this](const TraceStep& step) { show(step); });
}

void TraceDialog::show(const TraceStep& step) {
  steps_->clear();
  auto* top = new QTreeWidgetItem(steps_);
  addStep(step, top, 0);
  steps_->setCurrentItem(top);
}

}  // namespace torsio::gui
