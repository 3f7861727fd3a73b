// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QString>
#include <QVariant>

#include "app/gui/base/language.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

/// What this station remembers for itself and, under an opaque user id, for each person who sits down at it:
/// language, theme, layout, and which database is used. Never a name, never a secret.
class Preferences {
 public:
  /// `remember` off (tests, pictures): nothing is read or written.
  explicit Preferences(bool remember) : remember_(remember) {}

  /// Off: nothing is written until it is on again; what was written before is still read.
  void keep(bool on) noexcept { keep_ = on; }

  /// Empty user id: the station's own choice, which everybody begins with.
  [[nodiscard]] std::optional<Language> language(const QString& userId) const;
  void setLanguage(const QString& userId, Language language);
  [[nodiscard]] std::optional<ThemeKind> themeKind(const QString& userId) const;
  void setThemeKind(const QString& userId, ThemeKind kind);

  /// Text of the page on which somebody signed out; empty: none is known.
  [[nodiscard]] QString page(const QString& userId) const;
  void setPage(const QString& userId, const QString& text);

  /// Locator of the database; empty: the default file.
  [[nodiscard]] QString database() const;
  void setDatabase(const QString& locator);

  [[nodiscard]] QVariant layout(const QString& name) const;
  void setLayout(const QString& name, const QVariant& value);

 private:
  [[nodiscard]] QVariant read(const QString& key) const;
  void write(const QString& key, const QVariant& value) const;
  bool remember_;
  bool keep_ = true;
};

}  // namespace torsio::gui
