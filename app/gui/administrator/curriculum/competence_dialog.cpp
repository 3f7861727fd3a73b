// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/curriculum/competence_dialog.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"
#include "app/services/base/csv_table.h"
#include "app/services/recording/competence.h"
#include "app/services/study/standard_tables.h"
#include "assessment/statistics/standard_setting.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kDialogWidth = 900;

QDoubleSpinBox* shareField(QWidget* parent, const char* name) {
  auto* field = ranged(new QDoubleSpinBox(parent), 0.1, 99.9);
  field->setObjectName(QString::fromLatin1(name));
  field->setDecimals(1);
  field->setSuffix(QStringLiteral(" %"));
  return field;
}

}  // namespace

CompetenceDialog::CompetenceDialog(ShellContext& shell, const CurriculumVersionId& versionId, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      versionId_(versionId),
      exercise_(named(new QComboBox(this), "exercise")),
      inForce_(named(sentence(this), "in-force")),
      source_(named(new QComboBox(this), "source")),
      tolerance_(ranged(named(new QDoubleSpinBox(this), "tolerance"), 0.1, 180.0)),
      cohort_(new QComboBox(this)),
      take_(new QPushButton(tr("Derive from &experts"), this)),
      standard_(sentence(this)),
      adequate_(shareField(this, "adequate")),
      inadequate_(shareField(this, "inadequate")),
      attempts_(ranged(named(new QSpinBox(this), "attempts"), 1, static_cast<int>(kMaxCompetenceAttempts))),
      falsePass_(shareField(this, "false-pass")),
      falseFail_(shareField(this, "false-fail")),
      reason_(new QLineEdit(this)),
      validDays_(ranged(named(new QSpinBox(this), "valid-days"), 0, kMaxValidDays)),
      preview_(named(sentence(this, false), "preview")),
      interrupted_(named(new QComboBox(this), "interrupted")),
      excuse_(named(new QLineEdit(this), "excuse")),
      excuseRun_(named(new QPushButton(tr("E&xcuse"), this), "excuse-run")),
      excuseRow_(new QHBoxLayout),
      form_(new QFormLayout) {
  build();
  fillCohorts(cohort_, shell_.session(), CohortFirst::kStudy);
  read();
}

void CompetenceDialog::build() {
  setWindowTitle(tr("When trainees count as competent"));
  setMinimumWidth(kDialogWidth);
  for (const Term<ToleranceSource>& term : kToleranceSources) {
    source_->addItem(toQString(Text(term.label)), static_cast<int>(term.value));
  }
  tolerance_->setDecimals(1);
  tolerance_->setSuffix(QStringLiteral("\u00b0"));
  auto* experts = new QHBoxLayout;
  experts->addWidget(cohort_, 1);
  experts->addWidget(take_);
  form_->addRow(tr("E&xercise"), exercise_);
  form_->addRow(tr("Current design"), inForce_);
  form_->addRow(tr("Tolerance &source"), source_);
  form_->addRow(tr("&Tolerance"), tolerance_);
  form_->addRow(tr("Experts from cohort"), experts);
  form_->addRow(QString(), standard_);
  form_->addRow(tr("Failure rate when &competent"), adequate_);
  form_->addRow(tr("Failure rate when &not competent"), inadequate_);
  form_->addRow(tr("Runs &planned"), attempts_);
  form_->addRow(tr("&Wrong passes, at most"), falsePass_);
  form_->addRow(tr("Wrong &fails, at most"), falseFail_);
  validDays_->setSpecialValueText(tr("does not expire"));
  validDays_->setSuffix(tr(" days"));
  form_->addRow(tr("&Lasts without a run"), validDays_);
  form_->addRow(tr("&Reason"), reason_);
  form_->addRow(tr("Effect"), preview_);
  excuseRow_->addWidget(interrupted_, 1);
  excuseRow_->addWidget(excuse_, 1);
  excuseRow_->addWidget(excuseRun_);
  excuse_->setPlaceholderText(tr("Why it does not count as failed"));
  form_->addRow(tr("&Interrupted run"), excuseRow_);
  form_->setRowVisible(excuseRow_, false);
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace});
  auto* rule = sentence(this);
  rule->setText(
      tr("A run passes or fails as a whole. A registered design never changes; a new one "
         "applies to trainees who begin after its registration."));
  column->addWidget(rule);
  column->addLayout(form_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  register_ = named(buttons->addButton(tr("Register"), QDialogButtonBox::ActionRole), "register");
  column->addWidget(buttons);

  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(register_, &QPushButton::clicked, this, &CompetenceDialog::registerDesign);
  connect(take_, &QPushButton::clicked, this, &CompetenceDialog::takeFromExperts);
  connect(exercise_, &QComboBox::currentIndexChanged, this, &CompetenceDialog::showExercise);
  connect(source_, &QComboBox::currentIndexChanged, this, &CompetenceDialog::showPreview);
  connect(attempts_, &QSpinBox::valueChanged, this, &CompetenceDialog::showPreview);
  connect(validDays_, &QSpinBox::valueChanged, this, &CompetenceDialog::showPreview);
  connect(excuseRun_, &QPushButton::clicked, this, &CompetenceDialog::excuseChosenRun);
  const auto readyToExcuse = [this] {
    excuseRun_->setEnabled(shell_.may(Operation::kStudySetup) && interrupted_->count() > 0 &&
                           !excuse_->text().trimmed().isEmpty());
  };
  connect(excuse_, &QLineEdit::textChanged, this, readyToExcuse);
  readyToExcuse();
  connect(reason_, &QLineEdit::textChanged, this, &CompetenceDialog::showPreview);
  for (QDoubleSpinBox* field : {tolerance_, adequate_, inadequate_, falsePass_, falseFail_}) {
    connect(field, &QDoubleSpinBox::valueChanged, this, &CompetenceDialog::showPreview);
  }
}

