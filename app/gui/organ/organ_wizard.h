// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include <QWidget>

#include "app/gui/organ/organ_trial.h"
#include "app/gui/widgets/theme.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace torsio {
struct Arm;
}

namespace torsio::gui {

class Card;
class ArmForm;
class InstrumentPanel;
class OrganFindings;
class OrganPicture;
class OrganSettings;
class PageHeading;
class ScanPanel;
class ShellContext;

/// Brings an organ of one's own, step by step: a mesh is chosen, or a scan in which the organ is found; it is
/// judged, looked at, saved as an organ file and opened. Reading and judging are done in the background. GUI
/// thread.
class OrganWizard : public QWidget {
  Q_OBJECT

 public:
  explicit OrganWizard(ShellContext& shell, QWidget* parent = nullptr);

  /// Begins with the choice of a file.
  void begin();
  /// Reads and judges a mesh file with what the settings say; the page of the judgement follows.
  void judgeMesh(const std::filesystem::path& file);
  /// Looks for an instrument in a scan of it, with what its page says; the page follows.
  void openInstrument(const std::filesystem::path& source);
  /// The same in a mesh of it.
  void openToolMesh(const std::filesystem::path& file);
  /// Shows the page of an instrument of which nothing is known but its mesh file.
  void showToolMesh(const std::filesystem::path& file);
  void findInstrument();
  /// Writes the instrument that was found. Throws as writeInstrument().
  void saveInstrument(const std::filesystem::path& file);
  [[nodiscard]] InstrumentPanel& instrument() const noexcept { return *instrument_; }
  /// Draws and judges an arm with the measures of the form; the page of the judgement follows.
  void makeArm();
  /// Reads a scan, a NIfTI file or a folder of DICOM files; the page of its slices follows.
  void openScan(const std::filesystem::path& source);
  /// Shows a scan that was read.
  void showScan(const std::filesystem::path& source, ScanPreview preview);
  /// Looks for the organ in the scan, as the page of the slices says.
  void findOrgan();
  /// Draws and judges what was found; the page of the judgement follows.
  void makeSurface();
  [[nodiscard]] ScanPanel& scanPanel() const noexcept { return *scan_; }
  /// What was judged last; empty before.
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
  /// Back to where one came from.
  void closed();

 private:
  QWidget* createSourcePage();
  QWidget* createArmCard(QWidget* page);
  QWidget* createInstrumentCard(QWidget* page);
  void retranslateSources();
  void chooseInstrumentName();
  QWidget* createJudgingPage();
  using Opening = void (OrganWizard::*)(const std::filesystem::path& source);
  void chooseMesh(const QString& title, Opening open);
  void chooseScanFile(Opening open);
  void chooseScanFolder(Opening open);
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
  bool ofMeasures_ = false;  // an arm that was drawn
  std::shared_ptr<const Arm> drawnArm_;
  ScanRequest drawn_;    // of surface_
  ScanSurface surface_;  // as it was drawn from the scan
  std::optional<OrganTrial> trial_;
  std::optional<std::filesystem::path> saved_;
  bool changed_ = false;  // the settings, since the organ was judged

  PageHeading* heading_;
  QStackedWidget* pages_;
  QPushButton* close_;
  Card* meshCard_ = nullptr;
  QLabel* meshText_ = nullptr;
  QPushButton* mesh_ = nullptr;
  Card* scanCard_ = nullptr;
  QLabel* scanText_ = nullptr;
  QLabel* seriesLabel_ = nullptr;
  QSpinBox* series_ = nullptr;
  QCheckBox* resample_ = nullptr;
  QPushButton* scanFile_ = nullptr;
  QPushButton* scanFolder_ = nullptr;
  Card* armCard_ = nullptr;
  QLabel* armText_ = nullptr;
  ArmForm* arm_ = nullptr;
  QPushButton* makeArm_ = nullptr;
  Card* instrumentCard_ = nullptr;
  QLabel* instrumentText_ = nullptr;
  QPushButton* instrumentMesh_ = nullptr;
  QPushButton* instrumentFile_ = nullptr;
  QPushButton* instrumentFolder_ = nullptr;
  InstrumentPanel* instrument_ = nullptr;
  ScanPanel* scan_ = nullptr;
  Card* pictureCard_ = nullptr;
  OrganPicture* picture_ = nullptr;
  Card* findingsCard_ = nullptr;
  OrganFindings* findings_ = nullptr;
  Card* settingsCard_ = nullptr;
  OrganSettings* settings_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* again_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* open_ = nullptr;
};

}  // namespace torsio::gui
