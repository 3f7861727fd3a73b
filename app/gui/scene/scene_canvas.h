// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QString>
#include <QVariant>
#include <QVector3D>

#include "app/gui/scene/mesentery.h"
#include "app/gui/scene/organ_shadow.h"
#include "app/gui/scene/outline.h"
#include "app/gui/scene/quality_control.h"
#include "app/gui/scene/surroundings.h"
#include "app/gui/widgets/theme.h"
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
  kBest,  ///< the same with as much of each as a graphics card can do; never chosen by itself
};

/// The drawing of a scene: the scene graph, its level and its frames. It knows nothing of scenes and states;
/// SceneView hands it what is to be seen. On a platform without OpenGL everything is taken and nothing drawn.
/// GUI thread.
class SceneCanvas : public QObject {
  Q_OBJECT

 public:
  /// The meshes and pictures of scene_view.qml; null on a platform without OpenGL.
  struct Parts {
    OrganGeometry* organ = nullptr;
    SkinTexture* skin = nullptr;
    WireGeometry* wire = nullptr;
    RibbonGeometry* lattice = nullptr;
    RibbonGeometry* grasp = nullptr;
    OrganGeometry* ghost = nullptr;
    MarkerGeometry* markers = nullptr;
    SurroundingsTexture* surroundings = nullptr;
    ShadowTexture* shadow = nullptr;
    MesenteryGeometry* mesentery = nullptr;
    OutlineGeometry* organEdge = nullptr;
    OutlineGeometry* solidEdge = nullptr;
  };

  explicit SceneCanvas(QWidget& parent);

  /// Names the scene's own types to QML; the constructor does it where the scene can be drawn.
  static void registerTypes();
  [[nodiscard]] static bool platformCanRender();

  [[nodiscard]] QQuickWidget* widget() const noexcept { return quick_; }
  [[nodiscard]] bool drawn() const noexcept { return root_ != nullptr; }
  [[nodiscard]] const Parts& parts() const noexcept { return parts_; }
  /// A property of the root of scene_view.qml.
  void set(const char* name, const QVariant& value);

  /// `distant_mm`: how far beside the camera's distance something may stand that is to be seen.
  void setCamera(const OrbitCamera& camera, float distant_mm);
  void setInstrument(const InstrumentParts& parts);
  /// `grip`: 0 open .. 1 closed.
  void setTool(const Pose& pose, double grip);
  /// An arrow at a world point along the force on the tool; nothing below what a hand feels. `radius_mm`: of
  /// the organ, by which the arrow is measured.
  void setForce(const Vec3& at_m, const Vec3& force_N, float radius_mm);
  void setLook(const TissueLook& look);
  /// What lies behind an organ at rest that reaches back to `back_mm`.
  void setSurroundings(Surroundings kind, const OrganSurface& organ, const QVector3D& centre_mm,
                       float radius_mm, float back_mm, const Theme& theme);
  /// The mesentery of a loop of bowel at rest; none where the surroundings have none. After
  /// setSurroundings().
  void hangMesentery(const std::vector<MesenteryHold>& holds, const OrganSurface& rest);
  /// The shadow of the organ as it lies now.
  void castShadow(const OrganSurface& organ);
  /// The soft edge of the organ as its vertices were last updated.
  void edgeOrgan(const OrganSurface& organ);
  void setTheme(const Theme& theme);
  void setQuality(RenderQuality quality);

  void redraw();
  [[nodiscard]] std::int64_t framesDrawn() const noexcept { return framesDrawn_; }
  [[nodiscard]] const QString& renderer() const noexcept { return renderer_; }
  [[nodiscard]] QImage picture() const;

 Q_SIGNALS:
  /// As SceneView::frameDrawn().
  void frameDrawn();

 private:
  void readParts();
  void noteFrame();
  void applyQuality();
  void placePort(const QVector3D& tip_mm, const QVector3D& shaft);
  void shapeSolids();
  void edgeSolids();

  /// A rigid thing of the scene graph that gets a soft edge.
  struct Solid {
    QObject* model = nullptr;
    InstrumentGeometry* geometry = nullptr;
  };

  QQuickWidget* quick_ = nullptr;  // null on a platform without OpenGL
  QQuickItem* root_ = nullptr;
  Parts parts_;
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
