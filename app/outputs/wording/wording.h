// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QLocale>
#include <QString>

#include "sim/core/text.h"

namespace torsio {

/// How a report says a Text: in the language of whoever reads it.
using Wording = std::function<QString(const Text&)>;

/// Who reads a text: people, who see the minus of print, days as `locale` writes them and the digits of what
/// is counted ("%1 {mark|marks}") in groups, or programs, which ask for hyphens, ISO 8601 and bare digits.
enum class Signs { kOfPrint, kOfFiles };

/// `text` with the patterns that `translate` gives for its own and those of its arguments.
[[nodiscard]] QString worded(const Text& text, const std::function<QString(const std::string&)>& translate,
                             const QLocale& locale, Signs signs = Signs::kOfPrint);

/// The words of the sources, for people.
[[nodiscard]] QString englishWording(const Text& text);

/// The languages a report can be written in: "en", "zh_CN".
[[nodiscard]] const std::vector<std::string>& reportLanguages();

/// The wording of one of reportLanguages(), whatever the language of the window. What its translation lacks
/// stays English. Needs no window. Throws Error{kUsage} for another language.
[[nodiscard]] Wording wordingIn(const std::string& language, Signs signs = Signs::kOfPrint);

}  // namespace torsio
