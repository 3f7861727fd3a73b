// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/wording/wording.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QTranslator>

#include "app/outputs/wording/printed_minus.h"
#include "app/outputs/wording/printed_value.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/plain_text.h"

/// The linker drops the resources of a static library unless something refers to them.
static void initTranslations() {
  Q_INIT_RESOURCE(torsio_translations);
}

namespace torsio {

namespace {

constexpr const char* kEnglish = "en";
constexpr const char* kContext = "Text";

QLocale localeOf(const std::string& language) {
  return language == kEnglish ? QLocale(QLocale::English, QLocale::UnitedKingdom)
                              : QLocale(QString::fromStdString(language));
}

/// Returns whether an argument is a count in an English pattern: it comes before a plural.
bool counts(const std::string& pattern, std::size_t argument) {
  return pattern.find("%" + std::to_string(argument + 1) + " {") != std::string::npos;
}

}  // namespace

QString worded(const Text& text, const std::function<QString(const std::string&)>& translate,
               const QLocale& locale, Signs signs) {
  if (text.empty()) {
    return {};
  }
  const bool print = signs == Signs::kOfPrint;
  QString pattern = translate(plainText(text.pattern()));
  if (text.arguments().empty()) {
    return print ? printedMinus(printedTime(std::move(pattern), locale)) : pattern;
  }
  if (print) {
    pattern = printedPattern(std::move(pattern));
  }
  std::vector<std::string> words;
  words.reserve(text.arguments().size());
  for (const Text& argument : text.arguments()) {
    const QString word = worded(argument, translate, locale, signs);
    words.push_back(
        (print && counts(text.pattern(), words.size()) ? printedCount(word, locale) : word).toStdString());
  }
  return QString::fromStdString(filledIn(pattern.toStdString(), words));
}

QString englishWording(const Text& text) {
  return worded(
      text, [](const std::string& pattern) { return QString::fromStdString(pattern); }, localeOf(kEnglish));
}

const std::vector<std::string>& reportLanguages() {
  static const std::vector<std::string> kLanguages{kEnglish, "zh_CN"};
  return kLanguages;
}

Wording wordingIn(const std::string& language, Signs signs) {
  const std::vector<std::string>& known = reportLanguages();
  if (std::find(known.begin(), known.end(), language) == known.end()) {
    throw Error(ErrorCode::kUsage, Text::tr("reports are not written in this language"), language,
                Text::tr("Give en or zh_CN"));
  }
  if (language == kEnglish) {
    return [signs](const Text& text) {
      return signs == Signs::kOfPrint ? englishWording(text) : QString::fromStdString(text.str());
    };
  }
  initTranslations();
  const auto translator = std::make_shared<QTranslator>();
  const bool loaded = translator->load(
      QStringLiteral(":/torsio/translations/torsio_%1.qm").arg(QString::fromStdString(language)));
  TORSIO_EXPECTS(loaded);
  return [translator, locale = localeOf(language), signs](const Text& text) {
    QString words = worded(
        text,
        [&translator](const std::string& pattern) {
          const QString translated = translator->translate(kContext, pattern.c_str());
          return translated.isEmpty() ? QString::fromStdString(pattern) : translated;
        },
        locale, signs);
    return words.replace(QStringLiteral("\u3002 "), QStringLiteral("\u3002"));  // no blank after a full stop
  };
}

}  // namespace torsio
