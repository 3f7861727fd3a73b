// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/instrument_panel.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/organ/instrument_view.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "sim/geometry/mesh/mesh_space.h"

namespace torsio::gui {

namespace {

constexpr int kPlacesWidth = 400;
// Limits of requireToolRequest().
constexpr double kLeastThreshold_HU = -500.0;
constexpr double kMaxThreshold_HU = 3000.0;
constexpr double kLeastPivot_mm = 3.0;
constexpr double kMaxPivot_mm = 100.0;
constexpr std::array<double, 5> kUnits_m{1e-3, 1e-2, 1.0, 1e-6, 0.0254};  // mm, cm, m, um, inch

QDoubleSpinBox* box(QWidget* parent, const char* name, double least, double most, const QString& unit) {
  auto* field = new QDoubleSpinBox(parent);
  field->setObjectName(QLatin1String(name));
  field->setRange(least, most);
  field->setDecimals(0);
  field->setSuffix(unit);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field->setKeyboardTracking(false);
  return field;
}

}  // namespace

InstrumentPanel::InstrumentPanel(QWidget* parent) : QWidget(parent) {
  auto* row = bareLayout<QHBoxLayout>(this, 2 * kSpace);
  pictureCard_ = new Card(QString(), this);
  view_ = new InstrumentView(pictureCard_);
  pictureCard_->content()->addWidget(view_, 1);
  row->addWidget(pictureCard_, 1);
  auto* side = new QVBoxLayout;
  placesCard_ = new Card(QString(), this);
  QVBoxLayout* column = placesCard_->content();
  numbers_ = sentence(placesCard_, false);
  remarks_ = sentence(placesCard_);
  column->addWidget(numbers_);
  column->addWidget(remarks_);
  threshold_ = box(placesCard_, "toolThreshold", kLeastThreshold_HU, kMaxThreshold_HU, QStringLiteral(" HU"));
  pivot_ = box(placesCard_, "toolHinge", kLeastPivot_mm, kMaxPivot_mm, QStringLiteral(" mm"));
  pivot_->setDecimals(1);
  opening_ = box(placesCard_, "toolOpening", 0.0, 90.0, QStringLiteral("\u00B0"));
  reach_ = box(placesCard_, "toolReach", 0.5, 50.0, QStringLiteral(" mm"));
  reach_->setDecimals(1);
  title_ = new QLineEdit(placesCard_);
  unit_ = new QComboBox(placesCard_);
  unit_->setObjectName(QStringLiteral("toolUnit"));
  unit_->addItems(QStringList(static_cast<qsizetype>(kUnits_m.size())));
  drawnOpen_ = box(placesCard_, "toolDrawnOpen", 0.0, 90.0, QStringLiteral("\u00B0"));
  unitLabel_ = addField(column, unit_);
  drawnOpenLabel_ = addField(column, drawnOpen_);
  thresholdLabel_ = addField(column, threshold_);
  pivotLabel_ = addField(column, pivot_);
  openingLabel_ = addField(column, opening_);
  reachLabel_ = addField(column, reach_);
  titleLabel_ = addField(column, title_);
  otherEnd_ = new QPushButton(placesCard_);
  turnHinge_ = new QPushButton(placesCard_);
  column->addWidget(otherEnd_);
  column->addWidget(turnHinge_);
  auto* scroll = new QScrollArea(this);  // on a small screen
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(kPlacesWidth);
  auto* ground = new QWidget;
  auto* places = bareLayout<QVBoxLayout>(ground);
  keepOffScrollBar(*scroll, *places);
  places->addWidget(placesCard_);
  places->addStretch(1);
  scroll->setWidget(ground);
  side->addWidget(scroll, 1);
  back_ = new QPushButton(this);
  again_ = new QPushButton(this);
  save_ = primaryButton(this);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back_);
  buttons->addWidget(again_);
  side->addLayout(buttons);
  side->addWidget(save_);
  row->addLayout(side);

  connect(threshold_, &QDoubleSpinBox::valueChanged, this, &InstrumentPanel::noteChange);
  connect(pivot_, &QDoubleSpinBox::valueChanged, this, &InstrumentPanel::noteChange);
  connect(drawnOpen_, &QDoubleSpinBox::valueChanged, this, &InstrumentPanel::noteChange);
  connect(unit_, &QComboBox::currentIndexChanged, this, &InstrumentPanel::noteChange);
  connect(opening_, &QDoubleSpinBox::valueChanged, view_, &InstrumentView::setOpening);
  connect(view_, &InstrumentView::hingePicked, pivot_, &QDoubleSpinBox::setValue);
  connect(view_, &InstrumentView::otherEndPicked, this, &InstrumentPanel::takeOtherEnd);
  connect(otherEnd_, &QPushButton::clicked, this, &InstrumentPanel::takeOtherEnd);
  connect(turnHinge_, &QPushButton::clicked, this, &InstrumentPanel::turnHinge);
  connect(back_, &QPushButton::clicked, this, &InstrumentPanel::backWanted);
  connect(again_, &QPushButton::clicked, this, &InstrumentPanel::placeWanted);
  connect(save_, &QPushButton::clicked, this, &InstrumentPanel::saveWanted);
}

void InstrumentPanel::begin(const ToolRequest& request) {
  reset(request, {});
}

void InstrumentPanel::beginMesh(const std::filesystem::path& file) {
  reset({}, file);
}

