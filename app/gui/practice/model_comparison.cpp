// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/model_comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/base/figure_card.h"
#include "app/gui/base/scene_titles.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/scene/orbit_camera.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/signed_box.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/pdf/pdf_report.h"
#include "app/services/base/build_info.h"
#include "app/services/comparison/comparison_files.h"
#include "app/services/comparison/comparison_order.h"
#include "app/services/comparison/comparison_report.h"
#include "sim/core/angle.h"
#include "sim/core/clock.h"
#include "sim/core/load_decimals.h"

namespace torsio::gui {

namespace {

constexpr double kShownPoses_per_s = 30.0;  ///< per second of simulated time
constexpr int kReplayFrame_ms = 33;
constexpr int kLeastViewHeight = 250;
constexpr double kViewShare = 0.35;  // of the page's height, if larger
constexpr int kLabelRoom = 4;        ///< size hints of labels with a mnemonic are slightly too small
constexpr int kTableHeight = 330;
constexpr int kFigureHeight = 400;
constexpr int kFirstMarkerOfCourse = 8;  ///< the second knuckle, as in Fig. 14

ComparedScene loadCompared(SceneRequest request) {
  request.ridges = kComparedRidges;
  request.sections = kComparedSections;
  ComparedScene organ;
  organ.loaded = loadSceneForView(request);
  const Scene& scene = *organ.loaded.scene;
  if (!request.organFile) {
    organ.markers = readOrganMarkers(request.assets, scene);
  }
  if (organ.markers.empty()) {
    organ.markers = spreadMarkers(scene);
  }
  organ.skin = std::make_shared<const LatticeSkin>(scene.mesh, scene.lattice());
  organ.torque_Nm = usualTorque_Nm(scene);
  return organ;
}

/// Formats a time from microseconds to minutes with three digits.
QString spanOf(double seconds) {
  const QLocale locale;
  if (seconds < 1e-3) {
    return ModelComparison::tr("%1 \u00b5s").arg(numberText(seconds * 1e6, 0));
  }
  if (seconds < 1.0) {
    return ModelComparison::tr("%1 ms").arg(locale.toString(seconds * 1e3, 'g', 3));
  }
  return ModelComparison::tr("%1 s").arg(numberText(seconds, 2));
}

std::vector<SkinAnchor> anchorsOf(const Scene& scene, const std::vector<OrganMarker>& markers) {
  std::vector<SkinAnchor> anchors;
  for (const OrganMarker& marker : markers) {
    SkinAnchor anchor;
    anchor.corners = scene.mesh.triangles[marker.face];
    for (std::size_t k = 0; k < 3; ++k) {
      anchor.weights[k] = static_cast<float>(marker.barycentric[k]);
    }
    anchors.push_back(anchor);
  }
  return anchors;
}

}  // namespace

ModelComparison::ModelComparison(ShellContext& shell, QWidget* parent) : QWidget(parent), shell_(shell) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 2 * kSpace, 0, 0);
  outer->setSpacing(2 * kSpace);
  outer->addWidget(createBar());
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget;
  auto* column = bareLayout<QVBoxLayout>(content, 2 * kSpace);
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * kSpace);
  sides_[0].id = "pm";
  sides_[1].id = "fem";
  sides_[2].id = "msm";
  for (Side& side : sides_) {
    row->addWidget(createSide(side), 1);
  }
  column->addLayout(row);
  hint_ = sentence(content);
  column->addWidget(hint_);
  for (const int height :
       {kTableHeight, kTableHeight, kTableHeight, kFigureHeight, kFigureHeight, kFigureHeight}) {
    auto* card = new FigureCard(content);
    card->setMinimumHeight(height);
    card->hide();
    cards_.push_back(card);
    column->addWidget(card);
  }
  limits_ = sentence(content);
  limits_->setObjectName(QStringLiteral("limits"));
  column->addWidget(limits_);
  column->addStretch(1);
  scroll->setWidget(content);
  outer->addWidget(scroll, 1);
  replayTimer_.setInterval(kReplayFrame_ms);
  connect(&replayTimer_, &QTimer::timeout, this, &ModelComparison::replayFrame);
}

