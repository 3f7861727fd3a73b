// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/scene_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QQmlEngine>
#include <QQuickItem>
#include <QQuickWidget>
#include <QQuickWindow>
#include <QUrl>
#include <QVBoxLayout>

#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/organ_geometry.h"
#include "app/gui/scene/stress_legend.h"
#include "app/gui/scene/view_frame.h"
#include "sim/scene/hollow_view.h"
#include "sim/servo/indentation.h"

/// The linker drops resources of a static library that nothing names.
static void initSceneResources() {
  Q_INIT_RESOURCE(torsio_scene);
  Q_INIT_RESOURCE(torsio_light);
  Q_INIT_RESOURCE(torsio_shaders);
}

namespace torsio::gui {

namespace {

// Share of the organ's radius: what is seen of a line is the same on a large organ and a small one.
constexpr float kGhostDepth_mm = 0.6F;
constexpr float kLatticeWidth = 0.0042F;
constexpr float kGraspWidth = 0.013F;
constexpr float kMarkerRadius = 0.014F;
// The arrow of the force, shares of the organ's radius.
constexpr double kShortestArrow = 0.10;
constexpr double kLongestArrow = 0.55;
constexpr float kArrowThickness = 0.011F;
constexpr double kLongestArrow_N = 3.3;  // what the device can give at most: the arrow is full there
constexpr double kLeastForce_N = 0.02;   // below the friction of the device nobody feels it
constexpr double kJawHolding_deg = 3.0;  // each jaw, closed on tissue

/// A little shade, so that the form is seen under the colours of a map; most of what faces the viewer has
/// none.
float formShade(const float (&normal)[3]) {
  constexpr float kDeepest = 0.30F;
  const float facing = 0.20F * normal[0] * -1.0F + 0.45F * normal[1] + 0.87F * normal[2];
  const float away = std::clamp(0.55F - facing, 0.0F, 1.0F);
  return 1.0F - kDeepest * away;
}

/// Names of Mesa, Chrome's renderer, and Windows with and without a driver.
Renderer kindOf(const QString& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "software rasterizer", "SwiftShader",
                           "Microsoft Basic Render", "GDI Generic"}) {
    if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive)) {
      return Renderer::kSoftware;
    }
  }
  return Renderer::kGraphicsCard;
}

/// Stands where the organ would be on a display without OpenGL.
class NoSceneSentence : public QLabel {
 public:
  explicit NoSceneSentence(QWidget* parent) : QLabel(parent) {
    setAlignment(Qt::AlignCenter);
    setWordWrap(true);
    retranslate();
  }

 protected:
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::LanguageChange) {
      retranslate();
    }
    QLabel::changeEvent(event);
  }

 private:
  void retranslate() { setText(SceneView::tr("This display cannot show the organ: it has no OpenGL.")); }
};

}  // namespace

ViewScene makeViewScene(const std::shared_ptr<const Scene>& scene, const std::string& tissue) {
  ViewScene view;
  const std::string& tissueId = tissue.empty() ? scene->id : tissue;
  view.look = tissueLook(tissueId);
  view.surroundings = surroundingsOf(tissueId);
  view.surface = OrganSurface(scene->mesh);
  if (SceneView::platformCanRender()) {
    view.skin = std::make_shared<const TissueSkin>(paintSkin(*scene, view.look));
  }
  view.lines = latticeLines(*scene);
  view.shear = ShearMap(scene);
  view.blood = BloodMap(scene);
  view.deform = [scene](const OrganState& state, std::span<Vec3> out_m) { scene->deform(state, out_m); };
  if (scene->hollow) {
    view.deform = [drawn = std::make_shared<HollowView>(scene)](
                      const OrganState& state, std::span<Vec3> out_m) { drawn->deform(state, out_m); };
  }
  return view;
}

SceneView::SceneView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Organ and instrument"));
  setAccessibleDescription(tr("Three-dimensional view; the numbers beside it say the same in text."));
  setMinimumSize(320, 240);
  legend_ = new StressLegend(this);
  legend_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (platformCanRender()) {
    createScene();
    layout->addWidget(quick_);
  } else {
    layout->addWidget(new NoSceneSentence(this));
  }
  legend_->raise();
}

