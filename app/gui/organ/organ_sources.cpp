// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/organ_sources.h"

#include <cstddef>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

// Indices of the fields, in the order in which they are added.
constexpr std::size_t kWidth = 0;
constexpr std::size_t kThickness = 1;
constexpr std::size_t kForearm = 2;
constexpr std::size_t kPalm = 3;
constexpr std::size_t kBreadth = 4;
constexpr std::size_t kHand = 5;
constexpr std::size_t kFirstFinger = 6;

constexpr int kCardWidth = 620;
constexpr int kWholePage = 1000;  // stretch: margins only grow at the page's maximum width
constexpr int kMaxSeries = 100'000;

}  // namespace

ArmForm::ArmForm(QWidget* parent) : QWidget(parent) {
  auto* row = bareLayout<QHBoxLayout>(this, 2 * kSpace);
  auto* hand = new QFormLayout;
  auto* fingers = new QFormLayout;
  for (QFormLayout* form : {hand, fingers}) {
    form->setVerticalSpacing(kSpace);
  }
  row->addLayout(hand, 1);
  row->addLayout(fingers, 1);
  addLength(*hand, "wristWidth", kWristWidth);
  addLength(*hand, "wristThickness", kWristThickness);
  addLength(*hand, "forearmLength", kForearmLength);
  addLength(*hand, "palmLength", kPalmLength);
  addLength(*hand, "handBreadth", kHandBreadth);
  addLength(*hand, "handThickness", kHandThickness);
  for (const char* name : {"thumb", "indexFinger", "middleFinger", "ringFinger", "littleFinger"}) {
    addLength(*fingers, name, kFingers[fields_.size() - kFirstFinger]);
  }
}

void ArmForm::addLength(QFormLayout& form, const char* name, const PersonLength& range) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(QLatin1String(name));
  box->setRange(range.least_mm, range.most_mm);
  box->setDecimals(0);
  box->setSuffix(QStringLiteral(" mm"));
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setValue(range.man_mm);
  auto* label = new QLabel(this);
  label->setBuddy(box);
  form.addRow(label, box);
  fields_.push_back({box, label, range.man_mm});
}

PersonArm ArmForm::person() const {
  const auto value_mm = [this](std::size_t field) { return fields_[field].box->value(); };
  const auto changed = [this, value_mm](std::size_t field) {
    return value_mm(field) != fields_[field].man_mm;
  };
  PersonArm person;
  if (changed(kWidth) || changed(kThickness)) {
    person.wristWidth_mm = value_mm(kWidth);
    person.wristThickness_mm = value_mm(kThickness);
  }
  person.forearmLength_mm = value_mm(kForearm);
  person.palmLength_mm = value_mm(kPalm);
  person.handBreadth_mm = value_mm(kBreadth);
  person.handThickness_mm = value_mm(kHand);
  for (std::size_t finger = 0; finger < person.fingers_mm.size(); ++finger) {
    person.fingers_mm[finger] = value_mm(kFirstFinger + finger);
  }
  return person;
}

void ArmForm::reset() {
  for (const Field& field : fields_) {
    field.box->setValue(field.man_mm);
  }
}

void ArmForm::retranslate() {
  const QString names[] = {tr("Wrist, width"), tr("Wrist, thickness"), tr("Forearm, elbow to wrist"),
                           tr("Palm, length"), tr("Hand, breadth"),    tr("Hand, thickness"),
                           tr("Thumb"),        tr("Index finger"),     tr("Middle finger"),
                           tr("Ring finger"),  tr("Little finger")};
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    nameField(fields_[i].label, names[i]);
  }
}

OrganSources::OrganSources(QWidget* parent) : QWidget(parent) {
  auto* middle = bareLayout<QHBoxLayout>(this, 0);
  auto* page = new QWidget(this);
  page->setMaximumWidth(2 * kCardWidth + 2 * kSpace);  // keeps its cards side by side on a wide screen
  middle->addStretch(1);
  middle->addWidget(page, kWholePage);
  middle->addStretch(1);
  auto* row = bareLayout<QHBoxLayout>(page, 2 * kSpace);
  auto* column = new QVBoxLayout;
  column->setSpacing(2 * kSpace);
  row->addLayout(column, 1);
  meshCard_ = new Card(QString(), page);
  meshCard_->setMaximumWidth(kCardWidth);
  meshText_ = sentence(meshCard_);
  meshCard_->content()->addWidget(meshText_);
  mesh_ = primaryButton(meshCard_);
  meshCard_->content()->addWidget(mesh_, 0, Qt::AlignLeft);
  column->addWidget(meshCard_);
  scanCard_ = new Card(QString(), page);
  scanCard_->setMaximumWidth(kCardWidth);
  scanText_ = sentence(scanCard_);
  scanCard_->content()->addWidget(scanText_);
  series_ = new QSpinBox(scanCard_);
  series_->setRange(0, kMaxSeries);
  seriesLabel_ = addField(scanCard_->content(), series_);
  resample_ = new QCheckBox(scanCard_);
  scanCard_->content()->addWidget(resample_);
  auto* scans = new QHBoxLayout;
  scanFile_ = primaryButton(scanCard_);
  scanFolder_ = primaryButton(scanCard_);
  scans->addWidget(scanFile_);
  scans->addWidget(scanFolder_);
  scans->addStretch(1);
  scanCard_->content()->addLayout(scans);
  column->addWidget(scanCard_);
  column->addStretch(1);
  auto* right = new QVBoxLayout;
  right->setSpacing(2 * kSpace);
  right->addWidget(createArmCard(page));
  right->addWidget(createInstrumentCard(page));
  right->addStretch(1);
  row->addLayout(right, 1);
  connect(mesh_, &QPushButton::clicked, this,
          [this] { chooseMesh(tr("Mesh of an organ"), &OrganSources::meshChosen); });
  connect(scanFile_, &QPushButton::clicked, this, [this] { chooseScanFile(&OrganSources::scanChosen); });
  connect(scanFolder_, &QPushButton::clicked, this, [this] { chooseScanFolder(&OrganSources::scanChosen); });
  connect(makeArm_, &QPushButton::clicked, this, &OrganSources::armWanted);
}

