// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include <QWidget>

#include "app/gui/organ/organ_trial.h"
#include "app/gui/widgets/theme.h"

class QPushButton;
class QStackedWidget;

namespace torsio {
struct Arm;
}

namespace torsio::gui {

class Card;
class InstrumentPanel;
class OrganFindings;
class OrganPicture;
class OrganSettings;
class OrganSources;
class PageHeading;
class PatternPictures;
class ScanPanel;
class ShellContext;

/// Imports an organ step by step: choose a mesh, or a scan and segment the organ; judge, inspect, save as an
/// organ file, open. Reads and judges in the background. GUI thread.
class OrganWizard : public QWidget {
  Q_OBJECT

 public:
  explicit OrganWizard(ShellContext& shell, QWidget* parent = nullptr);

  /// Starts with the choice of a file.
  void begin();
  /// Reads and judges a mesh file with the settings; then shows the page of the judgement.
  void judgeMesh(const std::filesystem::path& file);
  /// Searches a scan for an instrument with the settings of its page; then shows the page.
  void openInstrument(const std::filesystem::path& source);
  /// Searches a mesh for an instrument; then shows its page.
  void openToolMesh(const std::filesystem::path& file);
  /// Shows the instrument page for a mesh file not read yet.
  void showToolMesh(const std::filesystem::path& file);
  void findInstrument();
  /// Writes the instrument. Throws like writeInstrument().
  void saveInstrument(const std::filesystem::path& file);
  [[nodiscard]] InstrumentPanel& instrument() const noexcept { return *instrument_; }
  /// Generates and judges an arm from the form's measurements; then shows the page of the judgement.
  void makeArm();
  /// Reads a scan (a NIfTI file or a folder of DICOM files); then shows the page of its slices.
  void openScan(const std::filesystem::path& source);
  /// Shows a scan already read.
  void showScan(const std::filesystem::path& source, ScanPreview preview);
  /// Segments the organ with the settings of the slices' page.
  void findOrgan();
  /// Reconstructs and judges the segmented organ; then shows the page of the judgement.
  void makeSurface();
  [[nodiscard]] ScanPanel& scanPanel() const noexcept { return *scan_; }
  /// Returns the last judged organ; empty at first.
  [[nodiscard]] const std::optional<OrganTrial>& trial() const noexcept { return trial_; }
  /// Writes the accepted organ. Throws Error{kFileUnwritable}.
  void save(const std::filesystem::path& file);
  [[nodiscard]] OrganPicture& picture() const noexcept { return *picture_; }
  [[nodiscard]] const std::filesystem::path& assets() const;

  void retranslate();
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  /// An organ file is to be opened in the simulator.
  void opened(const QString& file);
  /// The wizard is to be left.
  void closed();

 private:
  void chooseInstrumentName();
  QWidget* createJudgingPage();
  [[nodiscard]] bool mayWork();
  [[nodiscard]] OrganImportRequest request() const;
  [[nodiscard]] ScanRequest ofSource(ScanRequest scan) const;
  void goBack();
  void judgeAgain();
  void adopt(OrganTrial trial);
  void noteChange();
  bool chooseFile();
  void openSaved();
  void showButtons();

  ShellContext& shell_;
  std::filesystem::path source_;
  bool ofScan_ = false;
  bool ofMeasures_ = false;  // a generated arm
  std::shared_ptr<const Arm> drawnArm_;
  ScanRequest drawn_;    // request of surface_
  ScanSurface surface_;  // reconstructed from the scan
  std::optional<OrganTrial> trial_;
  std::optional<std::filesystem::path> saved_;
  bool changed_ = false;  // settings changed since the judgement

  PageHeading* heading_;
  QStackedWidget* pages_;
  QPushButton* close_;
  OrganSources* sources_;
  InstrumentPanel* instrument_ = nullptr;
  ScanPanel* scan_ = nullptr;
  Card* pictureCard_ = nullptr;
  OrganPicture* picture_ = nullptr;
  Card* findingsCard_ = nullptr;
  OrganFindings* findings_ = nullptr;
  PatternPictures* patterns_ = nullptr;
  Card* patternsCard_ = nullptr;
  Card* settingsCard_ = nullptr;
  OrganSettings* settings_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* again_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* open_ = nullptr;
};

}  // namespace torsio::gui
