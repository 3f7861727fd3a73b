// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated trackers based on the library's own classes, valid and misbehaving ones.

#include "app/connectors/tracker/tracker_link.h"

#include <arpa/inet.h>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <igtlImageMessage.h>
#include <igtlPositionMessage.h>
#include <igtlStatusMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>
#include <igtl_header.h>
#include <igtl_util.h>
#include <limits>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

#include <QTcpServer>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/connectors/tracker/igtl_messages.h"
#include "app/connectors/tracker/instrument_outlet.h"
#include "app/connectors/tracker/tracked_recording.h"
#include "app/connectors/tracker/tracker_clock.h"
#include "assessment/attempt/foreign_measures.h"
#include "sim/core/angle.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial.h"
#include "tests/support/fake_tracker.h"

namespace torsio {

namespace {

using testing::FakeTracker;

constexpr const char* kStylus = "StylusToReference";
constexpr std::chrono::milliseconds kStep{10};

bool becomes(const std::function<bool()>& done) {
  for (int tries = 0; tries < 2'000 && !done(); ++tries) {
    std::this_thread::sleep_for(kStep);
  }
  return done();
}

TrackerPlace placeOf(const FakeTracker& tracker) {
  return {.port = tracker.port()};
}

using Bytes = std::vector<std::byte>;

Bytes bytesOf(igtl::MessageBase& message) {
  message.Pack();
  const auto* const first = static_cast<const std::byte*>(message.GetPackPointer());
  return {first, first + message.GetPackSize()};
}

void addNumber(Bytes& bytes, std::uint64_t number, int count) {
  for (int i = count - 1; i >= 0; --i) {
    bytes.push_back(static_cast<std::byte>(number >> static_cast<unsigned>(8 * i)));
  }
}

/// The same message with the header of version 2: an extended header before the content, then for each entry
/// of the metadata the lengths of name and value with its encoding between them, then names and values.
Bytes extended(const Bytes& plain,
               const std::vector<std::pair<std::string, std::string>>& said = {{"TransformStatus", "OK"}}) {
  constexpr std::uint64_t kAscii = 3;  // MIBenum
  Bytes heads;
  Bytes words;
  addNumber(heads, said.size(), 2);
  for (const auto& [name, value] : said) {
    addNumber(heads, name.size(), 2);
    addNumber(heads, kAscii, 2);
    addNumber(heads, value.size(), 4);
    for (const char c : name + value) {
      words.push_back(static_cast<std::byte>(c));
    }
  }
  Bytes body;
  addNumber(body, 12, 2);
  addNumber(body, heads.size(), 2);
  addNumber(body, words.size(), 4);
  addNumber(body, 7, 4);  // number of the message
  body.insert(body.end(), plain.begin() + IGTL_HEADER_SIZE, plain.end());
  body.insert(body.end(), heads.begin(), heads.end());
  body.insert(body.end(), words.begin(), words.end());
  igtl_header head;
  std::memcpy(&head, plain.data(), sizeof head);
  igtl_header_convert_byte_order(&head);
  head.version = 2;
  head.body_size = body.size();
  head.crc = crc64(reinterpret_cast<unsigned char*>(body.data()), body.size(), 0);
  igtl_header_convert_byte_order(&head);
  Bytes message(sizeof head);
  std::memcpy(message.data(), &head, sizeof head);
  message.insert(message.end(), body.begin(), body.end());
  return message;
}

/// A TRANSFORM of version 2 with metadata, as PLUS and Slicer send it.
Bytes transformSaying(const std::string& name, const std::string& value) {
  const auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix;
  igtl::IdentityMatrix(matrix);
  message->SetDeviceName(kStylus);
  message->SetMatrix(matrix);
  return extended(bytesOf(*message), {{"Operator", "somebody"}, {name, value}});
}

/// A tracker of 100 Hz with regular timing: the instrument moves on a circle of 20 mm, twice per second.
class Circle {
 public:
  explicit Circle(FakeTracker& tracker) : tracker_(tracker) {}

