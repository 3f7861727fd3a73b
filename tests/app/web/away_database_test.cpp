// SPDX-License-Identifier: GPL-3.0-or-later
// The database server of the desk goes away and comes back; the desk is a service of systemd. With a
// PostgreSQL of its own, if TORSIO_TEST_POSTGRES says that there is one on this machine.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/support/review_centre.h"
#include "tests/app/web/served_desk.h"
#include "tests/app/web/serving_program.h"
#include "tests/app/web/web_client.h"

namespace torsio::web {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// A PostgreSQL server of this test alone, which it may stop and start.
class OwnServer {
 public:
  OwnServer() { locator_ = run("start"); }
  OwnServer(const OwnServer&) = delete;
  OwnServer& operator=(const OwnServer&) = delete;
  ~OwnServer() { run("stop"); }

  [[nodiscard]] const std::string& locator() const { return locator_; }
  /// Writes the password to a file, and returns the variable that names it.
  [[nodiscard]] std::string passwordFile(const std::filesystem::path& file) const {
    const std::size_t at = locator_.find('@');
    const std::size_t colon = locator_.rfind(':', at);
    std::ofstream(file) << "*:*:*:*:" << locator_.substr(colon + 1, at - colon - 1) << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_read);
    return "PGPASSFILE=" + file.string();
  }
  void goAway() const { run("down"); }
  void comeBack() const { run("up"); }
  /// It takes connections and answers nothing, until it is thawed.
  void freeze() const { run("freeze"); }
  void thaw() const { run("thaw"); }

 private:
  /// Returns the first line of the script's answer.
  std::string run(const std::string& what) const {
    const std::string command =
        "TORSIO_TEST_POSTGRES='" + locator_ + "' '" TORSIO_START_POSTGRES "' " + what + " 2>/dev/null";
    std::FILE* const answer = popen(command.c_str(), "r");
    std::array<char, 1000> line{};
    const bool said = std::fgets(line.data(), line.size(), answer) != nullptr;
    EXPECT_EQ(pclose(answer), 0) << what;
    std::string text = said ? line.data() : "";
    return text.substr(0, text.find('\n'));
  }

  std::string locator_;
};

class AwayDatabase : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("TORSIO_TEST_POSTGRES") == nullptr) {
      GTEST_SKIP() << "TORSIO_TEST_POSTGRES names no server";
    }
    server_ = std::make_unique<OwnServer>();
  }
  [[nodiscard]] ReviewCentre::Setup setup() const { return {.trial_s = 0.5, .locator = server_->locator()}; }
  [[nodiscard]] const OwnServer& server() const { return *server_; }

  /// Asks again and again, like a page; returns the time until the first good answer.
  static std::chrono::milliseconds untilGood(WebClient& client, const std::string& path) {
    const Clock::time_point from = Clock::now();
    while (client.get(path).status != 200 && Clock::now() - from < 30s) {
      std::this_thread::sleep_for(50ms);
    }
    return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - from);
  }

 private:
  std::unique_ptr<OwnServer> server_;
};

TEST_F(AwayDatabase, TheDeskReconnectsAfterARestart) {
  ServedDesk served(setup());
  WebClient rater = served.physician(0);
  const std::string sheet = "/api/cases/" + firstCase(rater) + "/sheet";
  ASSERT_EQ(rater.send("PUT", sheet, sheetBody(0, 70, 80, 75)).status, 200);

  server().goAway();
  server().comeBack();

  EXPECT_LT(untilGood(rater, "/api/queue"), 5s);
  EXPECT_EQ(rater.send("PUT", sheet, sheetBody(1, 71, 80, 75)).status, 200) << "the session went on";
  WebClient other = served.client();
  EXPECT_TRUE(other.signIn("physician1", kWebPassword));
}

TEST_F(AwayDatabase, OfTwoSealsOrTwoChangesAtOnceOneCountsAndTheOtherIsTold) {
  const ServedDesk served(setup());
  std::vector<WebClient> tabs{served.physician(0), served.physician(0)};
  const std::vector<std::string> paths{"/api/cases/" + firstCase(tabs[0]),
                                       "/api/cases/" + firstCase(tabs[1])};
  watchWhole(tabs[0], paths[0]);
  submitTwiceAtOnce(tabs, paths);
  amendTwiceAtOnce(tabs, paths);
}

