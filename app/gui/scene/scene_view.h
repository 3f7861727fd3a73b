// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
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

/// The live picture of organ and instrument. On a platform without OpenGL ("offscreen") it shows a sentence
/// instead, so that everything around it works and can be tested anywhere. GUI thread.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// Selects OpenGL with contexts shared by all windows; call before the application object exists. Otherwise
  /// a view moved to another window loses its scene graph.
  static void prepareGraphics();
  /// Sets a window's surface type for scenes before it is first shown. Otherwise its first scene recreates
  /// the window, which flickers and loses keyboard focus.
  static void prepareWindow(QWidget& window);
  /// Returns false on platforms that cannot draw scenes.
  [[nodiscard]] static bool platformCanRender();

  void setScene(const ViewScene& view);
  /// Releases the scene, so that there are never two in memory; shows a loading message until the next one.
  void forgetScene();
  void setInstrument(const InstrumentParts& parts);
  /// Moves the skin; no effect if the state is already shown.
  void setOrgan(const OrganState& state);
  /// Moves the skin, with dents under the instrument and the tissue's reaction force.
  void setTissue(const LiveState& state);
  /// Shows an arrow at a world point along the force on the tool; nothing below what a hand feels.
  void setForce(const Vec3& at_m, const Vec3& force_N);
  /// Colours the skin by shear stress, with a legend.
  void setShearVisible(bool visible);
  [[nodiscard]] bool shearVisible() const noexcept { return shearVisible_; }
  void setMarkersVisible(bool visible);
  /// Replaces the scene's markers.
  void setMarkers(std::vector<SkinAnchor> markers);
  /// Shows a translucent organ at the target pose; empty: none.
  void setGhost(const std::optional<OrganState>& state);
  /// `grip`: 0 open .. 1 closed.
  void setTool(const Pose& pose, double grip);
  void setToolVisible(bool visible);
  /// Shows or hides what is behind the organ; it is meant for the front view.
  void setSurroundingsVisible(bool visible);
  void setWireframe(bool visible);
  void setLattice(bool visible);
  void setQuality(RenderQuality quality);
  void setTheme(const Theme& theme);

  [[nodiscard]] OrbitCamera& camera() noexcept { return camera_; }
  [[nodiscard]] const OrbitCamera& camera() const noexcept { return camera_; }
  /// Passes the camera to the scene graph.
  void applyCamera();
  /// Shows the whole organ from the camera's present direction.
  void frameOrgan();

  /// Draws once more without a change.
  void redraw();
  /// Returns whether a redraw() will lead to frameDrawn().
  [[nodiscard]] bool draws() const;
  /// Returns the number of frames drawn, from which the window computes its rate.
  [[nodiscard]] std::int64_t framesDrawn() const noexcept { return canvas_->framesDrawn(); }
  /// Returns the renderer's name: "llvmpipe ..."; empty before the first frame.
  [[nodiscard]] const QString& renderer() const noexcept { return canvas_->renderer(); }
  /// Returns the present picture in device pixels; null without a renderer.
  [[nodiscard]] QImage picture();

 Q_SIGNALS:
  void cameraChanged();
  /// Emitted when a frame has been drawn and the window is about to be composed. Marking widgets for painting
  /// now is free, whereas with a software renderer each extra composition takes as long as a frame. The
  /// renderer is still active: do not show, hide or draw anything synchronously.
  void frameDrawn();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showSkin();
  /// Tells whether a vertex shader deforms the organ now.
  [[nodiscard]] bool onCard() const;
  void showAgain();
  /// Shows a state by the vertex shader; `dents`: under the instrument.
  void showOnCard(const OrganState& state, std::span<const ContactPatch> dents);
  void placeFollowed(std::span<const ContactPatch> dents);
  void coverSkin(const OrganState& state);
  void findFollowed();
  /// Returns whether the state differs from the one shown.
  [[nodiscard]] bool moves(const OrganState& state) const;
  /// Computes the vertices from the state, or from the latest shape of an asynchronous model.
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
  std::int64_t shapeShown_ = 0;  // number of the ViewScene::shape shown
  bool dented_ = false;
  bool shearVisible_ = false;
  bool markersVisible_ = false;
  std::vector<float> shearShare_;
  std::vector<std::array<float, 3>> colours_;  // one per vertex
  // Of an organ that a vertex shader deforms.
  bool byShader_ = false;
  std::vector<std::uint32_t> followed_;  // vertices that something is tied to
  std::vector<std::uint32_t> shading_;   // vertices that cast the shadow
  std::vector<std::array<float, 4>> covers_;
  HollowPose covered_;  // that covers_ shows
  bool coversCurrent_ = false;
  OrbitCamera camera_;
  QVector3D organCentre_;
  float organRadius_ = 100.0F;
  float organBack_ = 0.0F;  // mm: greatest depth, seen from the front
  bool wireframe_ = false;
  bool latticeVisible_ = false;
};

}  // namespace torsio::gui