void InstrumentPanel::reset(const ToolRequest& request, const std::filesystem::path& meshFile) {
  request_ = request;
  meshFile_ = meshFile;
  tool_ = {};
  const QSignalBlocker quietThreshold(threshold_);
  const QSignalBlocker quietPivot(pivot_);
  const QSignalBlocker quietUnit(unit_);
  const QSignalBlocker quietOpen(drawnOpen_);
  threshold_->setValue(request.threshold_HU);
  pivot_->setValue(request.pivot_mm);
  unit_->setCurrentIndex(0);
  drawnOpen_->setValue(0.0);
  opening_->setValue(InstrumentFacts().opening_deg);
  reach_->setValue(InstrumentFacts().gripReach_mm);
  title_->clear();
  for (QWidget* one : {static_cast<QWidget*>(threshold_), static_cast<QWidget*>(thresholdLabel_)}) {
    one->setVisible(!ofMesh());
  }
  for (QWidget* one : {static_cast<QWidget*>(unit_), static_cast<QWidget*>(unitLabel_),
                       static_cast<QWidget*>(drawnOpen_), static_cast<QWidget*>(drawnOpenLabel_)}) {
    one->setVisible(ofMesh());
  }
  for (QWidget* one : {static_cast<QWidget*>(unit_), static_cast<QWidget*>(unitLabel_)}) {
    one->setVisible(ofMesh() && !meshSpaceOf(meshFile_).unit_m);  // the file states it
  }
  setTool({});
}

InstrumentImportRequest InstrumentPanel::meshRequest() const {
  InstrumentImportRequest request;
  const ToolRequest scan = this->request();
  const ToolPlaces& places = scan;
  static_cast<ToolPlaces&>(request) = places;
  request.file = meshFile_;
  request.scale_m = meshSpaceOf(meshFile_).unit_m.value_or(
      kUnits_m[static_cast<std::size_t>(std::max(unit_->currentIndex(), 0))]);
  request.drawnOpen_deg = drawnOpen_->value();
  return request;
}

ToolRequest InstrumentPanel::request() const {
  ToolRequest request = request_;
  request.threshold_HU = threshold_->value();
  request.pivot_mm = pivot_->value();
  return request;
}

InstrumentFacts InstrumentPanel::facts() const {
  return {.title = title_->text().trimmed().toStdString(),
          .opening_deg = opening_->value(),
          .gripReach_mm = reach_->value(),
          .provenance = ofMesh() ? kInstrumentOfMesh : kInstrumentOfScan};
}

void InstrumentPanel::setTool(const ToolSurface& tool) {
  tool_ = tool;
  request_ = request();
  changed_ = false;
  view_->setTool(tool_, opening_->value());
  showNumbers();
}

void InstrumentPanel::takeOtherEnd() {
  request_.tip_mm = tool_.tip_mm + tool_.length_mm * tool_.axes[2];
  request_.shaft.reset();
  changed_ = true;
  Q_EMIT placeWanted();
}

void InstrumentPanel::turnHinge() {
  request_.jawAxis = tool_.axes[1];
  request_.tip_mm = tool_.tip_mm;
  changed_ = true;
  Q_EMIT placeWanted();
}

void InstrumentPanel::noteChange() {
  changed_ = true;
  showNumbers();
}

void InstrumentPanel::showNumbers() {
  const bool found = tool_.length_mm > 0.0;
  const QLocale locale;
  const auto number = [&locale](double value) { return locale.toString(value, 'f', 1); };
  numbers_->setText(
      found ? tr("%1 mm long, the shaft %2 mm wide, the jaws %3 mm long")
                  .arg(number(tool_.length_mm), number(2.0 * tool_.shaftRadius_mm), number(tool_.pivot_mm))
            : tr("Nothing has been found yet."));
  QStringList remarks;
  for (const ScanRemark& remark : tool_.remarks) {
    QString line = capitalised(toQString(remark.what));
    if (!remark.remedy.empty()) {
      line += QStringLiteral(". ") + toQString(remark.remedy);
    }
    remarks << line;
  }
  remarks_->setText(remarks.join(QLatin1Char('\n')));
  remarks_->setVisible(!remarks.isEmpty());
  otherEnd_->setEnabled(found);
  turnHinge_->setEnabled(found);
  again_->setEnabled(changed_);
  save_->setEnabled(found && !changed_);
}

void InstrumentPanel::retranslate() {
  pictureCard_->setTitle(tr("The instrument"));
  placesCard_->setTitle(tr("Tip, axis and jaws"));
  nameField(unitLabel_, tr("Unit of the file"));
  const QStringList units{tr("millimetres"), tr("centimetres"), tr("metres"), tr("micrometres"),
                          tr("inches")};
  for (int i = 0; i < units.size(); ++i) {
    unit_->setItemText(i, units[i]);
  }
  nameField(drawnOpenLabel_, tr("Each jaw is drawn open by"));
  nameField(thresholdLabel_, tr("The instrument is denser than"));
  nameField(pivotLabel_, tr("Distance from hinge to tip"));
  nameField(openingLabel_, tr("Each jaw opens by"));
  nameField(reachLabel_, tr("A closed jaw grips tissue over"));
  nameField(titleLabel_, tr("Name"));
  otherEnd_->setText(tr("The tip is at the other end"));
  turnHinge_->setText(tr("Rotate the hinge by 90\u00B0"));
  back_->setText(tr("Back"));
  again_->setText(tr("Find again"));
  save_->setText(tr("Save instrument\u2026"));
  showNumbers();
  view_->update();
}

void InstrumentPanel::setTheme(const Theme& theme) {
  view_->setTheme(theme);
}

}  // namespace torsio::gui
