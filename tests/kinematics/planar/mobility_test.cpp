// Freedoms counted and true, and number synthesis (plagiograph report, 1.2).
#include "kinematics/planar/mobility.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <utility>

#include "kinematics/planar/solver.hpp"
#include "tests/kinematics/planar/random_linkages.hpp"

namespace kempe {
namespace {

Mobility mobility_near(const PlanarLinkage& linkage, const PlanarPosition& guess) {
  const auto closed = solve_from(linkage.undriven(), guess);
  EXPECT_TRUE(closed);
  return mobility_of(linkage, closed ? closed->position : guess);
}

TEST(Mobility, FourBarHasOneByCountAndByRank) {
  const Mobility m = mobility_near(test::four_bar(2, 1, 2, 2),
                                   {{}, {Point(0, 0), 1}, {Point(0.5, 1), 0.3}, {Point(2, 0), 1.6}});
  EXPECT_EQ(m.links, 4);
  EXPECT_EQ(m.full_joints, 4);
  EXPECT_EQ(m.gruebler, 1);
  EXPECT_EQ(m.mobility, 1);
  EXPECT_EQ(m.rank, 8);
  EXPECT_TRUE(m.redundant.empty());
  EXPECT_FALSE(m.singular_here());
}

/// Three cranks of length 1 under one bar, feet and heads at these places.
PlanarLinkage three_cranks(double last_head) {
  PlanarLinkage linkage;
  int cranks[3];
  for (int& crank : cranks) crank = linkage.add_body("crank");
  const int bar = linkage.add_body("bar");
  const double feet[3] = {0, 2, 4}, heads[3] = {0, 2, last_head};
  for (int i = 0; i < 3; ++i) {
    linkage.add(Revolute{{0, Point(feet[i], 0)}, {cranks[i], Point(0, 0)}}, "foot");
    linkage.add(Revolute{{cranks[i], Point(1, 0)}, {bar, Point(heads[i], 0)}}, "head");
  }
  return linkage;
}

TEST(Mobility, ThirdCrankOfAParallelogramIsRedundantAndNamed) {
  PlanarPosition guess(5);
  for (std::size_t i = 1; i <= 3; ++i) guess[i] = {Point(2.0 * static_cast<double>(i - 1), 0), 1.1};
  guess[4] = {Point(std::cos(1.1), std::sin(1.1)), 0};
  const Mobility m = mobility_near(three_cranks(4), guess);
  EXPECT_EQ(m.gruebler, 0);
  EXPECT_EQ(m.mobility, 1);
  ASSERT_EQ(m.redundant.size(), 1u);
  EXPECT_GE(m.redundant[0].size(), 4u);
  EXPECT_EQ(m.shaky_freedoms(), 0);
}

TEST(Mobility, FlatParallelogramIsASingularPosition) {
  PlanarLinkage linkage = test::four_bar(3, 1, 3, 1);
  const PlanarPosition flat{{}, {Point(0, 0), 0}, {Point(1, 0), 0}, {Point(3, 0), 0}};
  const Mobility m = mobility_of(linkage, flat);
  EXPECT_TRUE(m.singular_here());
  EXPECT_EQ(m.rank_here, 7);
  EXPECT_EQ(m.rank, 8);
  EXPECT_EQ(m.mobility, 1);
  EXPECT_FALSE(m.dependent_here.empty());
}

TEST(Mobility, StraightRowOfDistancesIsShakyNotMovable) {
  // A at the ground, C at the ground, B held between them in a straight line: no motion, though the rank says
  // one.
  PlanarLinkage linkage;
  const int B = linkage.add_particle("B");
  linkage.add(Distance{{0, Point(0, 0)}, {B, Point(0, 0)}, 1}, "A-B");
  linkage.add(Distance{{B, Point(0, 0)}, {0, Point(3, 0)}, 2}, "B-C");
  const Mobility m = mobility_of(linkage, {{}, {Point(1, 0), 0}});
  EXPECT_EQ(m.particles, 1);
  EXPECT_EQ(m.links, 1);
  EXPECT_EQ(m.gruebler, 0);
  EXPECT_EQ(m.mobility, 0);
  EXPECT_EQ(m.shaky_freedoms(), 1);
}

TEST(Mobility, LinksMuchSmallerThanTheOthersCountAsLinks) {
  // A crank of a millionth of the ground turns all the same.
  for (const double crank : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const Point C = test::meet(Point(crank, 0), 2, Point(2, 0), 2, 1);
    const Mobility m =
        mobility_near(test::four_bar(2, crank, 2, 2), {{},
                                                       {Point(0, 0), 0},
                                                       {Point(crank, 0), std::atan2(C.y(), C.x())},
                                                       {Point(2, 0), std::atan2(C.y(), C.x() - 2)}});
    EXPECT_EQ(m.mobility, 1) << crank;
    EXPECT_EQ(m.rank, 8) << crank;
  }
}

TEST(Mobility, TriangleOfBarsIsRigidOnTheGround) {
  PlanarLinkage linkage;
  const int a = linkage.add_body("a"), b = linkage.add_body("b");
  linkage.add(Revolute{{0, Point(0, 0)}, {a, Point(0, 0)}}, "A");
  linkage.add(Revolute{{0, Point(2, 0)}, {b, Point(0, 0)}}, "B");
  linkage.add(Revolute{{a, Point(1.5, 0)}, {b, Point(1.5, 0)}}, "C");
  const Mobility m = mobility_near(linkage, {{}, {Point(0, 0), 0.8}, {Point(2, 0), 2.3}});
  EXPECT_EQ(m.gruebler, 0);
  EXPECT_EQ(m.mobility, 0);
}

TEST(NumberSynthesis, SixLinksWithOneFreedomAreTheReportsFour2AndTwo3) {
  const NumberSynthesis six = number_synthesis(6, 1);
  EXPECT_EQ(six.joints, 7);
  EXPECT_EQ(six.largest_link, 3);
  ASSERT_EQ(six.assortments.size(), 1u);
  EXPECT_EQ(six.assortments[0].count, (std::vector<int>{4, 2}));
  ASSERT_EQ(six.too_large.size(), 1u);  // both sums hold, but a quaternary link exceeds n/2
  EXPECT_EQ(six.too_large[0].count, (std::vector<int>{5, 0, 1}));
}

/// Looks through simple graphs with given numbers of joints at the links for one without a stiff part. Shares no formula
/// with the synthesis: it builds graphs and counts each subset of links.
class ChainSearch {
 public:
  explicit ChainSearch(std::vector<int> joints) : left_(std::move(joints)), neighbours_(left_.size(), 0) {}

