// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/graphics_application.h"

#include <cstdio>

#include <QApplication>

#include "app/outputs/charts/typeface.h"

namespace torsio {

namespace {

/// Standard error is for our own one-line messages; of Qt's messages, only failures pass.
void passOnlyFailures(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtCriticalMsg || type == QtFatalMsg) {
    std::fprintf(stderr, "%s\n", qPrintable(message));
  }
}

}  // namespace

std::unique_ptr<QCoreApplication> makeHeadlessGraphicsApplication(int& argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler(passOnlyFailures);
  auto application = std::make_unique<QApplication>(argc, argv);
  useTypeface(*application);
  return application;
}

}  // namespace torsio