SceneView::~SceneView() = default;

void SceneView::prepareGraphics() {
  QQuickWindow::setGraphicsApi(QSGRendererInterface::OpenGL);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

void SceneView::registerTypes() {
  static const bool kOnce = [] {
    initSceneResources();
    qmlRegisterType<OrganGeometry>("Torsio.Scene", 1, 0, "OrganGeometry");
    qmlRegisterType<SkinTexture>("Torsio.Scene", 1, 0, "SkinTexture");
    qmlRegisterType<SurroundingsTexture>("Torsio.Scene", 1, 0, "SurroundingsTexture");
    qmlRegisterType<WireGeometry>("Torsio.Scene", 1, 0, "WireGeometry");
    qmlRegisterType<RibbonGeometry>("Torsio.Scene", 1, 0, "RibbonGeometry");
    qmlRegisterType<MarkerGeometry>("Torsio.Scene", 1, 0, "MarkerGeometry");
    qmlRegisterType<InstrumentGeometry>("Torsio.Scene", 1, 0, "InstrumentGeometry");
    return true;
  }();
  Q_UNUSED(kOnce)
}

void SceneView::prepareWindow(QWidget& window) {
  if (!platformCanRender()) {
    return;
  }
  auto* surface = new QQuickWidget(&window);  // never shown, draws nothing
  surface->setFocusPolicy(Qt::NoFocus);
  surface->resize(1, 1);
  surface->hide();
}

bool SceneView::platformCanRender() {
  const QString platform = QGuiApplication::platformName();
  return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal") &&
         platform != QLatin1String("vnc");
}

void SceneView::createScene() {
  registerTypes();
  quick_ = new QQuickWidget(this);
  quick_->setResizeMode(QQuickWidget::SizeRootObjectToView);
  quick_->setFocusPolicy(Qt::NoFocus);
  quick_->setAttribute(Qt::WA_TransparentForMouseEvents);
  quick_->setSource(QUrl(QStringLiteral("qrc:/torsio/scene/scene_view.qml")));
  root_ = quick_->rootObject();
  if (root_ == nullptr) {
    qFatal("scene_view.qml: %s",
           qPrintable(quick_->errors().isEmpty() ? QString() : quick_->errors().front().toString()));
  }
  organ_ = root_->property("organ").value<OrganGeometry*>();
  skin_ = root_->property("skin").value<SkinTexture*>();
  wire_ = root_->property("wire").value<WireGeometry*>();
  lattice_ = root_->property("lattice").value<RibbonGeometry*>();
  markers_ = root_->property("markers").value<MarkerGeometry*>();
  ghost_ = root_->property("ghost").value<OrganGeometry*>();
  surroundings_ = root_->property("surroundings").value<SurroundingsTexture*>();
  grasp_ = root_->property("graspBand").value<RibbonGeometry*>();
  connect(quick_->quickWindow(), &QQuickWindow::afterRendering, this, &SceneView::noteFrame,
          Qt::DirectConnection);
}

void SceneView::noteFrame() {
  ++framesDrawn_;
  Q_EMIT frameDrawn();
  const double frame_s = sinceFrame_.isValid() ? static_cast<double>(sinceFrame_.nsecsElapsed()) * 1e-9 : 0.0;
  sinceFrame_.start();
  if (!renderer_.isEmpty()) {
    if (quality_ == RenderQuality::kAutomatic && control_.note(frame_s)) {
      QMetaObject::invokeMethod(this, &SceneView::applyQuality, Qt::QueuedConnection);
    }
    return;
  }
  if (QOpenGLContext* context = QOpenGLContext::currentContext(); context != nullptr) {
    const GLubyte* name = context->functions()->glGetString(GL_RENDERER);
    renderer_ = name != nullptr ? QString::fromLatin1(reinterpret_cast<const char*>(name)) : tr("unknown");
    control_ = QualityControl(kindOf(renderer_));
    QMetaObject::invokeMethod(this, &SceneView::applyQuality, Qt::QueuedConnection);
  }
}

void SceneView::redraw() {
  if (quick_ != nullptr) {
    quick_->quickWindow()->update();
  }
}

void SceneView::setRootProperty(const char* name, const QVariant& value) {
  if (root_ != nullptr) {
    root_->setProperty(name, value);
  }
}

void SceneView::setScene(const ViewScene& view) {
  view_ = view;
  deformed_m_.assign(view_.surface.vertices().size(), Vec3{});
  shown_ = OrganState{};
  shapeShown_ = 0;
  QVector3D low(1e9F, 1e9F, 1e9F);
  QVector3D high = -low;
  for (const SurfaceVertex& v : view_.surface.vertices()) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v.position[k]);
      high[k] = std::max(high[k], v.position[k]);
    }
  }
  organCentre_ = 0.5F * (low + high);
  organRadius_ = 0.5F * (high - low).length();
  showSurroundings(low.z());
  if (root_ != nullptr) {
    if (view_.skin) {
      skin_->setSkin(*view_.skin);
    }
    organ_->setSurface(view_.surface, view_.skin.get());
    wire_->setSurface(view_.surface);
    lattice_->setLines(view_.lines.lattice, kLatticeWidth * organRadius_, view_.surface);
    grasp_->setLines(view_.lines.grasp, kGraspWidth * organRadius_, view_.surface,
                     RibbonGeometry::Shape::kStanding);
  }
  setGhost(std::nullopt);
  setForce({}, {});
  legend_->setTop(view_.shear.top_Pa());
  shearShare_.assign(view_.surface.vertices().size(), 0.0F);
  colours_.resize(view_.surface.vertices().size());
  dented_ = false;
  showLook(view_.look);
  setShearVisible(shearVisible_);
  setMarkersVisible(markersVisible_);
  frameOrgan();
}

