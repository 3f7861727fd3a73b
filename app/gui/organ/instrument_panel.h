// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "sim/imaging/surface/tool_surface.h"
#include "sim/scene/instrument_file.h"
#include "sim/scene/instrument_import.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

class Card;
class InstrumentView;

/// Looks at an instrument that was found in a scan or a mesh, and says where its tip, hinge and jaws are. GUI
/// thread.
class InstrumentPanel : public QWidget {
  Q_OBJECT

 public:
  explicit InstrumentPanel(QWidget* parent = nullptr);

  /// Begins with a scan that has not been read: nothing is known of the instrument but its threshold.
  void begin(const ToolRequest& request);
  /// Begins with a mesh: nothing is known of the instrument but its file.
  void beginMesh(const std::filesystem::path& file);
  [[nodiscard]] bool ofMesh() const noexcept { return !meshFile_.empty(); }
  /// Shows what was found with request().
  void setTool(const ToolSurface& tool);
  /// What is asked of the scan, with what has been placed.
  [[nodiscard]] ToolRequest request() const;
  /// The same of a mesh.
  [[nodiscard]] InstrumentImportRequest meshRequest() const;
  [[nodiscard]] const ToolSurface& tool() const noexcept { return tool_; }
  [[nodiscard]] InstrumentFacts facts() const;
  [[nodiscard]] InstrumentView& view() const noexcept { return *view_; }

  void retranslate();
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  /// The instrument is to be found anew, with what is placed now.
  void placeWanted();
  void saveWanted();
  void backWanted();

 private:
  void reset(const ToolRequest& request, const std::filesystem::path& meshFile);
  void takeOtherEnd();
  void turnHinge();
  void noteChange();
  void showNumbers();

  ToolRequest request_;
  std::filesystem::path meshFile_;  // empty: a scan
  ToolSurface tool_;
  bool changed_ = false;  // since it was found

  Card* pictureCard_;
  InstrumentView* view_;
  Card* placesCard_;
  QLabel* numbers_;
  QLabel* remarks_;
  QDoubleSpinBox* threshold_;
  QLabel* thresholdLabel_;
  QComboBox* unit_;
  QLabel* unitLabel_;
  QDoubleSpinBox* drawnOpen_;
  QLabel* drawnOpenLabel_;
  QDoubleSpinBox* pivot_;
  QLabel* pivotLabel_;
  QDoubleSpinBox* opening_;
  QLabel* openingLabel_;
  QDoubleSpinBox* reach_;
  QLabel* reachLabel_;
  QLineEdit* title_;
  QLabel* titleLabel_;
  QPushButton* otherEnd_;
  QPushButton* turnHinge_;
  QPushButton* back_;
  QPushButton* again_;
  QPushButton* save_;
};

}  // namespace torsio::gui
