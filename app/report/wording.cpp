// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/wording.h"

#include <algorithm>
#include <memory>

#include <QTranslator>

#include "sim/base/contracts.h"
#include "sim/base/error.h"

/// The linker drops resources of a static library that nothing names.
static void initTranslations() {
  Q_INIT_RESOURCE(torsio_translations);
}

namespace torsio {

namespace {

constexpr const char* kEnglish = "en";
constexpr const char* kContext = "Text";

}  // namespace

QString worded(const Text& text, const std::function<QString(const std::string&)>& translate) {
  if (text.empty()) {
    return {};
  }
  if (text.arguments().empty()) {
    return translate(text.pattern());
  }
  std::vector<std::string> words;
  words.reserve(text.arguments().size());
  for (const Text& argument : text.arguments()) {
    words.push_back(worded(argument, translate).toStdString());
  }
  return QString::fromStdString(filledIn(translate(text.pattern()).toStdString(), words));
}

QString englishWording(const Text& text) {
  return QString::fromStdString(text.str());
}

const std::vector<std::string>& reportLanguages() {
  static const std::vector<std::string> kLanguages{kEnglish, "zh_CN"};
  return kLanguages;
}

Wording wordingIn(const std::string& language) {
  const std::vector<std::string>& known = reportLanguages();
  if (std::find(known.begin(), known.end(), language) == known.end()) {
    throw Error(ErrorCode::kUsage, Text::tr("reports are not written in this language"), language,
                Text::tr("Give en or zh_CN"));
  }
  if (language == kEnglish) {
    return englishWording;
  }
  initTranslations();
  const auto translator = std::make_shared<QTranslator>();
  const bool loaded = translator->load(
      QStringLiteral(":/torsio/translations/torsio_%1.qm").arg(QString::fromStdString(language)));
  TORSIO_EXPECTS(loaded);
  return [translator](const Text& text) {
    return worded(text, [&translator](const std::string& pattern) {
      const QString translated = translator->translate(kContext, pattern.c_str());
      return translated.isEmpty() ? QString::fromStdString(pattern) : translated;
    });
  };
}

}  // namespace torsio