void SceneView::showSurroundings(float back_mm) {
  constexpr float kBehind = 0.12F;  // radii: nothing that is twisted reaches it
  setRootProperty("surroundingsPosition",
                  QVector3D(organCentre_.x(), organCentre_.y(), back_mm - kBehind * organRadius_));
  setRootProperty("surroundingsSize", 2.0F * kSurroundingsReach * organRadius_);
  paintSurroundings();
}

void SceneView::paintSurroundings() {
  if (surroundings_ != nullptr && !view_.surface.vertices().empty()) {
    surroundings_->setPicture(gui::paintSurroundings(view_.surroundings, theme(themeKind_), view_.surface,
                                                     organCentre_, organRadius_));
  }
}

void SceneView::forgetScene() {
  view_ = {};
  deformed_m_ = {};
  shown_.reset();
}

void SceneView::showLook(const TissueLook& look) {
  setRootProperty("tissueRoughness", look.roughness);
  setRootProperty("filmAmount", look.clearcoat);
  setRootProperty("filmRoughness", look.filmRoughness);
  setRootProperty("scatter", look.scatter);
  setRootProperty("foldDepth", look.foldDepth);
  setRootProperty("poreDepth", look.poreDepth);
  setRootProperty("relief", QVector3D(look.relief_mm[0], look.relief_mm[1], look.relief_mm[2]));
}

void SceneView::setOrgan(const OrganState& state) {
  if (!view_.deform || !moves(state)) {
    return;
  }
  deformSkin(state);
  dented_ = false;
  showSkin();
}

void SceneView::setTissue(const LiveState& state) {
  if (!view_.deform) {
    return;
  }
  const OrganState organ = organStateOf(state);
  const bool touched = state.patches[0].depth_m > 0.0 || state.patches[1].depth_m > 0.0;
  if (touched || dented_ || moves(organ)) {
    deformSkin(organ);
    dented_ = indentSurface(state, deformed_m_);
    showSkin();
  }
  setForce(state.tool.position_m, state.response.force_N);
}

