// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/competence_dialog.h"

#include <algorithm>
#include <initializer_list>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/services/recording/competence.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kDialogWidth = 640;

QDoubleSpinBox* shareField(QWidget* parent, const char* name) {
  auto* field = new QDoubleSpinBox(parent);
  field->setObjectName(QString::fromLatin1(name));
  field->setRange(0.1, 99.9);
  field->setDecimals(1);
  field->setSuffix(QStringLiteral(" %"));
  return field;
}

}  // namespace

CompetenceDialog::CompetenceDialog(ShellContext& shell, const CurriculumVersionId& versionId, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      versionId_(versionId),
      exercise_(new QComboBox(this)),
      inForce_(sentence(this)),
      source_(new QComboBox(this)),
      tolerance_(new QDoubleSpinBox(this)),
      cohort_(new QComboBox(this)),
      take_(new QPushButton(tr("Derive from &experts"), this)),
      standard_(sentence(this)),
      adequate_(shareField(this, "adequate")),
      inadequate_(shareField(this, "inadequate")),
      attempts_(new QSpinBox(this)),
      falsePass_(shareField(this, "false-pass")),
      falseFail_(shareField(this, "false-fail")),
      reason_(new QLineEdit(this)),
      preview_(sentence(this, false)),
      form_(new QFormLayout) {
  build();
  fillCohorts(cohort_, shell_.session(), CohortFirst::kStudy);
  read();
}

void CompetenceDialog::build() {
  setWindowTitle(tr("When trainees count as competent"));
  setMinimumWidth(kDialogWidth);
  exercise_->setObjectName(QStringLiteral("exercise"));
  source_->setObjectName(QStringLiteral("source"));
  tolerance_->setObjectName(QStringLiteral("tolerance"));
  attempts_->setObjectName(QStringLiteral("attempts"));
  preview_->setObjectName(QStringLiteral("preview"));
  inForce_->setObjectName(QStringLiteral("in-force"));
  for (const Term<ToleranceSource>& term : kToleranceSources) {
    source_->addItem(toQString(Text(term.label)), static_cast<int>(term.value));
  }
  tolerance_->setRange(0.1, 180.0);
  tolerance_->setDecimals(1);
  tolerance_->setSuffix(QStringLiteral("\u00b0"));
  attempts_->setRange(1, static_cast<int>(kMaxCompetenceAttempts));
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
  form_->addRow(tr("Attempts &planned"), attempts_);
  form_->addRow(tr("&Wrong passes, at most"), falsePass_);
  form_->addRow(tr("Wrong &fails, at most"), falseFail_);
  form_->addRow(tr("&Reason"), reason_);
  form_->addRow(tr("Effect"), preview_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  auto* rule = sentence(this);
  rule->setText(
      tr("An attempt is a completed twist or an untwisting. A registered design never changes; a new one "
         "applies to trainees who begin after its registration."));
  column->addWidget(rule);
  column->addLayout(form_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  register_ = buttons->addButton(tr("Register"), QDialogButtonBox::ActionRole);
  register_->setObjectName(QStringLiteral("register"));
  column->addWidget(buttons);

  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(register_, &QPushButton::clicked, this, &CompetenceDialog::registerDesign);
  connect(take_, &QPushButton::clicked, this, &CompetenceDialog::takeFromExperts);
  connect(exercise_, &QComboBox::currentIndexChanged, this, &CompetenceDialog::showExercise);
  connect(source_, &QComboBox::currentIndexChanged, this, &CompetenceDialog::showPreview);
  connect(attempts_, &QSpinBox::valueChanged, this, &CompetenceDialog::showPreview);
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
                    toQString(competenceErrorText(newest, competenceErrors(newest, newest.attempts))));
  filling_ = true;
  experts_ = newest.experts;
  source_->setCurrentIndex(source_->findData(static_cast<int>(newest.source)));
  tolerance_->setValue(degrees(newest.tolerance_rad));
  adequate_->setValue(100.0 * newest.adequate);
  inadequate_->setValue(100.0 * newest.inadequate);
  attempts_->setValue(static_cast<int>(newest.attempts));
  falsePass_->setValue(100.0 * newest.falsePassMost);
  falseFail_->setValue(100.0 * newest.falseFailMost);
  reason_->clear();
  standard_->clear();
  form_->setRowVisible(standard_, false);
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
  design.falsePassMost = falsePass_->value() / 100.0;
  design.falseFailMost = falseFail_->value() / 100.0;
  design.reason = reason_->text().trimmed().toStdString();
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
               .arg(toQString(competenceErrorText(preview.design, preview.errors)));
    if (!preview.falseFailKept) {
      ready = false;
      said += QLatin1Char('\n') +
              tr("Too many would fail wrongly: plan more attempts, or choose rates further apart.");
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

bool CompetenceDialog::registerDesign() {
  return attempt(shell_, [&] {
    const CompetenceDesign stored = registerCompetence(shell_.session(), entered());
    shell_.notify(tr("Registered as version %1.").arg(stored.version));
    read();
  });
}

}  // namespace torsio::gui
