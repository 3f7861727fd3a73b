// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include <QWidget>

#include "app/services/organs/person_arm.h"

class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QCheckBox;
class QPushButton;
class QSpinBox;

namespace torsio::gui {

/// Fields for the measurements of a person's wrist, hand and fingers; initially a man's. GUI thread.
class ArmForm : public QWidget {
  Q_OBJECT

 public:
  explicit ArmForm(QWidget* parent = nullptr);

  /// Returns the input.
  [[nodiscard]] PersonArm person() const;
  /// Resets to a man's measurements.
  void reset();
  void retranslate();

 private:
  struct Field {
    QDoubleSpinBox* box;
    QLabel* label;
    double man_mm;
  };
  /// `name`: object name of the field.
  void addLength(QFormLayout& form, const char* name, const PersonLength& range);

  std::vector<Field> fields_;
};

class Card;

/// The wizard's first page: sources of organs and instruments, and how a scan is read. GUI thread.
class OrganSources : public QWidget {
  Q_OBJECT

 public:
  explicit OrganSources(QWidget* parent = nullptr);

  /// Returns the measurements for an arm.
  [[nodiscard]] PersonArm person() const;
  /// Resets them to a man's.
  void reset();
  /// Returns the series to read of a folder; 0: the one with the most slices.
  [[nodiscard]] int series() const;
  /// Returns whether unevenly spaced slices are accepted.
  [[nodiscard]] bool resample() const;
  void retranslate();

 Q_SIGNALS:
  void meshChosen(const std::filesystem::path& file);
  void scanChosen(const std::filesystem::path& source);
  void armWanted();
  void instrumentMeshChosen(const std::filesystem::path& file);
  void instrumentScanChosen(const std::filesystem::path& source);

 private:
  using Chosen = void (OrganSources::*)(const std::filesystem::path& source);
  QWidget* createArmCard(QWidget* page);
  QWidget* createInstrumentCard(QWidget* page);
  void chooseMesh(const QString& title, Chosen chosen);
  void chooseScanFile(Chosen chosen);
  void chooseScanFolder(Chosen chosen);

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
};

}  // namespace torsio::gui
