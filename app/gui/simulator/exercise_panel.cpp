// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/exercise_panel.h"

#include <cmath>

#include <QAbstractItemView>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/signed_box.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/angle.h"
#include "sim/core/time_units.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/hollow_validity.h"

namespace torsio::gui {

namespace {

constexpr int kEnglishRole = Qt::UserRole + 1;
constexpr double kLargestTarget_deg = 360.0;
constexpr int kBesideItems = 16;  ///< items of asynchronous models; formulations have smaller numbers

int itemOf(TissueModel tissue) {
  return kBesideItems + static_cast<int>(tissue);
}

QLabel* addField(QGridLayout* grid, QWidget* field) {
  const int row = grid->rowCount();
  auto* label = new QLabel;
  label->setProperty("quiet", true);
  label->setBuddy(field);
  field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  grid->addWidget(label, row, 0);
  grid->addWidget(field, row, 1);
  return label;
}

void name(QLabel* label, const QString& text) {
  label->setText(text);
  // Chinese mnemonics are in brackets at the end and not part of the name.
  static const QRegularExpression kMnemonic(QStringLiteral("\\(&.\\)|&"));
  QString plain = text;
  label->buddy()->setAccessibleName(plain.remove(kMnemonic));
}

void rename(QComboBox* box, int index, const QString& text) {
  if (index >= 0) {
    box->setItemText(index, text);
  }
}

/// Makes an open list as wide as its longest line, even if the closed field is narrower.
void fitPopupToLines(QComboBox* box) {
  constexpr int kRoundLine = 28;  // padding of a line and the list
  box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0) + kRoundLine);
}

QComboBox* makeBox() {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  return box;
}

}  // namespace

ExercisePanel::ExercisePanel(QWidget* parent)
    : QWidget(parent),
      card_(new Card(QString(), this)),
      organ_(makeBox()),
      pattern_(makeBox()),
      formulation_(makeBox()),
      target_(new SignedBox) {
  auto* column = bareLayout<QVBoxLayout>(this);
  auto* grid = new QGridLayout;
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kSpace);
  grid->setVerticalSpacing(kSpace - 2);
  grid->setColumnStretch(1, 1);
  organLabel_ = addField(grid, organ_);
  patternLabel_ = addField(grid, pattern_);
  formulationLabel_ = addField(grid, formulation_);
  formulation_->addItem(QString(), static_cast<int>(Formulation::kSaintVenant));
  formulation_->addItem(QString(), static_cast<int>(Formulation::kPaper));
  for (const TissueModel tissue : {TissueModel::kFiniteElements, TissueModel::kMassSpring}) {
    formulation_->addItem(QString(), itemOf(tissue));
  }
  targetLabel_ = addField(grid, target_);
  target_->setRange(-kLargestTarget_deg, kLargestTarget_deg);
  target_->setDecimals(0);
  target_->setSingleStep(5.0);
  target_->setSuffix(QString(QChar(0x00B0)));
  target_->setKeyboardTracking(false);
  target_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  card_->content()->addLayout(grid);
  beside_ = new QLabel;
  beside_->setObjectName(QStringLiteral("beside"));
  beside_->setProperty("quiet", true);
  beside_->setWordWrap(true);
  beside_->hide();
  card_->content()->addWidget(beside_);
  column->addWidget(card_);
  retranslate();

  connect(organ_, &QComboBox::activated, this, [this](int index) {
    const QString id = organ_->itemData(index).toString();
    if (!id.isEmpty()) {
      Q_EMIT organChosen(id);  // empty: the user's own organ, already shown
    }
  });
  connect(pattern_, &QComboBox::activated, this,
          [this](int index) { Q_EMIT patternChosen(pattern_->itemData(index).toString()); });
  connect(formulation_, &QComboBox::activated, this, [this](int index) {
    const int item = formulation_->itemData(index).toInt();
    if (item >= kBesideItems) {
      Q_EMIT tissueChosen(static_cast<TissueModel>(item - kBesideItems));
    } else {
      Q_EMIT formulationChosen(static_cast<Formulation>(item));
    }
  });
  connect(target_, &QDoubleSpinBox::valueChanged, this,
          [this](double target_deg) { Q_EMIT targetChosen(radians(target_deg)); });
}

