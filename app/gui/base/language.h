// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QString>
#include <QTranslator>

namespace torsio::gui {

enum class Language { kEnglish, kSimplifiedChinese };

/// "en", "zh_CN": in settings, on the command line.
[[nodiscard]] QString languageCode(Language language);
[[nodiscard]] std::optional<Language> languageOf(const QString& code);
/// As its speakers write it.
[[nodiscard]] QString languageName(Language language);
/// The one that the window speaks.
[[nodiscard]] Language presentLanguage();

/// The language of the whole program, switched while it runs: every widget gets a LanguageChange event, dates
/// and numbers follow QLocale(). Files keep their own form. GUI thread; one object lives as long as the
/// application.
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