  /// Returns the number of the next pose due after now.
  [[nodiscard]] int next() const { return static_cast<int>((clock_.now_us() - began_us_) / kEvery_us) + 2; }
  void send(int from, int count) {
    for (int i = from; i < from + count; ++i) {
      const std::int64_t wait_us = began_us_ + i * kEvery_us - clock_.now_us();
      std::this_thread::sleep_for(std::chrono::microseconds(wait_us));
      const double angle = 4.0 * M_PI * i / 100.0;
      ASSERT_TRUE(tracker_.sendTransform(kStylus, {20.0 * std::cos(angle), 20.0 * std::sin(angle), 5.0},
                                         sent_us_ + i * kEvery_us));
    }
  }

 private:
  static constexpr std::int64_t kEvery_us = 10'000;
  FakeTracker& tracker_;
  MonotonicClock clock_;
  std::int64_t began_us_ = clock_.now_us();
  std::int64_t sent_us_ = utcNow_us() + 3'600'000'000;  // its clock is an hour ahead
};

TEST(TrackerLink, ConnectsToATrackerAndReportsThePoseOfTheInstrument) {
  FakeTracker tracker;
  const TrackerLink link(placeOf(tracker));
  ASSERT_TRUE(tracker.wait());

  ASSERT_TRUE(tracker.sendStatus(13, "warming up"));
  ASSERT_TRUE(becomes([&] { return link.view().trouble.str() == "the tracker says: warming up"; }));
  ASSERT_TRUE(tracker.sendStatus(1, ""));
  ASSERT_TRUE(tracker.sendTransform(kStylus, {1.0, 2.0, 3.0}, 0));
  ASSERT_TRUE(tracker.sendTransform("ProbeToReference", {9.0, 9.0, 9.0}, 0));

  ASSERT_TRUE(becomes([&] { return link.view().instruments.size() == 2; }));
  const TrackerView view = link.view();
  EXPECT_EQ(view.stage, TrackerStage::kTracking);
  EXPECT_EQ(view.instrument, kStylus);  // the first one received
  EXPECT_NEAR(view.pose.position_m.y, 0.002, 1e-9);
  EXPECT_EQ(view.counts.received, 1);
  EXPECT_TRUE(view.trouble.empty());
}

TEST(TrackerLink, RequestsTrackingDataIfNothingArrives) {
  FakeTracker tracker;
  const TrackerLink link({.port = tracker.port(), .instrument = "Channel 0"});
  ASSERT_TRUE(tracker.wait());

  EXPECT_EQ(tracker.receive().kind, "STT_TDATA");
  ASSERT_TRUE(tracker.sendTracking("Channel 0", {4.0, 0.0, 0.0}, 0));
  EXPECT_TRUE(becomes([&] { return link.view().stage == TrackerStage::kTracking; }));
}

TEST(TrackerLink, ReconnectsWhenTheTrackerDisconnectsOrSendsGarbage) {
  FakeTracker tracker;
  const TrackerLink link(placeOf(tracker));
  ASSERT_TRUE(tracker.wait());
  tracker.hangUp();
  ASSERT_TRUE(becomes([&] { return link.view().trouble.str() == "the tracker ended the connection"; }));

  ASSERT_TRUE(tracker.wait());
  ASSERT_TRUE(tracker.sendBytes(std::string(200, '\xff')));
  ASSERT_TRUE(becomes([&] { return link.view().trouble.str() == "the data received are not OpenIGTLink"; }));
  EXPECT_EQ(link.view().stage, TrackerStage::kSeeking);

  ASSERT_TRUE(tracker.wait());
  ASSERT_TRUE(tracker.sendTransform(kStylus, {}, 0));
  EXPECT_TRUE(becomes([&] { return link.view().stage == TrackerStage::kTracking; }));
}

TEST(TrackerLink, CountsUnusablePoses) {
  FakeTracker tracker;
  const TrackerLink link(placeOf(tracker));
  ASSERT_TRUE(tracker.wait());

  ASSERT_TRUE(tracker.sendTransformWith(kStylus, std::nanf(""), 0));
  ASSERT_TRUE(tracker.sendTransformWith(kStylus, 0.3F, 0));
  ASSERT_TRUE(tracker.sendTransform(kStylus, {}, 5'000'000));
  ASSERT_TRUE(tracker.sendTransform(kStylus, {}, 5'000'000));  // a repeated time

  ASSERT_TRUE(becomes([&] { return link.view().counts.refused == 3; }));
  EXPECT_EQ(link.view().counts.received, 1);
}

TEST(TrackerLink, CountsPosesThatTheTrackerSaysAreNoneAsMissing) {
  FakeTracker tracker;
  const TrackerLink link(placeOf(tracker));
  ASSERT_TRUE(tracker.wait());
  const Bytes seen = transformSaying("TransformStatus", "OK");
  const Bytes lost = transformSaying("TransformStatus", "TOOL_OUT_OF_VIEW");
  const auto send = [&](const Bytes& bytes) {
    return tracker.sendBytes({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  };

  ASSERT_TRUE(send(seen) && send(lost) && send(lost));

  ASSERT_TRUE(becomes([&] { return link.view().counts.missing == 2; }));
  EXPECT_EQ(link.view().counts.received, 1);
  EXPECT_EQ(link.view().trouble.str(), "the tracker does not see the instrument: TOOL_OUT_OF_VIEW");
  ASSERT_TRUE(send(seen));
  EXPECT_TRUE(becomes([&] { return link.view().trouble.empty(); }));
}

TEST(TrackerLink, WaitsForATrackerThatConnects) {
  QTcpServer free;
  ASSERT_TRUE(free.listen(QHostAddress::LocalHost, 0));
  const std::uint16_t port = free.serverPort();
  free.close();
  const TrackerLink link({.port = port, .listens = true});
  FakeTracker tracker;
  ASSERT_TRUE(tracker.call(port));

  ASSERT_TRUE(tracker.sendTransform(kStylus, {}, 0));

  EXPECT_TRUE(becomes([&] { return link.view().stage == TrackerStage::kTracking; }));
  const TrackerLink second({.port = port, .listens = true});
  EXPECT_TRUE(becomes([&] { return !second.view().trouble.empty(); }));
  const TrackerLink elsewhere({.address = "no address", .port = port, .listens = true});
  EXPECT_TRUE(becomes([&] { return !elsewhere.view().trouble.empty(); }));
}

TEST(TrackerLink, NeverBlocksTheCaller) {
  FakeTracker hangs;  // its system accepts the connection, but nobody answers
  const MonotonicClock clock;
  const std::int64_t before_us = clock.now_us();
  for (int i = 0; i < 5; ++i) {
    const TrackerLink toWhoHangs(placeOf(hangs));
    const TrackerLink toNobody({.address = "192.0.2.1"});  // TEST-NET-1: nobody answers
    static_cast<void>(toNobody.view());
    static_cast<void>(toWhoHangs.view());
  }
  EXPECT_LT(clock.now_us() - before_us, 30'000'000);  // ten destructors of half a second, and a busy machine
}

TEST(TrackedRecording, IsMeasuredLikeAnyPathOnTheClockOfTheStation) {
  FakeTracker tracker;
  TrackerLink link({.port = tracker.port(), .instrument = kStylus});
  ASSERT_TRUE(tracker.wait());
  Circle circle(tracker);
  circle.send(0, 25);
  ASSERT_TRUE(becomes([&] { return link.view().counts.received == 25; }));  // none is in transit
  ASSERT_TRUE(link.view().period_us.has_value());

  auto sink = std::make_unique<MemoryTrialSink>();
  const MemoryTrialSink& kept = *sink;
  TrackedRecording recording(
      link, link.view(), {.trialId = "tracked", .phaseLabel = "real", .startedUtc_us = 7}, std::move(sink));
  const int first = circle.next();
  circle.send(first, 40);
  circle.send(first + 41, 60);  // one is missing
  ASSERT_TRUE(becomes([&] { return link.view().counts.received == 125; }));
  const RecordingResult result = recording.finish(TrialOutcome::kCompleted);

  const Trial& trial = kept.trial();
  EXPECT_TRUE(isForeign(trial.header.sceneId));
  EXPECT_EQ(trial.header.tickPeriod_us, 10'000);
  EXPECT_EQ(trial.header.startedUtc_us, 7);
  EXPECT_EQ(trial.summary.lateTicks, result.summary.lateTicks);
  EXPECT_EQ(trial.summary.refusedSamples, 0);
  const std::vector<Sample> samples = decodeTrial(trial);
  ASSERT_EQ(samples.size(), 100U);
  const Outcome<TrialMetrics> measured = measureForeign(trial.header, samples);
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->lostSamples, 1U);
  const double span_s =
      static_cast<double>(samples.back().device.time_us - samples.front().device.time_us) * 1e-6;
  EXPECT_NEAR(*measured->at(Quantity::kTime), span_s, 1e-9);
  EXPECT_NEAR(span_s, 1.0, 0.2);
  const double path_m = 0.020 * 4.0 * M_PI * span_s;
  EXPECT_NEAR(*measured->at(Quantity::kTipPath), path_m, 0.1 * path_m);
  EXPECT_EQ(measured->at(Quantity::kSparc).reason(), "not applicable: foreign recording");
  EXPECT_EQ(measured->at(Quantity::kPeakForce).reason(), "not applicable: foreign recording");
}

constexpr std::int64_t kAhead_us = 3'600'000'000;  // offset of the sender's clock

/// Feeds poses at 50 Hz with a latency of 2 ms.
std::int64_t feed(TrackerClock& clock, std::int64_t from_us, int count) {
  std::int64_t now_us = from_us;
  for (int i = 0; i < count; ++i, now_us += 20'000) {
    EXPECT_TRUE(clock.take(now_us + kAhead_us, now_us + 2'000));
  }
  return now_us;
}

TEST(TrackerClock, ConvertsTimesOfTheSenderToTheClockOfTheStation) {
  TrackerClock clock;
  std::int64_t now_us = feed(clock, 0, 30);
  const auto moment = clock.take(now_us + kAhead_us, now_us + 9'000);  // 7 ms later than the others
  ASSERT_TRUE(moment);
  EXPECT_NEAR(static_cast<double>(moment->time_us), static_cast<double>(now_us + 2'000), 100.0);
  EXPECT_FALSE(moment->late);
  EXPECT_EQ(moment->place, 30);
  EXPECT_EQ(clock.period_us(), 20'000);
  EXPECT_TRUE(clock.stamped());
}

TEST(TrackerClock, CountsLateAndMissingPoses) {
  TrackerClock clock;
  const std::int64_t now_us = feed(clock, 0, 30);
  const auto late = clock.take(now_us + 60'000 + kAhead_us, now_us + 60'000 + 53'000);
  ASSERT_TRUE(late);
  EXPECT_TRUE(late->late);
  EXPECT_EQ(late->place, 33);                                               // 30, 31 and 32 are missing
  EXPECT_FALSE(clock.take(now_us + 60'000 + kAhead_us, now_us + 120'000));  // a repeated pose
}

TEST(TrackerClock, FollowsAClockThatDriftsOrIsSet) {
  TrackerClock clock;
  std::int64_t now_us = feed(clock, 0, 30);
  for (int i = 0; i < 50 * 600; ++i, now_us += 20'000) {  // ten minutes, drifting by 50 us per second
    const std::int64_t sent_us = now_us - now_us / 20'000 + kAhead_us;
    const auto moment = clock.take(sent_us, now_us + 2'000);
    ASSERT_TRUE(moment);
    EXPECT_FALSE(moment->late);
    EXPECT_NEAR(static_cast<double>(moment->time_us), static_cast<double>(now_us + 2'000), 3'000.0);
  }
  const auto back = clock.take(now_us, now_us + 2'000);  // by an hour
  ASSERT_TRUE(back);
  const auto forth = clock.take(now_us + 20'000 + 2 * kAhead_us, now_us + 22'000);
  ASSERT_TRUE(forth);
  EXPECT_EQ(forth->place - back->place, 1);  // none missing
  EXPECT_FALSE(forth->late);
}

TEST(TrackerClock, UsesTheArrivalIfTheSenderGivesNoTime) {
  TrackerClock clock;
  std::int64_t now_us = 1'000;
  for (int i = 0; i < 30; ++i, now_us += 10'000) {
    EXPECT_EQ(clock.take({}, now_us)->time_us, now_us);
  }
  const auto late = clock.take({}, now_us + 80'000);
  EXPECT_TRUE(late->late);
  EXPECT_EQ(late->place, 30);  // missing poses are unknown
  EXPECT_FALSE(clock.stamped());
  EXPECT_EQ(clock.period_us(), 10'000);
  EXPECT_EQ(clock.take({}, now_us + 80'000)->time_us, late->time_us + 1);  // two at the same time: times
                                                                           // still increase
}

std::uint16_t freePort() {
  QTcpServer free;
  free.listen(QHostAddress::LocalHost, 0);
  return free.serverPort();
}

bool comes(const InstrumentOutlet& outlet, std::int64_t watchers) {
  return becomes([&] { return outlet.view().watchers == watchers; });
}

/// Connects with a small receive buffer and never reads.
int sleeper(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const int little = 4'096;
  ::setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &little, sizeof little);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(port);
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (int tries = 0; tries < 400; ++tries) {
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) {
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return socket;
}

TEST(InstrumentOutlet, SendsTheInstrumentAndItsEventsToViewers) {
  const std::uint16_t port = freePort();
  InstrumentOutlet outlet("127.0.0.1", port);
  FakeTracker slicer;
  ASSERT_TRUE(slicer.call(port));
  ASSERT_TRUE(comes(outlet, 1));

  LiveState state;
  state.tool.position_m = {0.010, -0.020, 0.030};  // left 10, front 20, head 30 mm
  state.phase = ExercisePhase::kTwisting;
  state.response.angle_rad = radians(91.84);
  outlet.show(state);
  const FakeTracker::Message pose = slicer.receive();
  const FakeTracker::Message grips = slicer.receive();
  state.phase = ExercisePhase::kReleased;
  state.response.angle_rad = 0.0;
  outlet.show(state);
  static_cast<void>(slicer.receive());
  const FakeTracker::Message letsGo = slicer.receive();

  EXPECT_EQ(pose.kind, "TRANSFORM");
  EXPECT_EQ(pose.device, "TorsioInstrument");
  EXPECT_EQ(pose.content, "-10.0 20.0 30.0");  // right, front, head
  EXPECT_EQ(grips.kind, "STRING");
  EXPECT_EQ(grips.device, "TorsioEvent");
  EXPECT_EQ(grips.content, "grips");
  EXPECT_EQ(letsGo.content, "lets go at 91.8 deg");
  slicer.hangUp();
  EXPECT_TRUE(comes(outlet, 0));
}

TEST(InstrumentOutlet, SkipsPosesForViewersThatDoNotRead) {
  const std::uint16_t port = freePort();
  InstrumentOutlet outlet("127.0.0.1", port);
  const int asleep = sleeper(port);
  ASSERT_TRUE(comes(outlet, 1));

  LiveState state;
  for (int i = 0; i < 100'000 && outlet.view().left == 0; ++i) {
    outlet.show(state);
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }

  EXPECT_GT(outlet.view().left, 0);
  FakeTracker awake;
  ASSERT_TRUE(awake.call(port));
  ASSERT_TRUE(comes(outlet, 2));
  outlet.show(state);
  EXPECT_EQ(awake.receive().kind, "TRANSFORM");
  ::close(asleep);
}

TEST(InstrumentOutlet, ReportsWhyNobodyCanConnect) {
  const std::uint16_t port = freePort();
  const InstrumentOutlet first("127.0.0.1", port);
  FakeTracker slicer;
  ASSERT_TRUE(slicer.call(port));
  const InstrumentOutlet second("127.0.0.1", port);
  const InstrumentOutlet nowhere("not here", port);
  for (int tries = 0; tries < 2'000 && (second.view().trouble.empty() || nowhere.view().trouble.empty());
       ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(second.view().trouble.empty());
  EXPECT_FALSE(nowhere.view().trouble.empty());
}

// Decoding of messages encoded by the library; the outlet's tests go the other way.

/// Rotated by 90 degrees about z, and shifted.
Bytes transform(float x_mm = 10.0F, float first = 0.0F) {
  const auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix{{first, -1, 0, x_mm}, {1, 0, 0, 20}, {0, 0, 1, -30}, {0, 0, 0, 1}};
  message->SetDeviceName("StylusToReference");
  message->SetMatrix(matrix);
  message->SetTimeStamp(1'700'000'000, 0x80000000U);
  return bytesOf(*message);
}

IgtlNews read(const Bytes& bytes) {
  IgtlReader reader;
  IgtlNews news;
  reader.take(bytes, news);
  return news;
}

TEST(IgtlMessages, DecodeWhatTheLibraryEncodes) {
  const IgtlNews news = read(transform());

  ASSERT_EQ(news.poses.size(), 1U);
  const TrackedPose& pose = news.poses[0];
  EXPECT_EQ(pose.instrument, "StylusToReference");
  EXPECT_EQ(pose.sent_us, 1'700'000'000'500'000);
  EXPECT_NEAR(pose.pose.position_m.x, 0.010, 1e-9);
  EXPECT_NEAR(pose.pose.position_m.z, -0.030, 1e-9);
  const Vec3 turned = rotate(pose.pose.orientation, {1.0, 0.0, 0.0});
  EXPECT_NEAR(turned.y, 1.0, 1e-9);
  EXPECT_EQ(news.refused + news.others, 0);
}

TEST(IgtlMessages, DecodeTrackingDataOfSeveralInstruments) {
  const auto message = igtl::TrackingDataMessage::New();
  message->SetDeviceName("Tracker");
  message->SetTimeStamp(0, 0);
  for (int i = 0; i < 3; ++i) {
    igtl::TrackingDataElement::Pointer element = igtl::TrackingDataElement::New();
    igtl::Matrix4x4 matrix;
    igtl::IdentityMatrix(matrix);
    matrix[1][3] = static_cast<float>(i);
    element->SetName(("Channel " + std::to_string(i)).c_str());
    element->SetMatrix(matrix);
    message->AddTrackingDataElement(element);
  }

  const IgtlNews news = read(bytesOf(*message));

  ASSERT_EQ(news.poses.size(), 3U);
  EXPECT_EQ(news.poses[2].instrument, "Channel 2");
  EXPECT_NEAR(news.poses[2].pose.position_m.y, 0.002, 1e-9);
  EXPECT_FALSE(news.poses[2].sent_us);  // sent without a time
}

TEST(IgtlMessages, DecodeAStatusAndSkipOtherMessages) {
  const auto status = igtl::StatusMessage::New();
  status->SetCode(igtl::StatusMessage::STATUS_NOT_READY);
  status->SetStatusString("the coil is\nwarm");
  Bytes bytes = bytesOf(*status);
  const auto image = igtl::ImageMessage::New();
  image->SetDimensions(640, 480, 1);
  image->SetScalarType(igtl::ImageMessage::TYPE_UINT8);
  image->AllocateScalars();
  for (const Bytes& next : {bytesOf(*image), transform()}) {
    bytes.insert(bytes.end(), next.begin(), next.end());
  }

  const IgtlNews news = read(bytes);

  EXPECT_EQ(news.status, "the coil is warm");
  EXPECT_EQ(news.others, 1);
  EXPECT_EQ(news.poses.size(), 1U);
}

TEST(IgtlMessages, DoNotDependOnHowTheBytesAreSplit) {
  Bytes bytes = transform(1.0F);
  const Bytes second = transform(2.0F);
  bytes.insert(bytes.end(), second.begin(), second.end());
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    IgtlReader reader;
    IgtlNews news;
    reader.take(std::span(bytes).first(cut), news);
    reader.take(std::span(bytes).subspan(cut), news);
    ASSERT_EQ(news.poses.size(), 2U) << cut;
    EXPECT_NEAR(news.poses[1].pose.position_m.x, 0.002, 1e-9);
  }
}

TEST(IgtlMessages, HearWhatASenderSaysOfAPose) {
  struct Case {
    const char* name;
    const char* value;
    const char* lost;
  };
  for (const Case& one : {Case{"TransformStatus", "OK", ""},
                          {"TransformStatus", "TOOL_OUT_OF_VIEW", "TOOL_OUT_OF_VIEW"},
                          {"TransformStatus", "OUT_OF_VOLUME", "OUT_OF_VOLUME"},
                          {"TransformStatus", "TOOL_SWITCH1_IS_ON", ""},
                          {"TransformValid", "true", ""},
                          {"TransformValid", "0", "TransformValid = 0"},
                          {"StylusToReferenceStatus", "INVALID", "INVALID"},
                          {"ProbeToReferenceStatus", "INVALID", ""},
                          {"Status", "in\x1b[2Jview", "in\xef\xbf\xbd[2Jview"}}) {
    const IgtlNews news = read(transformSaying(one.name, one.value));
    ASSERT_EQ(news.poses.size(), 1U) << one.name;
    EXPECT_EQ(news.poses[0].lost, one.lost) << one.name;
  }
}

TEST(IgtlMessages, DecodeAPositionWithItsRotation) {
  const auto message = igtl::PositionMessage::New();
  message->SetDeviceName("Stylus");
  message->SetPosition(10.0F, 20.0F, -30.0F);
  message->SetQuaternion(0.0F, 0.0F, 0.70710678F, 0.70710678F);

  const IgtlNews news = read(bytesOf(*message));

  ASSERT_EQ(news.poses.size(), 1U);
  EXPECT_NEAR(news.poses[0].pose.position_m.z, -0.030, 1e-9);
  EXPECT_NEAR(rotate(news.poses[0].pose.orientation, {1.0, 0.0, 0.0}).y, 1.0, 1e-6);
}

TEST(IgtlMessages, DecodeTheHeaderOfVersionTwoThatSlicerAndPlusSend) {
  const IgtlNews news = read(extended(transform()));

  ASSERT_EQ(news.poses.size(), 1U);
  EXPECT_NEAR(news.poses[0].pose.position_m.x, 0.010, 1e-9);
}

TEST(IgtlMessages, RejectDamagedMessagesAndContinueAfterThem) {
  Bytes damaged = transform();
  damaged.back() ^= std::byte{1};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Bytes bytes;
  for (const Bytes& next : {damaged, transform(nan), transform(1e9F), transform(10.0F, 0.5F), transform()}) {
    bytes.insert(bytes.end(), next.begin(), next.end());
  }

  const IgtlNews news = read(bytes);

  EXPECT_EQ(news.refused, 4);
  EXPECT_EQ(news.poses.size(), 1U);
}

TEST(IgtlMessages, ImpossibleSizesAreRejectedOrEndTheConnection) {
  Bytes extendedTooFar = extended(transform());
  extendedTooFar[IGTL_HEADER_SIZE + 4] = std::byte{0xff};  // metadata of 4 GiB; the checksum fails first
  EXPECT_EQ(read(extendedTooFar).refused, 1);
  Bytes huge = transform();
  huge[42] = std::byte{0x7f};  // first byte of the size
  EXPECT_THROW(read(huge), Error);
  const std::string page = "HTTP/1.1 400 Bad Request\r\nContent-Type: text/html\r\nConnection: close\r\n\r\n";
  Bytes rubbish;
  for (const char c : page) {
    rubbish.push_back(static_cast<std::byte>(c));
  }
  EXPECT_THROW(read(rubbish), Error);
  EXPECT_THROW(read(Bytes(58)), Error);
}

TEST(IgtlMessages, EncodedMessagesAreDecodedAgain) {
  const Pose pose{{0.01, -0.02, 0.03}, axisAngle({0.0, 0.6, 0.8}, 1.1)};

  const IgtlNews news = read(igtlTransform("TorsioInstrument", pose, 1'700'000'000'250'000));

  ASSERT_EQ(news.poses.size(), 1U);
  EXPECT_EQ(news.poses[0].sent_us, 1'700'000'000'250'000);
  EXPECT_NEAR(norm(news.poses[0].pose.position_m - pose.position_m), 0.0, 1e-8);
  EXPECT_NEAR(std::abs((conjugate(pose.orientation) * news.poses[0].pose.orientation).w), 1.0, 1e-9);
  EXPECT_EQ(read(igtlString("TorsioEvent", "touches", 0)).others, 1);
}

}  // namespace

}  // namespace torsio
