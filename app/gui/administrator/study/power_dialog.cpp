// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/power_dialog.h"

#include <cmath>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/widgets/form.h"
#include "assessment/statistics/power.h"

namespace torsio::gui {

namespace {

enum Design { kTwoGroups, kBeforeAfter, kSeveralGroups };

constexpr int kPowerDialogWidth = 560;

QDoubleSpinBox* spinOf(QWidget* parent, const char* name, double low, double high, double value) {
  auto* spin = new QDoubleSpinBox(parent);
  spin->setObjectName(QString::fromLatin1(name));
  spin->setDecimals(2);
  spin->setSingleStep(0.05);
  spin->setRange(low, high);
  spin->setValue(value);
  return spin;
}

double sizeOf(int design, int groups, double effect, double power, double alpha) {
  return design == kTwoGroups     ? sizeTwoSampleT(effect, power, alpha)
         : design == kBeforeAfter ? sizePairedT(effect, power, alpha)
                                  : sizeAnova(groups, effect, power, alpha);
}

double powerOf(int design, int groups, double n, double effect, double alpha) {
  return design == kTwoGroups     ? powerTwoSampleT(n, effect, alpha)
         : design == kBeforeAfter ? powerPairedT(n, effect, alpha)
                                  : powerAnova(groups, n, effect, alpha);
}

double detectableOf(int design, int groups, double n, double power, double alpha) {
  return design == kTwoGroups     ? detectableTwoSampleT(n, power, alpha)
         : design == kBeforeAfter ? detectablePairedT(n, power, alpha)
                                  : detectableAnova(groups, n, power, alpha);
}

}  // namespace

PowerDialog::PowerDialog(QWidget* parent)
    : QDialog(parent),
      design_(new QComboBox(this)),
      groups_(new QSpinBox(this)),
      effect_(spinOf(this, "effect", 0.1, 5.0, 0.8)),
      power_(spinOf(this, "power", 0.5, 0.99, 0.8)),
      alpha_(spinOf(this, "alpha", 0.01, 0.2, kUsualAlpha)),
      correlation_(spinOf(this, "correlation", 0.0, 0.95, 0.5)),
      atHand_(new QSpinBox(this)),
      needed_(sentence(this, false)),
      shown_(sentence(this, false)) {
  setWindowTitle(tr("How many trainees?"));
  setMinimumWidth(kPowerDialogWidth);
  design_->setObjectName(QStringLiteral("design"));
  needed_->setObjectName(QStringLiteral("needed"));
  shown_->setObjectName(QStringLiteral("shown"));
  design_->addItem(tr("two groups (t test, Cohen's d)"));
  design_->addItem(tr("one group before and after (d of the differences)"));
  design_->addItem(tr("several groups (analysis of variance, Cohen's f)"));
  groups_->setRange(3, 10);
  atHand_->setRange(3, 1000);
  atHand_->setValue(10);
  auto* form = new QFormLayout;
  form->addRow(tr("&Comparison"), design_);
  form->addRow(tr("&Groups"), groups_);
  form->addRow(tr("&Effect that must not be missed"), effect_);
  form->addRow(tr("&Power wanted"), power_);
  form->addRow(tr("Significance &level"), alpha_);
  form->addRow(tr("Co&rrelation of the scores before and after"), correlation_);
  form->addRow(tr("Needed"), needed_);
  form->addRow(tr("Trainees at &hand, each group"), atHand_);
  form->addRow(tr("What they show"), shown_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  auto* raters = sentence(this);
  raters->setText(
      tr("How many raters are needed stands under Results, in the section Raters, once marks are there."));
  column->addWidget(raters);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(design_, &QComboBox::currentIndexChanged, this, &PowerDialog::showAnswer);
  for (QSpinBox* spin : {groups_, atHand_}) {
    connect(spin, &QSpinBox::valueChanged, this, &PowerDialog::showAnswer);
  }
  for (QDoubleSpinBox* spin : {effect_, power_, alpha_, correlation_}) {
    connect(spin, &QDoubleSpinBox::valueChanged, this, &PowerDialog::showAnswer);
  }
  showAnswer();
}

void PowerDialog::showAnswer() {
  const int design = design_->currentIndex();
  const int groups = groups_->value();
  const double n = atHand_->value();
  groups_->setEnabled(design == kSeveralGroups);
  correlation_->setEnabled(design != kBeforeAfter);
  const double size = sizeOf(design, groups, effect_->value(), power_->value(), alpha_->value());
  const auto whole = [](double needed) { return static_cast<int>(std::ceil(needed)); };
  needed_->setText(design == kBeforeAfter
                       ? tr("%n trainee(s)", nullptr, whole(size))
                       : tr("%n trainee(s) in each group; %1 when scores are adjusted for the score before",
                            nullptr, whole(size))
                             .arg(whole(sizeWithCovariate(size, correlation_->value()))));
  shown_->setText(tr("power %1 for this effect; with power %2 they detect an effect of %3")
                      .arg(powerOf(design, groups, n, effect_->value(), alpha_->value()), 0, 'f', 2)
                      .arg(power_->value(), 0, 'f', 2)
                      .arg(detectableOf(design, groups, n, power_->value(), alpha_->value()), 0, 'f', 2));
}

}  // namespace torsio::gui
