// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/list_dialogs.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/people/consent_service.h"
#include "app/study/cohort_service.h"
#include "assessment/people/consent.h"
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

ConsentDialog::ConsentDialog(ShellContext& shell, PersonId personId, const QString& code, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      personId_(std::move(personId)),
      purpose_(new QComboBox(this)),
      granted_(new QPushButton(tr("&Given"), this)),
      withdrawn_(new QPushButton(tr("&Withdrawn"), this)),
      decisions_(new DataTable(QString(), this)) {
  QVBoxLayout* column =
      columnOf(*this, tr("Consents of %1").arg(code),
               tr("Every decision is kept; the newest about a purpose counts. Enter here what "
                  "was signed on paper."));
  purpose_->setObjectName(QStringLiteral("purpose"));
  granted_->setObjectName(QStringLiteral("granted"));
  withdrawn_->setObjectName(QStringLiteral("withdrawn"));
  decisions_->setObjectName(QStringLiteral("decisions"));
  const std::string language = languageCode(presentLanguage()).toStdString();
  for (const ConsentText& text : consentTexts(shell_.assets(), language)) {
    purpose_->addItem(toQString(text.title),
                      QVariant(QStringList{toQString(text.purpose), toQString(text.version)}));
    purpose_->setItemData(purpose_->count() - 1, toQString(text.text), Qt::ToolTipRole);
  }
  decisions_->setColumns({{tr("When")}, {tr("Purpose")}, {tr("Decision")}, {tr("Text")}});
  decisions_->setEmptyText(tr("Nothing was decided yet."));
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpace);
  QLabel* label = fieldBeside(row, purpose_);
  label->setText(tr("On &paper"));
  row->addWidget(granted_);
  row->addWidget(withdrawn_);
  row->addStretch(1);
  column->addLayout(row);
  column->addWidget(decisions_, 1);
  addClose(*this, column);
  for (QWidget* field : std::initializer_list<QWidget*>{purpose_, granted_, withdrawn_}) {
    field->setEnabled(shell_.may(Operation::kConsentRecord));
  }
  connect(granted_, &QPushButton::clicked, this, [this] { record(true); });
  connect(withdrawn_, &QPushButton::clicked, this, [this] { record(false); });
  read();
}

QString ConsentDialog::titleOf(const std::string& purpose) const {
  for (int i = 0; i < purpose_->count(); ++i) {
    if (purpose_->itemData(i).toStringList().front() == toQString(purpose)) {
      return purpose_->itemText(i);
    }
  }
  return toQString(purpose);
}

void ConsentDialog::read() {
  attempt(shell_, [&] {
    std::vector<ConsentDecision> all = consentHistory(shell_.session(), personId_);
    std::reverse(all.begin(), all.end());
    std::vector<Row> rows;
    for (const ConsentDecision& one : all) {
      rows.push_back({QString::number(rows.size()),
                      {timeCell(one.decidedUtc_us),
                       {titleOf(one.purpose)},
                       {one.granted ? tr("given") : tr("withdrawn")},
                       {toQString(one.textVersion)}}});
    }
    decisions_->setRows(std::move(rows));
  });
}

void ConsentDialog::record(bool granted) {
  const QStringList chosen = purpose_->currentData().toStringList();
  attempt(shell_, [&] {
    recordConsent(shell_.session(), personId_, chosen.at(0).toStdString(), granted,
                  chosen.at(1).toStdString());
  });
  read();
}

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
