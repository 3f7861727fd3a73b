// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/retention_dialog.h"

#include <algorithm>
#include <array>

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialog>
#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

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
