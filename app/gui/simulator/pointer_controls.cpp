// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/pointer_controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/simulator/tool_pose.h"
#include "sim/core/angle.h"

namespace torsio::gui {

namespace {

constexpr double kKeyPixels_per_s = 140.0;
constexpr double kKeyDepth_m_per_s = 0.05;
constexpr double kKeyRoll_rad_per_s = radians(60.0);
constexpr double kTapShare = 0.25;  // of full speed, so that a tap turns finely
constexpr double kTap_s = 0.15;
constexpr double kFullSpeed_s = 0.5;
constexpr double kShortestTap_s = 0.05;  // assumed time of a key pressed and released between two frames
constexpr double kKeyTilt_rad_per_s = radians(40.0);
constexpr double kKeyOrbit_px_per_s = 220.0;
constexpr double kWheelDepth_m = 0.004;     // one notch
constexpr double kFarthestAhead_m = 0.012;  // ahead of a tip that the tissue holds
constexpr double kWheelRoll_rad = radians(5.0);
constexpr double kDragRoll_rad_per_px = radians(0.5);
constexpr double kSteepestTilt_rad = radians(80.0);
// The stylus comes from the lower right, so that the shaft never hides the tip.
constexpr double kRestYaw_rad = radians(34.0);
constexpr double kRestPitch_rad = radians(38.0);

constexpr double kSettleTime_s = 0.12;  // of the tilt, equal to the tissue's own relaxation
constexpr double kSettled_rad = radians(0.2);
constexpr double kLean = 0.6;    // weight of the surface normal in the direction of the shaft
constexpr float kEndOn = 0.25F;  // looking along the axis: no side of the tissue is nearer

/// Returns the fraction of the full turning speed after a key has been held for this time.
double turningShare(double held_s) {
  return std::clamp(kTapShare + (1.0 - kTapShare) * (held_s - kTap_s) / (kFullSpeed_s - kTap_s), kTapShare,
                    1.0);
}

bool movesWhileHeld(int key) {
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Q:
    case Qt::Key_E:
    case Qt::Key_A:
    case Qt::Key_D:
    case Qt::Key_W:
    case Qt::Key_S:
      return true;
    default:
      return false;
  }
}

}  // namespace

PointerControls::PointerControls(SceneView& view) : QObject(&view), view_(view) {
  input_.yaw_rad = kRestYaw_rad;
  input_.pitch_rad = kRestPitch_rad;
  view_.setMouseTracking(true);
  view_.setFocusPolicy(Qt::StrongFocus);
  view_.installEventFilter(this);
  connect(&view_, &SceneView::cameraChanged, this, &PointerControls::publish);
}

void PointerControls::park(const Vec3& tip_m) {
  input_.present = true;
  input_.onPlane_m = tip_m;
  input_.depth_m = 0.0;
  input_.yaw_rad = kRestYaw_rad;
  input_.pitch_rad = kRestPitch_rad;
  input_.roll_rad = 0.0;
  mouseKnown_ = false;
  tiltedByHand_ = false;
  rolledByHand_ = false;
  letEverythingGo();
}

void PointerControls::letEverythingGo() {
  held_.clear();
  unseen_.clear();
  tapped_.clear();
  gripKept_ = false;
  input_.buttons = 0;
  setGrip(false);
}

void PointerControls::publish() {
  input_.view = cameraToWorld(view_.camera().rotation());
  Q_EMIT changed();
}

void PointerControls::setGrip(bool closed) {
  if (closed && input_.grip == 0.0) {
    heldView_ = cameraToWorld(view_.camera().rotation());
  }
  input_.grip = closed ? 1.0 : 0.0;
  publish();
}

Quat PointerControls::orientation(const Quat& view) const {
  return view * axisAngle({0.0, 1.0, 0.0}, input_.yaw_rad) * axisAngle({1.0, 0.0, 0.0}, input_.pitch_rad) *
         axisAngle({0.0, 0.0, 1.0}, input_.roll_rad);
}

