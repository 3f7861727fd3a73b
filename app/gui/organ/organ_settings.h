// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>

#include <QWidget>

#include "sim/core/vec3.h"
#include "sim/scene/organ_import.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QRadioButton;

namespace torsio::gui {

/// Input about an imported organ: unit of the file, anatomy, wall, ends. GUI thread.
class OrganSettings : public QWidget {
  Q_OBJECT

 public:
  explicit OrganSettings(const std::filesystem::path& assets, QWidget* parent = nullptr);

  /// Hides unit and holes for a scan, which defines its unit and whose surface has no holes.
  void setScan(bool scan);
  /// Takes the unit that a mesh file states, and does not offer another.
  void setMesh(const std::filesystem::path& file);
  /// Writes the input into a request; the caller sets the file.
  void apply(OrganImportRequest& request) const;
  /// Assigns a clicked place to the end that waits for one, if any.
  void takePlace(const Vec3& place_m);
  /// Resets everything for another file.
  void reset();

  void retranslate();

 Q_SIGNALS:
  /// The input has changed.
  void changed();

 private:
  struct End {
    QLabel* label = nullptr;
    std::array<QDoubleSpinBox*, 3> place_mm{};
    QPushButton* pick = nullptr;
    QCheckBox* cut = nullptr;
  };

  QWidget* createEnds();
  void createEnd(End& end);
  void enableEnds();
  [[nodiscard]] static Vec3 placeOf_m(const End& end);

  std::filesystem::path assets_;
  QWidget* ofMesh_;  // unit and holes
  QLabel* unitLabel_;
  QComboBox* unit_;
  QLabel* scaleLabel_;
  QDoubleSpinBox* scale_;
  QCheckBox* closeHoles_;
  QLabel* anatomyLabel_;
  QComboBox* anatomy_;
  QLabel* wallLabel_;
  QDoubleSpinBox* wall_;
  QLabel* endsLabel_;
  QRadioButton* found_ = nullptr;
  QRadioButton* given_ = nullptr;
  End fixed_;
  End free_;
};

}  // namespace torsio::gui
