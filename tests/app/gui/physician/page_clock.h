// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <QTimer>
#include <QWidget>

namespace torsio::gui {

/// Speeds up a page's timers until their data has been read and shown. False: they do not run.
inline bool looksAnew(const QWidget& page) {
  constexpr int kRings = 20;
  constexpr int kEvery_ms = 100;
  constexpr int kLongest_ms = 20'000;
  int rings = 0;
  QObject here;
  for (QTimer* clock : page.findChildren<QTimer*>(Qt::FindDirectChildrenOnly)) {
    if (clock->isActive()) {
      clock->setInterval(kEvery_ms);
      QObject::connect(clock, &QTimer::timeout, &here, [&rings] { ++rings; });
    }
  }
  return QTest::qWaitFor([&] { return rings >= kRings; }, kLongest_ms);
}

}  // namespace torsio::gui
