// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/consent_dialog.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QDateEdit>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/access/all_or_none.h"
#include "app/services/access/first_run.h"
#include "app/services/people/consent_service.h"

namespace torsio::gui {

namespace {

constexpr int kDecisionsWidth = 820;
constexpr int kDecisionsHeight = 480;

std::string ownLanguage() {
  return languageCode(presentLanguage()).toStdString();
}

}  // namespace

ConsentDialog::ConsentDialog(ShellContext& shell, People people, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      people_(std::move(people)),
      version_(named(new QComboBox(this), "version")),
      purpose_(named(new QComboBox(this), "purpose")),
      signed_(named(new QDateEdit(QDate::currentDate(), this), "signed")),
      granted_(named(new QPushButton(tr("&Given"), this), "granted")),
      withdrawn_(named(new QPushButton(tr("&Withdrawn"), this), "withdrawn")),
      print_(named(new QPushButton(tr("&Print a form\u2026"), this), "printForm")),
      decisions_(named(new DataTable(QString(), this), "decisions")) {
  setWindowTitle(tr("Consents of %1").arg(codes()));
  resize(kDecisionsWidth, kDecisionsHeight);
  signed_->setCalendarPopup(true);
  showAsDate(signed_);
  signed_->setMaximumDate(QDate::currentDate());
  version_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  purpose_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  QVBoxLayout* column = pageColumn(this);
  QLabel* words = sentence(this, false);
  words->setText(
      people_.size() == 1
          ? tr("Every decision is kept; the newest about a purpose counts. Enter here what was signed on "
               "paper.")
          : tr("Enter here what all %n of them signed on paper on the same day. Every decision is kept; the "
               "newest of a person about a purpose counts.",
               nullptr, static_cast<int>(people_.size())));
  column->addWidget(words);
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpace);
  nameField(addField(row, version_), tr("&Text"));
  nameField(addField(row, purpose_), tr("P&urpose"));
  nameField(addField(row, signed_), tr("&Signed on"));
  row->addWidget(granted_);
  row->addWidget(withdrawn_);
  row->addStretch(1);
  column->addLayout(row);
  column->addWidget(decisions_, 1);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(print_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  pressNothingByEnter(*this);
  decisions_->setColumns({{tr("Person")},
                          {tr("When")},
                          {tr("Purpose")},
                          {tr("Decision")},
                          {tr("How")},
                          {tr("Signed on")},
                          {tr("Text")}});
  decisions_->setEmptyText(tr("Nothing was decided yet."));
  for (QWidget* field : std::initializer_list<QWidget*>{version_, purpose_, signed_, granted_, withdrawn_}) {
    field->setEnabled(shell_.may(Operation::kConsentRecord));
  }
  connect(version_, &QComboBox::currentIndexChanged, this, &ConsentDialog::showPurposes);
  connect(granted_, &QPushButton::clicked, this, [this] { record(true); });
  connect(withdrawn_, &QPushButton::clicked, this, [this] { record(false); });
  connect(print_, &QPushButton::clicked, this, &ConsentDialog::print);
  readVersions();
  read();
}

QString ConsentDialog::codes() const {
  QStringList codes;
  for (const auto& [id, code] : people_) {
    codes << code;
  }
  return firstFew(codes);
}

void ConsentDialog::readVersions() {
  attempt(shell_, [&] {
    versions_ = consentVersions(shell_.session(), shell_.assets());
    for (auto version = versions_.rbegin(); version != versions_.rend(); ++version) {
      version_->addItem(toQString(version->id));
    }
  });
}

const ConsentVersion* ConsentDialog::chosen() const {
  for (const ConsentVersion& version : versions_) {
    if (version.id == version_->currentText().toStdString()) {
      return &version;
    }
  }
  return nullptr;
}

void ConsentDialog::showPurposes() {
  const QString before = purpose_->currentData().toString();
  purpose_->clear();
  const ConsentVersion* version = chosen();
  if (version == nullptr) {
    return;
  }
  for (const ConsentText& text : wordsIn(*version, ownLanguage()).texts) {
    purpose_->addItem(toQString(text.title), toQString(text.purpose));
    purpose_->setItemData(purpose_->count() - 1, toQString(text.text), Qt::ToolTipRole);
  }
  purpose_->setCurrentIndex(std::max(0, purpose_->findData(before)));
}

QString ConsentDialog::titleOf(const std::string& purpose, const std::string& version) const {
  QString title = toQString(purpose);
  for (const ConsentVersion& one : versions_) {
    for (const ConsentText& text : wordsIn(one, ownLanguage()).texts) {
      if (text.purpose == purpose) {
        title = toQString(text.title);
      }
    }
    if (one.id == version) {
      break;
    }
  }
  return title;
}

void ConsentDialog::read() {
  attempt(shell_, [&] {
    std::vector<Row> rows;
    for (const auto& [id, code] : people_) {
      std::vector<ConsentDecision> all = consentHistory(shell_.session(), id);
      std::reverse(all.begin(), all.end());
      for (const ConsentDecision& one : all) {
        rows.push_back({QString::number(rows.size()),
                        {{code},
                         timeCell(one.decidedUtc_us),
                         {titleOf(one.purpose, one.textVersion)},
                         {one.granted ? tr("given") : tr("withdrawn")},
                         {toQString(labelOf(one.form))},
                         timeCell(one.signedUtc_us),
                         {toQString(one.textVersion)}}});
      }
    }
    decisions_->setRows(std::move(rows));
  });
}

void ConsentDialog::record(bool granted) {
  attempt(shell_, [&] {
    const bool today = signed_->date() == QDate::currentDate();
    allOrNone(shell_.session(), people_, [&](const auto& person) {
      recordConsent(shell_.session(), person.first, purpose_->currentData().toString().toStdString(), granted,
                    version_->currentText().toStdString(),
                    today ? 0 : signed_->date().startOfDay().toMSecsSinceEpoch() * 1000);
    });
  });
  read();
}

void ConsentDialog::print() {
  const ConsentVersion* version = chosen();
  if (version == nullptr) {
    return;
  }
  const QString file =
      askFileToSave(this, tr("Consent form of %1").arg(codes()),
                    QStringLiteral("consent-%1").arg(people_.front().second), tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  attempt(shell_, [&] {
    std::vector<std::string> forms;
    for (const auto& [id, code] : people_) {
      forms.push_back(code.toStdString());
    }
    writeConsentForms(*version, wordsIn(*version, ownLanguage()), forms,
                      toQString(centreSign(shell_.session().connectionWithoutRight()).name), toPath(file));
  });
}

}  // namespace torsio::gui
