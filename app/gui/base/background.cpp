// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/background.h"

#include <utility>

namespace torsio::gui {

Background::Background(QObject* parent) : QObject(parent) {
  worker_.setMaxThreadCount(1);
}

Background::~Background() {
  worker_.waitForDone();
}

void Background::setWorking(bool working) {
  working_ = working;
  Q_EMIT workingChanged(working);
}

void Background::start(std::function<void()> work, std::function<void()> then, Failed failed) {
  if (working_) {
    return;
  }
  setWorking(true);
  worker_.start([this, work = std::move(work), then = std::move(then), failed = std::move(failed)] {
    std::exception_ptr problem;
    try {
      work();
    } catch (...) {
      problem = std::current_exception();
    }
    QMetaObject::invokeMethod(this, [this, then, failed, problem] {
      setWorking(false);
      if (problem) {
        failed(problem);
      } else {
        then();
      }
    });
  });
}

}  // namespace torsio::gui
