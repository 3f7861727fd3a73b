// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/scene_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <QGuiApplication>
#include <QMatrix4x4>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QQmlEngine>
#include <QQuickItem>
#include <QQuickWidget>
#include <QQuickWindow>
#include <QUrl>
#include <QVector4D>

#include "app/gui/scene/drapery.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/orbit_camera.h"
#include "app/gui/scene/organ_geometry.h"
#include "app/gui/scene/skin_overlays.h"
#include "app/gui/scene/view_frame.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/scene/tissue_look.h"

/// Names the resources, which the linker would otherwise drop from a static library.
static void initSceneResources() {
  Q_INIT_RESOURCE(torsio_scene);
  Q_INIT_RESOURCE(torsio_light);
  Q_INIT_RESOURCE(torsio_shaders);
  Q_INIT_RESOURCE(torsio_moved_shaders);
}

namespace torsio::gui {

namespace {

// Lengths of the force arrow, in radii of the organ.
constexpr double kShortestArrow = 0.10;
constexpr double kLongestArrow = 0.55;
constexpr float kArrowThickness = 0.014F;
constexpr double kLongestArrow_N = 3.3;  // maximum force of the device, at which the arrow has full length
constexpr double kLeastForce_N = 0.02;   // below the friction of the device, nobody feels it
constexpr double kJawHolding_deg = 3.0;  // each jaw, closed on tissue

/// Recognises renderers by name: Mesa's, Chrome's, and Windows' with and without a driver.
Renderer kindOf(const QString& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "software rasterizer", "SwiftShader",
                           "Microsoft Basic Render", "GDI Generic"}) {
    if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive)) {
      return Renderer::kSoftware;
    }
  }
  return Renderer::kGraphicsCard;
}

/// Returns the angle of each jaw. A mouse button closes to the tissue held; a hand may close further on
/// nothing.
double shownJaw_deg(double grip, double opening_deg) {
  const double closed = std::clamp(grip, 0.0, 1.0);
  const double open = std::max(0.0, 1.0 - closed / kPointerClosure);
  const double pressed = std::max(0.0, (closed - kPointerClosure) / (1.0 - kPointerClosure));
  return open * opening_deg + (1.0 - open) * kJawHolding_deg * (1.0 - pressed);
}

/// Returns whether a node and all its parents are visible.
bool seen(const QObject* model) {
  for (const QObject* at = model; at != nullptr; at = at->property("parent").value<QObject*>()) {
    const QVariant visible = at->property("visible");
    if (visible.isValid() && !visible.toBool()) {
      return false;
    }
  }
  return true;
}

/// Returns whether the hand points towards the viewer, where it would hide its work.
bool handHidesWork(const QObject& root, const QVector3D& eye) {
  constexpr float kTowardsViewer = 0.7F;  // cosine
  const QVector3D tip = root.property("toolPosition").value<QVector3D>();
  const auto turn = root.property("toolRotation").value<QQuaternion>();
  return QVector3D::dotProduct((eye - tip).normalized(), turn.rotatedVector({0.0F, 0.0F, 1.0F})) >
         kTowardsViewer;
}

// The port, from the inside of the abdomen outwards: radius and position along the shaft, mm.
constexpr std::array<std::array<double, 2>, 14> kPortBody_mm{{{0.0, -30.0},
                                                              {3.4, -30.0},
                                                              {4.2, -26.0},
                                                              {4.2, 12.0},
                                                              {5.0, 17.0},
                                                              {8.6, 23.0},
                                                              {9.6, 25.0},
                                                              {9.6, 28.0},
                                                              {8.2, 29.5},
                                                              {8.2, 38.0},
                                                              {9.2, 39.5},
                                                              {9.2, 43.0},
                                                              {8.0, 44.5},
                                                              {0.0, 44.5}}};
constexpr std::array<std::array<double, 2>, 6> kPortSeal_mm{
    {{0.0, 44.0}, {6.4, 44.0}, {6.4, 46.2}, {5.6, 47.4}, {3.4, 47.8}, {0.0, 47.8}}};
