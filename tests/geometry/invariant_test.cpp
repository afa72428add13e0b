#include "geometry/invariant.hpp"

#include <gtest/gtest.h>

namespace kempe {
namespace {

TEST(Invariant, HoldsInSilence) { invariant(true, "two and two are four"); }

TEST(InvariantDeathTest, BrokenEndsTheProgramWithConditionAndPlace) {
  EXPECT_DEATH(invariant(2 + 2 == 5, "two and two are five"),
               "invariant_test.cpp:[0-9]+: .*two and two are five");
}

}  // namespace
}  // namespace kempe
