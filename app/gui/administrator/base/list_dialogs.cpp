// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/list_dialogs.h"

#include <algorithm>
#include <map>

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/study/cohort_service.h"
#include "assessment/study/cohort.h"
#include "sim/base/ids.h"

namespace torsio::gui {

namespace {

constexpr int kWidth = 720;
constexpr int kHeight = 460;

struct ListDialogs {
  Q_DECLARE_TR_FUNCTIONS(ListDialogs)
};

QVBoxLayout* columnOf(QDialog& dialog, const QString& title, const QString& words) {
  dialog.setWindowTitle(title);
  auto* column = new QVBoxLayout(&dialog);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  column->setSpacing(2 * kSpace);
  QLabel* label = sentence(&dialog, false);
  label->setText(words);
  column->addWidget(label);
  dialog.resize(kWidth, kHeight);
  return column;
}

void addClose(QDialog& dialog, QVBoxLayout* column) {
  auto* buttons = new QDialogButtonBox(&dialog);
  buttons->addButton(ListDialogs::tr("&Close"), QDialogButtonBox::RejectRole);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  column->addWidget(buttons);
}

}  // namespace

void showDeviations(ShellContext& shell, const CohortId& cohortId, QWidget* parent) {
  std::map<std::string, std::string> codes;
  for (const Enrolment& enrolment : enrolments(shell.session(), cohortId)) {
    codes[enrolment.id] = enrolment.traineeCode;
  }
  std::vector<Row> rows;
  for (const ProtocolDeviation& one : deviations(shell.session(), cohortId)) {
    rows.push_back(
        {toQString(one.id),
         {timeCell(one.happenedUtc_us),
          {one.enrolmentId.empty() ? ListDialogs::tr("the whole cohort") : toQString(codes[one.enrolmentId])},
          {toQString(one.kind)},
          {orDash(one.description)}}});
  }
  std::reverse(rows.begin(), rows.end());
  QDialog dialog(parent);
  QVBoxLayout* column =
      columnOf(dialog, ListDialogs::tr("Deviations"),
               ListDialogs::tr("What went otherwise than the protocol says. The report lists it as well."));
  auto* table = new DataTable(QString(), &dialog);
  table->setObjectName(QStringLiteral("deviations"));
  table->setColumns({{ListDialogs::tr("When")},
                     {ListDialogs::tr("Trainee")},
                     {ListDialogs::tr("Kind")},
                     {ListDialogs::tr("Description")}});
  table->setEmptyText(ListDialogs::tr("No deviation was noted."));
  table->setRows(std::move(rows));
  column->addWidget(table, 1);
  addClose(dialog, column);
  dialog.exec();
}

}  // namespace torsio::gui
