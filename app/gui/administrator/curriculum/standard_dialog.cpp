// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/standard_dialog.h"

#include <string>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/outputs/wording/joined_sentences.h"
#include "app/services/base/csv_table.h"
#include "app/services/study/standard_tables.h"
#include "assessment/statistics/standard_setting.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

enum Method { kAngoff, kBorderline, kContrasting };

constexpr int kStandardWidth = 620;
constexpr int kMinLines = 9;

QString inHundredths(double value) {
  return QString::number(value, 'f', 2);
}

QString angoffText(const CsvTable& table) {
  const JudgedItems judged = readJudgedItems(table);
  const Outcome<Angoff> result = angoff(judged.percent);
  if (!result) {
    return toQString(Text(result.reason()));
  }
  const QString cut = StandardDialog::tr("Pass from %1 of %2 items on (%3 %).")
                          .arg(inHundredths(result->cut))
                          .arg(judged.items.size())
                          .arg(inHundredths(result->percent));
  return result->deviation
             ? joinedSentences(
                   {cut, StandardDialog::tr(
                             "%1 judges; they differ by %2 items (standard deviation), the cut is sure "
                             "to %3 (standard error).")
                             .arg(judged.judges.size())
                             .arg(inHundredths(*result->deviation), inHundredths(*result->error))})
             : joinedSentences(
                   {cut, StandardDialog::tr("One judge alone says nothing about how sure this is.")});
}

QString borderlineText(const CsvTable& table, double borderline) {
  const RatedScores rated = readRatedScores(table);
  const Outcome<BorderlineRegression> result = borderlineRegression(rated.ratings, rated.scores, borderline);
  if (!result) {
    return toQString(Text(result.reason()));
  }
  return StandardDialog::tr(
             "Pass from a score of %1 on (standard error %2). The ratings of %3 subjects explain "
             "%4 % of the scores.")
      .arg(inHundredths(result->cut), inHundredths(result->error))
      .arg(rated.scores.size())
      .arg(100.0 * result->rSquared, 0, 'f', 0);
}

QString contrastingText(const CsvTable& table) {
  const ContrastedScores groups = readContrastedScores(table);
  const Outcome<ContrastingGroups> result = contrastingGroups(groups.novices, groups.masters);
  if (!result) {
    return toQString(Text(result.reason()));
  }
  return StandardDialog::tr(
             "Pass from a score of %1 on: %2 % of %3 novices would pass wrongly, %4 % of %5 masters "
             "fail wrongly, were their scores normal.")
      .arg(inHundredths(result->cutNormal))
      .arg(100.0 * result->falsePass, 0, 'f', 0)
      .arg(groups.novices.size())
      .arg(100.0 * result->falseFail, 0, 'f', 0)
      .arg(groups.masters.size());
}

}  // namespace

StandardDialog::StandardDialog(QWidget* parent)
    : QDialog(parent),
      method_(new QComboBox(this)),
      asks_(sentence(this)),
      table_(new QPlainTextEdit(this)),
      borderline_(new QDoubleSpinBox(this)),
      answer_(sentence(this, false)),
      form_(new QFormLayout) {
  setWindowTitle(tr("Pass mark"));
  setMinimumWidth(kStandardWidth);
  method_->setObjectName(QStringLiteral("method"));
  table_->setObjectName(QStringLiteral("table"));
  borderline_->setObjectName(QStringLiteral("borderline"));
  answer_->setObjectName(QStringLiteral("answer"));
  method_->addItem(tr("judges say who would succeed (Angoff)"));
  method_->addItem(tr("global ratings beside scores (borderline regression)"));
  method_->addItem(tr("novices and masters (contrasting groups)"));
  table_->setTabChangesFocus(true);
  table_->setMinimumHeight(kMinLines * table_->fontMetrics().lineSpacing());
  borderline_->setRange(-1000.0, 1000.0);
  borderline_->setDecimals(1);
  borderline_->setValue(3.0);
  form_->addRow(tr("&Method"), method_);
  form_->addRow(QString(), asks_);
  form_->addRow(tr("&Table"), table_);
  form_->addRow(tr("&Rating that means borderline"), borderline_);
  form_->addRow(tr("Result"), answer_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  column->addLayout(form_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(method_, &QComboBox::currentIndexChanged, this, &StandardDialog::showMethod);
  connect(table_, &QPlainTextEdit::textChanged, this, &StandardDialog::showAnswer);
  connect(borderline_, &QDoubleSpinBox::valueChanged, this, &StandardDialog::showAnswer);
  showMethod();
}

void StandardDialog::showMethod() {
  const int method = method_->currentIndex();
  form_->setRowVisible(borderline_, method == kBorderline);
  asks_->setText(
      method == kAngoff
          ? tr("One line for each judge and item: of a hundred borderline trainees, how many would "
               "succeed in it.")
      : method == kBorderline
          ? tr("One line for each subject: the score, and an expert's rating of the whole performance.")
          : tr("One line for each subject: novice or master, as others have judged, and the score; higher is "
               "better."));
  table_->setPlaceholderText(method == kAngoff ? tr("judge,item,percent\nJ1,grip,80\nJ2,grip,70")
                             : method == kBorderline
                                 ? tr("subject,global,score\nT-01,3,14.5\nT-02,4,17")
                                 : tr("subject,group,score\nT-01,novice,11\nT-02,master,17"));
  showAnswer();
}

void StandardDialog::showAnswer() {
  readAnswer();
  growToSentences(this);
}

void StandardDialog::readAnswer() {
  setLook(answer_, "caution", false);
  const QString text = table_->toPlainText();
  if (text.trimmed().isEmpty()) {
    answer_->setText(tr("Paste the table above, with its first line as in the example."));
    return;
  }
  try {
    const std::string bytes = text.toStdString();
    const std::string name = tr("table").toStdString();
    const int method = method_->currentIndex();
    answer_->setText(method == kAngoff
                         ? angoffText(CsvTable::parse(bytes, name, {"judge", "item", "percent"}))
                     : method == kBorderline
                         ? borderlineText(CsvTable::parse(bytes, name, {"subject", "global", "score"}),
                                          borderline_->value())
                         : contrastingText(CsvTable::parse(bytes, name, {"subject", "group", "score"})));
  } catch (const Error& error) {
    setLook(answer_, "caution", true);
    answer_->setText(tr("%1: %2").arg(translated(error).details, translatedLine(error)));
  }
}

}  // namespace torsio::gui
