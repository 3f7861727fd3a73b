// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QString>
#include <QTranslator>

namespace torsio::gui {

enum class Language { kEnglish, kSimplifiedChinese };

/// "en", "zh_CN": code in settings and on the command line.
[[nodiscard]] QString languageCode(Language language);
[[nodiscard]] std::optional<Language> languageOf(const QString& code);
/// Returns the language's own name.
[[nodiscard]] QString languageName(Language language);
/// Returns the window's language.
[[nodiscard]] Language presentLanguage();

/// Switches the program's language at run time: every widget gets a LanguageChange event; dates and numbers
/// follow QLocale(). File formats do not change. GUI thread; one instance for the application's lifetime.
class LanguageSwitch : public QObject {
  Q_OBJECT

 public:
  explicit LanguageSwitch(QObject* parent = nullptr);
  ~LanguageSwitch() override;

  void choose(Language language);
  [[nodiscard]] Language present() const noexcept { return present_; }

 private:
  void install();
  Language present_ = Language::kEnglish;
  QTranslator texts_;
};

}  // namespace torsio::gui
