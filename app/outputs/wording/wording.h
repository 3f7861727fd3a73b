// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QLocale>
#include <QString>

#include "sim/core/text.h"

namespace torsio {

/// Translates a Text for a report's reader.
using Wording = std::function<QString(const Text&)>;

/// Whom a text is formatted for: readers, with the typographic minus, dates of `locale` and grouped digits of
/// counts ("%1 {mark|marks}"), or programs, with hyphens, ISO 8601 and plain digits.
enum class Signs { kOfPrint, kOfFiles };

/// Formats `text`, translating its pattern and those of its arguments with `translate`.
[[nodiscard]] QString worded(const Text& text, const std::function<QString(const std::string&)>& translate,
                             const QLocale& locale, Signs signs = Signs::kOfPrint);

/// Formats the untranslated English text for readers.
[[nodiscard]] QString englishWording(const Text& text);

/// Returns the languages of reports: "en", "zh_CN".
[[nodiscard]] const std::vector<std::string>& reportLanguages();

/// Returns the wording of one of reportLanguages(), independent of the window's language. Untranslated texts
/// stay English. Needs no window. Throws Error{kUsage} for another language.
[[nodiscard]] Wording wordingIn(const std::string& language, Signs signs = Signs::kOfPrint);

}  // namespace torsio
