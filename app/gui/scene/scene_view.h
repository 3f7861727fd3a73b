// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <QColor>
#include <QElapsedTimer>
#include <QImage>
#include <QWidget>

#include "app/gui/scene/blood_map.h"
#include "app/gui/scene/lattice_overlay.h"
#include "app/gui/scene/markers.h"
#include "app/gui/scene/orbit_camera.h"
#include "app/gui/scene/organ_surface.h"
#include "app/gui/scene/quality_control.h"
#include "app/gui/scene/shear_map.h"
#include "app/gui/scene/surroundings.h"
#include "app/gui/scene/tissue_look.h"
#include "app/gui/scene/tissue_skin.h"
#include "app/gui/widgets/theme.h"
#include "sim/base/live_types.h"
#include "sim/base/pose.h"
#include "sim/scene/organ_state.h"

class QQuickItem;
class QQuickWidget;

namespace torsio::gui {

class OrganGeometry;
class SkinTexture;
class StressLegend;
class WireGeometry;
struct InstrumentParts;
struct Theme;

/// What the view draws for one organ; made once beside the loading.
struct ViewScene {
  OrganSurface surface;
  std::shared_ptr<const TissueSkin> skin;  ///< null where no scene can be drawn
  LatticeLines lines;
  TissueLook look;
  Surroundings surroundings = Surroundings::kDrape;
  ShearMap shear;                   ///< empty: no map can be shown
  BloodMap blood;                   ///< empty: the tissue keeps its colour
  std::vector<SkinAnchor> markers;  ///< empty: the organ has none
  /// The vertices for a state of twist, one a vertex of the surface, metres. GUI thread.
  std::function<void(const OrganState&, std::span<Vec3>)> deform;
  /// Where a model beside the servo answers: the number of its newest shape, 0 before the first, and the
  /// vertices of that shape. GUI thread. Empty: `deform` tells all.
  std::function<std::int64_t()> shapeNumber;
  std::function<void(std::span<Vec3>)> shape;
};

/// Surface, overlay lines and colours of a scene. Slow (fractions of a second); asks scene->collision, so
/// call it before the servo runs.
/// `tissue`: name by which the look is chosen, empty: the scene's id.
[[nodiscard]] ViewScene makeViewScene(const std::shared_ptr<const Scene>& scene,
                                      const std::string& tissue = {});

enum class RenderQuality {
  kAutomatic,  ///< by frame time: fine as long as it stays smooth; a software renderer stays fast
  kFast,
  kFine,  ///< antialiasing, shadow, ambient occlusion
};

/// The living picture of organ and instrument. On a platform without OpenGL ("offscreen") it shows a sentence
/// instead, so that everything round it can be built and tested anywhere.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// Before the application object exists: OpenGL, shared by all windows. A view that is put into another
  /// window loses its scene graph otherwise.
  static void prepareGraphics();
  /// Names the scene's own types to QML; the constructor does it where the scene can be drawn.
  static void registerTypes();
  /// Gives a window, before it is first shown, the kind of surface that scenes are drawn on. Without it the
  /// first scene that appears in it makes the window anew: it flickers, and the keyboard is lost.
  static void prepareWindow(QWidget& window);
  /// False on platforms that cannot draw the scene.
  [[nodiscard]] static bool platformCanRender();

  void setScene(const ViewScene& view);
  /// Lets go of the scene, so that two are never in memory; what is drawn stays until the next one.
  void forgetScene();
  void setInstrument(const InstrumentParts& parts);
  /// Moves the skin; does nothing when the state is the shown one.
  void setOrgan(const OrganState& state);
  /// Moves the skin, with the dents under the instrument and the force that the tissue answers with.
  void setTissue(const LiveState& state);
  /// An arrow at a world point along the force on the tool; nothing below what a hand feels.
  void setForce(const Vec3& at_m, const Vec3& force_N);
  /// Colours the skin by shear stress, with a legend.
  void setShearVisible(bool visible);
  [[nodiscard]] bool shearVisible() const noexcept { return shearVisible_; }
  void setMarkersVisible(bool visible);
  /// Other markers than the scene came with.
  void setMarkers(std::vector<SkinAnchor> markers);
  /// A translucent organ at the pose to reach; nothing: none.
  void setGhost(const std::optional<OrganState>& state);
  /// `grip`: 0 open .. 1 closed.
  void setTool(const Pose& pose, double grip);
  void setToolVisible(bool visible);
  void setWireframe(bool visible);
  void setLattice(bool visible);
  void setQuality(RenderQuality quality);
  void setTheme(const Theme& theme);

