// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/engineer_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

/// Returns a number field in which 0 means "none".
QDoubleSpinBox* numberOrNone(double most, int decimals, double step) {
  auto* box = new QDoubleSpinBox;
  box->setRange(0.0, most);
  box->setDecimals(decimals);
  box->setSingleStep(step);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  return box;
}

std::optional<double> numberOf(const QDoubleSpinBox& box) {
  return box.value() == 0.0 ? std::nullopt : std::optional(box.value());
}

/// Returns a combo box with two entries, still without text.
QComboBox* comboOfTwo() {
  auto* box = new QComboBox;
  box->addItems({QString(), QString()});
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(10);
  return box;
}

}  // namespace

EngineerPanel::EngineerPanel(QWidget* parent)
    : QWidget(parent), card_(new Card(QString(), this)), head_(new QToolButton(card_)) {
  body_ = createFields();
  auto* column = bareLayout<QVBoxLayout>(this);
  column->addWidget(card_);
  head_->setCheckable(false);
  head_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  head_->setFocusPolicy(Qt::TabFocus);
  head_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  card_->content()->addWidget(head_);
  card_->content()->addWidget(body_);
  setFolded(true);
  connect(head_, &QToolButton::clicked, this, [this] { setFolded(!body_->isHidden()); });
  connect(apply_, &QPushButton::clicked, this, [this] { Q_EMIT chosen(choice()); });
  connect(reset_, &QPushButton::clicked, this, [this] { Q_EMIT chosen({}); });
  for (QComboBox* box : {drift_, interpolation_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &EngineerPanel::noteChange);
  }
  for (QDoubleSpinBox* box : {modulus_, beta_, foundation_, stiffening_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, &EngineerPanel::noteChange);
  }
  for (QCheckBox* box : {clampLift_, poynting_, restrainedEnds_, taper_, shearCentre_}) {
    connect(box, &QCheckBox::toggled, this, &EngineerPanel::noteChange);
  }
  retranslate();
}

QWidget* EngineerPanel::createFields() {
  auto* body = new QWidget(card_);
  auto* column = bareLayout<QVBoxLayout>(body, kSpace);
  hint_ = sentence(body);
  column->addWidget(hint_);
  modulus_ = numberOrNone(1e6, 0, 500.0);
  drift_ = comboOfTwo();
  interpolation_ = comboOfTwo();
  beta_ = numberOrNone(10000.0, 1, 10.0);
  clampLift_ = new QCheckBox;
  poynting_ = new QCheckBox;
  restrainedEnds_ = new QCheckBox;
  taper_ = new QCheckBox;
  shearCentre_ = new QCheckBox;
  foundation_ = numberOrNone(100.0, 2, 0.1);
  stiffening_ = numberOrNone(10.0, 2, 0.1);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kSpace);
  grid->setVerticalSpacing(kSpace - 2);
  const auto labelled = [grid](QWidget* field) {
    auto* label = new QLabel;
    label->setProperty("quiet", true);
    label->setWordWrap(true);
    label->setBuddy(field);
    grid->addWidget(label, grid->rowCount(), 0);
    grid->addWidget(field, grid->rowCount(), 0);
    return label;
  };
  const auto alone = [grid](QWidget* field) { grid->addWidget(field, grid->rowCount(), 0); };
  modulusLabel_ = labelled(modulus_);
  driftLabel_ = labelled(drift_);
  interpolationLabel_ = labelled(interpolation_);
  betaLabel_ = labelled(beta_);
  alone(clampLift_);
  for (QCheckBox* box : {poynting_, restrainedEnds_, taper_, shearCentre_}) {
    alone(box);
  }
  foundationLabel_ = labelled(foundation_);
  stiffeningLabel_ = labelled(stiffening_);
  ofPaper_ = {interpolationLabel_, interpolation_, betaLabel_, beta_, clampLift_};
  ofSaintVenant_ = {poynting_,        restrainedEnds_, taper_,           shearCentre_,
                    foundationLabel_, foundation_,     stiffeningLabel_, stiffening_};
  column->addLayout(grid);
  state_ = sentence(body);
  column->addWidget(state_);
  apply_ = new QPushButton(body);
  reset_ = new QPushButton(body);
  column->addWidget(apply_);
  column->addWidget(reset_);
  return body;
}

void EngineerPanel::setFolded(bool folded) {
  body_->setHidden(folded);
  head_->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
}

void EngineerPanel::setChangeable(bool changeable) {
  body_->setEnabled(changeable);
}