void PointerControls::setHeldAxis(const std::optional<Vec3>& axis, double reach_rad) {
  if (axis.has_value() == heldAxis_.has_value()) {
    return;
  }
  heldAxis_ = axis;
  reach_rad_ = reach_rad;
  turned_rad_ = leastTurned_rad_ = mostTurned_rad_ = 0.0;
  gripped_ = orientation(heldView_);
  if (!axis) {
    rolledByHand_ = false;
    mouseKnown_ = false;  // the mouse has controlled the turn: the tip follows from its new position
  }
}

void PointerControls::followTurn() {
  const Quat wanted = axisAngle(*heldAxis_, turned_rad_) * gripped_;
  const Tilt tilt =
      tiltOf(conjugate(heldView_) * wanted, {input_.yaw_rad, input_.pitch_rad, input_.roll_rad});
  input_.yaw_rad = tilt.yaw_rad;
  input_.pitch_rad = tilt.pitch_rad;
  input_.roll_rad = tilt.roll_rad;
}

void PointerControls::settle(double elapsed_s) {
  if (heldAxis_ || input_.grip > 0.0 || tiltedByHand_) {
    return;
  }
  Vec3 handle{std::sin(kRestYaw_rad) * std::cos(kRestPitch_rad), -std::sin(kRestPitch_rad),
              std::cos(kRestYaw_rad) * std::cos(kRestPitch_rad)};
  if (leanTo_) {
    const Vec3 outwards = rotate(conjugate(cameraToWorld(view_.camera().rotation())), *leanTo_);
    handle = normalized(handle * (1.0 - kLean) + outwards * kLean);
  }
  const Tilt now{input_.yaw_rad, input_.pitch_rad, input_.roll_rad};
  const Tilt goal{std::atan2(handle.x, handle.z), -std::asin(std::clamp(handle.y, -1.0, 1.0)),
                  rolledByHand_ ? now.roll_rad : 0.0};
  if (distance(now, goal) < kSettled_rad) {
    return;
  }
  const double share = 1.0 - std::exp(-elapsed_s / kSettleTime_s);
  input_.yaw_rad += (goal.yaw_rad - now.yaw_rad) * share;
  input_.pitch_rad += (goal.pitch_rad - now.pitch_rad) * share;
  input_.roll_rad += (goal.roll_rad - now.roll_rad) * share;
  publish();
}

double PointerControls::turnOf(const QPointF& drag) const {
  if (!heldAxis_) {
    return drag.x() * kDragRoll_rad_per_px;
  }
  const OrbitCamera& camera = view_.camera();
  const QVector3D axis = toViewDirection(*heldAxis_);
  const QVector3D nearSide = -camera.forward();
  const QVector3D way = QVector3D::crossProduct(axis, nearSide);
  if (way.length() < kEndOn) {
    return QVector3D::dotProduct(axis, nearSide) > 0.0F ? -drag.x() * kDragRoll_rad_per_px
                                                        : drag.x() * kDragRoll_rad_per_px;
  }
  const double right = static_cast<double>(QVector3D::dotProduct(way.normalized(), camera.right()));
  const double up = static_cast<double>(QVector3D::dotProduct(way.normalized(), camera.up()));
  return (drag.x() * right - drag.y() * up) * kDragRoll_rad_per_px;
}

void PointerControls::moveInPicture(const QPointF& pixels) {
  const QSizeF size(view_.size());
  const OrbitCamera& camera = view_.camera();
  const QVector3D tip = toView(input_.onPlane_m);
  const QPointF next = camera.pixel(tip, size) + pixels;
  input_.onPlane_m = fromView(camera.atDepth(next, camera.depth(tip), size));
  publish();
}

void PointerControls::moveInDepth(double towards_m) {
  const QSizeF size(view_.size());
  const OrbitCamera& camera = view_.camera();
  const QVector3D tip = toView(input_.onPlane_m);
  const float nearest = 0.1F * camera.distance();
  const float depth =
      std::max(nearest, camera.depth(tip) + static_cast<float>(towards_m) * kViewUnitsPerMetre);
  input_.onPlane_m = fromView(camera.atDepth(camera.pixel(tip, size), depth, size));
  publish();
}

void PointerControls::holdAt(const Vec3& tip_m) {
  const OrbitCamera& camera = view_.camera();
  const double ahead_m =
      static_cast<double>(camera.depth(toView(input_.onPlane_m)) - camera.depth(toView(tip_m))) /
      static_cast<double>(kViewUnitsPerMetre);
  if (ahead_m > kFarthestAhead_m) {
    moveInDepth(kFarthestAhead_m - ahead_m);
  }
}

