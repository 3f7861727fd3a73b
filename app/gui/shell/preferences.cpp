// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/preferences.h"

#include <QApplication>
#include <QSettings>

#include "app/gui/base/translated_text.h"
#include "app/services/access/station_record.h"
#include "app/services/base/configuration.h"

namespace torsio::gui {

namespace {

QString keyFor(const QString& userId, const char* name) {
  return userId.isEmpty() ? QStringLiteral("station/%1").arg(QLatin1String(name))
                          : QStringLiteral("users/%1/%2").arg(userId, QLatin1String(name));
}

}  // namespace

QVariant Preferences::read(const QString& key) const {
  return remember_ ? QSettings().value(key) : QVariant();
}

/// Returns what was chosen; for the station what the computer's configuration says, if nothing was.
QString Preferences::chosenOr(const ConfiguredKey& key, const QString& userId, const char* name) const {
  const QString chosen = read(keyFor(userId, name)).toString();
  return chosen.isEmpty() && userId.isEmpty() && remember_ ? toQString(configured(key).value_or("")) : chosen;
}

void Preferences::write(const QString& key, const QVariant& value) const {
  if (remember_ && keep_) {
    QSettings().setValue(key, value);
  }
}

std::optional<Language> Preferences::language(const QString& userId) const {
  return languageOf(chosenOr(kConfiguredLanguage, userId, "language"));
}

void Preferences::setLanguage(const QString& userId, Language language) {
  write(keyFor(userId, "language"), languageCode(language));
}

std::optional<ThemeKind> Preferences::themeKind(const QString& userId) const {
  const QString name = chosenOr(kConfiguredTheme, userId, "theme");
  if (name == QLatin1String("dark")) {
    return ThemeKind::kDark;
  }
  if (name == QLatin1String("light")) {
    return ThemeKind::kLight;
  }
  return std::nullopt;
}

void Preferences::setThemeKind(const QString& userId, ThemeKind kind) {
  write(keyFor(userId, "theme"), kind == ThemeKind::kDark ? QStringLiteral("dark") : QStringLiteral("light"));
}

QString Preferences::page(const QString& userId) const {
  return read(keyFor(userId, "page")).toString();
}

void Preferences::setPage(const QString& userId, const QString& text) {
  write(keyFor(userId, "page"), text);
}

QString Preferences::database() const {
  return remember_ ? toQString(chosenRecord()) : QString();
}

void Preferences::setDatabase(const QString& locator) {
  if (remember_ && keep_) {
    chooseRecord(locator.toStdString());
  }
}

QVariant Preferences::layout(const QString& name) const {
  return read(QStringLiteral("layout/%1").arg(name));
}

void Preferences::setLayout(const QString& name, const QVariant& value) {
  write(QStringLiteral("layout/%1").arg(name), value);
}

Appearance::Appearance(Preferences& preferences, std::optional<ThemeKind> fixed, ThemeKind usual)
    : preferences_(preferences), fixed_(fixed), usual_(usual), theme_(usual) {}

void Appearance::apply(const QString& userId) {
  const auto language = preferences_.language(userId);
  if (const auto shown = language ? language : preferences_.language({})) {
    language_.choose(*shown);
  }
  const auto own = preferences_.themeKind(userId);
  const auto stored = own ? own : preferences_.themeKind({});
  show(fixed_.value_or(stored.value_or(usual_)));
}

void Appearance::choose(const QString& userId, Language language) {
  language_.choose(language);
  preferences_.setLanguage(userId, language);
}

void Appearance::choose(const QString& userId, ThemeKind kind) {
  fixed_.reset();
  preferences_.setThemeKind(userId, kind);
  show(kind);
}

void Appearance::show(ThemeKind kind) {
  theme_ = kind;
  applyTheme(*qApp, theme(kind));
  Q_EMIT themeChanged(kind);
}

}  // namespace torsio::gui