bool SceneView::moves(const OrganState& state) const {
  const bool otherShape = view_.shapeNumber && view_.shapeNumber() != shapeShown_;
  return !shown_.has_value() || *shown_ != state || otherShape;
}

void SceneView::deformSkin(const OrganState& state) {
  shown_ = state;
  shapeShown_ = view_.shapeNumber ? view_.shapeNumber() : 0;
  if (shapeShown_ > 0) {
    view_.shape(deformed_m_);
  } else {
    view_.deform(state, deformed_m_);
  }
}

void SceneView::paintSkin() {
  if (shearVisible_ && !view_.shear.empty()) {
    view_.shear.evaluate(*shown_, shearShare_);
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      colours_[i] = shearColour(shearShare_[i]);
      const float form = formShade(view_.surface.vertices()[i].normal);
      for (float& channel : colours_[i]) {
        channel *= form;
      }
    }
    view_.surface.paint(colours_);
  } else if (!view_.blood.empty()) {
    view_.blood.evaluate(*shown_, colours_);
    view_.surface.paint(colours_);
  }
}

void SceneView::showSkin() {
  view_.surface.update(deformed_m_);
  paintSkin();
  if (root_ == nullptr) {
    return;
  }
  organ_->updateVertices(view_.surface);
  grasp_->follow(view_.surface);
  if (wireframe_) {
    wire_->updateVertices(view_.surface);
  }
  if (latticeVisible_) {
    lattice_->follow(view_.surface);
  }
  if (markersVisible_) {
    placeMarkers();
  }
}

void SceneView::setForce(const Vec3& at_m, const Vec3& force_N) {
  const double size_N = norm(force_N);
  setRootProperty("forceVisible", size_N > kLeastForce_N);
  if (size_N <= kLeastForce_N) {
    return;
  }
  const QVector3D along = toViewDirection(force_N).normalized();
  setRootProperty("forcePosition", toView(at_m));
  setRootProperty("forceRotation", QQuaternion::rotationTo({0.0F, 1.0F, 0.0F}, along));
  const double share = std::min(size_N / kLongestArrow_N, 1.0);
  setRootProperty("forceLength", organRadius_ * (kShortestArrow + (kLongestArrow - kShortestArrow) * share));
  setRootProperty("forceThickness", organRadius_ * kArrowThickness);
}

void SceneView::setShearVisible(bool visible) {
  const bool possible = !view_.shear.empty();
  shearVisible_ = visible;
  legend_->setVisible(visible && possible);
  placeLegend();
  if (view_.surface.vertices().empty() || !possible) {
    return;
  }
  if (!visible) {
    view_.surface.paint({});
  }
  setRootProperty("stressVisible", visible);
  if (!shown_.has_value()) {
    shown_ = OrganState{};
  }
  if (visible || !view_.blood.empty()) {
    view_.deform(*shown_, deformed_m_);
    showSkin();
  } else if (organ_ != nullptr) {
    organ_->updateVertices(view_.surface);
  }
}

void SceneView::setMarkersVisible(bool visible) {
  markersVisible_ = visible;
  setRootProperty("markersVisible", visible && !view_.markers.empty());
  if (visible && root_ != nullptr && !view_.surface.vertices().empty()) {
    placeMarkers();
  }
}

void SceneView::setMarkers(std::vector<SkinAnchor> markers) {
  view_.markers = std::move(markers);
  setMarkersVisible(markersVisible_);
}

void SceneView::placeMarkers() {
  std::vector<QVector3D> places;
  for (const SkinAnchor& marker : view_.markers) {
    places.push_back(markerPlace(marker, view_.surface));
  }
  markers_->setMarkers(places, kMarkerRadius * organRadius_);
}