  [[nodiscard]] OrbitCamera& camera() noexcept { return camera_; }
  [[nodiscard]] const OrbitCamera& camera() const noexcept { return camera_; }
  /// Hands a changed camera to the scene graph.
  void applyCamera();
  /// Shows the whole organ from the camera's present direction.
  void frameOrgan();

  /// Draws once more, although nothing changed.
  void redraw();
  /// Whether a redraw() will end in frameDrawn().
  [[nodiscard]] bool draws() const { return quick_ != nullptr && isVisible(); }
  /// Frames drawn so far; the window measures its rate from it.
  [[nodiscard]] std::int64_t framesDrawn() const noexcept { return framesDrawn_; }
  /// Name of the renderer: "llvmpipe ...", empty before the first frame.
  [[nodiscard]] const QString& renderer() const noexcept { return renderer_; }
  /// The picture as it is now, in device pixels; null without a renderer.
  [[nodiscard]] QImage picture();

 Q_SIGNALS:
  void cameraChanged();
  /// A frame is drawn and the window is about to be put together anew: what is to change with the picture and
  /// is marked for painting now costs nothing more, while on a software renderer each putting together takes
  /// as long as a frame. The renderer is still at work: nothing may be shown, hidden or drawn at once.
  void frameDrawn();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void createScene();
  void noteFrame();
  void applyQuality();
  void showSkin();
  /// Tells whether the organ lies otherwise than it is shown.
  [[nodiscard]] bool moves(const OrganState& state) const;
  /// Computes the vertices: of the state, or of the shape that a model beside the servo has delivered.
  void deformSkin(const OrganState& state);
  void paintSkin();
  void showLook(const TissueLook& look);
  /// `back_mm`: farthest point of the organ from the viewer in front of it.
  void showSurroundings(float back_mm);
  void paintSurroundings();
  void placeMarkers();
  void placeLegend();
  void setRootProperty(const char* name, const QVariant& value);

  QQuickWidget* quick_ = nullptr;  // null on a platform without OpenGL
  QQuickItem* root_ = nullptr;
  OrganGeometry* organ_ = nullptr;
  SkinTexture* skin_ = nullptr;
  WireGeometry* wire_ = nullptr;
  RibbonGeometry* lattice_ = nullptr;
  RibbonGeometry* grasp_ = nullptr;
  OrganGeometry* ghost_ = nullptr;
  SurroundingsTexture* surroundings_ = nullptr;
  ThemeKind themeKind_ = ThemeKind::kLight;
  MarkerGeometry* markers_ = nullptr;
  StressLegend* legend_ = nullptr;

  ViewScene view_;
  std::vector<Vec3> deformed_m_;
  std::optional<OrganState> shown_;
  std::int64_t shapeShown_ = 0;  // of ViewScene::shape
  bool dented_ = false;
  bool shearVisible_ = false;
  bool markersVisible_ = false;
  std::vector<float> shearShare_;
  std::vector<std::array<float, 3>> colours_;  // one a vertex
  OrbitCamera camera_;
  QVector3D organCentre_;
  float organRadius_ = 100.0F;
  double jawOpening_deg_ = 20.0;
  bool wireframe_ = false;
  bool latticeVisible_ = false;
  RenderQuality quality_ = RenderQuality::kAutomatic;
  QualityControl control_;
  QElapsedTimer sinceFrame_;
  QString renderer_;
  std::int64_t framesDrawn_ = 0;
};

}  // namespace torsio::gui