void EngineerPanel::showModel(const TwistModelOptions& options, const Material& material,
                              const ModelChoice& built, bool chosen) {
  const std::vector<QWidget*> fields{modulus_,     drift_,      interpolation_,  beta_,
                                     clampLift_,   poynting_,   restrainedEnds_, taper_,
                                     shearCentre_, foundation_, stiffening_};
  for (QWidget* field : fields) {
    field->blockSignals(true);
  }
  shown_ = built;
  chosen_ = chosen;
  formulation_ = options.formulation;
  modulus_->setValue(material.shearModulus_Pa);
  drift_->setCurrentIndex(options.kriging.drift == Drift::kConstant ? 1 : 0);
  interpolation_->setCurrentIndex(options.paperInterpolation == PaperInterpolation::kComponents ? 1 : 0);
  beta_->setValue(built.beta.value_or(0.0));
  clampLift_->setChecked(options.paper.clampLift);
  poynting_->setChecked(options.poynting);
  restrainedEnds_->setChecked(options.corrections.restrainedEnds);
  taper_->setChecked(options.corrections.taper);
  shearCentre_->setChecked(options.centre == TwistCentre::kShearCentre);
  foundation_->setValue(options.foundationLengths);
  stiffening_->setValue(options.stiffeningStrain);
  for (QWidget* field : fields) {
    field->blockSignals(false);
  }
  modulus_->setProperty("shown", modulus_->value());
  const bool paper = formulation_ == Formulation::kPaper;
  for (QWidget* widget : ofPaper_) {
    widget->setEnabled(paper);
  }
  for (QWidget* widget : ofSaintVenant_) {
    widget->setEnabled(!paper);
  }
  noteChange();
}

ModelChoice EngineerPanel::choice() const {
  ModelChoice asked;
  // An unchanged value is the tissue's, or the one chosen before.
  asked.shearModulus_Pa = modulus_->value() == modulus_->property("shown").toDouble() ? shown_.shearModulus_Pa
                                                                                      : numberOf(*modulus_);
  asked.drift = drift_->currentIndex() == 1 ? std::optional(Drift::kConstant) : std::nullopt;
  asked.interpolation =
      interpolation_->currentIndex() == 1 ? std::optional(PaperInterpolation::kComponents) : std::nullopt;
  asked.beta = numberOf(*beta_);
  asked.clampLift = clampLift_->isChecked();
  asked.poynting = poynting_->isChecked();
  asked.restrainedEnds = restrainedEnds_->isChecked();
  asked.taper = taper_->isChecked();
  asked.shearCentre = shearCentre_->isChecked();
  asked.foundationLengths = numberOf(*foundation_);
  asked.stiffeningStrain = numberOf(*stiffening_);
  return choiceFor(asked, formulation_);
}

void EngineerPanel::noteChange() {
  apply_->setEnabled(!(choice() == shown_));
  reset_->setEnabled(chosen_);
  state_->setText(chosen_ ? tr("The organ is built with this model: nothing can be recorded.")
                          : tr("The organ is built as in its scene."));
}

void EngineerPanel::retranslate() {
  head_->setText(tr("Model (engineer)"));
  head_->setToolTip(tr("The parts of the twist model one by one"));
  hint_->setText(tr("For trying out the equations. Never part of a graded run."));
  nameField(modulusLabel_, tr("Shear modulus G"));
  modulus_->setSuffix(tr(" Pa"));
  nameField(driftLabel_, tr("Drift (Eq. 16)"));
  const QSignalBlocker quietDrift(drift_);
  drift_->setItemText(0, tr("linear"));
  drift_->setItemText(1, tr("constant, as printed"));
  nameField(interpolationLabel_, tr("Interpolation (Eq. 15)"));
  const QSignalBlocker quietInterpolation(interpolation_);
  interpolation_->setItemText(0, tr("the angle"));
  interpolation_->setItemText(1, tr("dX, dY, dZ"));
  nameField(betaLabel_, tr("\u03b2 in sections (Eq. 18)"));
  beta_->setSpecialValueText(tr("infinite"));
  clampLift_->setText(tr("Lift clamp (Eq. 23)"));
  poynting_->setText(tr("Poynting's stretch"));
  restrainedEnds_->setText(tr("Restrained ends"));
  taper_->setText(tr("Taper correction"));
  shearCentre_->setText(tr("About shear centres"));
  nameField(foundationLabel_, tr("Foundation (organ lengths)"));
  foundation_->setSpecialValueText(tr("none"));
  nameField(stiffeningLabel_, tr("Stiffening strain"));
  stiffening_->setSpecialValueText(tr("none"));
  apply_->setText(tr("App&ly"));
  reset_->setText(tr("As in the scene"));
  noteChange();
}

}  // namespace torsio::gui
