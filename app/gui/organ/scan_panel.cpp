// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/scan_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/organ/slice_view.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

constexpr int kControlsWidth = 320;
constexpr double kFinest_mm = 1.0 / 16.0;  // of a dab's position, which is passed as text
constexpr double kDabEvery = 0.4;          // spacing along a stroke, in radii
constexpr int kMaxLevel_HU = 2000;
constexpr int kMaxWidth_HU = 4000;
constexpr std::size_t kTissues = 4;

double finest(double mm) {
  return std::round(mm / kFinest_mm) * kFinest_mm;
}

}  // namespace

QString sliceName(SlicePlane plane) {
  return QStringLiteral("slice%1").arg(static_cast<int>(plane));
}

ScanPanel::ScanPanel(QWidget* parent) : QWidget(parent) {
  auto* row = bareLayout<QHBoxLayout>(this, 2 * kSpace);
  auto* slices = new QGridLayout;
  slices->setSpacing(kSpace);
  constexpr std::array<std::pair<SlicePlane, std::array<int, 2>>, 3> kPlaces{
      {{SlicePlane::kAxial, {0, 0}}, {SlicePlane::kCoronal, {0, 1}}, {SlicePlane::kSagittal, {1, 1}}}};
  for (const auto& [plane, place] : kPlaces) {
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpace / 2);
    auto* name = new QLabel(this);
    auto* view = new SliceView(state_, plane, this);
    view->setObjectName(sliceName(plane));
    names_[static_cast<std::size_t>(plane)] = name;
    views_[static_cast<std::size_t>(plane)] = view;
    column->addWidget(name);
    column->addWidget(view, 1);
    slices->addLayout(column, place[0], place[1], plane == SlicePlane::kAxial ? 2 : 1, 1);
    connect(view, &SliceView::pressed, this,
            [this, view](const PreviewVoxel& voxel) { press(*view, voxel); });
    connect(view, &SliceView::dragged, this, [this, view](const PreviewVoxel& voxel) { drag(*view, voxel); });
    connect(view, &SliceView::released, this, &ScanPanel::release);
    connect(view, &SliceView::moved, this, &ScanPanel::refresh);
  }
  slices->setColumnStretch(0, 3);
  slices->setColumnStretch(1, 2);
  row->addLayout(slices, 1);
  row->addWidget(createControls());
  connect(back_, &QPushButton::clicked, this, &ScanPanel::backWanted);
  connect(find_, &QPushButton::clicked, this, &ScanPanel::findWanted);
  connect(surface_, &QPushButton::clicked, this, &ScanPanel::surfaceWanted);
}

QWidget* ScanPanel::createControls() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kControlsWidth);
  auto* outer = bareLayout<QVBoxLayout>(side);
  auto* scroll = new QScrollArea(side);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* panel = new QWidget;
  auto* column = bareLayout<QVBoxLayout>(panel);
  keepOffScrollBar(*scroll, *column);
  column->setSpacing(kSpace);
  createTissue(column);
  createTools(column);
  createGrey(column);
  column->addStretch(1);
  scroll->setWidget(panel);
  outer->addWidget(scroll, 1);
  said_ = sentence(side, false);
  said_->setObjectName(QStringLiteral("scanSaid"));
  outer->addWidget(said_);
  back_ = new QPushButton(side);
  find_ = new QPushButton(side);
  find_->setObjectName(QStringLiteral("findOrgan"));
  surface_ = primaryButton(side);
  surface_->setObjectName(QStringLiteral("makeSurface"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back_, 1);
  buttons->addWidget(find_, 1);
  outer->addLayout(buttons);
  outer->addWidget(surface_);
  return side;
}

