// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/organ_settings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/scene_titles.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/geometry/mesh/mesh_space.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

namespace {

constexpr double kMillimetre_m = 1e-3;
constexpr double kSameUnit = 1e-6;                                    // relative
constexpr std::array<double, 4> kUnits_mm{1.0, 10.0, 1000.0, 0.001};  // mm, cm, m, um
constexpr double kFarthest_mm = 1e5;
constexpr double kThickest_mm = 50.0;

QDoubleSpinBox* lengthBox(double least, double most, int decimals) {
  auto* box = new QDoubleSpinBox;
  box->setRange(least, most);
  box->setDecimals(decimals);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setKeyboardTracking(false);
  return box;
}

QComboBox* narrowBox() {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(14);
  return box;
}

}  // namespace

OrganSettings::OrganSettings(const std::filesystem::path& assets, QWidget* parent)
    : QWidget(parent), assets_(assets), ofMesh_(new QWidget(this)) {
  auto* column = bareLayout<QVBoxLayout>(this);
  auto* mesh = bareLayout<QVBoxLayout>(ofMesh_);
  unit_ = narrowBox();
  unit_->setObjectName(QStringLiteral("organUnit"));
  unit_->addItems({QString(), QString(), QString(), QString(), QString()});
  unitLabel_ = addField(mesh, unit_);
  scale_ = lengthBox(1e-6, 1e6, 6);
  scale_->setValue(1.0);
  scaleLabel_ = addField(mesh, scale_);
  closeHoles_ = new QCheckBox(ofMesh_);
  mesh->addWidget(closeHoles_);
  column->addWidget(ofMesh_);
  anatomy_ = narrowBox();
  anatomy_->setObjectName(QStringLiteral("anatomy"));
  anatomy_->addItem(QString(), QString());
  for (const std::string& id : sceneIds(assets_)) {
    anatomy_->addItem(QString(), toQString(id));
  }
  anatomyLabel_ = addField(column, anatomy_);
  wall_ = lengthBox(0.0, kThickest_mm, 1);
  wallLabel_ = addField(column, wall_);
  column->addWidget(createEnds());
  connect(unit_, &QComboBox::activated, this, [this](int index) {
    if (index < static_cast<int>(kUnits_mm.size())) {
      scale_->setValue(kUnits_mm[static_cast<std::size_t>(index)]);
    }
    scale_->setEnabled(index == static_cast<int>(kUnits_mm.size()));
  });
  scale_->setEnabled(false);
  for (QDoubleSpinBox* box : {scale_, wall_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, &OrganSettings::changed);
  }
  connect(closeHoles_, &QCheckBox::toggled, this, &OrganSettings::changed);
  connect(anatomy_, &QComboBox::currentIndexChanged, this, &OrganSettings::changed);
  enableEnds();
}

QWidget* OrganSettings::createEnds() {
  auto* ends = new QWidget(this);
  auto* column = bareLayout<QVBoxLayout>(ends);
  endsLabel_ = new QLabel(ends);
  found_ = new QRadioButton(ends);
  given_ = new QRadioButton(ends);
  given_->setObjectName(QStringLiteral("endsGiven"));
  found_->setChecked(true);
  for (QWidget* widget :
       {static_cast<QWidget*>(endsLabel_), static_cast<QWidget*>(found_), static_cast<QWidget*>(given_)}) {
    column->addWidget(widget);
  }
  for (End* end : {&fixed_, &free_}) {
    createEnd(*end);
    column->addWidget(end->label);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace / 2);
    for (QDoubleSpinBox* box : end->place_mm) {
      row->addWidget(box, 1);
    }
    row->addWidget(end->pick);
    column->addLayout(row);
    column->addWidget(end->cut);
  }
  connect(given_, &QRadioButton::toggled, this, [this] {
    enableEnds();
    Q_EMIT changed();
  });
  connect(fixed_.pick, &QPushButton::toggled, this, [this](bool on) {
    if (on) {
      free_.pick->setChecked(false);
    }
  });
  connect(free_.pick, &QPushButton::toggled, this, [this](bool on) {
    if (on) {
      fixed_.pick->setChecked(false);
    }
  });
  return ends;
}

void OrganSettings::createEnd(End& end) {
  end.label = new QLabel;
  for (QDoubleSpinBox*& box : end.place_mm) {
    box = lengthBox(-kFarthest_mm, kFarthest_mm, 1);
    box->setMinimumWidth(0);
    connect(box, &QDoubleSpinBox::valueChanged, this, &OrganSettings::changed);
  }
  end.label->setBuddy(end.place_mm[0]);
  end.pick = new QPushButton;
  end.pick->setCheckable(true);
  end.cut = new QCheckBox;
  connect(end.cut, &QCheckBox::toggled, this, &OrganSettings::changed);
}

void OrganSettings::enableEnds() {
  for (const End* end : {&fixed_, &free_}) {
    for (QDoubleSpinBox* box : end->place_mm) {
      box->setEnabled(given_->isChecked());
    }
    end->pick->setEnabled(given_->isChecked());
    end->cut->setEnabled(given_->isChecked());
    if (!given_->isChecked()) {
      end->pick->setChecked(false);
    }
  }
}

