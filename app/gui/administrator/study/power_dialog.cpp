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

enum Design { kTwoGroups, kBeforeAfter, kSeveralGroups, kAgreement };

constexpr int kPowerDialogWidth = 560;
constexpr int kMaxRaters = 50;

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
      alpha_(spinOf(this, "alpha", 0.01, 0.2, kDefaultAlpha)),
      correlation_(spinOf(this, "correlation", 0.0, 0.95, 0.5)),
      icc_(spinOf(this, "icc", 0.05, 0.95, 0.7)),
      width_(spinOf(this, "width", 0.05, 1.0, 0.3)),
      raters_(new QSpinBox(this)),
      atHand_(new QSpinBox(this)),
      form_(new QFormLayout),
      needed_(sentence(this, false)),
      shown_(sentence(this, false)) {
  setWindowTitle(tr("How many trainees and raters?"));
  setMinimumWidth(kPowerDialogWidth);
  design_->setObjectName(QStringLiteral("design"));
  needed_->setObjectName(QStringLiteral("needed"));
  shown_->setObjectName(QStringLiteral("shown"));
  design_->addItem(tr("two groups (t test, Cohen's d)"));
  design_->addItem(tr("one group before and after (d of the differences)"));
  design_->addItem(tr("several groups (analysis of variance, Cohen's f)"));
  design_->addItem(tr("agreement of raters (ICC, width of its 95 % interval)"));
  raters_->setObjectName(QStringLiteral("raters"));
  raters_->setRange(2, kMaxRaters);
  raters_->setValue(4);
  groups_->setRange(3, 10);
  atHand_->setObjectName(QStringLiteral("atHand"));
  atHand_->setRange(3, 1000);
  atHand_->setValue(10);
  form_->addRow(tr("&Comparison"), design_);
  form_->addRow(tr("&Groups"), groups_);
  form_->addRow(tr("&Effect that must not be missed"), effect_);
  form_->addRow(tr("&Power wanted"), power_);
  form_->addRow(tr("Significance &level"), alpha_);
  form_->addRow(tr("Co&rrelation of the scores before and after"), correlation_);
  form_->addRow(tr("Agreement of one rater e&xpected (ICC)"), icc_);
  form_->addRow(tr("&Width of its interval, at most"), width_);
  form_->addRow(tr("R&aters who score everybody"), raters_);
  form_->addRow(tr("Needed"), needed_);
  form_->addRow(tr("Trainees at &hand, each group"), atHand_);
  form_->addRow(tr("What they show"), shown_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  column->addLayout(form_);
  auto* raters = sentence(this);
  raters->setText(
      tr("How many raters a mean score needs stands under Results, in the section Raters, once marks are "
         "there."));
  column->addWidget(raters);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(design_, &QComboBox::currentIndexChanged, this, &PowerDialog::showAnswer);
  for (QSpinBox* spin : {groups_, raters_, atHand_}) {
    connect(spin, &QSpinBox::valueChanged, this, &PowerDialog::showAnswer);
  }
  for (QDoubleSpinBox* spin : {effect_, power_, alpha_, correlation_, icc_, width_}) {
    connect(spin, &QDoubleSpinBox::valueChanged, this, &PowerDialog::showAnswer);
  }
  showAnswer();
}

void PowerDialog::showAnswer() {
  const int design = design_->currentIndex();
  for (QDoubleSpinBox* of : {effect_, power_, alpha_}) {
    form_->setRowVisible(of, design != kAgreement);
  }
  form_->setRowVisible(groups_, design == kSeveralGroups);
  form_->setRowVisible(correlation_, design == kTwoGroups || design == kSeveralGroups);
  qobject_cast<QLabel*>(form_->labelForField(atHand_))
      ->setText(design == kTwoGroups || design == kSeveralGroups ? tr("Trainees at &hand, each group")
                                                                 : tr("Trainees at &hand"));
  for (QWidget* of :
       {static_cast<QWidget*>(icc_), static_cast<QWidget*>(width_), static_cast<QWidget*>(raters_)}) {
    form_->setRowVisible(of, design == kAgreement);
  }
  if (design == kAgreement) {
    showAgreement();
    return;
  }
  const int groups = groups_->value();
  const double n = atHand_->value();
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
  growToSentences(this);
}

void PowerDialog::showAgreement() {
  const auto sizeFor = [this](int raters) {
    return std::ceil(sizeIccWidth(icc_->value(), raters, width_->value()));
  };
  needed_->setText(tr("%1 trainees, each scored by %2 raters")
                       .arg(QString::number(sizeFor(raters_->value()), 'f', 0))
                       .arg(raters_->value()));
  int raters = 2;
  while (raters < kMaxRaters && sizeFor(raters) > atHand_->value()) {
    ++raters;
  }
  shown_->setText(sizeFor(raters) <= atHand_->value()
                      ? tr("%1 raters are enough for this width").arg(raters)
                      : tr("too few for this width, however many raters score them"));
  growToSentences(this);
}

}  // namespace torsio::gui
