// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>

#include <QWidget>

#include "app/gui/organ/slice_view.h"
#include "app/gui/widgets/theme.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QRadioButton;
class QSlider;
class QSpinBox;
class QVBoxLayout;

namespace torsio::gui {

class Card;
class SliceView;

/// Returns the object name of a plane's slice view.
[[nodiscard]] QString sliceName(SlicePlane plane);

/// A scan in three slices with the organ's mask: grey window, tissue, seed by click, box by drag, brush to
/// correct the mask. It requests work (`findWanted`, `surfaceWanted`) and does none itself. GUI thread.
class ScanPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ScanPanel(QWidget* parent = nullptr);

  /// Shows a scan; discards the input about the previous one.
  void setScan(const std::filesystem::path& source, ScanPreview preview);
  /// Shows the segmented organ; keeps brush strokes.
  void setFound(ScanPreview organ);
  /// Returns the request to segment or reconstruct; `brushed`: with the brush strokes.
  [[nodiscard]] ScanRequest request(bool brushed) const;
  [[nodiscard]] const SliceState& state() const noexcept { return state_; }
  /// Shows the slices through a place, mm.
  void lookAt(const Vec3& place_mm);

  void retranslate();
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  void findWanted();
  void surfaceWanted();
  void backWanted();

 private:
  enum class Tool { kLook, kSeed, kBox, kAdd, kErase };
  struct GreyWindow {
    double level;
    double width;
  };

  QWidget* createControls();
  void createGrey(QVBoxLayout* column);
  void createTissue(QVBoxLayout* column);
  void createTools(QVBoxLayout* column);
  void chooseTool(int tool);
  void press(const SliceView& view, const PreviewVoxel& voxel);
  void drag(const SliceView& view, const PreviewVoxel& voxel);
  void release();
  void dab(const PreviewVoxel& voxel);
  void spanBox(const SliceView& view, const PreviewVoxel& voxel);
  void takeGrey();
  void refresh();
  void showState();

  SliceState state_;
  std::filesystem::path source_;
  Tool tool_ = Tool::kLook;
  PreviewVoxel pressed_{};
  std::array<SliceView*, 3> views_{};  // in the order of SlicePlane
  std::array<QLabel*, 3> names_{};
  Card* greyCard_ = nullptr;
  QLabel* presetLabel_ = nullptr;
  QComboBox* preset_ = nullptr;
  QLabel* levelLabel_ = nullptr;
  QSlider* level_ = nullptr;
  QLabel* widthLabel_ = nullptr;
  QSlider* width_ = nullptr;
  Card* organCard_ = nullptr;
  QLabel* tissueLabel_ = nullptr;
  QComboBox* tissue_ = nullptr;
  QLabel* numberLabel_ = nullptr;
  QSpinBox* number_ = nullptr;
  QCheckBox* fluid_ = nullptr;
  Card* toolCard_ = nullptr;
  QButtonGroup* tools_ = nullptr;
  std::array<QRadioButton*, 5> toolButtons_{};
  QLabel* radiusLabel_ = nullptr;
  QDoubleSpinBox* radius_ = nullptr;
  QPushButton* undo_ = nullptr;
  QPushButton* clear_ = nullptr;
  QLabel* said_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* find_ = nullptr;
  QPushButton* surface_ = nullptr;
};

}  // namespace torsio::gui