void OrganSettings::setScan(bool scan) {
  ofMesh_->setVisible(!scan);
}

void OrganSettings::setMesh(const std::filesystem::path& file) {
  setScan(false);
  const std::optional<double> stated_m = meshSpaceOf(file).unit_m;
  unit_->setEnabled(!stated_m);
  if (!stated_m) {
    return;
  }
  const double unit_mm = *stated_m / kMillimetre_m;
  const auto known = std::find_if(kUnits_mm.begin(), kUnits_mm.end(), [unit_mm](double one_mm) {
    return std::abs(one_mm / unit_mm - 1.0) < kSameUnit;
  });
  const QSignalBlocker quiet(this);
  unit_->setCurrentIndex(static_cast<int>(known - kUnits_mm.begin()));  // past the last: another
  scale_->setValue(unit_mm);
  scale_->setEnabled(false);
}

Vec3 OrganSettings::placeOf_m(const End& end) {
  return Vec3{end.place_mm[0]->value(), end.place_mm[1]->value(), end.place_mm[2]->value()} * kMillimetre_m;
}

void OrganSettings::apply(OrganImportRequest& request) const {
  request.scale_m = scale_->value() * kMillimetre_m;
  request.closeHoles = closeHoles_->isChecked();
  request.anatomy = anatomy_->currentData().toString().toStdString();
  if (wall_->value() > 0.0) {
    request.wall_m = wall_->value() * kMillimetre_m;
  }
  if (!given_->isChecked()) {
    return;
  }
  request.ends.fixedEnd_m = placeOf_m(fixed_);
  request.ends.freeEnd_m = placeOf_m(free_);
  const Vec3 along = *request.ends.freeEnd_m - *request.ends.fixedEnd_m;
  if (norm(along) > 0.0) {
    request.ends.fixedCut = fixed_.cut->isChecked() ? -1.0 / norm(along) * along : Vec3{};
    request.ends.freeCut = free_.cut->isChecked() ? 1.0 / norm(along) * along : Vec3{};
  }
}

void OrganSettings::takePlace(const Vec3& place_m) {
  for (const End* end : {&fixed_, &free_}) {
    if (!end->pick->isChecked()) {
      continue;
    }
    const std::array<double, 3> place{place_m.x, place_m.y, place_m.z};
    for (std::size_t k = 0; k < 3; ++k) {
      end->place_mm[k]->setValue(place[k] / kMillimetre_m);
    }
    if (end == &fixed_) {
      free_.pick->setChecked(true);  // the other end is next
    } else {
      free_.pick->setChecked(false);
    }
    return;
  }
}

void OrganSettings::reset() {
  const QSignalBlocker quiet(this);
  unit_->setCurrentIndex(0);
  scale_->setValue(1.0);
  scale_->setEnabled(false);
  closeHoles_->setChecked(false);
  anatomy_->setCurrentIndex(0);
  wall_->setValue(0.0);
  found_->setChecked(true);
  for (const End* end : {&fixed_, &free_}) {
    for (QDoubleSpinBox* box : end->place_mm) {
      box->setValue(0.0);
    }
    end->cut->setChecked(false);
  }
  enableEnds();
}

void OrganSettings::retranslate() {
  nameField(unitLabel_, tr("&Unit of the file"));
  const QStringList units{tr("millimetres"), tr("centimetres"), tr("metres"), tr("micrometres"),
                          tr("another")};
  for (int i = 0; i < units.size(); ++i) {
    unit_->setItemText(i, units[i]);
  }
  nameField(scaleLabel_, tr("&Millimetres in one unit"));
  closeHoles_->setText(tr("Close holes and open ends"));
  nameField(anatomyLabel_, tr("&Anatomy"));
  SceneTitles titles(assets_);
  anatomy_->setItemText(0, tr("Not known: twists about its own axis"));
  for (int i = 1; i < anatomy_->count(); ++i) {
    anatomy_->setItemText(i, titles.scene(anatomy_->itemData(i).toString().toStdString()));
  }
  nameField(wallLabel_, tr("Thickness of its &wall"));
  wall_->setSuffix(tr(" mm"));
  wall_->setSpecialValueText(tr("not known"));
  endsLabel_->setText(tr("Ends of the organ"));
  found_->setText(tr("found from its shape"));
  given_->setText(tr("given, in millimetres: left, back, up"));
  nameField(fixed_.label, tr("&Held end"));
  nameField(free_.label, tr("&Free end"));
  const QStringList axes{tr("to the left"), tr("to the back"), tr("up")};
  for (const End* end : {&fixed_, &free_}) {
    for (int k = 0; k < axes.size(); ++k) {
      end->place_mm[static_cast<std::size_t>(k)]->setAccessibleName(
          tr("%1: %2").arg(end == &fixed_ ? tr("Held end") : tr("Free end"), axes[k]));
    }
    end->pick->setText(tr("Click"));
    end->pick->setToolTip(tr("Then click on the organ where this end lies"));
    end->pick->setAccessibleName(end == &fixed_ ? tr("Click the held end") : tr("Click the free end"));
    end->cut->setText(tr("cut there: what lies beyond follows as a whole"));
  }
}

}  // namespace torsio::gui