void PointerControls::turn(double angle_rad) {
  if (heldAxis_) {
    turned_rad_ =
        std::clamp(turned_rad_ + angle_rad, mostTurned_rad_ - reach_rad_, leastTurned_rad_ + reach_rad_);
    leastTurned_rad_ = std::min(leastTurned_rad_, turned_rad_);
    mostTurned_rad_ = std::max(mostTurned_rad_, turned_rad_);
    followTurn();
  } else {
    rolledByHand_ = true;
    input_.roll_rad += angle_rad;
  }
  publish();
}

void PointerControls::advance(double elapsed_s) {
  settle(elapsed_s);
  if (held_.empty()) {
    return;
  }
  const auto down = [this, elapsed_s](Qt::Key key) {
    const double share = tapped_.contains(key) ? std::min(1.0, kShortestTap_s / elapsed_s) : 1.0;
    return held_.contains(key) ? share : 0.0;
  };
  const QPointF way(down(Qt::Key_Right) - down(Qt::Key_Left), down(Qt::Key_Down) - down(Qt::Key_Up));
  if (!way.isNull()) {
    moveInPicture(way * kKeyPixels_per_s * elapsed_s);
  }
  const double depth = down(Qt::Key_PageUp) - down(Qt::Key_PageDown);
  if (depth != 0.0) {
    moveInDepth(depth * kKeyDepth_m_per_s * elapsed_s);
  }
  const double roll = down(Qt::Key_E) - down(Qt::Key_Q);
  if (roll != 0.0) {
    turn(roll * turningShare(rollHeld_s_) * kKeyRoll_rad_per_s * elapsed_s);
    rollHeld_s_ += elapsed_s;
  }
  const double yaw = down(Qt::Key_D) - down(Qt::Key_A);
  const double pitch = down(Qt::Key_S) - down(Qt::Key_W);
  if ((yaw != 0.0 || pitch != 0.0) && !heldAxis_) {
    const double step = kKeyTilt_rad_per_s * elapsed_s;
    tiltedByHand_ = true;
    input_.yaw_rad = std::clamp(input_.yaw_rad + yaw * step, -kSteepestTilt_rad, kSteepestTilt_rad);
    input_.pitch_rad = std::clamp(input_.pitch_rad + pitch * step, -kSteepestTilt_rad, kSteepestTilt_rad);
    publish();
  }
  unseen_.clear();
  for (const int key : std::exchange(tapped_, {})) {
    held_.erase(key);
  }
}

bool PointerControls::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseMove:
      mouseMoved(static_cast<QMouseEvent&>(*event));
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      mousePressed(static_cast<QMouseEvent&>(*event));
      return true;
    case QEvent::MouseButtonRelease:
      mouseReleased(static_cast<QMouseEvent&>(*event));
      return true;
    case QEvent::Wheel:
      wheelTurned(static_cast<QWheelEvent&>(*event));
      return true;
    case QEvent::KeyPress:
      return keyPressed(static_cast<QKeyEvent&>(*event));
    case QEvent::KeyRelease:
      return keyReleased(static_cast<QKeyEvent&>(*event));
    case QEvent::Leave:
      mouseKnown_ = false;
      return false;
    case QEvent::FocusOut: {
      const bool gripped = input_.grip > 0.0;
      letEverythingGo();
      if (gripped) {
        Q_EMIT gripLost();
      }
      return false;
    }
    default:
      return false;
  }
}

void PointerControls::mouseMoved(const QMouseEvent& event) {
  const QPointF here = event.position();
  const QPointF way = mouseKnown_ ? here - lastMouse_ : QPointF();
  const bool entered = !mouseKnown_;
  lastMouse_ = here;
  mouseKnown_ = true;
  if ((event.buttons() & Qt::RightButton) != 0) {
    view_.camera().orbit(way);
    view_.applyCamera();
  } else if ((event.buttons() & Qt::MiddleButton) != 0) {
    view_.camera().pan(way, view_.height());
    view_.applyCamera();
  } else if (heldAxis_ || (event.modifiers() & Qt::ShiftModifier) != 0) {
    // The tip stays in place: a twisting hand does not pull.
    if (!way.isNull()) {
      turn(turnOf(way));
    }
  } else if (entered && input_.grip == 0.0) {
    // The mouse enters the view: the tip moves under it at its old depth.
    moveInPicture(here - view_.camera().pixel(toView(input_.onPlane_m), QSizeF(view_.size())));
  } else {
    moveInPicture(way);
  }
}

