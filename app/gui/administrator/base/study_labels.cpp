// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/study_labels.h"

#include <span>
#include <utility>

#include <QCoreApplication>

#include "app/gui/base/translated_text.h"
#include "assessment/domain/rating/sheet_state.h"

namespace torsio::gui {

namespace {

using Names = std::span<const std::pair<const char*, const char*>>;

QString translated(const char* text) {
  return QCoreApplication::translate("Study", text);
}

QString named(Names names, const std::string& code) {
  if (code.empty()) {
    return QStringLiteral("\u2013");
  }
  for (const auto& [known, name] : names) {
    if (code == known) {
      return translated(name);
    }
  }
  return toQString(code);
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
  return named({}, occasion.label);
}

QString factorName(const std::string& code) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"sex", QT_TRANSLATE_NOOP("Study", "sex")},
      {"level", QT_TRANSLATE_NOOP("Study", "level of education")},
      {"experience", QT_TRANSLATE_NOOP("Study", "experience")},
      {"handedness", QT_TRANSLATE_NOOP("Study", "handedness")}};
  return named(kNames, code);
}

QString levelName(const std::string& code) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"female", QT_TRANSLATE_NOOP("Study", "female")},
      {"male", QT_TRANSLATE_NOOP("Study", "male")},
      {"other", QT_TRANSLATE_NOOP("Study", "other")},
      {"left", QT_TRANSLATE_NOOP("Study", "left-handed")},
      {"right", QT_TRANSLATE_NOOP("Study", "right-handed")}};
  return code.empty() ? translated(QT_TRANSLATE_NOOP("Study", "not known")) : named(kNames, code);
}

QString raterClassName(const std::string& code) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"intern", QT_TRANSLATE_NOOP("Study", "intern")},
      {"deputy_chief", QT_TRANSLATE_NOOP("Study", "deputy chief physician")},
      {"chief", QT_TRANSLATE_NOOP("Study", "chief physician")}};
  return named(kNames, code);
}

QString methodName(AllocationMethod method) {
  switch (method) {
    case AllocationMethod::kCompletePermutation:
      return translated(
          QT_TRANSLATE_NOOP("Study", "Simple randomisation into equal groups (as in the paper)"));
    case AllocationMethod::kPermutedBlocks:
      return translated(QT_TRANSLATE_NOOP("Study", "Shuffled blocks, one after another"));
    case AllocationMethod::kStratifiedBlocks:
      return translated(QT_TRANSLATE_NOOP("Study", "Shuffled blocks within strata"));
    case AllocationMethod::kMinimisation:
      return translated(QT_TRANSLATE_NOOP("Study", "Minimisation (Pocock and Simon)"));
  }
  return {};
}

QString sheetStateName(SheetState state) {
  switch (state) {
    case SheetState::kOpen:
      return translated(QT_TRANSLATE_NOOP("Study", "open"));
    case SheetState::kDraft:
      return translated(QT_TRANSLATE_NOOP("Study", "draft"));
    case SheetState::kSubmitted:
      return translated(QT_TRANSLATE_NOOP("Study", "submitted"));
    case SheetState::kWithdrawn:
      return translated(QT_TRANSLATE_NOOP("Study", "taken back"));
  }
  return {};
}

}  // namespace torsio::gui