void CompetenceDialog::read() {
  exercises_ = competenceDesigns(shell_.session(), versionId_);
  const QVariant before = exercise_->currentData();
  filling_ = true;
  exercise_->clear();
  for (const ExerciseDesigns& exercise : exercises_) {
    exercise_->addItem(toQString(Text(exercise.title)), toQString(exercise.moduleId));
  }
  exercise_->setCurrentIndex(std::max(0, exercise_->findData(before)));
  filling_ = false;
  showExercise();
}

const ExerciseDesigns* CompetenceDialog::chosen() const {
  const int at = exercise_->currentIndex();
  return at < 0 ? nullptr : &exercises_[static_cast<std::size_t>(at)];
}

void CompetenceDialog::showExercise() {
  const ExerciseDesigns* exercise = chosen();
  if (filling_ || exercise == nullptr) {
    return;
  }
  const CompetenceDesign& newest = exercise->inForce.design;
  inForce_->setText(toQString(competenceRuleText(exercise->inForce)) + QLatin1Char('\n') +
                    toQString(competenceErrorText(newest)));
  filling_ = true;
  experts_ = newest.experts;
  dependence_ = shell_.may(Operation::kCurriculumEdit)
                    ? dependenceOfRuns(shell_.session(), exercise->moduleId)
                    : EstimatedDependence{};
  source_->setCurrentIndex(source_->findData(static_cast<int>(newest.source)));
  tolerance_->setValue(degrees(newest.tolerance_rad));
  adequate_->setValue(100.0 * newest.adequate);
  inadequate_->setValue(100.0 * newest.inadequate);
  attempts_->setValue(static_cast<int>(newest.attempts));
  validDays_->setValue(static_cast<int>(newest.validDays));
  falsePass_->setValue(100.0 * newest.falsePassMost);
  falseFail_->setValue(100.0 * newest.falseFailMost);
  reason_->clear();
  standard_->clear();
  form_->setRowVisible(standard_, false);
  showInterrupted();
  filling_ = false;
  showPreview();
}

CompetenceDesign CompetenceDialog::entered() const {
  CompetenceDesign design;
  const ExerciseDesigns& exercise = *chosen();
  design.moduleId = exercise.moduleId;
  design.source = static_cast<ToleranceSource>(source_->currentData().toInt());
  design.tolerance_rad = design.source == ToleranceSource::kExercise ? exercise.shipped.tolerance_rad
                                                                     : radians(tolerance_->value());
  design.experts = design.source == ToleranceSource::kExperts ? experts_ : 0;
  design.adequate = adequate_->value() / 100.0;
  design.inadequate = inadequate_->value() / 100.0;
  design.attempts = attempts_->value();
  design.validDays = validDays_->value();
  design.falsePassMost = falsePass_->value() / 100.0;
  design.falseFailMost = falseFail_->value() / 100.0;
  design.reason = reason_->text().trimmed().toStdString();
  setDependence(design, dependence_);
  return design;
}

