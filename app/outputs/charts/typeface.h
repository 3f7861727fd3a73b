// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

class QApplication;

namespace torsio {

/// The one typeface of the window, the reports, the charts and the pictures (Debian: fonts-noto-core),
/// whatever the machine's default is: digits of one width, and the letters of every European language.
inline constexpr const char* kTypeface = "Noto Sans";
/// Has the signs that kTypeface lacks (arrows, ticks, circles), and takes its place where it is not installed
/// (Debian: fonts-dejavu-core).
inline constexpr const char* kFallbackTypeface = "DejaVu Sans";
/// Its companion for Chinese, in the simplified shapes (Debian: fonts-noto-cjk).
inline constexpr const char* kChineseTypeface = "Noto Sans CJK SC";

/// Returns the typeface with its companions in the order in which they are asked for a character. The caller
/// sets the size. Needs a QApplication. Any thread.
[[nodiscard]] QFont typeface();

/// Returns typeface() for what is printed or kept in a file: "ff" and "fi" stay two signs each, so that a
/// hash or a password can be found and copied as it was written. Any thread.
[[nodiscard]] QFont printedTypeface();

/// Returns those of kTypeface, kFallbackTypeface and kChineseTypeface that are not among the `installed`
/// families.
[[nodiscard]] QStringList missingTypefaces(const QStringList& installed);

/// Gives `application` the typeface; one line on standard error names each family that is missing, and the
/// start goes on. GUI thread, before the first widget.
void useTypeface(QApplication& application);

}  // namespace torsio
