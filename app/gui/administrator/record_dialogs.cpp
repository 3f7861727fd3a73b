// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/record_dialogs.h"

#include <algorithm>
#include <array>

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/administrator_parts.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "assessment/people/retention.h"
#include "assessment/study/cohort.h"

namespace torsio::gui {

namespace {

constexpr std::array kCategories = {kRetainTrainee, kRetainRater, kRetainLeft, kRetainWithdrawn};
constexpr int kLongest_days = 36'500;
constexpr int kUsual_days = 3'650;

struct RecordDialogs {
  Q_DECLARE_TR_FUNCTIONS(RecordDialogs)
};

/// A dialog with a sentence, content and the two buttons.
struct Asked {
  Asked(QWidget* parent, const QString& title, const QString& question) : dialog(parent) {
    dialog.setWindowTitle(title);
    column = new QVBoxLayout(&dialog);
    column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
    column->setSpacing(2 * kSpace);
    column->addWidget(sentence(&dialog, question));
  }
  static QLabel* sentence(QWidget* parent, const QString& text) {
    QLabel* label = gui::sentence(parent, false);
    label->setText(text);
    return label;
  }
  QPushButton* finish(const QString& accept) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    buttons->button(QDialogButtonBox::Ok)->setText(accept);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    column->addWidget(buttons);
    return buttons->button(QDialogButtonBox::Ok);
  }

  QDialog dialog;
  QVBoxLayout* column;
};

/// The fields of one category.
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
  row.days->setSuffix(RecordDialogs::tr(" days"));
  row.days->setAccessibleName(RecordDialogs::tr("Days: %1").arg(row.wanted->text()));
  row.basis->setPlaceholderText(RecordDialogs::tr("lawful basis"));
  row.basis->setAccessibleName(RecordDialogs::tr("Lawful basis: %1").arg(row.wanted->text()));
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
    return RecordDialogs::tr("trainee");
  }
  if (code == kRetainRater) {
    return RecordDialogs::tr("rater");
  }
  if (code == kRetainLeft) {
    return RecordDialogs::tr("left the centre");
  }
  if (code == kRetainWithdrawn) {
    return RecordDialogs::tr("consent withdrawn");
  }
  return toQString(code);
}

std::optional<RetentionRulesEdit> askRetentionRules(QWidget* parent,
                                                    const std::vector<RetentionRule>& rules) {
  Asked asked(parent, RecordDialogs::tr("Rules for keeping records"),
              RecordDialogs::tr("After this long without activity a record is listed for review. Nothing is "
                                "erased by itself."));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setVerticalSpacing(kSpace);
  grid->setColumnStretch(2, 1);
  std::vector<RuleRow> rows;
  for (const char* category : kCategories) {
    rows.push_back(addRow(asked.dialog, *grid, category, rules));
  }
  asked.column->addLayout(grid);
  QPushButton* ok = asked.finish(RecordDialogs::tr("Keep these rules"));
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
  if (asked.dialog.exec() != QDialog::Accepted) {
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

std::optional<GroupMove> askGroupMove(QWidget* parent, const QString& traineeCode,
                                      const std::vector<StudyGroup>& groups) {
  Asked asked(parent, RecordDialogs::tr("Move to another group"),
              RecordDialogs::tr("%1 was put into a group by the draw. A move by hand stands beside the drawn "
                                "record for good, with its reason, and weakens the study.")
                  .arg(traineeCode));
  auto* group = new QComboBox(&asked.dialog);
  group->setObjectName(QStringLiteral("group"));
  for (const StudyGroup& one : groups) {
    group->addItem(toQString(one.code), toQString(one.id));
  }
  auto* reason = new QLineEdit(&asked.dialog);
  reason->setObjectName(QStringLiteral("reason"));
  auto* form = new QFormLayout;
  form->addRow(RecordDialogs::tr("&Group"), group);
  form->addRow(RecordDialogs::tr("&Reason"), reason);
  asked.column->addLayout(form);
  QPushButton* ok = asked.finish(RecordDialogs::tr("Move"));
  const auto check = [=] { ok->setEnabled(group->count() > 0 && !reason->text().trimmed().isEmpty()); };
  QObject::connect(reason, &QLineEdit::textChanged, ok, check);
  check();
  if (asked.dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  return GroupMove{chosenId(group), reason->text().trimmed().toStdString()};
}

}  // namespace torsio::gui
