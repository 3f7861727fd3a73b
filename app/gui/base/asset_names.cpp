// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/asset_names.h"

#include <QCoreApplication>

namespace torsio::gui {

namespace {

/// The asset files are data and know one language; these lines make their names known to the translators.
[[maybe_unused]] const char* const kNames[] = {
    QT_TRANSLATE_NOOP("Assets", "Forearm"),
    QT_TRANSLATE_NOOP("Assets", "Intestine"),
    QT_TRANSLATE_NOOP("Assets", "Stomach"),
    QT_TRANSLATE_NOOP("Assets", "Right forearm"),
    QT_TRANSLATE_NOOP("Assets", "Pronation"),
    QT_TRANSLATE_NOOP("Assets", "Supination"),
    QT_TRANSLATE_NOOP("Assets", "Loop"),
    QT_TRANSLATE_NOOP("Assets", "Organo-axial"),
    QT_TRANSLATE_NOOP("Assets", "Mesentero-axial"),
    QT_TRANSLATE_NOOP("Assets", "Combined"),
    QT_TRANSLATE_NOOP("Assets", "Partial"),
    QT_TRANSLATE_NOOP("Assets", "Small intestine, loop"),
    QT_TRANSLATE_NOOP("Assets", "Pronation, 60 degrees"),
    QT_TRANSLATE_NOOP("Assets", "Supination, 60 degrees"),
    QT_TRANSLATE_NOOP("Assets", "Loop, 180 degrees"),
    QT_TRANSLATE_NOOP("Assets", "Organo-axial, 180 degrees"),
    QT_TRANSLATE_NOOP("Assets", "Mesentero-axial, 45 degrees"),
    QT_TRANSLATE_NOOP("Assets", "Combined, 120 degrees"),
    QT_TRANSLATE_NOOP("Assets", "Partial, antrum only, 90 degrees"),
    QT_TRANSLATE_NOOP("Assets", "Small-bowel loop"),
    QT_TRANSLATE_NOOP("Assets", "Gastric organo-axial"),
    QT_TRANSLATE_NOOP("Assets", "Gastric mesentero-axial"),
    QT_TRANSLATE_NOOP("Assets", "Testis"),
    QT_TRANSLATE_NOOP("Assets", "Sigmoid"),
    QT_TRANSLATE_NOOP("Assets", "Midgut"),
    QT_TRANSLATE_NOOP("Assets", "Detorse"),
    QT_TRANSLATE_NOOP("Assets", "Small-bowel loop, twisted"),
    QT_TRANSLATE_NOOP("Assets", "Stomach, organo-axial volvulus"),
    QT_TRANSLATE_NOOP("Assets", "Stomach, mesentero-axial volvulus"),
    QT_TRANSLATE_NOOP("Assets", "Testis on its cord, torsion"),
    QT_TRANSLATE_NOOP("Assets", "Sigmoid volvulus"),
    QT_TRANSLATE_NOOP("Assets", "Midgut volvulus"),
    QT_TRANSLATE_NOOP("Assets", "Undo a small-bowel loop"),
    QT_TRANSLATE_NOOP("Assets", "Undo organo-axial"),
    QT_TRANSLATE_NOOP("Assets", "Undo mesentero-axial"),
    QT_TRANSLATE_NOOP("Assets", "Undo testicular torsion"),
    QT_TRANSLATE_NOOP("Assets", "Undo a sigmoid volvulus"),
    QT_TRANSLATE_NOOP("Assets", "Undo a midgut volvulus"),
    QT_TRANSLATE_NOOP("Assets", "dorsal forearm, 60 mm from the wrist crease"),
    QT_TRANSLATE_NOOP("Assets", "palmar forearm, 60 mm from the wrist crease"),
    QT_TRANSLATE_NOOP("Assets", "radial styloid"),
    QT_TRANSLATE_NOOP("Assets", "ulnar head"),
    QT_TRANSLATE_NOOP("Assets", "dorsal wrist centre"),
    QT_TRANSLATE_NOOP("Assets", "palmar wrist crease centre"),
    QT_TRANSLATE_NOOP("Assets", "thumb base (first carpometacarpal joint)"),
    QT_TRANSLATE_NOOP("Assets", "second knuckle (index metacarpal head)"),
    QT_TRANSLATE_NOOP("Assets", "fifth knuckle (ulnar border)"),
    QT_TRANSLATE_NOOP("Assets", "tip of the middle finger"),
};

}  // namespace

QString assetName(const QString& english) {
  return QCoreApplication::translate("Assets", english.toUtf8().constData());
}

}  // namespace torsio::gui