void ScanPanel::createTissue(QVBoxLayout* column) {
  organCard_ = new Card(QString(), this);
  tissue_ = new QComboBox(organCard_);
  tissue_->setObjectName(QStringLiteral("tissue"));
  tissue_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  tissue_->setMinimumContentsLength(12);
  for (std::size_t i = 0; i < kTissues; ++i) {
    tissue_->addItem(QString(), static_cast<int>(i));
  }
  tissueLabel_ = addField(organCard_->content(), tissue_);
  number_ = new QSpinBox(organCard_);
  number_->setRange(1, 32'767);
  number_->setEnabled(false);
  numberLabel_ = addField(organCard_->content(), number_);
  fluid_ = new QCheckBox(organCard_);
  fluid_->setEnabled(false);
  organCard_->content()->addWidget(fluid_);
  connect(tissue_, &QComboBox::currentIndexChanged, this, [this](int index) {
    number_->setEnabled(index == static_cast<int>(ScanTissue::kLabel));
    fluid_->setEnabled(index == static_cast<int>(ScanTissue::kGasLumen) ||
                       index == static_cast<int>(ScanTissue::kWall));
    showState();
  });
  column->addWidget(organCard_);
}

void ScanPanel::createTools(QVBoxLayout* column) {
  toolCard_ = new Card(QString(), this);
  tools_ = new QButtonGroup(toolCard_);
  for (std::size_t i = 0; i < toolButtons_.size(); ++i) {
    toolButtons_[i] = new QRadioButton(toolCard_);
    tools_->addButton(toolButtons_[i], static_cast<int>(i));
    toolCard_->content()->addWidget(toolButtons_[i]);
  }
  toolButtons_[0]->setChecked(true);
  radius_ = new QDoubleSpinBox(toolCard_);
  radius_->setRange(1.0, 50.0);
  radius_->setDecimals(0);
  radius_->setValue(8.0);
  radiusLabel_ = addField(toolCard_->content(), radius_);
  auto* buttons = new QHBoxLayout;
  undo_ = new QPushButton(toolCard_);
  undo_->setShortcut(QKeySequence::Undo);
  clear_ = new QPushButton(toolCard_);
  buttons->addWidget(undo_, 1);
  buttons->addWidget(clear_, 1);
  toolCard_->content()->addLayout(buttons);
  connect(tools_, &QButtonGroup::idClicked, this, &ScanPanel::chooseTool);
  connect(radius_, &QDoubleSpinBox::valueChanged, this, [this] { chooseTool(static_cast<int>(tool_)); });
  connect(undo_, &QPushButton::clicked, this, [this] {
    state_.undoStroke();
    refresh();
  });
  connect(clear_, &QPushButton::clicked, this, [this] {
    state_.clearStrokes();
    state_.box.reset();
    state_.seed_mm.reset();
    refresh();
  });
  column->addWidget(toolCard_);
}

void ScanPanel::createGrey(QVBoxLayout* column) {
  greyCard_ = new Card(QString(), this);
  preset_ = new QComboBox(greyCard_);
  preset_->addItems({QString(), QString(), QString(), QString()});
  presetLabel_ = addField(greyCard_->content(), preset_);
  level_ = new QSlider(Qt::Horizontal, greyCard_);
  level_->setRange(-1024, kMaxLevel_HU);
  level_->setPageStep(50);
  levelLabel_ = addField(greyCard_->content(), level_);
  width_ = new QSlider(Qt::Horizontal, greyCard_);
  width_->setRange(10, kMaxWidth_HU);
  width_->setPageStep(100);
  widthLabel_ = addField(greyCard_->content(), width_);
  connect(preset_, &QComboBox::activated, this, [this](int index) {
    constexpr std::array<GreyWindow, 3> kWindows{{{40.0, 400.0}, {-600.0, 1600.0}, {500.0, 2000.0}}};
    if (index < static_cast<int>(kWindows.size())) {
      state_.level = kWindows[static_cast<std::size_t>(index)].level;
      state_.width = kWindows[static_cast<std::size_t>(index)].width;
    } else if (!state_.empty()) {
      const auto& values = state_.preview.volume.values;
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      state_.level = 0.5 * (*low + *high);
      state_.width = std::max(10.0, static_cast<double>(*high) - *low);
    }
    refresh();
  });
  for (QSlider* slider : {level_, width_}) {
    connect(slider, &QSlider::valueChanged, this, &ScanPanel::takeGrey);
  }
  column->addWidget(greyCard_);
}

void ScanPanel::takeGrey() {
  state_.level = level_->value();
  state_.width = width_->value();
  refresh();
}

void ScanPanel::setScan(const std::filesystem::path& source, ScanPreview preview) {
  source_ = source;
  state_.setPreview(std::move(preview));
  const auto& values = state_.preview.volume.values;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const bool mask = *low >= 0 && *high < 1024;  // labels, not Hounsfield units
  if (mask) {
    state_.level = 0.5 * *high;
    state_.width = std::max(1.0, static_cast<double>(*high));
  } else {
    state_.level = 40.0;
    state_.width = 400.0;
  }
  tissue_->setCurrentIndex(static_cast<int>(mask ? ScanTissue::kLabel : ScanTissue::kSkin));
  number_->setValue(std::max<int>(1, *high));
  tools_->button(0)->setChecked(true);
  chooseTool(0);
  refresh();
}

void ScanPanel::setFound(ScanPreview organ) {
  state_.setFound(std::move(organ));
  refresh();
}

ScanRequest ScanPanel::request(bool brushed) const {
  ScanRequest request;
  request.source = source_;
  request.tissue = static_cast<ScanTissue>(tissue_->currentData().toInt());
  request.label = request.tissue == ScanTissue::kLabel ? number_->value() : 0;
  request.fluid = fluid_->isEnabled() && fluid_->isChecked();
  request.seed_mm = state_.seed_mm;
  request.box_mm = state_.box_mm();
  if (brushed) {
    request.brush = state_.dabs();
  }
  return request;
}

void ScanPanel::lookAt(const Vec3& place_mm) {
  const Vec3 at = state_.preview.volume.voxelAt(place_mm);
  const std::array<double, 3> voxel{at.x, at.y, at.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<double>(state_.preview.volume.count[axis]) - 1.0;
    state_.at[axis] = static_cast<int>(std::clamp(std::round(voxel[axis]), 0.0, std::max(last, 0.0)));
  }
  refresh();
}

void ScanPanel::chooseTool(int tool) {
  tool_ = static_cast<Tool>(tool);
  const bool brush = tool_ == Tool::kAdd || tool_ == Tool::kErase;
  for (SliceView* view : views_) {
    view->setBrush(brush ? radius_->value() : 0.0);
  }
}

void ScanPanel::press(const SliceView& view, const PreviewVoxel& voxel) {
  pressed_ = voxel;
  switch (tool_) {
    case Tool::kLook:
      state_.at = voxel;
      break;
    case Tool::kSeed:
      state_.at = voxel;
      state_.seed_mm = state_.placeOf_mm(voxel);
      break;
    case Tool::kBox:
      spanBox(view, voxel);
      break;
    case Tool::kAdd:
    case Tool::kErase:
      if (!state_.found.empty()) {
        state_.strokes.emplace_back();
        dab(voxel);
      }
      break;
  }
  refresh();
}

void ScanPanel::drag(const SliceView& view, const PreviewVoxel& voxel) {
  switch (tool_) {
    case Tool::kLook:
      state_.at = voxel;
      break;
    case Tool::kSeed:
      return;
    case Tool::kBox:
      spanBox(view, voxel);
      break;
    case Tool::kAdd:
    case Tool::kErase:
      dab(voxel);
      break;
  }
  refresh();
}

void ScanPanel::release() {
  if (!state_.strokes.empty() && state_.strokes.back().empty()) {
    state_.strokes.pop_back();
  }
  showState();
}

/// Adds dabs along a stroke, no more than needed to cover it.
void ScanPanel::dab(const PreviewVoxel& voxel) {
  if (state_.found.empty() || state_.strokes.empty()) {
    return;
  }
  const double radius_mm = radius_->value();
  const Vec3 to_mm = state_.placeOf_mm(voxel);
  const std::vector<BrushDab>& stroke = state_.strokes.back();
  const Vec3 from_mm = stroke.empty() ? to_mm : stroke.back().centre_mm;
  const double way_mm = norm(to_mm - from_mm);
  const double step_mm = kDabEvery * radius_mm;
  if (!stroke.empty() && way_mm < step_mm) {
    return;
  }
  const int steps = std::max(1, static_cast<int>(way_mm / step_mm));
  for (int i = 1; i <= steps; ++i) {
    const Vec3 at_mm = from_mm + (static_cast<double>(i) / steps) * (to_mm - from_mm);
    if (state_.dabs().size() < kMaxDabs) {
      state_.paint({{finest(at_mm.x), finest(at_mm.y), finest(at_mm.z)}, radius_mm, tool_ == Tool::kAdd});
    }
  }
}

/// Sets the box from a drag in one plane: keeps its extent across the plane, initially the whole scan.
void ScanPanel::spanBox(const SliceView& view, const PreviewVoxel& voxel) {
  const ScanVolume& volume = state_.preview.volume;
  std::array<PreviewVoxel, 2> box = state_.box.value_or(std::array<PreviewVoxel, 2>{
      PreviewVoxel{},
      PreviewVoxel{static_cast<int>(volume.count[0]) - 1, static_cast<int>(volume.count[1]) - 1,
                   static_cast<int>(volume.count[2]) - 1}});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis != static_cast<std::size_t>(view.plane())) {
      box[0][axis] = std::min(pressed_[axis], voxel[axis]);
      box[1][axis] = std::max(pressed_[axis], voxel[axis]);
    }
  }
  state_.box = box;
}