QWidget* OrganSources::createInstrumentCard(QWidget* page) {
  instrumentCard_ = new Card(QString(), page);
  instrumentCard_->setMaximumWidth(kCardWidth);
  instrumentText_ = sentence(instrumentCard_);
  instrumentCard_->content()->addWidget(instrumentText_);
  auto* buttons = new QHBoxLayout;
  instrumentMesh_ = primaryButton(instrumentCard_);
  instrumentFile_ = primaryButton(instrumentCard_);
  instrumentFolder_ = primaryButton(instrumentCard_);
  buttons->addWidget(instrumentMesh_);
  buttons->addWidget(instrumentFile_);
  buttons->addWidget(instrumentFolder_);
  buttons->addStretch(1);
  instrumentCard_->content()->addLayout(buttons);
  connect(instrumentMesh_, &QPushButton::clicked, this,
          [this] { chooseMesh(tr("Mesh of an instrument"), &OrganSources::instrumentMeshChosen); });
  connect(instrumentFile_, &QPushButton::clicked, this,
          [this] { chooseScanFile(&OrganSources::instrumentScanChosen); });
  connect(instrumentFolder_, &QPushButton::clicked, this,
          [this] { chooseScanFolder(&OrganSources::instrumentScanChosen); });
  return instrumentCard_;
}

QWidget* OrganSources::createArmCard(QWidget* page) {
  armCard_ = new Card(QString(), page);
  armCard_->setMaximumWidth(kCardWidth);
  armText_ = sentence(armCard_);
  armCard_->content()->addWidget(armText_);
  arm_ = new ArmForm(armCard_);
  armCard_->content()->addWidget(arm_);
  makeArm_ = primaryButton(armCard_);
  armCard_->content()->addWidget(makeArm_, 0, Qt::AlignLeft);
  return armCard_;
}

PersonArm OrganSources::person() const {
  return arm_->person();
}

void OrganSources::reset() {
  arm_->reset();
}

int OrganSources::series() const {
  return series_->value();
}

bool OrganSources::resample() const {
  return resample_->isChecked();
}

void OrganSources::chooseMesh(const QString& title, Chosen chosen) {
  const QString file =
      askFileToOpen(this, title, tr("Meshes (*.obj *.stl *.ply *.off *.glb *.gltf *.dae);;All files (*)"));
  if (!file.isEmpty()) {
    Q_EMIT(this->*chosen)(toPath(file));
  }
}

void OrganSources::chooseScanFile(Chosen chosen) {
  const QString file =
      askFileToOpen(this, tr("Scan"), tr("NIfTI files (*.nii *.nii.gz *.hdr *.hdr.gz);;All files (*)"));
  if (!file.isEmpty()) {
    Q_EMIT(this->*chosen)(toPath(file));
  }
}

void OrganSources::chooseScanFolder(Chosen chosen) {
  const QString folder = askFolder(this, tr("Folder of DICOM files"));
  if (!folder.isEmpty()) {
    Q_EMIT(this->*chosen)(toPath(folder));
  }
}

void OrganSources::retranslate() {
  meshCard_->setTitle(tr("Mesh"));
  meshText_->setText(
      tr("A closed surface of one organ: obj, stl, ply, off, glb, gltf or dae. It is read in a separate "
         "process, checked, repaired where that is safe, and test-twisted."));
  mesh_->setText(tr("Choose a mesh\u2026"));
  scanCard_->setTitle(tr("Scan"));
  scanText_->setText(
      tr("A CT, or a label mask from another program. You view its slices, mark the organ and correct the "
         "result. Patient names are neither shown nor kept."));
  nameField(seriesLabel_, tr("&Series, where a folder holds several"));
  series_->setSpecialValueText(tr("the one with the most slices"));
  resample_->setText(tr("Accept unevenly spaced slices"));
  scanFile_->setText(tr("NIfTI file\u2026"));
  scanFolder_->setText(tr("DICOM folder\u2026"));
  armCard_->setTitle(tr("Arm from a person's measurements"));
  armText_->setText(
      tr("A drawn forearm and hand: wrist and fingers as measured on the trainee or the patient. The preset "
         "values are a man's; the girth of the forearm follows the wrist."));
  arm_->retranslate();
  makeArm_->setText(tr("Draw the arm"));
  instrumentCard_->setTitle(tr("Instrument"));
  instrumentText_->setText(
      tr("The mesh of a tool, or its CT with the jaws closed, becomes an instrument: you place its tip, "
         "hinge and jaws on a picture. The choices for scans apply to its CT, too."));
  instrumentMesh_->setText(tr("Mesh\u2026"));
  instrumentFile_->setText(tr("NIfTI file\u2026"));
  instrumentFolder_->setText(tr("DICOM folder\u2026"));
}

}  // namespace torsio::gui