TEST_F(AwayDatabase, TheDeskSaysThatTheRecordIsAwayAndLogsItOnce) {
  ServedDesk served(setup());
  WebClient rater = served.physician(0);
  WebClient watcher = served.client();
  EXPECT_EQ(watcher.get("/readyz").status, 200);

  server().goAway();

  for (int i = 0; i < 20; ++i) {
    const DeskAnswer queue = rater.get("/api/queue");
    ASSERT_EQ(queue.status, 503);
    EXPECT_EQ(queue.json().at("error").at("what"), "the record cannot be reached just now");
    EXPECT_EQ(queue.headers.at("retry-after"), "1");
    WebClient late = served.client();
    EXPECT_FALSE(late.signIn("physician1", kWebPassword));
  }
  EXPECT_EQ(watcher.get("/readyz").status, 503);
  EXPECT_EQ(watcher.get("/healthz").status, 200);
  EXPECT_EQ(watcher.get("/healthz").json(), (nlohmann::json{{"status", "ok"}}));

  server().comeBack();

  EXPECT_LT(untilGood(rater, "/api/queue"), 5s);
  EXPECT_EQ(watcher.get("/readyz").status, 200);
  WebClient late = served.client();
  EXPECT_TRUE(late.signIn("physician1", kWebPassword)) << "tries meanwhile were not wrong ones";
  const std::string causes = served.loggedCauses();
  EXPECT_EQ(causes.find("The record cannot be reached: "), 0U) << causes;
  EXPECT_NE(causes.find("The record is back after "), std::string::npos) << causes;
  EXPECT_EQ(std::count(causes.begin(), causes.end(), '\n'), 2) << causes;
}

TEST_F(AwayDatabase, TheServerWaitsForADatabaseThatIsAwayAtStart) {
  ReviewCentre centre(setup());
  setWebPasswords(centre);
  const std::vector<std::string> environment{server().passwordFile(centre.folder() / "pgpass")};
  server().goAway();
  {
    ServingProgram hurried(centre, environment, {"--wait-for-database", "1"});
    EXPECT_EQ(hurried.ended(), 9);
  }
  ServingProgram patient(centre, environment);
  std::this_thread::sleep_for(1s);
  server().comeBack();
  const std::uint16_t port = patient.port();
  ASSERT_NE(port, 0) << patient.errors();
  WebClient client(port);
  client.headers = {{"Sec-Fetch-Site", "same-origin"}};
  EXPECT_TRUE(client.signIn("physician0", kWebPassword));
  EXPECT_EQ(patient.errors().find("Waiting for the database server: "), 0U) << patient.errors();
  EXPECT_EQ(patient.stopped(), 0);
}

TEST_F(AwayDatabase, TheServerStopsThoughTheDatabaseIsFrozen) {
  ReviewCentre centre(setup());
  const std::vector<std::string> environment{server().passwordFile(centre.folder() / "pgpass")};
  ServingProgram served(centre, environment);
  const std::uint16_t port = served.port();
  ASSERT_NE(port, 0) << served.errors();

  server().freeze();
  std::vector<std::thread> pages;
  for (int i = 0; i < 12; ++i) {
    pages.emplace_back([port] { (void)WebClient(port).get("/readyz"); });
  }
  std::this_thread::sleep_for(1s);
  const Clock::time_point told = Clock::now();
  EXPECT_EQ(served.stopped(), 9);
  EXPECT_LT(Clock::now() - told, 25s);
  server().thaw();
  for (std::thread& page : pages) {
    page.join();
  }

  EXPECT_NE(served.errors().find("ended without it"), std::string::npos) << served.errors();
  EXPECT_FALSE(std::filesystem::exists(centre.folder() / "desk.json"))
      << "nobody is sent to a desk that ended";
}

/// Receives what a service tells systemd.
class ServiceManager {
 public:
  explicit ServiceManager(const std::filesystem::path& folder)
      : name_((folder / "notify").string()), socket_(socket(AF_UNIX, SOCK_DGRAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, name_.c_str(), sizeof address.sun_path - 1);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const timeval patience{.tv_sec = 30, .tv_usec = 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;
  ~ServiceManager() { close(socket_); }

  [[nodiscard]] std::string variable() const { return "NOTIFY_SOCKET=" + name_; }
  /// True once it was told this.
  [[nodiscard]] bool hears(const std::string& wanted) const {
    std::array<char, 1000> heard{};
    for (ssize_t bytes = 0; (bytes = recv(socket_, heard.data(), heard.size(), 0)) > 0;) {
      if (std::string(heard.data(), static_cast<std::size_t>(bytes)).find(wanted) != std::string::npos) {
        return true;
      }
    }
    return false;
  }

 private:
  std::string name_;
  int socket_;
};

TEST(ServiceOfSystemd, SaysThatItIsReadyAndAliveAndStopping) {
  ReviewCentre centre({.trial_s = 0.5});
  const ServiceManager manager(centre.folder());
  ServingProgram served(centre, {manager.variable()});

  EXPECT_TRUE(manager.hears("READY=1")) << served.errors();
  EXPECT_TRUE(manager.hears("WATCHDOG=1"));
  WebClient client(served.port());
  EXPECT_EQ(client.get("/healthz").headers.at("strict-transport-security"), "max-age=31536000")
      << "behind a proxy that encrypts";
  EXPECT_EQ(served.stopped(), 0);
  EXPECT_TRUE(manager.hears("STOPPING=1"));
}

}  // namespace
}  // namespace torsio::web