void ScanPanel::refresh() {
  const QSignalBlocker quietLevel(level_);
  const QSignalBlocker quietWidth(width_);
  level_->setValue(static_cast<int>(std::lround(state_.level)));
  width_->setValue(static_cast<int>(std::lround(state_.width)));
  for (SliceView* view : views_) {
    view->refresh();
  }
  showState();
}

void ScanPanel::showState() {
  const bool found = !state_.found.empty();
  undo_->setEnabled(!state_.strokes.empty());
  clear_->setEnabled(!state_.strokes.empty() || state_.box || state_.seed_mm);
  toolButtons_[static_cast<std::size_t>(Tool::kAdd)]->setEnabled(found);
  toolButtons_[static_cast<std::size_t>(Tool::kErase)]->setEnabled(found);
  surface_->setEnabled(found);
  find_->setEnabled(!state_.empty());
  if (state_.empty()) {
    said_->clear();
    return;
  }
  const Vec3 at_mm = state_.placeOf_mm(state_.at);
  const ScanVolume& volume = state_.preview.volume;
  const std::int16_t value =
      volume
          .values[volume.index(static_cast<std::size_t>(state_.at[0]), static_cast<std::size_t>(state_.at[1]),
                               static_cast<std::size_t>(state_.at[2]))];
  QString said =
      tr("%1 mm left, %2 back, %3 up: value %4")
          .arg(numberText(at_mm.x, 0), numberText(at_mm.y, 0), numberText(at_mm.z, 0), countText(value));
  if (const std::optional<double> volume_ml = state_.volume_ml()) {
    said += QLatin1Char('\n') + tr("The mask holds %1 ml").arg(numberText(*volume_ml, 0));
  }
  for (const ScanRemark& remark : state_.preview.remarks) {
    said += QLatin1Char('\n') + capitalised(toQString(remark.what));
  }
  said_->setText(said);
}

