// SPDX-License-Identifier: GPL-3.0-or-later
// The two carriers between threads. Run under ThreadSanitizer by the tsan preset.
#include <array>
#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/latest_value.h"
#include "sim/core/spsc_ring.h"

namespace torsio {
namespace {

constexpr std::uint64_t kExchanges = 1'000'000;

/// Wide enough that a torn copy would be seen: all words are the same.
struct Wide {
  std::array<std::uint64_t, 24> words{};

  Wide() = default;
  explicit Wide(std::uint64_t value) { words.fill(value); }
  bool whole() const {
    for (const std::uint64_t word : words) {
      if (word != words[0]) {
        return false;
      }
    }
    return true;
  }
};

TEST(SpscRing, KeepsOrderAndRefusesWhenFull) {
  SpscRing<int> ring(3);
  int value = 0;

  EXPECT_FALSE(ring.pop(value));
  EXPECT_TRUE(ring.push(1));
  EXPECT_TRUE(ring.push(2));
  EXPECT_TRUE(ring.push(3));
  EXPECT_FALSE(ring.push(4));
  EXPECT_FALSE(ring.push(5));

  for (const int expected : {1, 2, 3}) {
    ASSERT_TRUE(ring.pop(value));
    EXPECT_EQ(value, expected);
  }
  EXPECT_FALSE(ring.pop(value));
  EXPECT_EQ(ring.refused(), 2U);
}

TEST(SpscRing, GoesRoundItsEndManyTimes) {
  SpscRing<int> ring(2);
  int value = 0;
  for (int i = 0; i < 1'000; ++i) {
    ASSERT_TRUE(ring.push(i));
    ASSERT_TRUE(ring.pop(value));
    ASSERT_EQ(value, i);
  }
  EXPECT_EQ(ring.refused(), 0U);
}

TEST(SpscRing, RefusesACapacityOfZero) {
  EXPECT_THROW(SpscRing<int> ring(0), ContractError);
}

TEST(SpscRing, CarriesAMillionValuesBetweenTwoThreadsWholeAndInOrder) {
  SpscRing<Wide> ring(256);
  std::thread producer([&ring] {
    for (std::uint64_t i = 1; i <= kExchanges;) {
      if (ring.push(Wide(i))) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  });

  Wide value;
  std::uint64_t expected = 1;
  std::uint64_t wrong = 0;
  while (expected <= kExchanges) {
    if (!ring.pop(value)) {
      std::this_thread::yield();
      continue;
    }
    if (!value.whole() || value.words[0] != expected) {
      ++wrong;
    }
    ++expected;
  }
  producer.join();

  EXPECT_EQ(wrong, 0U);
}

TEST(LatestValue, GivesTheNewestValueAsOftenAsItIsAsked) {
  LatestValue<int> latest;

  EXPECT_EQ(latest.latest(), 0);
  latest.publish(1);
  latest.publish(2);
  EXPECT_EQ(latest.latest(), 2);
  EXPECT_EQ(latest.latest(), 2);
  latest.publish(3);
  EXPECT_EQ(latest.latest(), 3);
}

TEST(LatestValue, NeverTearsNorGoesBackInAMillionExchanges) {
  LatestValue<Wide> latest;
  std::thread writer([&latest] {
    for (std::uint64_t i = 1; i <= kExchanges; ++i) {
      latest.publish(Wide(i));
    }
  });

  std::uint64_t before = 0;
  std::uint64_t wrong = 0;
  while (before < kExchanges) {
    const Wide& value = latest.latest();
    if (!value.whole() || value.words[0] < before) {
      ++wrong;
    }
    before = value.words[0];
  }
  writer.join();

  EXPECT_EQ(wrong, 0U);
}

}  // namespace
}  // namespace torsio
