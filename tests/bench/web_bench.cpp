// SPDX-License-Identifier: GPL-3.0-or-later
// Two hundred raters at the browser's review desk: response times, processor time of saving a sheet, memory
// of the server. `torsio_bench_web [RATERS [SECONDS [DATABASE]]]`. DATABASE: an empty PostgreSQL database to
// which the record is copied, and which is then served; default: SQLite. Server and raters share this
// process, and its memory includes both.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <QCoreApplication>

#include "app/services/access/access_service.h"
#include "app/services/base/assets.h"
#include "app/services/base/build_info.h"
#include "app/web/http_server.h"
#include "app/web/web_desk.h"
#include "db/migrations/migrations.h"
#include "db/repository/system/record_copy.h"
#include "tests/app/support/review_centre.h"
#include "tests/app/web/served_desk.h"
#include "tests/app/web/web_client.h"

namespace {
using Clock = std::chrono::steady_clock;

double processor_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string memory() {
  std::ifstream status("/proc/self/status");
  std::string found;
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM", 0) == 0) {
      found = line;
    }
  }
  return found;
}

/// Responses of all raters.
struct Times {
  std::mutex mutex;
  std::vector<double> all_ms;
  std::atomic<int> refused{0};

  void add(const torsio::DeskAnswer& answer, Clock::time_point begun) {
    const double took_ms = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    refused += answer.status == 200 ? 0 : 1;
    const std::lock_guard lock(mutex);
    all_ms.push_back(took_ms);
  }
  double at(double share) {
    std::sort(all_ms.begin(), all_ms.end());
    return all_ms.empty() ? 0.0
                          : all_ms[static_cast<std::size_t>(share * static_cast<double>(all_ms.size() - 1))];
  }
};

struct Rater {
  torsio::WebClient client;
  std::string path;
  std::int64_t revision = 0;
};

/// Scores like a watching rater: a report every two seconds, a mark every three.
void score(Rater& rater, Times& times, int seconds, int first_ms) {
  std::this_thread::sleep_for(std::chrono::milliseconds(first_ms));
  for (int second = 0; second < seconds; ++second) {
    const auto begun = Clock::now();
    if (second % 2 == 0) {
      times.add(rater.client.send("POST", rater.path + "/viewing",
                                  {{"played", {{{"from_us", 0}, {"to_us", 400'000}, {"speed", 1.0}}}}}),
                begun);
    }
    if (second % 3 == 0) {
      const auto saved = Clock::now();
      const torsio::DeskAnswer answer = rater.client.send(
          "PUT", rater.path + "/sheet", torsio::sheetBody(rater.revision, 70, 80, 10 + second));
      rater.revision += answer.status == 200 ? 1 : 0;
      times.add(answer, saved);
    }
    std::this_thread::sleep_until(begun + std::chrono::seconds(1));
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace torsio;
  const QCoreApplication application(argc, argv);
  const int count = argc > 1 ? std::atoi(argv[1]) : 200;
  const int seconds = argc > 2 ? std::atoi(argv[2]) : 20;
  torsio::testing::ReviewCentre centre({.raters = count, .trainees = 2, .trial_s = 0.5});
  const std::string locator = argc > 3 ? argv[3] : centre.locator();
  if (argc > 3) {
    Connection to = openRecord(locator, OpenMode::kCreate, {.softwareVersion = softwareVersion()});
    (void)copyRecord(centre.connection(), to);
  }
  web::WebDesk desk({.locator = locator, .assets = assetsFolder()});
  const web::HttpServer server({"127.0.0.1", 0}, {}, {.connectionsAnAddress = 1000},
                               [&desk](web::HttpRequest request, web::HttpServer::Reply reply) {
                                 desk.handle(std::move(request), std::move(reply));
                               });
  std::vector<std::unique_ptr<Rater>> raters;
  Times opened;
  for (int i = 0; i < count; ++i) {
    const auto session = centre.physician(static_cast<std::size_t>(i));
    const std::string cookie = desk.sessions().open(
        session->actor(), "", passwordStamp(*session, session->actor().userId), web::deskNow());
    auto rater = std::make_unique<Rater>(Rater{torsio::WebClient(server.port()), "", 0});
    rater->client.cookie = std::string(web::kCookie) + "=" + cookie;
    rater->client.token = desk.sessions().find(cookie, web::deskNow())->token;
    const auto begun = Clock::now();
    rater->path = "/api/cases/" + torsio::firstCase(rater->client);
    opened.add(rater->client.get(rater->path), begun);
    raters.push_back(std::move(rater));
  }
  const double before_s = processor_s();
  constexpr int kSaves = 100;
  for (int i = 0; i < kSaves; ++i) {
    Rater& one = *raters.front();
    const torsio::DeskAnswer answer =
        one.client.send("PUT", one.path + "/sheet", torsio::sheetBody(one.revision, 70, 80, 10 + i % 80));
    one.revision += answer.status == 200 ? 1 : 0;
  }
  std::cout << "a sheet's save: " << 1000.0 * (processor_s() - before_s) / kSaves << " ms of the processor\n";

  Times times;
  const double begun_s = processor_s();
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < raters.size(); ++i) {
    threads.emplace_back([&, i] { score(*raters[i], times, seconds, static_cast<int>(i * 5 % 1000)); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  std::cout << count << " raters for " << seconds << " s: " << times.all_ms.size() << " answers, "
            << times.refused << " of them no success; half within " << times.at(0.5) << " ms, 99 % within "
            << times.at(0.99) << " ms, all within " << times.at(1.0) << " ms; "
            << 1000.0 * (processor_s() - begun_s) /
                   static_cast<double>(std::max<std::size_t>(times.all_ms.size(), 1))
            << " ms of the processor each\n"
            << memory() << "\n";
  return 0;
}