void ModelComparison::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  for (const Side& side : sides_) {
    side.view->setMinimumHeight(std::max(kLeastViewHeight, static_cast<int>(kViewShare * height())));
  }
}

QWidget* ModelComparison::createBar() {
  auto* bar = new QWidget(this);
  auto* row = bareLayout<QHBoxLayout>(bar, kSpace);
  organLabel_ = new QLabel(bar);
  organChoice_ = new QComboBox(bar);
  organLabel_->setBuddy(organChoice_);
  for (const std::string& id : sceneIds(shell_.assets())) {
    organChoice_->addItem(QString(), toQString(id));
  }
  torqueLabel_ = new QLabel(bar);
  torqueLabel_->setContentsMargins(0, 0, kLabelRoom, 0);
  torque_ = new SignedBox(bar);
  torque_->setRange(-100.0, 100.0);
  torque_->setDecimals(kModelTorqueDecimals);
  torque_->setSingleStep(0.005);
  torque_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  torqueLabel_->setBuddy(torque_);
  compare_ = primaryButton(bar);
  replay_ = new QPushButton(bar);
  save_ = new QPushButton(bar);
  row->addWidget(organLabel_);
  row->addWidget(organChoice_);
  row->addSpacing(kSpace);
  row->addWidget(torqueLabel_);
  row->addWidget(torque_);
  row->addSpacing(kSpace);
  row->addWidget(compare_);
  row->addWidget(replay_);
  row->addWidget(save_);
  row->addStretch(1);
  connect(organChoice_, &QComboBox::activated, this, [this](int index) {
    const QString id = organChoice_->itemData(index).toString();
    SceneRequest request = id.isEmpty() ? *ownOrgan_ : SceneRequest{};
    if (!id.isEmpty()) {
      request.assets = shell_.assets();
      request.id = id.toStdString();
    }
    load(request);
  });
  connect(compare_, &QPushButton::clicked, this, [this] { compare({}); });
  connect(replay_, &QPushButton::clicked, this, &ModelComparison::replay);
  connect(save_, &QPushButton::clicked, this, &ModelComparison::chooseFolder);
  for (QPushButton* button : {compare_, replay_, save_}) {
    button->setEnabled(false);
  }
  return bar;
}

QWidget* ModelComparison::createSide(Side& side) {
  side.card = new Card(QString(), this);
  side.poses = std::make_shared<std::vector<ModelPose>>();
  side.view = new SceneView(side.card);
  side.view->setMinimumHeight(kLeastViewHeight);
  side.view->setToolVisible(false);
  side.view->setMarkersVisible(true);
  auto* turn = new ViewTurn(*side.view);
  connect(turn, &ViewTurn::turned, this, [this, view = side.view] { turnOthers(*view); });
  side.clock = new QLabel(side.card);
  side.clock->setObjectName(QStringLiteral("clock"));
  QFont large = side.clock->font();
  large.setPointSizeF(kFigureText_pt);
  side.clock->setFont(large);
  side.figures = sentence(side.card);
  side.card->content()->addWidget(side.view, 1);
  side.card->content()->addWidget(side.clock);
  side.card->content()->addWidget(side.figures);
  return side.card;
}

void ModelComparison::load(const SceneRequest& request) {
  asked_ = true;
  if (request.organFile) {
    if (!ownOrgan_) {
      organChoice_->addItem(QString(), QString());
    }
    ownOrgan_ = request;
    nameOrgans();
  }
  organChoice_->setCurrentIndex(
      organChoice_->findData(request.organFile ? QString() : toQString(request.id)));
  shell_.run(
      this, tr("Loading the organ"),
      [request](SessionContext&, const ProgressCallback& progress) {
        progress({request.id, 0.0, -1.0});
        return loadCompared(request);
      },
      [this](ComparedScene organ) { adopt(std::move(organ)); });
}