  bool finds_one(std::size_t link = 0) {
    if (link == left_.size()) return is_connected() && no_part_is_stiff();
    if (left_[link] == 0) return finds_one(link + 1);
    const int joints = std::exchange(left_[link], 0);
    const bool found = join(link, link + 1, joints);
    left_[link] = joints;
    return found;
  }

 private:
  /// Joins `link` to `more` of the links from `next` on.
  bool join(std::size_t link, std::size_t next, int more) {
    if (more == 0) return finds_one(link + 1);
    for (std::size_t other = next; other < left_.size(); ++other) {
      const bool triangle = (neighbours_[link] & neighbours_[other]) != 0 && left_.size() > 3;
      if (left_[other] == 0 || triangle) continue;
      connect(link, other, -1);
      const bool found = join(link, other + 1, more - 1);
      connect(link, other, 1);
      if (found) return true;
    }
    return false;
  }

  void connect(std::size_t a, std::size_t b, int change) {
    left_[b] += change;
    neighbours_[a] ^= 1U << b;
    neighbours_[b] ^= 1U << a;
  }

  bool is_connected() const {
    unsigned reached = 1, before = 0;
    while (reached != before) {
      before = reached;
      for (std::size_t link = 0; link < left_.size(); ++link)
        if (before >> link & 1) reached |= neighbours_[link];
    }
    return reached == (1U << left_.size()) - 1;
  }

  bool no_part_is_stiff() const {
    const unsigned all = (1U << left_.size()) - 1;
    for (unsigned part = 1; part < all; ++part) {
      int ends = 0;
      for (std::size_t link = 0; link < left_.size(); ++link)
        if (part >> link & 1) ends += std::popcount(neighbours_[link] & part);
      if (const int links = std::popcount(part); links > 1 && 3 * (links - 1) - ends < 1) return false;
    }
    return true;
  }

