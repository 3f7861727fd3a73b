// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

class QApplication;

namespace torsio::gui {

enum class ThemeKind { kLight, kDark };

/// The colours of the window. Every pair of text and ground below keeps a contrast of 4.5 : 1, every mark one
/// of 3 : 1 (tests/app/gui/widgets/theme_test.cpp).
struct Theme {
  ThemeKind kind = ThemeKind::kLight;
  QColor window;   ///< ground of the window, bars
  QColor surface;  ///< ground of panels and fields
  QColor raised;   ///< buttons, hovered rows
  QColor line;     ///< hairlines between areas, never the only sign of anything
  QColor border;   ///< outline of a field or button
  QColor text;
  QColor quietText;     ///< labels, hints
  QColor disabledText;  ///< what cannot be used now: dimmer, and still legible
  QColor accent;        ///< the one colour of action and selection
  QColor onAccent;
  QColor good;       ///< target reached
  QColor caution;    ///< force limit: amber, never red, in a dark room
  QColor recording;  ///< a trial is being recorded
  QColor track;      ///< empty part of a gauge
  QColor backdrop;   ///< round the picture of an organ
  QColor lattice;    ///< ridges and sections
  QColor wire;
  QColor grasp;  ///< section to take hold of
  QColor shaft;  ///< sleeve of the instrument, before the lamps shine on it
};

[[nodiscard]] const Theme& theme(ThemeKind kind);

/// The one scale of type sizes, points.
inline constexpr double kSmallText_pt = 9.0;
inline constexpr double kBodyText_pt = 10.0;
inline constexpr double kTitleText_pt = 12.0;
inline constexpr double kFigureText_pt = 21.0;

/// The one scale of distances, device-independent pixels.
inline constexpr int kSpace = 8;
/// The least height of what a finger presses.
inline constexpr int kTouch_px = 44;

/// Palette, fonts and style sheet of the whole application.
void applyTheme(QApplication& application, const Theme& chosen);

}  // namespace torsio::gui
