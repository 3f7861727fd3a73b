// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/study_labels.h"

#include <utility>

#include <QCoreApplication>

#include "app/gui/base/translated_text.h"
#include "assessment/domain/people/person.h"

namespace torsio::gui {

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("Study", text);
}

}  // namespace

QString occasionName(const Occasion& occasion) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"pre", QT_TRANSLATE_NOOP("Study", "before training")},
      {"mid", QT_TRANSLATE_NOOP("Study", "half-way")},
      {"post", QT_TRANSLATE_NOOP("Study", "after training")}};
  for (const auto& [known, name] : kNames) {
    if (occasion.code == known) {
      return translated(name);
    }
  }
  return occasion.label.empty() ? QStringLiteral("\u2013") : toQString(occasion.label);
}

QString levelName(const std::string& code) {
  if (code.empty()) {
    return translated(QT_TRANSLATE_NOOP("Study", "not known"));
  }
  return toQString(fromStoredText<Sex>(code) ? labelOfStored<Sex>(code) : labelOfStored<Handedness>(code));
}

QString raterClassName(const std::string& code) {
  return code.empty() ? QStringLiteral("\u2013") : toQString(labelOfStored<Seniority>(code));
}

}  // namespace torsio::gui