  std::vector<int> left_;
  std::vector<unsigned> neighbours_;
};

std::vector<int> joints_of(const LinkAssortment& assortment) {
  std::vector<int> joints;
  for (std::size_t i = assortment.count.size(); i-- > 0;)
    joints.insert(joints.end(), static_cast<std::size_t>(assortment.count[i]), static_cast<int>(i) + 2);
  return joints;
}

TEST(NumberSynthesis, ListsExactlyTheAssortmentsOfWhichAGraphCanBeDrawn) {
  int chains = 0, none = 0;
  for (int links = 3; links <= 9; ++links)
    for (int freedoms = 0; freedoms <= links - 3; ++freedoms) {
      const NumberSynthesis s = number_synthesis(links, freedoms);
      SCOPED_TRACE(std::to_string(links) + " links, mobility " + std::to_string(freedoms));
      for (const LinkAssortment& assortment : s.assortments) {
        EXPECT_TRUE(ChainSearch(joints_of(assortment)).finds_one());
        ++chains;
      }
      for (const auto* list : {&s.too_large, &s.stiff})
        for (const LinkAssortment& assortment : *list) {
          EXPECT_FALSE(ChainSearch(joints_of(assortment)).finds_one());
          ++none;
        }
    }
  EXPECT_GT(chains, 25);
  EXPECT_GT(none, 10);
}

TEST(NumberSynthesis, StiffAndManifoldChains) {
  const NumberSynthesis truss = number_synthesis(5, 0);  // Baranov's truss of five links
  EXPECT_EQ(truss.largest_link, 3);
  EXPECT_EQ(truss.assortments, (std::vector<LinkAssortment>{{{3, 2}}}));
  const NumberSynthesis seven = number_synthesis(7, 0);
  EXPECT_EQ(seven.assortments, (std::vector<LinkAssortment>{{{3, 4}}, {{4, 2, 1}}}));
  EXPECT_EQ(seven.stiff, (std::vector<LinkAssortment>{{{5, 0, 2}}}));
  const NumberSynthesis two = number_synthesis(7, 2);  // two four-bars may share a quaternary link
  EXPECT_EQ(two.largest_link, 4);
  EXPECT_EQ(two.assortments, (std::vector<LinkAssortment>{{{5, 2}}, {{6, 0, 1}}}));
  EXPECT_EQ(number_synthesis(10, 1).assortments.size(), 7U);  // as in the atlas of 230 chains
  EXPECT_EQ(number_synthesis(12, 1).largest_link, 6);
}

TEST(NumberSynthesis, KnownAtlasOfEightAndTenLinks) {
  // 8 links: joints 10; (4,4), (5,2,1), (6,0,2) and no larger link than n/2 = 4.
  const NumberSynthesis eight = number_synthesis(8, 1);
  EXPECT_EQ(eight.joints, 10);
  std::vector<std::vector<int>> counts;
  for (const auto& assortment : eight.assortments) counts.push_back(assortment.count);
  EXPECT_EQ(counts, (std::vector<std::vector<int>>{{4, 4}, {5, 2, 1}, {6, 0, 2}}));
  EXPECT_EQ(number_synthesis(4, 1).assortments, (std::vector<LinkAssortment>{{{4}}}));
  EXPECT_EQ(number_synthesis(5, 2).assortments, (std::vector<LinkAssortment>{{{5}}}));
  EXPECT_EQ(number_synthesis(5, 1).joints, 0);  // 3 * 4 - 1 is odd
  for (int links = 3; links <= 14; ++links)
    for (int freedoms = 0; freedoms < links; ++freedoms) {
      const NumberSynthesis s = number_synthesis(links, freedoms);
      for (const auto* list : {&s.assortments, &s.too_large, &s.stiff})
        for (const LinkAssortment& assortment : *list) {
          int n = 0, ends = 0;
          for (std::size_t i = 0; i < assortment.count.size(); ++i) {
            n += assortment.count[i];
            ends += assortment.count[i] * (static_cast<int>(i) + 2);
          }
          EXPECT_EQ(n, links);
          EXPECT_EQ(ends, 2 * s.joints);
          EXPECT_EQ(3 * (links - 1) - 2 * s.joints, freedoms);
        }
    }
}

}  // namespace
}  // namespace kempe
