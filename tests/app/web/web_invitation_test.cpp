// SPDX-License-Identifier: GPL-3.0-or-later
// Invitation links created in a browser by one or two people, mailed and revoked; browser sessions ended at
// the desk.
#include <string>

#include <gtest/gtest.h>

#include "app/connectors/mail/mailing.h"
#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/system/setting_repository.h"
#include "tests/app/web/served_desk.h"
#include "tests/support/fake_mail_server.h"

namespace torsio::web {
namespace {

using nlohmann::json;
using torsio::testing::FakeMailServer;

class WebInvitation : public ::testing::Test {
 protected:
  WebInvitation() {
    AccessRepository access(served.centre.connection(), PasswordCost::kTest);
    access.addUser({.id = "u-second", .login = "second", .roles = {"administrator"}}, kWebPassword);
    access.setPassword("u-second", access.sealPassword("second", kWebPassword), false);
    SettingRepository(served.centre.connection()).set(kTwoPeople.name, "no", 0);
  }
  WebClient signedIn(const std::string& login) { return served.signedIn(login); }
  static json lineOf(WebClient& client, const std::string& login) {
    const json all = client.get("/api/invitations").json();
    for (const json& one : all.at("people")) {
      if (one.at("login") == login) {
        return one;
      }
    }
    return nullptr;
  }
  static json usersOf(WebClient& client, const std::string& login) {
    return {{{"user", lineOf(client, login).at("user")}}};
  }
  int join(const std::string& secret, const std::string& code = "") {
    WebClient client = served.client();
    return client
        .send("POST", "/api/join", {{"token", secret}, {"code", code}, {"newPassword", kChosenPassword}})
        .status;
  }
  static std::string secretOf(const std::string& link) { return link.substr(link.find('#') + 1); }

  ServedDesk served;
};

TEST_F(WebInvitation, IsShownOnceAndRevoked) {
  WebClient office = signedIn("office");
  EXPECT_EQ(lineOf(office, "office"), nullptr) << "nobody invites himself";

  const DeskAnswer made = office.send("POST", "/api/invitations", {{"users", usersOf(office, "physician0")}});
  ASSERT_EQ(made.status, 200) << made.body;
  const json card = made.json().at("cards").at(0);
  const std::string link = card.at("link");
  EXPECT_EQ(link.find("http://127.0.0.1:"), 0U) << link;
  EXPECT_NE(card.at("words").get<std::string>().find(link), std::string::npos);
  EXPECT_NE(card.at("words").get<std::string>().find("physician0"), std::string::npos);
  EXPECT_EQ(card.at("mail"), nullptr) << "nobody asked for a mail";
  EXPECT_EQ(office.get("/api/invitations").body.find(secretOf(link)), std::string::npos);
  EXPECT_TRUE(lineOf(office, "physician0").at("until_utc_us").is_number());

  const json users{{"users", usersOf(office, "physician0")}};
  EXPECT_EQ(office.send("POST", "/api/invitations/revoke", users).status, 400) << "not without a reason";
  json order = users;
  order["reason"] = "sent to the wrong address";
  EXPECT_EQ(office.send("POST", "/api/invitations/revoke", order).status, 200);
  EXPECT_EQ(join(secretOf(link)), 401);
  EXPECT_EQ(lineOf(office, "physician0").at("until_utc_us"), nullptr);
}

TEST_F(WebInvitation, NeedsTwoPeopleIfTheCentreRequiresIt) {
  SettingRepository(served.centre.connection()).set(kTwoPeople.name, "yes", 0);
  WebClient office = signedIn("office");
  WebClient second = signedIn("second");
  json order{{"users", usersOf(office, "physician0")}};
  EXPECT_TRUE(lineOf(office, "physician0").at("by_two"));
  EXPECT_EQ(office.send("POST", "/api/invitations", order).status, 400) << "not without a reason";
  order["reason"] = "first visit";
  const json asked = office.send("POST", "/api/invitations", order).json().at("cards").at(0);
  EXPECT_EQ(asked.at("link"), "");
  const std::string code = asked.at("code");
  EXPECT_NE(asked.at("words").get<std::string>().find(code), std::string::npos);

  const json own = office.get("/api/invitations").json().at("waiting").at(0);
  EXPECT_TRUE(own.at("own"));
  EXPECT_EQ(office.send("POST", "/api/invitations/confirm", {{"request", own.at("request")}}).status, 403);
  EXPECT_EQ(office.get("/api/me").json().at("user").at("invitations_wait"), 0) << "their own";
  EXPECT_EQ(second.get("/api/me").json().at("user").at("invitations_wait"), 1);
  EXPECT_EQ(second.get("/api/me").json().at("user").at("requests_wait"),
            "A request waits for you as the second person: Users, Requests");
  const json theirs = second.get("/api/invitations").json().at("waiting").at(0);
  EXPECT_EQ(theirs.at("by"), "office");
  const DeskAnswer confirmed =
      second.send("POST", "/api/invitations/confirm", {{"request", theirs.at("request")}});
  ASSERT_EQ(confirmed.status, 200) << confirmed.body;
  const std::string secret = secretOf(confirmed.json().at("cards").at(0).at("link"));
  ASSERT_EQ(secret.rfind("2.", 0), 0U) << "its page asks for the code";
  EXPECT_EQ(confirmed.body.find(code), std::string::npos);

  EXPECT_EQ(join(secret.substr(2)), 401) << "without the code";
  EXPECT_EQ(join(secret.substr(2), code), 200);
}

TEST_F(WebInvitation, IsMailedIfTheCentreHasAServer) {
  WebClient office = signedIn("office");
  EXPECT_FALSE(office.get("/api/invitations").json().at("mail"));
  json order{{"users", usersOf(office, "physician0")}, {"mail_password", ""}};
  EXPECT_NE(office.send("POST", "/api/invitations", order).json().at("cards").at(0).at("mail"), "")
      << "no server: the link is shown all the same, and why it was not sent";

  Connection& connection = served.centre.connection();
  PeopleRepository(connection)
      .setIdentity({served.centre.physician(0)->actor().personId, "A. Physician", "a.physician@example.org",
                    "staff-1"});
  FakeMailServer server;
  MailSettings settings{.from = "office@example.org"};
  settings.server = {.host = "127.0.0.1", .port = server.port(), .encryption = MailEncryption::kNone};
  setMailSettings(*served.centre.administrator(), settings);
  EXPECT_TRUE(office.get("/api/invitations").json().at("mail"));
  order["users"] = {usersOf(office, "physician0").at(0), usersOf(office, "physician1").at(0)};

  const json cards = office.send("POST", "/api/invitations", order).json().at("cards");

  EXPECT_EQ(cards.at(0).at("mail"), "");
  EXPECT_EQ(cards.at(1).at("mail"), "no mail address is known");
  ASSERT_EQ(server.taken().size(), 1U);
  EXPECT_EQ(server.taken().at(0).to, "a.physician@example.org");
  EXPECT_EQ(join(secretOf(cards.at(0).at("link"))), 200);
}

TEST_F(WebInvitation, BrowserSessionsAreEndedAtTheDesk) {
  WebClient one = served.physician(0);
  WebClient other = served.physician(1);
  const auto office = served.centre.administrator();

  endBrowserSessions(*office, served.centre.physician(0)->actor().userId);

  EXPECT_EQ(one.get("/api/queue").status, 401);
  EXPECT_EQ(other.get("/api/queue").status, 200);
  EXPECT_EQ(served.physician(0).get("/api/queue").status, 200) << "the account is as it was";
}

}  // namespace
}  // namespace torsio::web
