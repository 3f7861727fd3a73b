// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/wording/joined_sentences.h"

namespace torsio {

namespace {

bool isFullWidthStop(QChar stop) {
  return stop == QChar(0x3002) || stop == QChar(0xFF01) || stop == QChar(0xFF1F);  // full-width . ! and ?
}

}  // namespace

QString joinedSentences(const QStringList& sentences) {
  QString all;
  for (const QString& sentence : sentences) {
    if (!all.isEmpty() && !sentence.isEmpty() && !isFullWidthStop(all.back())) {
      all += QLatin1Char(' ');
    }
    all += sentence;
  }
  return all;
}

}  // namespace torsio
