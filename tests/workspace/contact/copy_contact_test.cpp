// Gaps that the copy alone decides about, against the poses of many of the tracer's places.

#include "workspace/contact/copy_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/region.hpp"
#include "tests/workspace/random_linkage.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using test::Dice;

Ring star(Dice& dice, const Point& centre, double size) {
  Ring ring;
  const int corners = 3 + dice.below(5);
  for (int i = 0; i < corners; ++i)
    ring.push_back(centre + as_point(std::polar(size * dice.between(0.4, 1), 2 * pi * i / corners)));
  return ring;
}

Body body_at(Dice& dice, Carrier carrier, double size) {
  Body body;
  body.at = carrier;
  const Point centre(dice.between(-size, size), dice.between(-size, size));
  if (dice.below(2) == 0)
    body.shape = Disc{centre, dice.between(0.1, 1) * size};
  else
    body.shape = Polygon{star(dice, centre, size), {}};
  return body;
}

/// With a region that the linkage reaches, bodies at tracer and pen, and obstacles about the table.
MapTask random_task(Dice& dice) {
  while (true) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    MapTask task{linkage, test::random_style(dice), test::random_layers(dice), {.clearance = 0.5}};
    const Annulus reach = reachable_annulus(linkage);
    const double from_pole = 0.5 * (reach.inner + reach.outer), size = 0.3 * (reach.outer - reach.inner);
    const Point middle = linkage.pole() + as_point(std::polar(from_pole, dice.between(-pi, pi)));
    task.region.polygons.push_back({star(dice, middle, size), {}});
    if (!openings_over(linkage, task.region)) continue;
    for (const Carrier carrier : {Carrier::tracer, Carrier::pen})
      task.bodies.push_back(body_at(dice, carrier, 0.3 * size));
    for (int i = 0; i < 3; ++i) {
      const Point at =
          linkage.pole() + as_point(std::polar(reach.outer * dice.between(0.2, 1.5), dice.between(-pi, pi)));
      task.obstacles.push_back({.shape = {star(dice, at, 0.3 * size), {}}});
    }
    return task;
  }
}

/// Those that are not left to others.
Encounters of_the_copy(const ContactScene& scene, const Encounters& others) {
  Encounters left;
  for (const Encounter& one : scene.encounters.pairs) {
    const bool is_other = std::any_of(others.pairs.begin(), others.pairs.end(), [&](const Encounter& other) {
      return other.piece == one.piece && other.obstacle == one.obstacle;
    });
    if (!is_other) left.add(one, scene.obstacles[one.obstacle].frame);
  }
  return left;
}

TEST(CopyContact, GapIsTheLeastOfManyPosesAndIsMet) {
  Dice dice(2031);
  int told = 0, overlaps = 0;
  for (int i = 0; i < 300; ++i) {
    const MapTask task = random_task(dice);
    const CopyingLinkage& linkage = task.linkage;
    const PreparedTask prepared(task, 1e4);
    const ContactScene& scene = prepared.scene;
    const CopyContacts contacts = copy_contacts(prepared, scene.encounters, infinity, 1e-9);
    const Encounters asked = of_the_copy(scene, contacts.others);
    ASSERT_GT(asked.pairs.size(), 4u);  // the bodies' points and the posts at least
    ASSERT_TRUE(contacts.smallest);
    const auto gap_at = [&](const Point& tracer) {
      const Point reach = tracer - linkage.pole();
      const auto opening = linkage.opening_at(reach.norm());
      return opening ? tightest_obstacle(scene, asked, *opening, std::atan2(reach.y(), reach.x())).gap
                     : infinity;
    };
    const Ring& outer = task.region.polygons[0].outer;
    double sampled = infinity, spacing = 0;
    for (std::size_t corner = 0; corner < outer.size(); ++corner) {
      const Point from = outer[corner], to = outer[(corner + 1) % outer.size()];
      constexpr int steps = 200;
      spacing = std::max(spacing, (to - from).norm() / steps);
      for (int step = 0; step < steps; ++step)
        sampled = std::min(sampled, gap_at(from + step * (to - from) / steps));
    }
    const Box box = bounding_box(task.region);
    for (int k = 0; k < 300; ++k) {
      const Point inside(dice.between(box.lower.x(), box.upper.x()),
                         dice.between(box.lower.y(), box.upper.y()));
      if (contains(task.region, inside)) sampled = std::min(sampled, gap_at(inside));
    }
    const double moved = std::max({1.0, std::abs(linkage.k()), std::abs(linkage.k() - 1.0)}) * spacing;
    EXPECT_LE(contacts.smallest->gap, sampled + 1e-9) << i;
    EXPECT_NEAR(gap_at(contacts.smallest->at), contacts.smallest->gap, 1e-7) << i;
    EXPECT_LT(distance(task.region, contacts.smallest->at), 1e-9) << i;
    if (contacts.smallest->gap > 0) {
      EXPECT_GE(contacts.smallest->gap, sampled - moved) << i;
    }
    (contacts.smallest->gap > 0 ? told : overlaps)++;
  }
  EXPECT_GT(told, 200);
  EXPECT_GT(overlaps, 10);
}

TEST(CopyContact, NothingIsToldThatIsNotBelowWhatWasAsked) {
  Dice dice(2032);
  for (int i = 0; i < 100; ++i) {
    const MapTask task = random_task(dice);
    const PreparedTask prepared(task, 1e4);
    const Encounters& all = prepared.scene.encounters;
    const double smallest = copy_contacts(prepared, all, infinity, 0).smallest->gap;
    const auto below = copy_contacts(prepared, all, smallest + 1e-3, 0).smallest;
    ASSERT_TRUE(below);
    EXPECT_EQ(below->gap, smallest);
    EXPECT_FALSE(copy_contacts(prepared, all, smallest - 1e-9, 0).smallest);
    const CopyContacts stopped = copy_contacts(prepared, all, infinity, 0, [] { return true; });
    EXPECT_FALSE(stopped.smallest);
    EXPECT_EQ(stopped.others.pairs.size(), all.pairs.size());
  }
}

}  // namespace
}  // namespace kempe
