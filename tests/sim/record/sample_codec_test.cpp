// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/sample_codec.h"

#include <array>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/random.h"
#include "sim/record/column_codec.h"
#include "tests/sim/record/samples.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

std::vector<std::int64_t> roundTrip(const std::vector<std::int64_t>& column,
                                    std::size_t* packedSize = nullptr) {
  std::vector<std::uint8_t> packed;
  packColumn(column, packed);
  EXPECT_LE(packed.size(), largestPackedColumn(column.size()));
  if (packedSize != nullptr) {
    *packedSize = packed.size();
  }
  std::vector<std::int64_t> back(column.size());
  EXPECT_TRUE(unpackColumn(packed, back).empty());
  return back;
}

TEST(ColumnCodec, RoundTripsTheExtremesOfSixtyFourBits) {
  constexpr auto kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  for (const std::vector<std::int64_t>& column :
       {std::vector<std::int64_t>{kLeast, kMost, kLeast, kMost, 0, -1},
        {kMost},
        {0},
        {kLeast, kLeast},
        {1, 2, 3, 4, 5},
        {0, 0, 0, 0, 0, 0, kMost}}) {
    EXPECT_EQ(roundTrip(column), column);
  }
}

TEST(ColumnCodec, RoundTripsRandomColumnsOfEveryRoughness) {
  Random random(1);
  for (int bits = 1; bits <= 64; ++bits) {
    std::vector<std::int64_t> column(257);
    for (std::int64_t& value : column) {
      value = static_cast<std::int64_t>(random.next() >> (64 - bits)) - (bits < 64 ? 1LL << (bits - 1) : 0);
    }
    ASSERT_EQ(roundTrip(column), column) << bits << " bits";
  }
}

TEST(ColumnCodec, TakesNothingPerSampleForColumnsThatAPolynomialDescribes) {
  std::vector<std::int64_t> cubic(1000);
  for (std::int64_t i = 0; i < 1000; ++i) {
    cubic[static_cast<std::size_t>(i)] = 7 * i * i * i - 40 * i * i + 3;
  }
  std::size_t size = 0;

  EXPECT_EQ(roundTrip(cubic, &size), cubic);

  EXPECT_LT(size, 20U);
}

TEST(SampleCodec, GivesBackEveryIntegerExactlyAndEveryAnswerInItsStep) {
  const std::vector<Sample> samples = twistSamples(1000);

  const std::vector<Sample> back = decodeChunk(encodeChunk(0, samples));

  ASSERT_EQ(back.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(back[i], inStoredSteps(samples[i])) << "sample " << i;
    ASSERT_EQ(back[i].device, samples[i].device);
    ASSERT_EQ(back[i].command, samples[i].command);
    ASSERT_NEAR(back[i].response.angle_rad, samples[i].response.angle_rad, 0.5001 * kAngleStep_rad);
    ASSERT_NEAR(back[i].response.torque_Nm, samples[i].response.torque_Nm, 0.5001 * kTorqueStep_Nm);
    ASSERT_NEAR(back[i].response.depth_m, samples[i].response.depth_m, 0.5001 * kDepthStep_m);
    ASSERT_NEAR(back[i].response.graspArc_m, samples[i].response.graspArc_m, 0.5001 * kArcStep_m);
    ASSERT_NEAR(norm(back[i].force_N - samples[i].force_N), 0.0, kForceStep_N);
  }
}

TEST(SampleCodec, GivesTheSameBytesForTheSameSamples) {
  const std::vector<Sample> samples = twistSamples(1000);

  const TrialChunk a = encodeChunk(3, samples);
  const TrialChunk b = encodeChunk(3, samples);

  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_EQ(a.digest, b.digest);
  EXPECT_EQ(a.outputDigest, b.outputDigest);
}

TEST(SampleCodec, RoundTripsSamplesOfPureNoise) {
  Random random(2);
  std::vector<Sample> samples(500);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = noiseSample(static_cast<std::int64_t>(3 * i), random);
  }

  const std::vector<Sample> back = decodeChunk(encodeChunk(0, samples));

  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(back[i], inStoredSteps(samples[i]));
  }
}

