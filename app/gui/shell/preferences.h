// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QString>
#include <QVariant>

#include "app/gui/base/language.h"
#include "app/gui/widgets/theme.h"

namespace torsio {
struct ConfiguredKey;
}

namespace torsio::gui {

/// Settings of this station and, by opaque user id, of its users: language, theme, layout, and the database.
/// Never contains names or secrets.
class Preferences {
 public:
  /// `remember` off (tests, screenshots): reads and writes nothing.
  explicit Preferences(bool remember) : remember_(remember) {}

  /// Off: stops writing; stored values are still read.
  void keep(bool on) noexcept { keep_ = on; }

  /// Empty user id: the station's own setting, the default for everybody.
  [[nodiscard]] std::optional<Language> language(const QString& userId) const;
  void setLanguage(const QString& userId, Language language);
  [[nodiscard]] std::optional<ThemeKind> themeKind(const QString& userId) const;
  void setThemeKind(const QString& userId, ThemeKind kind);

  /// Id of the page at a user's last sign-out; empty: unknown.
  [[nodiscard]] QString page(const QString& userId) const;
  void setPage(const QString& userId, const QString& text);

  /// Returns the database's locator; empty: the default file.
  [[nodiscard]] QString database() const;
  void setDatabase(const QString& locator);

  [[nodiscard]] QVariant layout(const QString& name) const;
  void setLayout(const QString& name, const QVariant& value);

 private:
  [[nodiscard]] QVariant read(const QString& key) const;
  [[nodiscard]] QString chosenOr(const ConfiguredKey& key, const QString& userId, const char* name) const;
  void write(const QString& key, const QVariant& value) const;
  bool remember_;
  bool keep_ = true;
};

/// Language and theme of the window: those of the signed-in user, else the station's. Stores what is chosen.
/// GUI thread.
class Appearance : public QObject {
  Q_OBJECT

 public:
  /// `preferences` must outlive it. `fixed`: shown until a theme is chosen, whatever is stored; `usual`: if
  /// none is stored.
  Appearance(Preferences& preferences, std::optional<ThemeKind> fixed, ThemeKind usual);

  [[nodiscard]] LanguageSwitch& languageSwitch() noexcept { return language_; }
  [[nodiscard]] ThemeKind themeKind() const noexcept { return theme_; }
  /// Shows what a user has stored; empty: the station.
  void apply(const QString& userId);
  void choose(const QString& userId, Language language);
  void choose(const QString& userId, ThemeKind kind);

 Q_SIGNALS:
  void themeChanged(ThemeKind kind);

 private:
  void show(ThemeKind kind);

  Preferences& preferences_;
  std::optional<ThemeKind> fixed_;
  ThemeKind usual_;
  ThemeKind theme_;
  LanguageSwitch language_;
};

}  // namespace torsio::gui
