// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/statements_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/services/study/study_statements.h"

namespace torsio::gui {

namespace {

constexpr int kColumns = 2;
constexpr int kLines = 2;  // of a field; longer statements scroll
constexpr QSize kStatementsSize(900, 640);

}  // namespace

StatementsDialog::StatementsDialog(const QString& cohort, const StudyStatements& statements, bool mayChange,
                                   QWidget* parent)
    : QDialog(parent) {
  setObjectName(QStringLiteral("statementsDialog"));
  setWindowTitle(tr("About the study %1").arg(cohort));
  resize(kStatementsSize);
  QLabel* words = sentence(this);
  words->setText(tr(
      "What a reviewer asks and the record cannot know. The report prints each statement, or that it is not "
      "recorded. Earlier versions are kept. No names of trainees."));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setVerticalSpacing(kSpace / 2);
  auto* checks = new FieldChecks(this);
  int place = 0;
  for (const Term<StudyItem>& item : kStudyItems) {
    auto* field = named(new QPlainTextEdit(this), item.stored.data());
    field->setTabChangesFocus(true);
    field->setReadOnly(!mayChange);
    field->setPlaceholderText(toQString(Text(hintOf(item.value))));
    field->setMinimumHeight((kLines + 1) * field->fontMetrics().lineSpacing());
    if (const auto stated = statements.find(item.value); stated != statements.end()) {
      field->setPlainText(toQString(stated->second));
    }
    auto* label = new QLabel(this);
    label->setBuddy(field);
    nameField(label, toQString(labelOf(item.value)));
    QLabel* hint = fieldHint(this);
    checks->add(hint, field, [field] {
      return static_cast<std::size_t>(field->toPlainText().trimmed().toUtf8().size()) > kLongestStatement
                 ? tr("Too long: shorten it, and refer to the protocol.")
                 : QString();
    });
    const int line = 3 * (place / kColumns);
    grid->addWidget(label, line, place % kColumns);
    grid->addWidget(field, line + 1, place % kColumns);
    grid->addWidget(hint, line + 2, place % kColumns);
    fields_[item.value] = field;
    ++place;
  }
  auto* buttons = new QDialogButtonBox(this);
  if (mayChange) {
    QPushButton* save = named(buttons->addButton(QDialogButtonBox::Save), "saveStatements");
    save->setText(tr("&Save"));
    checks->decide(save);
  }
  buttons->addButton(mayChange ? QDialogButtonBox::Cancel : QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addLayout(grid, 1);
  column->addWidget(buttons);
}

StudyStatements StatementsDialog::statements() const {
  StudyStatements stated;
  for (const auto& [item, field] : fields_) {
    if (const QString words = field->toPlainText().trimmed(); !words.isEmpty()) {
      stated[item] = words.toStdString();
    }
  }
  return stated;
}

}  // namespace torsio::gui