void CompetenceDialog::showPreview() {
  if (filling_ || chosen() == nullptr) {
    return;
  }
  const auto source = static_cast<ToleranceSource>(source_->currentData().toInt());
  tolerance_->setEnabled(source == ToleranceSource::kChosen);
  cohort_->setEnabled(source == ToleranceSource::kExperts);
  take_->setEnabled(source == ToleranceSource::kExperts && cohort_->count() > 0);
  const CompetenceDesign design = entered();
  bool ready = shell_.may(Operation::kCurriculumEdit);
  QString said;
  try {
    const CompetencePreview preview = previewOfCompetence(design);
    said = tr("Limit %1. %2")
               .arg(preview.design.limit, 0, 'f', 2)
               .arg(toQString(competenceErrorText(preview.design)));
    if (!preview.falseFailKept) {
      ready = false;
      said += QLatin1Char('\n') +
              tr("Too many would fail wrongly: plan more runs, or choose rates further apart.");
    }
  } catch (const Error& error) {
    ready = false;
    said = toQString(error.happenedText());
  }
  if (source == ToleranceSource::kChosen && design.reason.empty()) {
    ready = false;
    said += QLatin1Char('\n') + tr("A tolerance chosen by hand needs a reason.");
  }
  if (source == ToleranceSource::kExperts && experts_ == 0) {
    ready = false;
    said += QLatin1Char('\n') + tr("Choose the cohort of the experts and take the tolerance from them.");
  }
  preview_->setText(said);
  setLook(preview_, "caution", !ready);
  register_->setEnabled(ready);
  growToSentences(this);
}

bool CompetenceDialog::takeFromExperts() {
  return attempt(shell_, [&] {
    const ProficiencyThreshold found =
        expertTolerance_deg(shell_.session(), chosen()->moduleId, chosenId(cohort_));
    experts_ = static_cast<std::int64_t>(found.experts);
    standard_->setText(
        tr("%n expert(s): mean error %1\u00b0, mean and one standard deviation %2\u00b0, bound that "
           "covers nine in ten experts %3\u00b0.",
           nullptr, static_cast<int>(found.experts))
            .arg(found.mean, 0, 'f', 2)
            .arg(found.oneDeviation, 0, 'f', 2)
            .arg(found.toleranceBound, 0, 'f', 2));
    form_->setRowVisible(standard_, true);
    tolerance_->setValue(found.toleranceBound);
    showPreview();
  });
}

void CompetenceDialog::showInterrupted() {
  interrupted_->clear();
  for (const InterruptedRun& run : interruptedRuns(shell_.session(), chosen()->moduleId)) {
    if (!run.excused) {
      interrupted_->addItem(tr("%1, %2").arg(toQString(run.trainee), shownTime(run.startedUtc_us)),
                            toQString(run.trialId));
    }
  }
  excuse_->clear();
  form_->setRowVisible(excuseRow_, interrupted_->count() > 0);
}

bool CompetenceDialog::excuseChosenRun() {
  return attempt(shell_, [&] {
    excuseRun(shell_.session(), TrialId(interrupted_->currentData().toString().toStdString()),
              excuse_->text().trimmed().toStdString());
    shell_.notify(tr("Excused. The run does not count as failed."));
    showInterrupted();
  });
}

bool CompetenceDialog::registerDesign() {
  return attempt(shell_, [&] {
    const CompetenceDesign stored = registerCompetence(shell_.session(), entered());
    shell_.notify(tr("Registered as version %1.").arg(stored.version));
    read();
  });
}

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
      method_(named(new QComboBox(this), "method")),
      asks_(sentence(this)),
      table_(named(new QPlainTextEdit(this), "table")),
      borderline_(ranged(named(new QDoubleSpinBox(this), "borderline"), -1000.0, 1000.0)),
      answer_(named(sentence(this, false), "answer")),
      form_(new QFormLayout) {
  setWindowTitle(tr("Pass mark"));
  setMinimumWidth(kStandardWidth);
  method_->addItem(tr("judges say who would succeed (Angoff)"));
  method_->addItem(tr("global ratings beside scores (borderline regression)"));
  method_->addItem(tr("novices and masters (contrasting groups)"));
  table_->setTabChangesFocus(true);
  table_->setMinimumHeight(kMinLines * table_->fontMetrics().lineSpacing());
  borderline_->setDecimals(1);
  borderline_->setValue(3.0);
  form_->addRow(tr("&Method"), method_);
  form_->addRow(QString(), asks_);
  form_->addRow(tr("&Table"), table_);
  form_->addRow(tr("&Rating that means borderline"), borderline_);
  form_->addRow(tr("Result"), answer_);
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace});
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
