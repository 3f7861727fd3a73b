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

/// Turns mouse and keys over the scene view into what the pointer device understands, and into camera moves.
/// The instrument's tip stays under the mouse: depth moves along the line of sight.
///
/// | what            | mouse                      | keys                  |
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
/// These are the usual keys; PointerKeys may put them elsewhere.
class PointerControls : public QObject {
  Q_OBJECT

 public:
  /// Of what is turned without end.
  static constexpr double kNoEnd_rad = std::numeric_limits<double>::infinity();

  explicit PointerControls(SceneView& view);

  void setKeys(const PointerKeys& keys);
  /// Puts the tip to a point in front of the organ with the jaw open, as seen from the camera.
  void park(const Vec3& tip_m);
  /// What the jaw holds: the unit axis about which a turn twists it, or nothing; and how far a hand turns it
  /// in one grip, rad, there and back together. Told once a frame.
  void setHeldAxis(const std::optional<Vec3>& axis, double reach_rad = kNoEnd_rad);
  /// The surface that the free tip is near to, or nothing: the shaft leans away from it, so that it does not
  /// lie across the tissue when the jaw closes. Told once a frame. Tilting by hand ends it until parked
  /// again.
  void leanAwayFrom(const std::optional<Vec3>& normal) { leanTo_ = normal; }
  /// Where the tissue holds the pressed tip: the wheel gathers no depth behind it that would have to be
  /// turned back before the tip follows. Told once a frame in which it presses.
  void holdAt(const Vec3& tip_m);
  /// Moves what held keys move; called once a frame. `elapsed_s`: since the last call.
  void advance(double elapsed_s);
  /// The newest wish.
  [[nodiscard]] const PointerInput& input() const noexcept { return input_; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void changed();
  /// The jaw opened because the keyboard went elsewhere.
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
  /// How far a drag turns what is held: along the way on which the near side of the tissue moves.
  [[nodiscard]] double turnOf(const QPointF& drag) const;
  void setGrip(bool closed);
  void publish();

  SceneView& view_;
  PointerKeys keys_;
  PointerInput input_;
  QPointF lastMouse_;
  bool mouseKnown_ = false;
  std::set<int> held_;       // keys that move something while they are down
  std::set<int> unseen_;     // of these, pressed since the last frame
  std::set<int> tapped_;     // of these, let go again already: they move something in the next frame
  double rollHeld_s_ = 0.0;  // how long a key has turned the tool
  bool gripKept_ = false;
  std::optional<Vec3> heldAxis_;  // world frame
  Quat heldView_;            // the camera when the jaw closed: the device keeps it while the jaw is closed
  Quat gripped_;             // orientation of the tool when the tissue was gripped
  double turned_rad_ = 0.0;  // since then, about the axis
  double leastTurned_rad_ = 0.0;
  double mostTurned_rad_ = 0.0;
  double reach_rad_ = kNoEnd_rad;
  std::optional<Vec3> leanTo_;  // outwards from the surface nearby, world frame
  bool tiltedByHand_ = false;
  bool rolledByHand_ = false;
};

}  // namespace torsio::gui
