// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

class QApplication;

namespace torsio {

/// The typeface of window, reports, charts and pictures (Debian: fonts-noto-core), independent of the
/// system's default: tabular digits and the letters of every European language.
inline constexpr const char* kTypeface = "Noto Sans";
/// Supplies symbols that kTypeface lacks (arrows, ticks, circles), and replaces it if it is not installed
/// (Debian: fonts-dejavu-core).
inline constexpr const char* kFallbackTypeface = "DejaVu Sans";
/// Companion for simplified Chinese (Debian: fonts-noto-cjk).
inline constexpr const char* kChineseTypeface = "Noto Sans CJK SC";

/// Returns the typeface with its fallbacks in order. The caller sets the size. Needs a QApplication. Any
/// thread.
[[nodiscard]] QFont typeface();

/// Returns typeface() for printed and stored documents: without ligatures ("ff", "fi"), so that hashes and
/// passwords can be searched for and copied. Any thread.
[[nodiscard]] QFont printedTypeface();

/// Returns those of kTypeface, kFallbackTypeface and kChineseTypeface that are not in `installed`.
[[nodiscard]] QStringList missingTypefaces(const QStringList& installed);

/// Sets the typeface of `application`; prints one line on standard error per missing family and continues.
/// GUI thread, before the first widget.
void useTypeface(QApplication& application);

}  // namespace torsio
