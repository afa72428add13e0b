#include "geometry/similarity_fit.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

Point random_point(std::mt19937_64& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size)};
}

std::vector<PointPair> pairs_of(std::mt19937_64& random, int count, Complex k, const Point& translation,
                                double noise) {
  std::vector<PointPair> pairs;
  for (int i = 0; i < count; ++i) {
    const Point tracer = random_point(random, 100);
    pairs.push_back({tracer, as_point(k * as_complex(tracer)) + translation + random_point(random, noise)});
  }
  return pairs;
}

double sum_of_squares(const std::vector<PointPair>& pairs, Complex k, const Point& translation) {
  double sum = 0;
  for (const PointPair& pair : pairs) {
    sum += (as_point(k * as_complex(pair.tracer)) + translation - pair.pen).squaredNorm();
  }
  return sum;
}

TEST(SimilarityFit, RecoversRandomSimilarities) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Complex k = std::polar(std::exp(uniform(random, -5, 5)), uniform(random, -pi, pi));
    const Point translation = random_point(random, 500);
    const auto fit = fit_similarity(pairs_of(random, 2 + i % 9, k, translation, 0));
    ASSERT_TRUE(fit);
    EXPECT_LT(std::abs(fit->k - k), 1e-11 * std::abs(k) + 1e-13 * translation.norm());
    EXPECT_LT((fit->translation - translation).norm(), 1e-9 * (1 + std::abs(k)));
    EXPECT_LT(fit->residual_largest, 1e-9 * (1 + std::abs(k)));
  }
}

/// Nelder-Mead is not needed: the sum of squares is a bowl, so stepping along the four axes with halving
/// steps ends at its bottom.
double least_sum_by_descent(const std::vector<PointPair>& pairs) {
  std::array<double, 4> x{1, 0, 0, 0};
  const auto value = [&] { return sum_of_squares(pairs, {x[0] / 100, x[1] / 100}, {x[2], x[3]}); };
  double best = value();
  for (double step = 256; step > 1e-7;) {
    bool improved = false;
    for (double& variable : x) {
      for (const double change : {step, -step}) {
        variable += change;
        const double now = value();
        if (now < best) {
          best = now;
          improved = true;
        } else {
          variable -= change;
        }
      }
    }
    if (!improved) step /= 2;
  }
  return best;
}

TEST(SimilarityFit, LeavesTheLeastResidualThatADescentFinds) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100; ++i) {
    const Complex k = std::polar(uniform(random, 0.5, 3), uniform(random, -pi, pi));
    const auto pairs = pairs_of(random, 4 + i % 7, k, random_point(random, 20), 3);
    const auto fit = fit_similarity(pairs);
    ASSERT_TRUE(fit);
    const double own = sum_of_squares(pairs, fit->k, fit->translation);
    EXPECT_NEAR(fit->residual_rms, std::sqrt(own / static_cast<double>(pairs.size())), 1e-9);
    EXPECT_LE(own, least_sum_by_descent(pairs) + 1e-7);
  }
}

TEST(SimilarityFit, LargestResidualIsThatOfTheWorstPair) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const auto pairs = pairs_of(random, 5, {0.5, 1}, {3, 4}, 2);
    const auto fit = fit_similarity(pairs);
    ASSERT_TRUE(fit);
    double worst = 0;
    for (const PointPair& pair : pairs) {
      worst =
          std::max(worst, (as_point(fit->k * as_complex(pair.tracer)) + fit->translation - pair.pen).norm());
    }
    EXPECT_NEAR(fit->residual_largest, worst, 1e-9);
    EXPECT_LE(fit->residual_rms, fit->residual_largest);
  }
}

TEST(SimilarityFit, FixedPointStaysWhereItIs) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    const Complex k = std::polar(uniform(random, 0.1, 4), uniform(random, 0.2, pi));
    const Point pole = random_point(random, 200);
    const auto fit = fit_similarity(pairs_of(random, 4, k, pole - as_point(k * as_complex(pole)), 0));
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->fixed_point().value() - pole).norm(), 1e-9);
  }
}

/// plagiograph-report.txt, its table of pairs: K = 1.4, rotation 90 degrees, both arms through the origin.
TEST(SimilarityFit, OfTheReportsPairsIsItsRatio) {
  const auto fit = fit_similarity({{{7.5, 0}, {0, 10.5}}, {{7, 0}, {0, 9.8}}, {{5.6, 0}, {0, 7.84}}});
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->k.real(), 0);
  EXPECT_NEAR(fit->k.imag(), 1.4, 1e-14);
  EXPECT_EQ(fit->fixed_point().value(), Point(0, 0));
  EXPECT_LT(fit->residual_largest, 1e-14);
}

TEST(SimilarityFit, RefusesMirrorImages) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i) {
    auto pairs = pairs_of(random, 3 + i % 6, std::polar(uniform(random, 0.2, 3), uniform(random, -pi, pi)),
                          random_point(random, 20), 0);
    for (PointPair& pair : pairs) pair.pen.x() = -pair.pen.x();
    const auto fit = fit_similarity(pairs);
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error(), PairFault::mirrored);
  }
}

TEST(SimilarityFit, OfPointsOnALineIsTheRotation) {
  // A reflection fits them as well: the linkage makes the rotation.
  const auto fit = fit_similarity({{{0, 0}, {0, 0}}, {{1, 1}, {0, 2}}, {{3, 3}, {0, 6}}});
  ASSERT_TRUE(fit);
  EXPECT_LT(std::abs(fit->k - Complex(1, 1)), 1e-14);
}

TEST(SimilarityFit, RefusesPairsThatDetermineNoRatio) {
  EXPECT_EQ(fit_similarity({}).error(), PairFault::too_few);
  EXPECT_EQ(fit_similarity({{{1, 2}, {3, 4}}}).error(), PairFault::too_few);
  EXPECT_EQ(fit_similarity({{{1, 2}, {3, 4}}, {{1, 2}, {5, 6}}}).error(), PairFault::too_few);
  EXPECT_EQ(fit_similarity({{{1, 2}, {3, 4}}, {{5, 2}, {3, 4}}}).error(), PairFault::one_pen_point);
  EXPECT_EQ(fit_similarity({{{0, 0}, {0, 0}}, {{1, 0}, {5, 0}}, {{2, 0}, {0, 0}}, {{3, 0}, {5, 1}}}).error(),
            PairFault::no_similarity);
}

TEST(SimilarityFit, OfATranslationHasNoFixedPoint) {
  const auto fit = fit_similarity({{{0, 0}, {5, 5}}, {{1, 0}, {6, 5}}});
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->fixed_point());
}

}  // namespace
}  // namespace kempe
