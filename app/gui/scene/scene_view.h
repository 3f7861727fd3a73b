// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <QImage>
#include <QString>
#include <QWidget>

#include "app/gui/scene/orbit_camera.h"
#include "app/gui/scene/scene_canvas.h"
#include "app/gui/scene/view_scene.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/live_types.h"
#include "sim/core/pose.h"
#include "sim/scene/organ_state.h"

namespace torsio::gui {

class StressLegend;
struct InstrumentParts;
struct Theme;

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
  /// Gives a window, before it is first shown, the kind of surface that scenes are drawn on. Without it the
  /// first scene that appears in it makes the window anew: it flickers, and the keyboard is lost.
  static void prepareWindow(QWidget& window);
  /// False on platforms that cannot draw the scene.
  [[nodiscard]] static bool platformCanRender();

  void setScene(const ViewScene& view);
  /// Lets go of the scene, so that two are never in memory; until the next one it says that one is loading.
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
  /// What lies behind the organ; seen from the front it means something.
  void setSurroundingsVisible(bool visible);
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
  [[nodiscard]] bool draws() const;
  /// Frames drawn so far; the window measures its rate from it.
  [[nodiscard]] std::int64_t framesDrawn() const noexcept { return canvas_->framesDrawn(); }
  /// Name of the renderer: "llvmpipe ...", empty before the first frame.
  [[nodiscard]] const QString& renderer() const noexcept { return canvas_->renderer(); }
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
  void showSkin();
  /// Tells whether the organ lies otherwise than it is shown.
  [[nodiscard]] bool moves(const OrganState& state) const;
  /// Computes the vertices: of the state, or of the shape that an asynchronous model has delivered.
  void deformSkin(const OrganState& state);
  void paintSkin();
  void showSurroundings();
  void placeMarkers();
  void placeLegend();
  void showWaiting();
  void endWaiting();

  SceneCanvas* canvas_ = nullptr;
  StressLegend* legend_ = nullptr;
  QWidget* waiting_ = nullptr;  // until a scene is drawn
  ThemeKind themeKind_ = ThemeKind::kLight;

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
  float organBack_ = 0.0F;  // mm: the farthest that it reaches from a viewer in front
  bool wireframe_ = false;
  bool latticeVisible_ = false;
};

}  // namespace torsio::gui