void ModelComparison::adopt(ComparedScene organ) {
  replayTimer_.stop();
  organ_ = std::move(organ);
  result_.reset();
  for (Side& side : sides_) {
    side.poses->clear();
    ViewScene view = organ_.loaded.view;
    view.shear = {};
    // Views refer to poses by number, passed in place of the grasp.
    view.deform = [skin = organ_.skin, scene = organ_.loaded.scene, poses = side.poses](
                      const OrganState& state, std::span<Vec3> out_m) {
      const auto pose = static_cast<std::size_t>(state.twist.graspArc_m);
      if (pose < poses->size()) {
        skin->deform((*poses)[pose].places, (*poses)[pose].angle_rad, out_m);
      } else {
        std::copy(scene->mesh.vertices_m.begin(), scene->mesh.vertices_m.end(), out_m.begin());
      }
    };
    side.view->setScene(view);
  }
  torque_->setValue(organ_.torque_Nm);
  setMarkers(organ_.markers);
  compare_->setEnabled(true);
  showResult();
  Q_EMIT organChanged();
}

void ModelComparison::setMarkers(std::vector<OrganMarker> markers) {
  markers_ = std::move(markers);
  for (const Side& side : sides_) {
    side.view->setMarkers(anchorsOf(*organ_.loaded.scene, markers_));
  }
}

void ModelComparison::compare(const ComparisonOptions& options) {
  if (!loaded()) {
    return;
  }
  if (shell_.working()) {  // timing needs an otherwise idle machine
    shell_.notify(tr("Wait until the current work has finished"));
    return;
  }
  ComparisonOptions asked = options;
  if (!asked.torque_Nm) {
    asked.torque_Nm = torque_->value();
  }
  asked.poseEvery_s = 1.0 / kShownPoses_per_s;
  asked.courseMarker = std::min(kFirstMarkerOfCourse, static_cast<int>(markers_.size()));
  shell_.run(
      this, tr("Comparing the models"),
      [asked, scene = organ_.loaded.scene, markers = markers_](SessionContext&,
                                                               const ProgressCallback& progress) {
        checkMarkers(markers, {});
        return std::make_shared<const ComparisonResult>(runComparison(*scene, markers, {}, asked, progress));
      },
      [this, scene = organ_.loaded.scene](std::shared_ptr<const ComparisonResult> result) {
        if (scene == organ_.loaded.scene) {  // unless the organ has been changed
          took(std::move(result));
        }
      });
}

void ModelComparison::took(std::shared_ptr<const ComparisonResult> result) {
  result_ = std::move(result);
  generation_ += 1.0;
  for (Side& side : sides_) {
    *side.poses = result_->model(side.id).poses;
  }
  showResult();
  Q_EMIT compared();
}

void ModelComparison::showResult() {
  replay_->setEnabled(result_ != nullptr);
  save_->setEnabled(result_ != nullptr);
  for (Side& side : sides_) {
    showPose(side, result_ != nullptr ? result_->model(side.id).deformation_s : 0.0);
    showFigures(side);
  }
  hint_->setVisible(result_ == nullptr);
  for (FigureCard* card : cards_) {
    card->setVisible(result_ != nullptr);
  }
  std::vector<Text> said = comparisonLimits();
  if (result_ == nullptr) {
    limits_->setText(translatedLines(said));
    return;
  }
  const std::vector<Text> order = comparisonOrder(*result_);
  said.insert(said.begin(), order.begin(), order.end());
  limits_->setText(translatedLines(said));
  const ReportModel report = comparisonReport(*result_, softwareVersion(), 0);
  cards_[0]->setTable(report.sections[0].tables[0]);
  cards_[1]->setTable(report.sections[1].tables[0]);
  cards_[2]->setTable(report.sections[1].tables[1]);
  cards_[3]->setFigure(report.sections[0].figures[0]);
  cards_[4]->setFigure(report.sections[1].figures[0]);
  cards_[5]->setFigure(report.sections[1].figures[1]);
}

void ModelComparison::showPose(Side& side, double processing_s) {
  const std::vector<ModelPose>& poses = *side.poses;
  std::size_t pose = 0;
  while (pose + 1 < poses.size() && poses[pose + 1].processing_s <= processing_s) {
    ++pose;
  }
  side.view->setOrgan({{static_cast<double>(pose), generation_ + 1.0}, {}});
  side.clock->setText(result_ == nullptr
                          ? QStringLiteral("\u2013")
                          : spanOf(std::min(processing_s, result_->model(side.id).deformation_s)));
  side.clock->setAccessibleName(tr("Processing time of %1").arg(toQString(side.id).toUpper()));
}