TEST(SampleCodec, KeepsAnHourOfTwistingBelowSixtyMegabytes) {
  // Sixty seconds of a smooth hand with tremor stand for the hour; the recorder's other bytes (digests and
  // lengths) are below 300 a chunk.
  double bytes = 0.0;
  const std::vector<Sample> samples = twistSamples(60'000);
  for (std::size_t second = 0; second < 60; ++second) {
    bytes += 300.0 + static_cast<double>(
                         encodeChunk(0, std::span(samples).subspan(1000 * second, 1000)).bytes.size());
  }

  EXPECT_LT(bytes / 60.0 * 3600.0, 60e6);
}

TEST(SampleCodec, SeesTheLastBitOfEveryExactAnswerInItsDigest) {
  const std::vector<Sample> samples = twistSamples(100);
  const std::string digest = outputDigest(samples);
  const auto changed = [&samples](auto select) {
    std::vector<Sample> copy = samples;
    double& value = select(copy[50]);
    value = std::nextafter(value, 1e9);
    return outputDigest(copy);
  };

  EXPECT_NE(digest, changed([](Sample& s) -> double& { return s.response.angle_rad; }));
  EXPECT_NE(digest, changed([](Sample& s) -> double& { return s.response.torque_Nm; }));
  EXPECT_NE(digest, changed([](Sample& s) -> double& { return s.response.force_N.y; }));
  EXPECT_NE(digest, changed([](Sample& s) -> double& { return s.response.depth_m; }));
  EXPECT_NE(digest, changed([](Sample& s) -> double& { return s.response.graspArc_m; }));
  EXPECT_NE(digest, changed([](Sample& s) -> double& { return s.force_N.z; }));
}

TEST(SampleCodec, KeepsAHollowOrganInColumnsOfItsOwnAndLeavesOtherChunksAsTheyWere) {
  const std::vector<Sample> samples = detorsionSamples(1000);
  const TrialChunk hollow = encodeChunk(0, samples);
  const TrialChunk plain = encodeChunk(0, twistSamples(1000));

  const std::vector<Sample> back = decodeChunk(hollow);

  EXPECT_EQ(hollow.bytes[4], std::byte{3});
  EXPECT_EQ(plain.bytes[4], std::byte{1});
  EXPECT_EQ(decodeChunk(plain).front().hollow, HollowReading{});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(back[i], inStoredSteps(samples[i]));
    ASSERT_NEAR(back[i].hollow.pressure_Pa, samples[i].hollow.pressure_Pa, 0.501 * kPressureStep_Pa);
    ASSERT_NEAR(back[i].hollow.patency, samples[i].hollow.patency, 0.501 * kShareStep);
    ASSERT_NEAR(back[i].hollow.flow, samples[i].hollow.flow, 0.501 * kShareStep);
    ASSERT_NEAR(back[i].hollow.dose, samples[i].hollow.dose, 0.501 * kDoseStep);
  }
  EXPECT_EQ(back.back().command, samples.back().command);
}

TEST(SampleCodec, SeesTheLastBitOfAHollowOrganInItsDigestWhereTheRulesKnowOne) {
  const std::vector<Sample> samples = detorsionSamples(100);
  const std::string digest = outputDigest(samples);
  const auto changed = [](std::vector<Sample> copy, auto select) {
    double& value = select(copy[50].hollow);
    value = std::nextafter(value, 1e9);
    return outputDigest(copy);
  };
  const auto pressure = [](HollowReading& h) -> double& { return h.pressure_Pa; };

  EXPECT_NE(digest, changed(samples, pressure));
  EXPECT_NE(digest, changed(samples, [](HollowReading& h) -> double& { return h.patency; }));
  EXPECT_NE(digest, changed(samples, [](HollowReading& h) -> double& { return h.flow; }));
  EXPECT_NE(digest, changed(samples, [](HollowReading& h) -> double& { return h.dose; }));
  EXPECT_EQ(outputDigest(twistSamples(100)), changed(twistSamples(100), pressure));
}

TEST(SampleCodec, RefusesToEncodeNothing) {
  EXPECT_THROW((void)encodeChunk(0, {}), ContractError);
}

ErrorCode refusal(const TrialChunk& chunk) {
  return testing::refusalCode([&] { return decodeChunk(chunk); });
}

TEST(SampleCodec, RefusesAChunkWhoseBytesDoNotMatchItsDigest) {
  const TrialChunk good = encodeChunk(0, twistSamples(100));
  TrialChunk flipped = good;
  flipped.bytes[flipped.bytes.size() / 2] ^= std::byte{1};
  TrialChunk renumbered = good;
  renumbered.index = 1;
  TrialChunk counted = good;
  counted.samples = 99;
  TrialChunk endless = good;
  endless.samples = std::numeric_limits<std::int64_t>::max();

  for (const TrialChunk& bad : {flipped, renumbered, counted, endless}) {
    EXPECT_EQ(refusal(bad), ErrorCode::kBadData);
  }
}

TEST(SampleCodec, RefusesAnotherFormatVersionInPlainWords) {
  TrialChunk chunk = encodeChunk(0, twistSamples(100));
  chunk.bytes[4] = std::byte{4};
  chunk.digest = chunkDigest(chunk);
  const Error error = testing::refusal([&] { return decodeChunk(chunk); });
  EXPECT_EQ(error.code(), ErrorCode::kBadData);
  EXPECT_NE(error.happened().find("version"), std::string::npos);
}

TEST(SampleCodec, RefusesEveryTruncation) {
  for (const TrialChunk& good : {encodeChunk(0, twistSamples(60)), encodeChunk(0, detorsionSamples(60))}) {
    for (std::size_t size = 0; size < good.bytes.size(); ++size) {
      TrialChunk cut = good;
      cut.bytes.resize(size);
      cut.digest = chunkDigest(cut);  // the digest is right: the decoder itself must see it
      ASSERT_EQ(refusal(cut), ErrorCode::kBadData) << size << " bytes";
    }
  }
}

