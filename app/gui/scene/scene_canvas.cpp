// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/scene_canvas.h"

#include <algorithm>
#include <cmath>

#include <QGuiApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QQmlEngine>
#include <QQuickItem>
#include <QQuickWidget>
#include <QQuickWindow>
#include <QUrl>

#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/lattice_overlay.h"
#include "app/gui/scene/markers.h"
#include "app/gui/scene/organ_geometry.h"
#include "app/gui/scene/view_frame.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/scene/tissue_look.h"

/// The linker drops resources of a static library that nothing names.
static void initSceneResources() {
  Q_INIT_RESOURCE(torsio_scene);
  Q_INIT_RESOURCE(torsio_light);
  Q_INIT_RESOURCE(torsio_shaders);
  Q_INIT_RESOURCE(torsio_smooth);
}

namespace torsio::gui {

namespace {

// The arrow of the force, shares of the organ's radius.
constexpr double kShortestArrow = 0.10;
constexpr double kLongestArrow = 0.55;
constexpr float kArrowThickness = 0.011F;
constexpr double kLongestArrow_N = 3.3;  // what the device can give at most: the arrow is full there
constexpr double kLeastForce_N = 0.02;   // below the friction of the device nobody feels it
constexpr double kJawHolding_deg = 3.0;  // each jaw, closed on tissue

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

/// Of each jaw. A mouse button closes to what holds tissue, a hand may close on to nothing between the jaws.
double shownJaw_deg(double grip, double opening_deg) {
  const double closed = std::clamp(grip, 0.0, 1.0);
  const double open = std::max(0.0, 1.0 - closed / kPointerClosure);
  const double pressed = std::max(0.0, (closed - kPointerClosure) / (1.0 - kPointerClosure));
  return open * opening_deg + (1.0 - open) * kJawHolding_deg * (1.0 - pressed);
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
  connect(quick_->quickWindow(), &QQuickWindow::afterRendering, this, &SceneCanvas::noteFrame,
          Qt::DirectConnection);
}

void SceneCanvas::readParts() {
  parts_.organ = root_->property("organ").value<OrganGeometry*>();
  parts_.skin = root_->property("skin").value<SkinTexture*>();
  parts_.wire = root_->property("wire").value<WireGeometry*>();
  parts_.lattice = root_->property("lattice").value<RibbonGeometry*>();
  parts_.grasp = root_->property("graspBand").value<RibbonGeometry*>();
  parts_.ghost = root_->property("ghost").value<OrganGeometry*>();
  parts_.markers = root_->property("markers").value<MarkerGeometry*>();
  parts_.surroundings = root_->property("surroundings").value<SurroundingsTexture*>();
  parts_.shadow = root_->property("shadow").value<ShadowTexture*>();
}

void SceneCanvas::registerTypes() {
  static const bool kOnce = [] {
    initSceneResources();
    qmlRegisterType<OrganGeometry>("Torsio.Scene", 1, 0, "OrganGeometry");
    qmlRegisterType<SkinTexture>("Torsio.Scene", 1, 0, "SkinTexture");
    qmlRegisterType<SurroundingsTexture>("Torsio.Scene", 1, 0, "SurroundingsTexture");
    qmlRegisterType<ShadowTexture>("Torsio.Scene", 1, 0, "ShadowTexture");
    qmlRegisterType<WireGeometry>("Torsio.Scene", 1, 0, "WireGeometry");
    qmlRegisterType<RibbonGeometry>("Torsio.Scene", 1, 0, "RibbonGeometry");
    qmlRegisterType<MarkerGeometry>("Torsio.Scene", 1, 0, "MarkerGeometry");
    qmlRegisterType<InstrumentGeometry>("Torsio.Scene", 1, 0, "InstrumentGeometry");
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
  set("handVisible", hasHand_ && !throughPort(surroundings_));
  set("jawPivot", parts.jawPivot_mm);
  if (root_ == nullptr) {
    return;
  }
  root_->property("shaft").value<InstrumentGeometry*>()->setMesh(parts.shaft);
  root_->property("upperJaw").value<InstrumentGeometry*>()->setMesh(parts.upperJaw);
  root_->property("lowerJaw").value<InstrumentGeometry*>()->setMesh(parts.lowerJaw);
  if (hasHand_) {
    root_->property("hand").value<InstrumentGeometry*>()->setMesh(parts.hand);
  }
}

void SceneCanvas::setTool(const Pose& pose, double grip) {
  const QVector3D tip_mm = toView(pose.position_m);
  const QQuaternion turn = toolToView(pose.orientation);
  set("toolPosition", tip_mm);
  set("toolRotation", turn);
  set("jawAngle", shownJaw_deg(grip, jawOpening_deg_));
  placePort(tip_mm, turn.rotatedVector({0.0F, 0.0F, 1.0F}));
}

void SceneCanvas::placePort(const QVector3D& tip_mm, const QVector3D& shaft) {
  // The wall of the abdomen stands like a dome over the organ: the port is where the shaft goes through it.
  constexpr float kDome = 1.12F;       // radii
  constexpr float kSleeve_mm = 50.0F;  // nearer to the tip it would hide the jaws
  const QVector3D from = tip_mm - centre_mm_;
  const float along = QVector3D::dotProduct(from, shaft);
  const float reach = kDome * radius_mm_;
  const float square = along * along - from.lengthSquared() + reach * reach;
  const float at = square > 0.0F ? std::sqrt(square) - along : -1.0F;
  set("portVisible", throughPort(surroundings_) && at > kSleeve_mm && at < shaftLength_mm_);
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
  set("forceRotation", QQuaternion::rotationTo({0.0F, 1.0F, 0.0F}, along));
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

void SceneCanvas::setSurroundings(Surroundings kind, const QVector3D& centre_mm, float radius_mm,
                                  float back_mm, const Theme& theme) {
  constexpr float kBehind = 0.12F;  // radii: nothing that is twisted reaches it
  const float ground_mm = back_mm - kBehind * radius_mm;
  surroundings_ = kind;
  centre_mm_ = centre_mm;
  radius_mm_ = radius_mm;
  shadow_ = OrganShadow(centre_mm, radius_mm, ground_mm);
  set("surroundingsPosition", QVector3D(centre_mm.x(), centre_mm.y(), ground_mm));
  set("surroundingsSize", 2.0F * kSurroundingsReach * radius_mm);
  set("shadowShare", kSurroundingsReach / kShadowReach);
  set("handVisible", hasHand_ && !throughPort(kind));
  if (parts_.surroundings != nullptr) {
    parts_.surroundings->setPicture(paintSurroundings(kind, theme));
  }
}

void SceneCanvas::castShadow(const OrganSurface& organ) {
  if (parts_.shadow != nullptr) {
    parts_.shadow->setShade(shadow_.cast(organ));
  }
}

void SceneCanvas::setTheme(const Theme& theme) {
  set("backdrop", theme.backdropBottom);
  set("gloveColour", theme.kind == ThemeKind::kDark ? QColor(0x6E, 0x93, 0xB4) : QColor(0x9C, 0xBE, 0xDA));
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
}

QImage SceneCanvas::picture() const {
  return quick_ != nullptr ? quick_->grabFramebuffer() : QImage();
}

}  // namespace torsio::gui