void ModelComparison::showFigures(const Side& side) {
  if (result_ == nullptr) {
    side.figures->setText(tr("Not computed yet"));
    return;
  }
  const ModelResult& model = result_->model(side.id);
  QString text =
      tr("for the whole twist, %n frame(s), median %1; set-up not included: %2", nullptr, model.frames)
          .arg(spanOf(model.frameMedian_s), spanOf(model.setUp_s));
  text += QLatin1Char('\n');
  text += model.noEquilibrium.empty() ? tr("In equilibrium %1\u00b0, %2 mm from the reference")
                                            .arg(numberText(degrees(model.settled.angle_rad), 1),
                                                 numberText(1e3 * model.settled.rmse_m, 2))
                                      : tr("No equilibrium: %1").arg(toQString(model.noEquilibrium));
  side.figures->setText(text);
}

void ModelComparison::replay() {
  replayClock_.start();
  replayTimer_.start();
  replayFrame();
}

void ModelComparison::replayFrame() {
  if (result_ == nullptr) {
    replayTimer_.stop();
    return;
  }
  const double now_s = static_cast<double>(replayClock_.nsecsElapsed()) * 1e-9;
  bool going = false;
  for (Side& side : sides_) {
    showPose(side, now_s);
    going = going || now_s < result_->model(side.id).deformation_s;
  }
  if (!going) {
    replayTimer_.stop();
  }
}

void ModelComparison::saveReport(const std::filesystem::path& folder) const {
  writeComparisonFiles(*result_, folder);
  writePdfReport(comparisonReport(*result_, softwareVersion(), utcNow_us()), folder / kComparisonReportName,
                 [](const Text& text) { return toQString(text); });
}

void ModelComparison::chooseFolder() {
  const QString folder = askFolder(this, tr("Folder for the report and its tables"));
  if (!folder.isEmpty()) {
    attempt(shell_, [&] {
      saveReport(toPath(folder));
      shell_.notify(tr("Saved %1").arg(folder));
    });
  }
}

void ModelComparison::turnOthers(const SceneView& turned) {
  for (const Side& side : sides_) {
    if (side.view != &turned) {
      side.view->camera() = turned.camera();
      side.view->applyCamera();
    }
  }
}

void ModelComparison::nameOrgans() {
  SceneTitles titles(shell_.assets());
  for (int i = 0; i < organChoice_->count(); ++i) {
    const QString id = organChoice_->itemData(i).toString();
    organChoice_->setItemText(
        i, id.isEmpty() ? toQString(ownOrgan_->organFile->filename()) : titles.scene(id.toStdString()));
  }
}

void ModelComparison::retranslate() {
  nameField(organLabel_, tr("&Organ"));
  nameField(torqueLabel_, tr("&Torque"));
  torque_->setSuffix(tr(" N m"));
  nameOrgans();
  compare_->setText(tr("&Compare"));
  compare_->setToolTip(tr("Computes all models anew; a quarter of a minute to a minute"));
  replay_->setText(tr("Re&play"));
  replay_->setToolTip(tr("Shows each model as fast as it was computed"));
  save_->setText(tr("&Save report\u2026"));
  save_->setToolTip(tr("PDF, JSON and tables, as torsio compare writes them"));
  hint_->setText(
      tr("Compare twists the organ about its own axis by all three models under the same torque. Each clock "
         "shows "
         "how long its model computed until the twist stood still. Drag a view to turn all of them."));
  sides_[0].card->setTitle(tr("PM: twist model"));
  sides_[1].card->setTitle(tr("FEM: finite elements"));
  sides_[2].card->setTitle(tr("MSM: springs"));
  if (loaded()) {
    showResult();
  }
}

void ModelComparison::setTheme(const Theme& theme) {
  for (const Side& side : sides_) {
    side.view->setTheme(theme);
  }
  for (FigureCard* card : cards_) {
    card->setTheme(theme);
  }
}

}  // namespace torsio::gui
