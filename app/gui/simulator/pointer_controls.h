// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <set>

#include <QObject>
#include <QPointF>

#include "app/gui/simulator/pointer_keys.h"
#include "sim/core/pose.h"
#include "sim/device/virtual/pointer_device.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace torsio::gui {

class SceneView;

/// Converts mouse and keys over the scene view into input of the pointer device and moves of the camera.
/// The instrument's tip stays under the mouse: depth moves along the line of sight.
///
/// | action          | mouse                      | keys                  |
/// |-----------------|----------------------------|-----------------------|
/// | move in picture | move                       | arrows                |
/// | depth           | wheel                      | Page Up, Page Down    |
/// | grip            | left button                | Space (hold), G (keep)|
/// | twist, held     | left drag, Shift + wheel   | Q, E                  |
/// | roll, free      | Shift + move or wheel      | Q, E                  |
/// | tilt            |                            | A, D, W, S            |
/// | orbit           | right drag                 | Ctrl + arrows         |
/// | move the view   | middle drag                |                       |
/// | zoom            | Ctrl + wheel               | + and -               |
///
/// These are the default keys; PointerKeys may change them. GUI thread.
class PointerControls : public QObject {
  Q_OBJECT

 public:
  /// Value for a turn without limit.
  static constexpr double kNoEnd_rad = std::numeric_limits<double>::infinity();

  explicit PointerControls(SceneView& view);

  void setKeys(const PointerKeys& keys);
  /// Moves the tip to a point in front of the organ with the jaw open, as seen from the camera.
  void park(const Vec3& tip_m);
  /// Sets what the jaw holds, once per frame: the unit axis about which a turn twists it, or empty;
  /// `reach_rad`: range of the hand in one grip, in total, rad.
  void setHeldAxis(const std::optional<Vec3>& axis, double reach_rad = kNoEnd_rad);
  /// Sets the normal of the surface near the free tip, or empty, once per frame: the shaft leans away from
  /// it, so that it does not lie across the tissue when the jaw closes. Manual tilting disables it until
  /// parked again.
  void leanAwayFrom(const std::optional<Vec3>& normal) { leanTo_ = normal; }
  /// Sets where the tissue holds the pressed tip, in each frame in which it presses: limits the wheel's depth
  /// behind it, which would have to be wound back before the tip follows.
  void holdAt(const Vec3& tip_m);
  /// Applies the keys held; call once per frame. `elapsed_s`: since the last call.
  void advance(double elapsed_s);
  /// Returns the latest input.
  [[nodiscard]] const PointerInput& input() const noexcept { return input_; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void changed();
  /// The jaw opened because of a loss of focus.
  void gripLost();

 private:
  void mouseMoved(const QMouseEvent& event);
  void mousePressed(const QMouseEvent& event);
  void mouseReleased(const QMouseEvent& event);
  void wheelTurned(const QWheelEvent& event);
  bool keyPressed(const QKeyEvent& event);
  bool keyReleased(const QKeyEvent& event);
  void letEverythingGo();
  void moveInPicture(const QPointF& pixels);
  void moveInDepth(double towards_m);
  void turn(double angle_rad);
  void followTurn();
  void settle(double elapsed_s);
  [[nodiscard]] Quat orientation(const Quat& view) const;
  /// Returns how far a drag turns what is held: in the direction in which the near side of the tissue moves.
  [[nodiscard]] double turnOf(const QPointF& drag) const;
  void setGrip(bool closed);
  void publish();

  SceneView& view_;
  PointerKeys keys_;
  PointerInput input_;
  QPointF lastMouse_;
  bool mouseKnown_ = false;
  std::set<int> held_;       // keys held that move something
  std::set<int> unseen_;     // of these, pressed since the last frame
  std::set<int> tapped_;     // of these, already released: they take effect in the next frame
  double rollHeld_s_ = 0.0;  // how long a key has turned the tool
  bool gripKept_ = false;
  std::optional<Vec3> heldAxis_;  // world frame
  Quat heldView_;                 // the camera when the jaw closed, which the device keeps while it is closed
  Quat gripped_;                  // orientation of the tool when it gripped the tissue
  double turned_rad_ = 0.0;       // turn since then about the axis
  double leastTurned_rad_ = 0.0;
  double mostTurned_rad_ = 0.0;
  double reach_rad_ = kNoEnd_rad;
  std::optional<Vec3> leanTo_;  // outward normal of the nearby surface, world frame
  bool tiltedByHand_ = false;
  bool rolledByHand_ = false;
};

}  // namespace torsio::gui
