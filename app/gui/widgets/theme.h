// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

class QApplication;

namespace torsio::gui {

enum class ThemeKind { kLight, kDark };

/// The colours of the window. Every pair of text and background has a contrast of at least 4.5 : 1, every
/// mark 3 : 1 (tests/app/gui/widgets/theme_test.cpp).
struct Theme {
  ThemeKind kind = ThemeKind::kLight;
  QColor window;   ///< background of window and bars
  QColor surface;  ///< background of panels and fields
  QColor raised;   ///< buttons, hovered rows
  QColor line;     ///< hairlines between areas, never the only indication of anything
  QColor border;   ///< outline of a field or button
  QColor text;
  QColor quietText;     ///< labels, hints
  QColor disabledText;  ///< disabled: dimmer, but legible
  QColor accent;        ///< the single colour of actions and selection
  QColor onAccent;
  QColor good;       ///< target reached
  QColor caution;    ///< force limit: amber, never red, in a dark room
  QColor recording;  ///< a trial is being recorded
  QColor track;      ///< empty part of a gauge
  QColor backdrop;   ///< behind the picture of an organ
  QColor lattice;    ///< ridges and sections
  QColor wire;
  QColor grasp;  ///< section to grasp
  QColor shaft;  ///< sleeve of the instrument, before lighting
};

[[nodiscard]] const Theme& theme(ThemeKind kind);

/// All font sizes, points.
inline constexpr double kSmallText_pt = 9.0;
inline constexpr double kBodyText_pt = 10.0;
inline constexpr double kTitleText_pt = 12.0;
inline constexpr double kFigureText_pt = 21.0;

/// Unit of all distances, device-independent px.
inline constexpr int kSpace = 8;
/// Minimum height of a touch target.
inline constexpr int kTouch_px = 44;

/// Sets palette, fonts and style sheet of the application.
void applyTheme(QApplication& application, const Theme& chosen);

}  // namespace torsio::gui
