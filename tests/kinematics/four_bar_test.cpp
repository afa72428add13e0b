#include "kinematics/four_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/random.hpp"

namespace kempe {
namespace {

using test::uniform;

FourBar random_bar(std::mt19937_64& random) {
  return {100, uniform(random, 10, 300), uniform(random, 10, 300), uniform(random, 10, 300),
          random() & 1 ? FourBarBranch::first : FourBarBranch::second};
}

TEST(FourBar, ClosesItsLoopOrSaysThatItDoesNot) {
  std::mt19937_64 random(1);
  int closed = 0;
  for (int i = 0; i < 5000; ++i) {
    const FourBar bar = random_bar(random);
    const double phi = uniform(random, -pi, pi);
    const auto psi = bar.output_angle(phi);
    const double apart = std::abs(bar.ground - std::polar(bar.input, phi));
    const bool closes = apart <= bar.coupler + bar.output && apart >= std::abs(bar.coupler - bar.output);
    ASSERT_EQ(psi.has_value(), closes);
    if (!psi) continue;
    ++closed;
    EXPECT_NEAR(std::abs(bar.ground + std::polar(bar.output, *psi) - std::polar(bar.input, phi)), bar.coupler,
                1e-9);
  }
  EXPECT_GT(closed, 1000);
}

TEST(FourBar, ObeysFreudensteinsEquation) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    const FourBar bar = random_bar(random);
    const double phi = uniform(random, -pi, pi);
    const auto psi = bar.output_angle(phi);
    if (!psi) continue;
    const auto [K1, K2, K3] = bar.coefficients();
    EXPECT_NEAR(K1 * std::cos(*psi) - K2 * std::cos(phi) + K3, std::cos(phi - *psi),
                1e-9 * (1 + std::abs(K3)));
  }
}

TEST(FourBar, ComesBackFromItsCoefficients) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {
    const FourBar bar = random_bar(random);
    const auto back = four_bar_from(bar.coefficients(), bar.ground);
    ASSERT_TRUE(back);
    EXPECT_FALSE(back->input_turned || back->output_turned);
    EXPECT_NEAR(back->linkage.input, bar.input, 1e-9 * bar.input);
    EXPECT_NEAR(back->linkage.coupler, bar.coupler, 1e-6 * bar.coupler);
    EXPECT_NEAR(back->linkage.output, bar.output, 1e-9 * bar.output);
  }
  EXPECT_FALSE(four_bar_from({0, 1, 1}, 100));
  EXPECT_FALSE(four_bar_from({1, 1, std::nan("")}, 100));
  EXPECT_FALSE(four_bar_from({1, 1, 2}, 100));  // an imaginary coupler
}

TEST(FourBar, NamesGrashofsClasses) {
  EXPECT_EQ((FourBar{100, 30, 90, 80}).motion(), CrankMotion::crank_rocker);
  EXPECT_EQ((FourBar{30, 90, 80, 100}).motion(), CrankMotion::double_crank);
  EXPECT_EQ((FourBar{100, 90, 80, 30}).motion(), CrankMotion::rocker_crank);
  EXPECT_EQ((FourBar{100, 90, 30, 80}).motion(), CrankMotion::double_rocker);
  EXPECT_EQ((FourBar{100, 40, 100, 40}).motion(), CrankMotion::change_point);
}

TEST(FourBar, TransmissionAngleIsBetweenCouplerAndOutputCrank) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    const FourBar bar = random_bar(random);
    const double phi = uniform(random, -pi, pi);
    const auto psi = bar.output_angle(phi);
    if (!psi) continue;
    const Complex output = std::polar(bar.output, *psi);
    const Complex coupler = bar.ground + output - std::polar(bar.input, phi);
    const double angle = std::abs(std::arg(coupler / output));
    EXPECT_NEAR(*bar.transmission_angle(phi), std::min(angle, pi - angle), 1e-6);
  }
}

TEST(FourBar, LeastTransmissionAngleIsThatOfTheWholeRange) {
  std::mt19937_64 random(5);
  int closed = 0;
  for (int i = 0; i < 2000; ++i) {
    const FourBar bar = random_bar(random);
    const double first = uniform(random, -pi, pi), last = first + uniform(random, -7, 7);
    const auto least = bar.least_transmission_angle(first, last);
    double sampled = pi;
    bool open = false;
    for (int j = 0; j <= 2000; ++j) {
      const auto here = bar.transmission_angle(first + (last - first) * j / 2000);
      open = open || !here;
      sampled = std::min(sampled, here.value_or(pi));
    }
    EXPECT_FALSE(open && least);
    if (!least) continue;
    ++closed;
    EXPECT_LE(*least, sampled + 1e-12);
    EXPECT_GE(*least, sampled - 1e-2);
  }
  EXPECT_GT(closed, 200);
}

}  // namespace
}  // namespace kempe