void PointerControls::mousePressed(const QMouseEvent& event) {
  lastMouse_ = event.position();
  mouseKnown_ = true;
  view_.setFocus(Qt::MouseFocusReason);
  if (event.button() == Qt::LeftButton) {
    setGrip(true);
  }
}

void PointerControls::mouseReleased(const QMouseEvent& event) {
  if (event.button() == Qt::LeftButton && !gripKept_) {
    setGrip(false);
  }
}

void PointerControls::wheelTurned(const QWheelEvent& event) {
  // Some systems make the wheel horizontal while Shift is pressed.
  const QPoint angle = event.angleDelta();
  const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
  if ((event.modifiers() & Qt::ControlModifier) != 0) {
    view_.camera().zoom(notches);
    view_.applyCamera();
  } else if ((event.modifiers() & Qt::ShiftModifier) != 0) {
    turn(notches * kWheelRoll_rad);
  } else {
    moveInDepth(notches * kWheelDepth_m);
  }
}

void PointerControls::setKeys(const PointerKeys& keys) {
  letEverythingGo();
  keys_ = keys;
}

bool PointerControls::keyPressed(const QKeyEvent& event) {
  const int key = event.key();
  if ((event.modifiers() & (Qt::AltModifier | Qt::MetaModifier)) != 0) {
    return false;
  }
  if ((event.modifiers() & Qt::ControlModifier) != 0) {
    const double step = 0.05 * kKeyOrbit_px_per_s;
    const QPointF way(key == Qt::Key_Right ? -step : (key == Qt::Key_Left ? step : 0.0),
                      key == Qt::Key_Up ? step : (key == Qt::Key_Down ? -step : 0.0));
    if (way.isNull()) {
      return false;
    }
    view_.camera().orbit(way);
    view_.applyCamera();
    return true;
  }
  const int usual = keys_.usualFor(key);
  if (key == Qt::Key_Plus || key == Qt::Key_Equal || key == Qt::Key_Minus) {
    view_.camera().zoom(key == Qt::Key_Minus ? -1.0 : 1.0);
    view_.applyCamera();
    return true;
  }
  if (movesWhileHeld(usual)) {
    if (!event.isAutoRepeat()) {
      held_.insert(usual);
      unseen_.insert(usual);
      tapped_.erase(usual);
      rollHeld_s_ = usual == Qt::Key_Q || usual == Qt::Key_E ? 0.0 : rollHeld_s_;
    }
    return true;
  }
  if (event.isAutoRepeat()) {
    return usual == Qt::Key_Space || usual == Qt::Key_G || usual == Qt::Key_B;
  }
  if (usual == Qt::Key_Space) {
    setGrip(true);
    return true;
  }
  if (usual == Qt::Key_G) {
    gripKept_ = !gripKept_;
    setGrip(gripKept_);
    return true;
  }
  if (key == Qt::Key_Escape && gripKept_) {
    gripKept_ = false;
    setGrip(false);
    return true;
  }
  if (usual == Qt::Key_B) {
    input_.buttons |= kButtonBookmark;
    publish();
    return true;
  }
  return false;
}

bool PointerControls::keyReleased(const QKeyEvent& event) {
  if (event.isAutoRepeat()) {
    return true;
  }
  const int usual = keys_.usualFor(event.key());
  if (usual == Qt::Key_Space) {
    if (!gripKept_) {
      setGrip(false);
    }
    return true;
  }
  if (usual == Qt::Key_B) {
    input_.buttons &= ~static_cast<std::uint32_t>(kButtonBookmark);
    publish();
    return true;
  }
  if (unseen_.contains(usual)) {
    tapped_.insert(usual);
    return true;
  }
  return held_.erase(usual) > 0;
}

}  // namespace torsio::gui
