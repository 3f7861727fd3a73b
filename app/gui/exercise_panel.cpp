// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/exercise_panel.h"

#include <cmath>
#include <numbers>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/look/card.h"
#include "app/gui/look/theme.h"

namespace torsio::gui {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kLargestTarget_deg = 360.0;

template <typename Field>
Field* addField(QGridLayout* grid, const QString& name, Field* field) {
  const int row = grid->rowCount();
  auto* label = new QLabel(name);
  label->setProperty("quiet", true);
  label->setBuddy(field);
  QString plain = name;
  field->setAccessibleName(plain.remove(QLatin1Char('&')));
  field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  grid->addWidget(label, row, 0);
  grid->addWidget(field, row, 1);
  return field;
}

QComboBox* makeBox() {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  return box;
}

}  // namespace

ExercisePanel::ExercisePanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* card = new Card(tr("Exercise"), this);
  auto* grid = new QGridLayout;
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setVerticalSpacing(kSpace - 2);
  grid->setColumnStretch(1, 1);
  organ_ = addField(grid, tr("&Organ"), makeBox());
  pattern_ = addField(grid, tr("&Pattern"), makeBox());
  formulation_ = addField(grid, tr("&Model"), makeBox());
  formulation_->addItem(tr("Saint-Venant"), static_cast<int>(Formulation::kSaintVenant));
  formulation_->addItem(tr("As in the paper"), static_cast<int>(Formulation::kPaper));
  formulation_->setToolTip(tr("Which reading of the equations turns the organ"));
  target_ = addField(grid, tr("&Target"), new QDoubleSpinBox);
  target_->setRange(-kLargestTarget_deg, kLargestTarget_deg);
  target_->setDecimals(0);
  target_->setSingleStep(5.0);
  target_->setSuffix(QString(QChar(0x00B0)));
  target_->setKeyboardTracking(false);
  target_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  card->content()->addLayout(grid);
  column->addWidget(card);

  connect(organ_, &QComboBox::activated, this, [this](int index) {
    const QString id = organ_->itemData(index).toString();
    if (!id.isEmpty()) Q_EMIT organChosen(id);  // empty: the user's own, shown already
  });
  connect(pattern_, &QComboBox::activated, this,
          [this](int index) { Q_EMIT patternChosen(pattern_->itemData(index).toString()); });
  connect(formulation_, &QComboBox::activated, this, [this](int index) {
    Q_EMIT formulationChosen(static_cast<Formulation>(formulation_->itemData(index).toInt()));
  });
  connect(target_, &QDoubleSpinBox::valueChanged, this,
          [this](double degrees) { Q_EMIT targetChosen(degrees * kRadPerDeg); });
}

QString ExercisePanel::readable(const std::string& id) {
  QString text = QString::fromStdString(id).replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

void ExercisePanel::setOrgans(const std::vector<std::string>& ids) {
  const QSignalBlocker quiet(organ_);
  organ_->clear();
  for (const std::string& id : ids) organ_->addItem(readable(id), QString::fromStdString(id));
}

void ExercisePanel::showScene(const Scene& scene, double target_rad, bool ownOrgan) {
  const QSignalBlocker quietOrgan(organ_);
  const QSignalBlocker quietPattern(pattern_);
  const QSignalBlocker quietFormulation(formulation_);
  const QSignalBlocker quietTarget(target_);
  const int old = organ_->findData(QString());
  if (old >= 0) organ_->removeItem(old);
  if (ownOrgan) organ_->addItem(QString::fromStdString(scene.title), QString());
  organ_->setCurrentIndex(organ_->findData(ownOrgan ? QString() : QString::fromStdString(scene.id)));
  pattern_->clear();
  for (const TwistPattern& pattern : scene.patterns) {
    const QString title =
        pattern.title.empty() ? readable(pattern.id) : QString::fromStdString(pattern.title);
    pattern_->addItem(title, QString::fromStdString(pattern.id));
  }
  pattern_->setCurrentIndex(pattern_->findData(QString::fromStdString(scene.pattern.id)));
  pattern_->setToolTip(QString::fromStdString(scene.pattern.source));
  formulation_->setCurrentIndex(formulation_->findData(static_cast<int>(scene.model.options().formulation)));
  target_->setValue(std::round(target_rad / kRadPerDeg));
}

void ExercisePanel::setChangeable(bool changeable) {
  for (QWidget* field : {static_cast<QWidget*>(organ_), static_cast<QWidget*>(pattern_),
                         static_cast<QWidget*>(formulation_), static_cast<QWidget*>(target_)}) {
    field->setEnabled(changeable);
  }
}

}  // namespace torsio::gui