// The force arrow's parts, each of unit length and unit radius.
constexpr std::array<std::array<double, 2>, 4> kStem_mm{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
constexpr std::array<std::array<double, 2>, 3> kHead_mm{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
constexpr int kBodySides = 20;

TriangleMesh ball() {
  constexpr int kRings = 10;
  std::array<std::array<double, 2>, kRings + 1> profile_mm{};
  for (std::size_t i = 0; i <= kRings; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / kRings;
    profile_mm[i] = {std::sin(angle), -std::cos(angle)};
  }
  return turnedBody(profile_mm, kBodySides);
}

}  // namespace

SceneCanvas::SceneCanvas(QWidget& parent) : QObject(&parent) {
  if (!platformCanRender()) {
    return;
  }
  registerTypes();
  quick_ = new QQuickWidget(&parent);
  quick_->setResizeMode(QQuickWidget::SizeRootObjectToView);
  quick_->setFocusPolicy(Qt::NoFocus);
  quick_->setAttribute(Qt::WA_TransparentForMouseEvents);
  quick_->setSource(QUrl(QStringLiteral("qrc:/torsio/scene/scene_view.qml")));
  root_ = quick_->rootObject();
  if (root_ == nullptr) {
    qFatal("scene_view.qml: %s",
           qPrintable(quick_->errors().isEmpty() ? QString() : quick_->errors().front().toString()));
  }
  readParts();
  shapeSolids();
  connect(quick_->quickWindow(), &QQuickWindow::afterRendering, this, &SceneCanvas::noteFrame,
          Qt::DirectConnection);
}

void SceneCanvas::readParts() {
  parts_.organ = root_->property("organ").value<OrganGeometry*>();
  parts_.organVertices = root_->property("organVertices").value<NumberTexture*>();
  parts_.organNeighbours = root_->property("organNeighbours").value<NumberTexture*>();
  parts_.organRows = root_->property("organRows").value<NumberTexture*>();
  parts_.skin = root_->property("skin").value<SkinTexture*>();
  parts_.wire = root_->property("wire").value<WireGeometry*>();
  parts_.lattice = root_->property("lattice").value<RibbonGeometry*>();
  parts_.grasp = root_->property("graspBand").value<RibbonGeometry*>();
  parts_.ghost = root_->property("ghost").value<OrganGeometry*>();
  parts_.markers = root_->property("markers").value<MarkerGeometry*>();
  parts_.surroundings = root_->property("surroundings").value<SurroundingsTexture*>();
  parts_.shadow = root_->property("shadow").value<ShadowTexture*>();
  parts_.mesentery = root_->property("mesentery").value<MesenteryGeometry*>();
  parts_.continuations = root_->property("continuations").value<ContinuationGeometry*>();
  parts_.organEdge = root_->property("organEdge").value<OutlineGeometry*>();
  parts_.solidEdge = root_->property("solidEdge").value<OutlineGeometry*>();
}

void SceneCanvas::shapeSolids() {
  const auto shape = [this](const char* name, const TriangleMesh& mesh) {
    root_->property(name).value<InstrumentGeometry*>()->setMesh(mesh);
  };
  shape("portBody", turnedBody(kPortBody_mm, kBodySides));
  shape("portSeal", turnedBody(kPortSeal_mm, kBodySides));
  shape("arrowStem", turnedBody(kStem_mm, kBodySides));
  shape("arrowHead", turnedBody(kHead_mm, kBodySides));
  shape("arrowFoot", ball());
  for (const QVariant& entry : root_->property("solids").toList()) {
    auto* model = entry.value<QObject*>();
    solids_.push_back({model, model->property("geometry").value<InstrumentGeometry*>()});
  }
}

void SceneCanvas::edgeSolids() {
  if (parts_.solidEdge == nullptr || eye_.pixel_share <= 0.0F) {
    return;
  }
  quads_.clear();
  for (const Solid& solid : solids_) {
    if (solid.geometry != nullptr && seen(solid.model)) {
      solid.geometry->appendSoftEdge(solid.model->property("sceneTransform").value<QMatrix4x4>(),
                                     solid.model->property("colour").value<QColor>(),
                                     solid.model->property("surface").toFloat(), eye_, quads_);
    }
  }
  parts_.solidEdge->setQuads(quads_);
}

void SceneCanvas::edgeOrgan(const OrganSurface& organ) {
  const bool gone = organ.vertices().empty();  // its scene was released
  if (!gone && parts_.organEdge != nullptr && eye_.pixel_share > 0.0F) {
    parts_.organEdge->setQuads(parts_.organ->softEdge(organ, eye_));
  }
}

void SceneCanvas::setCamera(const OrbitCamera& camera, float distant_mm) {
  set("cameraFieldOfView", OrbitCamera::kFieldOfView_deg);
  set("cameraPosition", camera.position());
  set("cameraRotation", camera.rotation());
  set("cameraNear", std::max(1.0F, camera.distance() - 0.5F * distant_mm));
  set("cameraFar", camera.distance() + distant_mm);
  if (quick_ == nullptr || quick_->height() <= 0) {
    return;
  }
  constexpr float kHalf_rad = 0.5F * OrbitCamera::kFieldOfView_deg * std::numbers::pi_v<float> / 180.0F;
  const auto pixels = static_cast<float>(quick_->height() * quick_->devicePixelRatioF());
  eye_ = {camera.position(), 2.0F * std::tan(kHalf_rad) / pixels};
  set("handVisible", hasHand_ && !throughPort(surroundings_) && !handHidesWork(*root_, eye_.position));
  edgeSolids();
}

void SceneCanvas::registerTypes() {
  static const bool kOnce = [] {
    initSceneResources();
    qmlRegisterType<OrganGeometry>("Torsio.Scene", 1, 0, "OrganGeometry");
    qmlRegisterType<NumberTexture>("Torsio.Scene", 1, 0, "NumberTexture");
    qmlRegisterType<SkinTexture>("Torsio.Scene", 1, 0, "SkinTexture");
    qmlRegisterType<SurroundingsTexture>("Torsio.Scene", 1, 0, "SurroundingsTexture");
    qmlRegisterType<ShadowTexture>("Torsio.Scene", 1, 0, "ShadowTexture");
    qmlRegisterType<WireGeometry>("Torsio.Scene", 1, 0, "WireGeometry");
    qmlRegisterType<RibbonGeometry>("Torsio.Scene", 1, 0, "RibbonGeometry");
    qmlRegisterType<MarkerGeometry>("Torsio.Scene", 1, 0, "MarkerGeometry");
    qmlRegisterType<InstrumentGeometry>("Torsio.Scene", 1, 0, "InstrumentGeometry");
    qmlRegisterType<MesenteryGeometry>("Torsio.Scene", 1, 0, "MesenteryGeometry");
    qmlRegisterType<ContinuationGeometry>("Torsio.Scene", 1, 0, "ContinuationGeometry");
    qmlRegisterType<OutlineGeometry>("Torsio.Scene", 1, 0, "OutlineGeometry");
    return true;
  }();
  Q_UNUSED(kOnce)
}

bool SceneCanvas::platformCanRender() {
  const QString platform = QGuiApplication::platformName();
  return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal") &&
         platform != QLatin1String("vnc");
}

void SceneCanvas::noteFrame() {
  ++framesDrawn_;
  Q_EMIT frameDrawn();
  const double frame_s = sinceFrame_.isValid() ? static_cast<double>(sinceFrame_.nsecsElapsed()) * 1e-9 : 0.0;
  sinceFrame_.start();
  if (!renderer_.isEmpty()) {
    if (quality_ == RenderQuality::kAutomatic && control_.note(frame_s)) {
      QMetaObject::invokeMethod(this, &SceneCanvas::applyQuality, Qt::QueuedConnection);
    }
    return;
  }
  if (QOpenGLContext* context = QOpenGLContext::currentContext(); context != nullptr) {
    const GLubyte* name = context->functions()->glGetString(GL_RENDERER);
    renderer_ = name != nullptr ? QString::fromLatin1(reinterpret_cast<const char*>(name)) : tr("unknown");
    control_ = QualityControl(kindOf(renderer_));
    QMetaObject::invokeMethod(this, &SceneCanvas::applyQuality, Qt::QueuedConnection);
  }
}

void SceneCanvas::redraw() {
  if (quick_ != nullptr) {
    quick_->quickWindow()->update();
  }
}

void SceneCanvas::set(const char* name, const QVariant& value) {
  if (root_ != nullptr) {
    root_->setProperty(name, value);
  }
}

void SceneCanvas::setInstrument(const InstrumentParts& parts) {
  jawOpening_deg_ = parts.jawOpening_deg;
  shaftLength_mm_ = static_cast<float>(parts.shaftLength_mm);
  hasHand_ = !parts.hand.triangles.empty();
  set("jawPivot", parts.jawPivot_mm);
  if (root_ == nullptr) {
    return;
  }
  root_->property("shaft").value<InstrumentGeometry*>()->setMesh(parts.shaft);
  root_->property("upperJaw").value<InstrumentGeometry*>()->setMesh(parts.upperJaw);
  root_->property("lowerJaw").value<InstrumentGeometry*>()->setMesh(parts.lowerJaw);
  set("handVisible", hasHand_ && !throughPort(surroundings_));
  if (hasHand_) {
    root_->property("hand").value<InstrumentGeometry*>()->setMesh(parts.hand);
    root_->property("sleeve").value<InstrumentGeometry*>()->setMesh(gownSleeve(parts.hand));
  }
}

void SceneCanvas::setTool(const Pose& pose, double grip) {
  const QVector3D tip_mm = toView(pose.position_m);
  const QQuaternion turn = toolToView(pose.orientation);
  set("toolPosition", tip_mm);
  set("toolRotation", turn);
  set("jawAngle", shownJaw_deg(grip, jawOpening_deg_));
  placePort(tip_mm, turn.rotatedVector({0.0F, 0.0F, 1.0F}));
  set("handVisible",
      hasHand_ && !throughPort(surroundings_) && (root_ == nullptr || !handHidesWork(*root_, eye_.position)));
  edgeSolids();
}

void SceneCanvas::placePort(const QVector3D& tip_mm, const QVector3D& shaft) {
  // The abdominal wall is a dome over the organ: the port is where the shaft passes it.
  constexpr float kDome = 1.2F;        // radii
  constexpr float kSleeve_mm = 60.0F;  // nearer to the tip it would hide the jaws
  const QVector3D from = tip_mm - centre_mm_;
  const float along = QVector3D::dotProduct(from, shaft);
  const float reach = kDome * radius_mm_;
  const float square = along * along - from.lengthSquared() + reach * reach;
  const float dome = square > 0.0F ? std::sqrt(square) - along : 0.0F;
  const float at = std::max(dome, kSleeve_mm);
  set("portVisible", throughPort(surroundings_) && at < shaftLength_mm_);
  set("portAlong", at);
}

void SceneCanvas::setForce(const Vec3& at_m, const Vec3& force_N, float radius_mm) {
  const double size_N = norm(force_N);
  set("forceVisible", size_N > kLeastForce_N);
  if (size_N <= kLeastForce_N) {
    return;
  }
  const QVector3D along = toViewDirection(force_N).normalized();
  set("forcePosition", toView(at_m));
  set("forceRotation", QQuaternion::rotationTo({0.0F, 0.0F, 1.0F}, along));
  const double share = std::min(size_N / kLongestArrow_N, 1.0);
  set("forceLength", radius_mm * (kShortestArrow + (kLongestArrow - kShortestArrow) * share));
  set("forceThickness", radius_mm * kArrowThickness);
}

void SceneCanvas::setLook(const TissueLook& look) {
  set("tissueRoughness", look.roughness);
  set("filmAmount", look.clearcoat);
  set("filmRoughness", look.filmRoughness);
  set("scatter", look.scatter);
  set("foldDepth", look.foldDepth);
  set("poreDepth", look.poreDepth);
  set("paintedRelief", look.paintedRelief_mm);
  set("relief", QVector3D(look.relief_mm[0], look.relief_mm[1], look.relief_mm[2]));
}

void SceneCanvas::setSurroundings(Surroundings kind, const OrganSurface& organ, const QVector3D& centre_mm,
                                  float radius_mm, float back_mm, const Theme& theme) {
  constexpr float kBehind = 0.12F;  // radii: beyond the reach of a twisted organ
  const float ground_mm = back_mm - kBehind * radius_mm;
  ground_mm_ = ground_mm;
  surroundings_ = kind;
  centre_mm_ = centre_mm;
  radius_mm_ = radius_mm;
  shadow_ = OrganShadow(centre_mm, radius_mm, ground_mm);
  set("surroundingsPosition", QVector3D(centre_mm.x(), centre_mm.y(), ground_mm));
  set("surroundingsSize", 2.0F * kSurroundingsReach * radius_mm);
  set("shadowShare", kSurroundingsReach / kShadowReach);
  set("handVisible", hasHand_ && !throughPort(kind));
  const bool draped = kind == Surroundings::kArm;
  set("drapeVisible", draped);
  if (draped && root_ != nullptr) {
    root_->property("drape").value<InstrumentGeometry*>()->setMesh(drapeOverArm(organ, ground_mm));
    edgeSolids();
  }
  if (parts_.surroundings != nullptr) {
    parts_.surroundings->setPicture(paintSurroundings(kind, theme));
    root_->property("mesenteryPaint").value<SurroundingsTexture*>()->setPicture(paintMesentery(theme));
  }
}

void SceneCanvas::hangMesentery(const std::vector<MesenteryHold>& holds, const OrganSurface& rest) {
  const bool closed = surroundings_ == Surroundings::kClosedLoop;
  const bool shown = (closed || surroundings_ == Surroundings::kBowelLoop) && !holds.empty();
  set("mesenteryVisible", shown);
  if (parts_.mesentery == nullptr) {
    return;
  }
  if (shown) {
    parts_.mesentery->hang(holds, mesenteryRoot(holds, rest, radius_mm_, ground_mm_, closed), rest);
  } else {
    parts_.mesentery->hang({}, {}, rest);
  }
}

void SceneCanvas::joinContinuations(const std::vector<Continuation>& ends, const OrganSurface& rest) {
  set("continuationsVisible", !ends.empty());
  if (parts_.continuations != nullptr) {
    parts_.continuations->join(ends, {{centre_mm_.x(), centre_mm_.y(), ground_mm_}, radius_mm_}, rest);
  }
}

void SceneCanvas::castShadow(const OrganSurface& organ, std::span<const std::uint32_t> of) {
  if (parts_.shadow != nullptr) {
    parts_.shadow->setShade(shadow_.cast(organ, of));
  }
}

void SceneCanvas::setTheme(const Theme& theme) {
  if (quick_ != nullptr) {
    quick_->setClearColor(theme.backdrop);  // visible beside the painted square
  }
  set("gloveColour", theme.kind == ThemeKind::kDark ? QColor(0x6E, 0x93, 0xB4) : QColor(0x9C, 0xBE, 0xDA));
  set("gownColour", theme.kind == ThemeKind::kDark ? QColor(0x33, 0x5A, 0x66) : QColor(0x86, 0xAE, 0xB8));
  set("clothColour", clothColour(theme));
  set("neighbourColour", neighbourColour(theme));
  set("latticeColour", theme.lattice);
  set("wireColour", theme.wire);
  set("graspColour", theme.grasp);
  set("shaftColour", theme.shaft);
  set("forceColour", theme.caution);
  set("markerColour", theme.accent);
  set("ghostColour", theme.grasp);
}

void SceneCanvas::setQuality(RenderQuality quality) {
  quality_ = quality;
  applyQuality();
}

void SceneCanvas::applyQuality() {
  const bool chosen = quality_ == RenderQuality::kFine || quality_ == RenderQuality::kBest;
  const bool byItself = quality_ == RenderQuality::kAutomatic && !renderer_.isEmpty() && control_.fine();
  set("best", quality_ == RenderQuality::kBest);
  set("fine", chosen || byItself);
  const QString wanted = qEnvironmentVariable("TORSIO_DEFORM");
  const bool card = !renderer_.isEmpty() && kindOf(renderer_) == Renderer::kGraphicsCard;
  // The best level keeps ambient occlusion, whose pass knows nothing of a material's textures.
  const bool able = (chosen || byItself) && quality_ != RenderQuality::kBest && wanted != u"processor";
  const bool before = std::exchange(prefersShader_, able && (card || wanted == u"card"));
  if (before != prefersShader_) {
    Q_EMIT shaderPreferred();
  }
}

void SceneCanvas::setDeformedByShader(bool deformed) {
  set("deformedByShader", deformed);
}

void SceneCanvas::setDents(std::span<const ContactPatch> dents) {
  static constexpr std::array kNames{std::array{"dentPlace0", "dentDepth0"},
                                     std::array{"dentPlace1", "dentDepth1"}};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const ContactPatch patch = i < dents.size() && dents[i].depth_m > 0.0 ? dents[i] : ContactPatch{};
    const auto four = [](const Vec3& v, double w) {
      return QVector4D(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
                       static_cast<float>(w));
    };
    set(kNames[i][0], four(patch.point_m, patch.radius_m));
    set(kNames[i][1], four(-patch.depth_m * patch.normal, patch.toolRadius_m));
  }
}

QImage SceneCanvas::picture() const {
  return quick_ != nullptr ? quick_->grabFramebuffer() : QImage();
}

}  // namespace torsio::gui
