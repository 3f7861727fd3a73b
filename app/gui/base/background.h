// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include <QObject>
#include <QThreadPool>

#include "app/services/access/session_context.h"

namespace torsio::gui {

/// Short background work without a progress display: checking a password, testing a database, reading for a
/// page that refreshes itself. One task at a time.
class Background : public QObject {
  Q_OBJECT

 public:
  explicit Background(QObject* parent = nullptr);
  ~Background() override;

  using Failed = std::function<void(const std::exception_ptr&)>;
  /// Runs `work()` in a worker thread and `then(result)`, result moved, in the GUI thread; if `work` throws,
  /// `failed` runs there instead. No effect while other work runs.
  template <typename Work, typename Then>
  void run(Work work, Then then, Failed failed) {
    const auto result = std::make_shared<std::optional<std::invoke_result_t<Work&>>>();
    start([work = std::move(work), result]() mutable { result->emplace(work()); },
          [then = std::move(then), result]() mutable { then(std::move(**result)); }, std::move(failed));
  }
  /// The same with `work(session)` on its own session.
  template <typename Work, typename Then>
  void run(const SessionKey& key, Work work, Then then, Failed failed) {
    run(
        [key, work = std::move(work)]() mutable {
          SessionContext own(key);
          return work(own);
        },
        std::move(then), std::move(failed));
  }
  [[nodiscard]] bool working() const noexcept { return working_; }

 Q_SIGNALS:
  void workingChanged(bool working);

 private:
  void start(std::function<void()> work, std::function<void()> then, Failed failed);
  void setWorking(bool working);
  QThreadPool worker_;
  bool working_ = false;
};

}  // namespace torsio::gui
