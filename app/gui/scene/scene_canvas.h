// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QString>
#include <QVariant>
#include <QVector3D>

#include "app/gui/scene/continuation.h"
#include "app/gui/scene/mesentery.h"
#include "app/gui/scene/organ_shadow.h"
#include "app/gui/scene/outline.h"
#include "app/gui/scene/quality_control.h"
#include "app/gui/scene/surroundings.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/live_types.h"
#include "sim/core/pose.h"

class QQuickItem;
class QQuickWidget;
class QWidget;

namespace torsio {
struct TissueLook;
}

namespace torsio::gui {

class InstrumentGeometry;
class MarkerGeometry;
class NumberTexture;
class OrbitCamera;
class OrganGeometry;
class OrganSurface;
class RibbonGeometry;
class SkinTexture;
class WireGeometry;
struct InstrumentParts;

enum class RenderQuality {
  kAutomatic,  ///< by frame time: fine as long as it stays smooth; a software renderer stays fast
  kFast,
  kFine,  ///< antialiasing, shadow, ambient occlusion
  kBest,  ///< like kFine with the maximum of each; never chosen automatically
};

/// Draws a scene: the scene graph, its quality level and frames. It knows no scenes or states; SceneView
/// tells it what to show. On a platform without OpenGL, it accepts everything and draws nothing. GUI thread.
class SceneCanvas : public QObject {
  Q_OBJECT

 public:
  /// The meshes and textures of scene_view.qml; null on a platform without OpenGL.
  struct Parts {
    OrganGeometry* organ = nullptr;
    NumberTexture* organVertices = nullptr;
    NumberTexture* organNeighbours = nullptr;
    NumberTexture* organRows = nullptr;
    SkinTexture* skin = nullptr;
    WireGeometry* wire = nullptr;
    RibbonGeometry* lattice = nullptr;
    RibbonGeometry* grasp = nullptr;
    OrganGeometry* ghost = nullptr;
    MarkerGeometry* markers = nullptr;
    SurroundingsTexture* surroundings = nullptr;
    ShadowTexture* shadow = nullptr;
    MesenteryGeometry* mesentery = nullptr;
    ContinuationGeometry* continuations = nullptr;
    OutlineGeometry* organEdge = nullptr;
    OutlineGeometry* solidEdge = nullptr;
  };

  explicit SceneCanvas(QWidget& parent);

  /// Registers the scene's types with QML; the constructor does it if scenes can be drawn.
  static void registerTypes();
  [[nodiscard]] static bool platformCanRender();

  [[nodiscard]] QQuickWidget* widget() const noexcept { return quick_; }
  [[nodiscard]] bool drawn() const noexcept { return root_ != nullptr; }
  [[nodiscard]] const Parts& parts() const noexcept { return parts_; }
  /// Sets a property of the root of scene_view.qml.
  void set(const char* name, const QVariant& value);

  /// `distant_mm`: depth shown beyond the camera's target; half of it before the target.
  void setCamera(const OrbitCamera& camera, float distant_mm);
  void setInstrument(const InstrumentParts& parts);
  /// `grip`: 0 open .. 1 closed.
  void setTool(const Pose& pose, double grip);
  /// Shows an arrow at a world point along the force on the tool; nothing below what a hand feels.
  /// `radius_mm`: of the organ, which scales the arrow.
  void setForce(const Vec3& at_m, const Vec3& force_N, float radius_mm);
  void setLook(const TissueLook& look);
  /// Sets what is behind an organ at rest that extends back to `back_mm`.
  void setSurroundings(Surroundings kind, const OrganSurface& organ, const QVector3D& centre_mm,
                       float radius_mm, float back_mm, const Theme& theme);
  /// Shows the mesentery of a loop of bowel at rest, if its surroundings have one. Call after
  /// setSurroundings().
  void hangMesentery(const std::vector<MesenteryHold>& holds, const OrganSurface& rest);
  /// Joins the open ends of the organ to what is painted behind it. Call after setSurroundings().
  void joinContinuations(const std::vector<Continuation>& ends, const OrganSurface& rest);
  /// Updates the shadow to the organ's present shape.
  void castShadow(const OrganSurface& organ, std::span<const std::uint32_t> of = {});
  /// Updates the soft edge after the organ's vertices.
  void edgeOrgan(const OrganSurface& organ);
  void setTheme(const Theme& theme);
  void setQuality(RenderQuality quality);
  /// Tells whether a vertex shader should deform the organ: at the fine level on a graphics card, or as the
  /// environment variable TORSIO_DEFORM says ("card": always at that level, "processor": never).
  [[nodiscard]] bool prefersShader() const noexcept { return prefersShader_; }
  /// Shows the organ as a vertex shader deforms it, with up to two dents, or as its vertices are.
  void setDeformedByShader(bool deformed);
  void setDents(std::span<const ContactPatch> dents);

  void redraw();
  [[nodiscard]] std::int64_t framesDrawn() const noexcept { return framesDrawn_; }
  [[nodiscard]] const QString& renderer() const noexcept { return renderer_; }
  [[nodiscard]] QImage picture() const;

 Q_SIGNALS:
  /// See SceneView::frameDrawn().
  void frameDrawn();
  /// Emitted when prefersShader() has changed.
  void shaderPreferred();

 private:
  void readParts();
  void noteFrame();
  void applyQuality();
  void placePort(const QVector3D& tip_mm, const QVector3D& shaft);
  void shapeSolids();
  void edgeSolids();

  /// A rigid node of the scene graph with a soft edge.
  struct Solid {
    QObject* model = nullptr;
    InstrumentGeometry* geometry = nullptr;
  };

  QQuickWidget* quick_ = nullptr;  // null on a platform without OpenGL
  QQuickItem* root_ = nullptr;
  Parts parts_;
  bool prefersShader_ = false;
  std::vector<Solid> solids_;
  std::vector<EdgeVertex> quads_;
  Eye eye_;
  double jawOpening_deg_ = 20.0;
  float shaftLength_mm_ = 250.0F;
  bool hasHand_ = false;
  Surroundings surroundings_ = Surroundings::kDrape;
  QVector3D centre_mm_;
  float radius_mm_ = 0.0F;
  float ground_mm_ = 0.0F;
  OrganShadow shadow_;
  RenderQuality quality_ = RenderQuality::kAutomatic;
  QualityControl control_;
  QElapsedTimer sinceFrame_;
  QString renderer_;
  std::int64_t framesDrawn_ = 0;
};

}  // namespace torsio::gui