void ScanPanel::retranslate() {
  names_[static_cast<std::size_t>(SlicePlane::kAxial)]->setText(tr("Axial"));
  names_[static_cast<std::size_t>(SlicePlane::kCoronal)]->setText(tr("Coronal"));
  names_[static_cast<std::size_t>(SlicePlane::kSagittal)]->setText(tr("Sagittal"));
  for (std::size_t i = 0; i < views_.size(); ++i) {
    views_[i]->setAccessibleName(names_[i]->text());
    views_[i]->setToolTip(tr("Wheel or arrow keys: change slice. Right drag: grey window"));
  }
  organCard_->setTitle(tr("What the organ is"));
  nameField(tissueLabel_, tr("&Tissue"));
  const QStringList tissues{tr("Everything inside the skin"), tr("Gas in a hollow organ"),
                            tr("Gas and the surrounding wall"), tr("A label of a mask")};
  for (int i = 0; i < tissues.size(); ++i) {
    tissue_->setItemText(i, tissues[i]);
  }
  nameField(numberLabel_, tr("Label &number"));
  fluid_->setText(tr("with the fluid below the gas"));
  toolCard_->setTitle(tr("What a click does"));
  const QStringList tools{tr("Look there"), tr("Seed: the organ lies there"), tr("Box: drag round the organ"),
                          tr("Brush: add to the mask"), tr("Brush: erase from the mask")};
  for (std::size_t i = 0; i < toolButtons_.size(); ++i) {
    toolButtons_[i]->setText(tools[static_cast<int>(i)]);
  }
  nameField(radiusLabel_, tr("&Radius of the brush"));
  radius_->setSuffix(tr(" mm"));
  undo_->setText(tr("Undo stroke"));
  clear_->setText(tr("Clear"));
  clear_->setToolTip(tr("Clears seed, box and all brush strokes"));
  greyCard_->setTitle(tr("Grey window"));
  nameField(presetLabel_, tr("&Preset"));
  const QStringList presets{tr("Soft tissue"), tr("Gas and lung"), tr("Bone"), tr("All values")};
  for (int i = 0; i < presets.size(); ++i) {
    preset_->setItemText(i, presets[i]);
  }
  nameField(levelLabel_, tr("&Level"));
  nameField(widthLabel_, tr("&Width"));
  back_->setText(tr("Another file"));
  find_->setText(tr("Find the organ"));
  surface_->setText(tr("Create its surface"));
  refresh();
}

void ScanPanel::setTheme(const Theme& theme) {
  for (SliceView* view : views_) {
    view->setTheme(theme);
  }
}

}  // namespace torsio::gui
