// SPDX-License-Identifier: GPL-3.0-or-later
// The wizard's first page: sources of organs and instruments.
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/organ/arm_form.h"
#include "app/gui/organ/organ_wizard.h"
#include "app/gui/widgets/card.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"

namespace torsio::gui {

namespace {

constexpr int kCardWidth = 620;
constexpr int kWholePage = 1000;  // stretch: margins only grow at the page's maximum width
constexpr int kMaxSeries = 100'000;

}  // namespace

QWidget* OrganWizard::createSourcePage() {
  auto* ground = new QWidget(pages_);
  auto* middle = new QHBoxLayout(ground);
  middle->setContentsMargins(0, 0, 0, 0);
  middle->setSpacing(0);
  auto* page = new QWidget(ground);
  page->setMaximumWidth(2 * kCardWidth + 2 * kSpace);  // keeps its cards side by side on a wide screen
  middle->addStretch(1);
  middle->addWidget(page, kWholePage);
  middle->addStretch(1);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2 * kSpace);
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
  return ground;
}

QWidget* OrganWizard::createInstrumentCard(QWidget* page) {
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
          [this] { chooseMesh(tr("Mesh of an instrument"), &OrganWizard::openToolMesh); });
  connect(instrumentFile_, &QPushButton::clicked, this,
          [this] { chooseScanFile(&OrganWizard::openInstrument); });
  connect(instrumentFolder_, &QPushButton::clicked, this,
          [this] { chooseScanFolder(&OrganWizard::openInstrument); });
  return instrumentCard_;
}

QWidget* OrganWizard::createArmCard(QWidget* page) {
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

void OrganWizard::chooseMesh(const QString& title, Opening open) {
  const QString file =
      askFileToOpen(this, title, tr("Meshes (*.obj *.stl *.ply *.off *.glb *.gltf *.dae);;All files (*)"));
  if (!file.isEmpty()) {
    (this->*open)(toPath(file));
  }
}

void OrganWizard::chooseScanFile(Opening open) {
  const QString file =
      askFileToOpen(this, tr("Scan"), tr("NIfTI files (*.nii *.nii.gz *.hdr *.hdr.gz);;All files (*)"));
  if (!file.isEmpty()) {
    (this->*open)(toPath(file));
  }
}

void OrganWizard::chooseScanFolder(Opening open) {
  const QString folder = askFolder(this, tr("Folder of DICOM files"));
  if (!folder.isEmpty()) {
    (this->*open)(toPath(folder));
  }
}

void OrganWizard::retranslateSources() {
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
