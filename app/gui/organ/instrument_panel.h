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

/// Shows an instrument found in a scan or mesh, and asks for its tip, hinge and jaws. GUI thread.
class InstrumentPanel : public QWidget {
  Q_OBJECT

 public:
  explicit InstrumentPanel(QWidget* parent = nullptr);

  /// Starts with an unread scan: only the threshold is known.
  void begin(const ToolRequest& request);
  /// Starts with a mesh: only its file is known.
  void beginMesh(const std::filesystem::path& file);
  [[nodiscard]] bool ofMesh() const noexcept { return !meshFile_.empty(); }
  /// Shows the result of request().
  void setTool(const ToolSurface& tool);
  /// Returns the request for the scan, with the points placed.
  [[nodiscard]] ToolRequest request() const;
  /// Returns the request for the mesh, with the points placed.
  [[nodiscard]] InstrumentImportRequest meshRequest() const;
  [[nodiscard]] const ToolSurface& tool() const noexcept { return tool_; }
  [[nodiscard]] InstrumentFacts facts() const;
  [[nodiscard]] InstrumentView& view() const noexcept { return *view_; }

  void retranslate();
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  /// The instrument is to be searched again, with the points placed.
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
  bool changed_ = false;  // since the last search

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