TEST(SampleCodec, RefusesAHollowOrganThatMakesNoSense) {
  const auto with = [](const HollowReading& reading) {
    std::vector<Sample> samples = detorsionSamples(20);
    samples[7].hollow = reading;
    return encodeChunk(0, samples);
  };

  EXPECT_EQ(refusal(with({-1.0, 1.0, 1.0, 0.0})), ErrorCode::kBadData);
  EXPECT_EQ(refusal(with({1e9, 1.0, 1.0, 0.0})), ErrorCode::kBadData);
  EXPECT_EQ(refusal(with({0.0, 1.1, 1.0, 0.0})), ErrorCode::kBadData);
  EXPECT_EQ(refusal(with({0.0, -0.1, 1.0, 0.0})), ErrorCode::kBadData);
  EXPECT_EQ(refusal(with({0.0, 1.0, 1.1, 0.0})), ErrorCode::kBadData);
  EXPECT_EQ(refusal(with({0.0, 1.0, -0.1, 0.0})), ErrorCode::kBadData);
  EXPECT_EQ(refusal(with({0.0, 1.0, 1.0, -0.1})), ErrorCode::kBadData);
  EXPECT_EQ(refusal(with({0.0, 1.0, 1.0, 0.0})), ErrorCode::kInternal);  // taken
}

TEST(SampleCodec, SurvivesRandomDamageBehindAValidDigest) {
  const std::array good{encodeChunk(0, twistSamples(200)), encodeChunk(0, detorsionSamples(200))};
  const std::array samples{decodeChunk(good[0]), decodeChunk(good[1])};
  Random random(3);
  int refused = 0;
  for (std::size_t round = 0; round < 20'000; ++round) {
    TrialChunk bad = good.at(round % 2);
    for (std::uint64_t n = 1 + random.bounded(4); n > 0; --n) {
      bad.bytes[random.bounded(bad.bytes.size())] = static_cast<std::byte>(random.bounded(256));
    }
    if (random.bounded(4) == 0) {
      bad.samples = static_cast<std::int64_t>(1 + random.bounded(400));
    }
    bad.digest = chunkDigest(bad);
    try {
      // A bit that the frame format leaves unused may be taken; then nothing else may have changed.
      ASSERT_EQ(decodeChunk(bad), samples.at(round % 2)) << "round " << round;
    } catch (const Error& error) {
      ASSERT_EQ(error.code(), ErrorCode::kBadData);
      ++refused;
    }
  }
  EXPECT_GT(refused, 19'000);
}

TEST(SampleCodec, RefusesRandomBytes) {
  Random random(4);
  for (int round = 0; round < 5'000; ++round) {
    TrialChunk chunk;
    chunk.samples = 100;
    chunk.bytes.resize(random.bounded(200));
    for (std::byte& byte : chunk.bytes) {
      byte = static_cast<std::byte>(random.bounded(256));
    }
    chunk.digest = chunkDigest(chunk);
    ASSERT_EQ(refusal(chunk), ErrorCode::kBadData);
  }
}

TEST(ColumnCodec, SurvivesRandomBytes) {
  // The layer below zstd's checksum: whatever comes, an error or some numbers, never a read past the end.
  Random random(5);
  std::vector<std::int64_t> column(50);
  int refused = 0;
  for (int round = 0; round < 50'000; ++round) {
    std::vector<std::uint8_t> packed(random.bounded(500));
    for (std::uint8_t& byte : packed) {
      byte = static_cast<std::uint8_t>(random.bounded(256));
    }
    if (packed.size() >= 2 && round % 2 == 0) {
      packed[0] %= 6;
      packed[1] %= 10;
    }
    try {
      (void)unpackColumn(packed, column);
    } catch (const Error& error) {
      ASSERT_EQ(error.code(), ErrorCode::kBadData);
      ++refused;
    }
  }
  EXPECT_GT(refused, 25'000);
  EXPECT_LT(refused, 50'000);
}

TEST(SampleCodec, DecodesATrialInOrderAndRefusesAMissingChunk) {
  const std::vector<Sample> samples = twistSamples(2'500);
  Trial trial;
  for (std::int64_t i = 0; i < 3; ++i) {
    const auto first = static_cast<std::size_t>(1000 * i);
    trial.chunks.push_back(
        encodeChunk(i, std::span(samples).subspan(first, std::min<std::size_t>(1000, 2500 - first))));
  }

  const std::vector<Sample> all = decodeTrial(trial);
  trial.chunks.erase(trial.chunks.begin() + 1);

  ASSERT_EQ(all.size(), 2'500U);
  EXPECT_EQ(all.back(), inStoredSteps(samples.back()));
  EXPECT_THROW((void)decodeTrial(trial), Error);
}

}  // namespace
}  // namespace torsio