void ExercisePanel::retranslate() {
  card_->setTitle(tr("Exercise"));
  name(organLabel_, tr("&Organ"));
  name(patternLabel_, tr("&Pattern"));
  name(formulationLabel_, tr("&Model"));
  name(targetLabel_, tr("&Target"));
  const auto index = [this](Formulation f) { return formulation_->findData(static_cast<int>(f)); };
  rename(formulation_, index(Formulation::kSaintVenant), tr("Saint-Venant"));
  rename(formulation_, index(Formulation::kPaper), tr("As in the paper"));
  const auto beside = [this](TissueModel t) { return formulation_->findData(itemOf(t)); };
  rename(formulation_, beside(TissueModel::kFiniteElements), tr("Finite elements"));
  rename(formulation_, beside(TissueModel::kMassSpring), tr("Mass-spring lattice"));
  formulation_->setToolTip(tr("Which model turns the organ and responds to the hand"));
  for (int i = 0; i < organ_->count(); ++i) {
    const QString id = organ_->itemData(i).toString();
    if (!id.isEmpty()) {
      rename(organ_, i, titles_.scene(id.toStdString()));
    }
  }
  for (int i = 0; i < pattern_->count(); ++i) {
    rename(pattern_, i, toQString(Text(pattern_->itemData(i, kEnglishRole).toString().toStdString())));
  }
  nameChosen();
}

void ExercisePanel::setOrgans(const std::filesystem::path& assets) {
  const QSignalBlocker quiet(organ_);
  titles_ = SceneTitles(assets);
  organ_->clear();
  for (const std::string& id : sceneIds(assets)) {
    organ_->addItem(titles_.scene(id), toQString(id));
  }
  nameChosen();
}

void ExercisePanel::nameChosen() {
  organ_->setToolTip(organ_->currentText());
  fitPopupToLines(organ_);
  fitPopupToLines(pattern_);
}

void ExercisePanel::showScene(const Scene& scene, double target_rad, bool ownOrgan) {
  const QSignalBlocker quietOrgan(organ_);
  const QSignalBlocker quietPattern(pattern_);
  const QSignalBlocker quietFormulation(formulation_);
  const QSignalBlocker quietTarget(target_);
  const int old = organ_->findData(QString());
  if (old >= 0) {
    organ_->removeItem(old);
  }
  if (ownOrgan) {
    organ_->addItem(toQString(scene.title), QString());
  }
  organ_->setCurrentIndex(organ_->findData(ownOrgan ? QString() : toQString(scene.id)));
  pattern_->clear();
  for (const TwistPattern& pattern : scene.patterns) {
    pattern_->addItem(toQString(Text(pattern.title)), toQString(pattern.id));
    pattern_->setItemData(pattern_->count() - 1, toQString(pattern.title), kEnglishRole);
  }
  pattern_->setCurrentIndex(pattern_->findData(toQString(scene.pattern.id)));
  pattern_->setToolTip(toQString(scene.pattern.source));
  nameChosen();
  const int item =
      runsAsync(scene.tissue) ? itemOf(scene.tissue) : static_cast<int>(scene.model.options().formulation);
  formulation_->setCurrentIndex(formulation_->findData(item));
  target_->setValue(std::round(degrees(target_rad)));
}

void ExercisePanel::showBeside(std::optional<double> rate_per_s, bool late) {
  beside_->setVisible(rate_per_s.has_value());
  if (!rate_per_s) {
    return;
  }
  const QString model = formulation_->currentText();
  const QLocale locale;
  if (late) {
    beside_->setText(tr("%1: no answer. The force of the grip is off").arg(model));
  } else if (*rate_per_s > 0.0) {
    beside_->setText(
        tr("%1: %2 times a second beside the force at %3")
            .arg(model, locale.toString(*rate_per_s, 'f', 0), locale.toString(1'000'000 / kTickPeriod_us)));
  } else {
    beside_->setText(tr("%1: beside the force; it begins with the first grip").arg(model));
  }
}

void ExercisePanel::setChangeable(bool changeable) {
  for (QWidget* field : {static_cast<QWidget*>(organ_), static_cast<QWidget*>(pattern_),
                         static_cast<QWidget*>(formulation_), static_cast<QWidget*>(target_)}) {
    field->setEnabled(changeable);
  }
}

ValidityButton::ValidityButton(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("validity"));
  setText(QStringLiteral("?"));
  setFocusPolicy(Qt::TabFocus);
  connect(this, &QToolButton::clicked, this, &ValidityButton::tell);
  retranslate();
  hide();
}

void ValidityButton::setScene(const Scene* scene) {
  words_.clear();
  checked_ = {};
  if (scene != nullptr && scene->comesTwisted()) {
    words_ = scene->hollow->detorsion().validity;
    checked_ = validityText(*scene->hollow);
  }
  setVisible(!words_.empty());
}

void ValidityButton::retranslate() {
  setToolTip(tr("What of this scene is measured, sourced and assumed"));
  setAccessibleName(toolTip());
}

void ValidityButton::tell() {
  QString words = toQString(Text(words_));
  if (!checked_.empty()) {
    words += QStringLiteral("\n\n") + toQString(checked_);
  }
  QMessageBox box(QMessageBox::NoIcon, tr("How far this scene holds"), words, QMessageBox::Close, this);
  box.exec();
}

}  // namespace torsio::gui
