// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <memory>

#include <QObject>
#include <QThreadPool>

namespace torsio::gui {

/// Short background work while nobody is signed in: checking a password, testing a database. One task at a
/// time.
class Background : public QObject {
  Q_OBJECT

 public:
  explicit Background(QObject* parent = nullptr);
  ~Background() override;

  /// Runs `work` in a worker thread and its result in the GUI thread; if it throws, `failed` runs there
  /// instead. No effect while other work runs.
  using Finish = std::function<void()>;
  void run(std::function<Finish()> work, std::function<void(const std::exception_ptr&)> failed);
  [[nodiscard]] bool working() const noexcept { return working_; }

 Q_SIGNALS:
  void workingChanged(bool working);

 private:
  void setWorking(bool working);
  QThreadPool worker_;
  bool working_ = false;
};

}  // namespace torsio::gui