void SceneView::setGhost(const std::optional<OrganState>& state) {
  setRootProperty("ghostVisible", state.has_value());
  if (!state || root_ == nullptr || !view_.deform) {
    return;
  }
  OrganSurface ghost = view_.surface;
  std::vector<Vec3> vertices_m(ghost.vertices().size());
  view_.deform(*state, vertices_m);
  ghost.update(vertices_m);
  ghost.sink(kGhostDepth_mm);  // what the twist does not move would be seen half as ghost, half as tissue
  ghost.paint(std::vector<std::array<float, 3>>(ghost.vertices().size(), {1.0F, 1.0F, 1.0F}));  // one colour
  ghost_->setSurface(ghost);
}

void SceneView::placeLegend() {
  legend_->resize(legend_->sizeHint());
  legend_->move(2 * kSpace, height() - legend_->height() - 2 * kSpace);
}

void SceneView::setInstrument(const InstrumentParts& parts) {
  jawOpening_deg_ = parts.jawOpening_deg;
  setRootProperty("jawPivot", parts.jawPivot_mm);
  if (root_ == nullptr) {
    return;
  }
  root_->property("shaft").value<InstrumentGeometry*>()->setMesh(parts.shaft);
  root_->property("upperJaw").value<InstrumentGeometry*>()->setMesh(parts.upperJaw);
  root_->property("lowerJaw").value<InstrumentGeometry*>()->setMesh(parts.lowerJaw);
}

void SceneView::setTool(const Pose& pose, double grip) {
  setRootProperty("toolPosition", toView(pose.position_m));
  setRootProperty("toolRotation", toolToView(pose.orientation));
  const double open = 1.0 - std::clamp(grip, 0.0, 1.0);
  setRootProperty("jawAngle", kJawHolding_deg + (jawOpening_deg_ - kJawHolding_deg) * open);
}

void SceneView::setToolVisible(bool visible) {
  setRootProperty("toolVisible", visible);
}

void SceneView::setWireframe(bool visible) {
  wireframe_ = visible;
  if (wire_ != nullptr && visible && !view_.surface.vertices().empty()) {
    wire_->updateVertices(view_.surface);
  }
  setRootProperty("wireVisible", visible);
}

void SceneView::setLattice(bool visible) {
  latticeVisible_ = visible;
  if (lattice_ != nullptr && visible && !view_.surface.vertices().empty()) {
    lattice_->follow(view_.surface);
  }
  setRootProperty("latticeVisible", visible);
}

void SceneView::setQuality(RenderQuality quality) {
  quality_ = quality;
  applyQuality();
}

void SceneView::applyQuality() {
  setRootProperty("fine", quality_ == RenderQuality::kFine || (quality_ == RenderQuality::kAutomatic &&
                                                               !renderer_.isEmpty() && control_.fine()));
}

void SceneView::setTheme(const Theme& theme) {
  setRootProperty("backdropTop", theme.backdropTop);
  setRootProperty("backdropBottom", theme.backdropBottom);
  setRootProperty("latticeColour", theme.lattice);
  setRootProperty("wireColour", theme.wire);
  setRootProperty("graspColour", theme.grasp);
  setRootProperty("shaftColour", theme.shaft);
  setRootProperty("forceColour", theme.caution);
  setRootProperty("markerColour", theme.accent);
  setRootProperty("ghostColour", theme.grasp);
  legend_->setTheme(theme);
  if (std::exchange(themeKind_, theme.kind) != theme.kind) {
    paintSurroundings();
  }
}

void SceneView::applyCamera() {
  setRootProperty("cameraFieldOfView", OrbitCamera::kFieldOfView_deg);
  setRootProperty("cameraPosition", camera_.position());
  setRootProperty("cameraRotation", camera_.rotation());
  setRootProperty("cameraNear", std::max(1.0F, camera_.distance() - 4.0F * organRadius_));
  setRootProperty("cameraFar", camera_.distance() + 8.0F * organRadius_);
  Q_EMIT cameraChanged();
}

void SceneView::frameOrgan() {
  camera_.frame(organCentre_, organRadius_, QSizeF(size()));
  applyCamera();
}

QImage SceneView::picture() {
  return quick_ != nullptr ? quick_->grabFramebuffer() : QImage();
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeLegend();
  applyCamera();
}

}  // namespace torsio::gui
