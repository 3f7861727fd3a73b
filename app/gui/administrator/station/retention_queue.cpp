// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/retention_queue.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/chosen_rows.h"
#include "app/gui/administrator/base/copies_text.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/base/second_person.h"
#include "app/gui/administrator/station/retention_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
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
      title_(new QLabel(this)),
      table_(new DataTable(QStringLiteral("retention"), this)),
      keep_(listButton(table_)),
      lock_(listButton(table_)),
      erase_(listButton(table_)),
      rules_(listButton(table_)) {
  title_->setObjectName(QStringLiteral("cardTitle"));
  table_->setObjectName(QStringLiteral("queue"));
  keep_->setObjectName(QStringLiteral("retentionKeep"));
  lock_->setObjectName(QStringLiteral("retentionLock"));
  erase_->setObjectName(QStringLiteral("retentionErase"));
  rules_->setObjectName(QStringLiteral("retentionRules"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2 * kSpace);
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

}  // namespace torsio::gui
