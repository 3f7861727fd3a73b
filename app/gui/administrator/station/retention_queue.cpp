// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/station/retention_queue.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/copies_text.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/two_people.h"

namespace torsio::gui {

namespace {

constexpr std::int64_t kYear_us = 365LL * 86'400 * 1'000'000;

std::vector<PersonId> idsOf(const std::vector<const RetentionItem*>& items) {
  std::vector<PersonId> ids;
  for (const RetentionItem* item : items) {
    ids.push_back(item->personId);
  }
  return ids;
}

QString codesOf(const std::vector<const RetentionItem*>& items) {
  return firstFew(namesOf(items, [](const RetentionItem& item) { return item.code; }));
}

}  // namespace

RetentionQueue::RetentionQueue(ShellContext& shell, QWidget* parent)
    : QWidget(parent),
      shell_(shell),
      title_(named(new QLabel(this), "cardTitle")),
      table_(named(new DataTable(QStringLiteral("retention"), this), "queue")),
      keep_(named(listButton(table_), "retentionKeep")),
      lock_(named(listButton(table_), "retentionLock")),
      erase_(named(listButton(table_), "retentionErase")),
      rules_(named(listButton(table_), "retentionRules")) {
  QVBoxLayout* column = columnOf(this, {}, 2 * kSpace);
  column->addWidget(title_);
  column->addWidget(table_, 1);
  connect(keep_, &QPushButton::clicked, this, &RetentionQueue::keepLonger);
  connect(lock_, &QPushButton::clicked, this, &RetentionQueue::lock);
  connect(erase_, &QPushButton::clicked, this, &RetentionQueue::erase);
  connect(rules_, &QPushButton::clicked, this, &RetentionQueue::changeRules);
  connect(table_, &DataTable::currentChanged, this, &RetentionQueue::showButtons);
  retranslate();
}

void RetentionQueue::read() {
  due_.clear();
  if (shell_.may(Operation::kRetentionManage)) {
    due_ = retentionQueue(shell_.session());
  }
  showRows();
}

void RetentionQueue::showRows() {
  std::vector<Row> rows;
  for (const RetentionItem& item : due_) {
    rows.push_back(
        {toQString(item.personId),
         {{toQString(item.code)},
          {retentionCategoryName(item.category)},
          {orDash(item.basis)},
          timeCell(item.sinceUtc_us),
          timeCell(item.dueUtc_us),
          {!item.held                           ? tr("to be reviewed")
           : item.hold->kind == HoldKind::kLock ? tr("locked: %1").arg(toQString(item.hold->reason))
                                                : tr("kept longer: %1").arg(toQString(item.hold->reason))}}});
  }
  table_->setRows(std::move(rows));
  showButtons();
}

std::vector<const RetentionItem*> RetentionQueue::chosen() const {
  return chosenRows(*table_, due_, [](const RetentionItem& item) { return item.personId; });
}

std::vector<const RetentionItem*> RetentionQueue::chosen(bool held) const {
  std::vector<const RetentionItem*> items = chosen();
  std::erase_if(items, [held](const RetentionItem* item) { return item->held != held; });
  return items;
}

void RetentionQueue::showButtons() {
  rules_->setEnabled(shell_.may(Operation::kRetentionManage));
  keep_->setEnabled(!chosen().empty());
  lock_->setEnabled(!chosen().empty());
  // If all selected people are locked, the same button releases them.
  lock_->setText(!chosen().empty() && chosen(false).empty() ? tr("&Release\u2026") : tr("&Lock\u2026"));
  erase_->setEnabled(!chosen(false).empty() && shell_.may(Operation::kPersonErase));
}

void RetentionQueue::changeRules() {
  attempt(shell_, [&] {
    const std::optional<RetentionRulesEdit> edit = askRetentionRules(this, retentionRules(shell_.session()));
    if (!edit) {
      return;
    }
    for (const RetentionRule& rule : edit->set) {
      setRetentionRule(shell_.session(), rule.category, rule.keep_days, rule.basis);
    }
    for (const std::string& category : edit->removed) {
      removeRetentionRule(shell_.session(), category);
    }
    read();
  });
}

void RetentionQueue::keepLonger() {
  const std::vector<const RetentionItem*> items = chosen();
  const std::optional<std::string> reason =
      askReason(this, tr("Keep longer"),
                tr("Kept for another year: %n record(s), %1.", nullptr, static_cast<int>(items.size()))
                    .arg(codesOf(items)));
  if (!reason) {
    return;
  }
  attempt(shell_, [&] {
    extendRecords(shell_.session(), idsOf(items), shell_.session().now_us() + kYear_us, *reason);
    read();
  });
}

void RetentionQueue::lock() {
  const bool back = chosen(false).empty();
  const std::vector<const RetentionItem*> items = chosen(back);
  const auto count = static_cast<int>(items.size());
  const std::optional<std::string> reason =
      back ? askReason(this, tr("Release"),
                       tr("No longer held: %n record(s), %1.", nullptr, count).arg(codesOf(items)))
           : askReason(this, tr("Lock"),
                       tr("Kept until somebody releases them: %n record(s), %1.", nullptr, count)
                           .arg(codesOf(items)));
  if (!reason) {
    return;
  }
  attempt(shell_, [&] {
    if (back) {
      releaseRecords(shell_.session(), idsOf(items), *reason);
    } else {
      lockRecords(shell_.session(), idsOf(items), *reason);
    }
    read();
  });
}

void RetentionQueue::erase() {
  const std::vector<const RetentionItem*> items = chosen(false);
  attempt(shell_, [&] {
    const std::vector<PersonId> who = idsOf(items);
    const RetentionOutcome tried = eraseDue(shell_.session(), who, "dry run", true);
    QString question = tr("The identities of %1 are erased for good, and %n recording(s) with them. Marks "
                          "stay without a person, so that statistics remain right.",
                          nullptr, static_cast<int>(tried.recordings))
                           .arg(codesOf(items));
    question += copiesText(shell_.session(), who, locale());
    const std::optional<std::string> reason = askReason(this, tr("Erase records"), question);
    if (!reason) {
      return;
    }
    std::vector<DutyWish> wishes;
    for (const PersonId& id : who) {
      wishes.push_back({.act = DutyAct::kErase, .subject = id, .reason = *reason});
    }
    static_cast<void>(actOrAskForAll(this, shell_, wishes, [&](const DutyWish& wish) {
      static_cast<void>(eraseDue(shell_.session(), std::array{PersonId(wish.subject)}, *reason, false));
    }));
    read();
  });
}

void RetentionQueue::retranslate() {
  title_->setText(tr("Records due for review"));
  keep_->setText(tr("&Keep longer\u2026"));
  erase_->setText(tr("&Erase\u2026"));
  rules_->setText(tr("R&ules\u2026"));
  rules_->setToolTip(tr("How long records are kept, and on what lawful basis"));
  table_->setColumns({{tr("Person")},
                      {tr("Why")},
                      {tr("Lawful basis")},
                      {tr("Last activity")},
                      {tr("Due since")},
                      {tr("State")}});
  table_->setEmptyText(
      tr("No record is due. \u201cRules\u201d sets how long a record may be inactive before it is listed "
         "here."));
  showRows();
}

namespace {

constexpr std::array kCategories = {kRetainTrainee, kRetainRater, kRetainLeft, kRetainWithdrawn};
constexpr int kLongest_days = 36'500;
constexpr int kUsual_days = 3'650;

struct RetentionDialog {
  Q_DECLARE_TR_FUNCTIONS(RetentionDialog)
};

/// The fields of a category.
struct RuleRow {
  RetentionRule before;
  bool existed = false;
  QCheckBox* wanted = nullptr;
  QSpinBox* days = nullptr;
  QLineEdit* basis = nullptr;
};

RuleRow addRow(QDialog& dialog, QGridLayout& grid, const char* category,
               const std::vector<RetentionRule>& rules) {
  RuleRow row;
  row.before.category = category;
  row.before.keep_days = kUsual_days;
  for (const RetentionRule& rule : rules) {
    if (rule.category == category) {
      row.before = rule;
      row.existed = true;
    }
  }
  const QString name = QLatin1String(category);
  row.wanted = new QCheckBox(retentionCategoryName(category), &dialog);
  row.days = new QSpinBox(&dialog);
  row.basis = new QLineEdit(toQString(row.before.basis), &dialog);
  row.wanted->setObjectName(name);
  row.days->setObjectName(name + QStringLiteral(".days"));
  row.basis->setObjectName(name + QStringLiteral(".basis"));
  row.days->setRange(1, kLongest_days);
  row.days->setValue(static_cast<int>(row.before.keep_days));
  row.days->setSuffix(RetentionDialog::tr(" days"));
  row.days->setAccessibleName(RetentionDialog::tr("Days: %1").arg(row.wanted->text()));
  row.basis->setPlaceholderText(RetentionDialog::tr("lawful basis"));
  row.basis->setAccessibleName(RetentionDialog::tr("Lawful basis: %1").arg(row.wanted->text()));
  row.wanted->setChecked(row.existed);
  for (QWidget* field : {static_cast<QWidget*>(row.days), static_cast<QWidget*>(row.basis)}) {
    field->setEnabled(row.existed);
    QObject::connect(row.wanted, &QCheckBox::toggled, field, &QWidget::setEnabled);
  }
  const int at = grid.rowCount();
  grid.addWidget(row.wanted, at, 0);
  grid.addWidget(row.days, at, 1);
  grid.addWidget(row.basis, at, 2);
  return row;
}

}  // namespace

QString retentionCategoryName(const std::string& code) {
  if (code == kRetainTrainee) {
    return RetentionDialog::tr("trainee");
  }
  if (code == kRetainRater) {
    return RetentionDialog::tr("rater");
  }
  if (code == kRetainLeft) {
    return RetentionDialog::tr("left the centre");
  }
  if (code == kRetainWithdrawn) {
    return RetentionDialog::tr("consent withdrawn");
  }
  return toQString(code);
}

std::optional<RetentionRulesEdit> askRetentionRules(QWidget* parent,
                                                    const std::vector<RetentionRule>& rules) {
  QuestionDialog asked(parent, RetentionDialog::tr("Rules for keeping records"),
                       RetentionDialog::tr("A record that has been inactive for this long is listed for "
                                           "review. Nothing is erased automatically."));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setVerticalSpacing(kSpace);
  grid->setColumnStretch(2, 1);
  std::vector<RuleRow> rows;
  for (const char* category : kCategories) {
    rows.push_back(addRow(asked, *grid, category, rules));
  }
  asked.column()->addLayout(grid);
  QPushButton* ok = asked.finish(RetentionDialog::tr("Save these rules"));
  const auto check = [&rows, ok] {
    ok->setEnabled(std::all_of(rows.begin(), rows.end(), [](const RuleRow& row) {
      return !row.wanted->isChecked() || !row.basis->text().trimmed().isEmpty();
    }));
  };
  for (const RuleRow& row : rows) {
    QObject::connect(row.wanted, &QCheckBox::toggled, ok, check);
    QObject::connect(row.basis, &QLineEdit::textChanged, ok, check);
  }
  check();
  if (asked.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  RetentionRulesEdit edit;
  for (const RuleRow& row : rows) {
    RetentionRule now{row.before.category, row.days->value(), row.basis->text().trimmed().toStdString(), 0};
    const bool same = now.keep_days == row.before.keep_days && now.basis == row.before.basis;
    if (row.wanted->isChecked()) {
      if (!row.existed || !same) {
        edit.set.push_back(std::move(now));
      }
    } else if (row.existed) {
      edit.removed.push_back(now.category);
    }
  }
  return edit;
}

}  // namespace torsio::gui
