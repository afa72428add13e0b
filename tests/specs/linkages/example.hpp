// A linkage file read, put together and run, and the plane geometry that oracles of linkages are made of.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "kinematics/planar/mobility.hpp"
#include "kinematics/planar/rates.hpp"
#include "specs/linkages/model.hpp"

namespace kempe {

/// An example read, put together and run.
class Example {
 public:
  explicit Example(const std::string& name, int steps = 0) : Example(parsed(name), steps) {}

  Example(LinkageFile read, int steps) : file(std::move(read)), model(linkage_model(file)) {
    const auto assembly_modes = start_assembly_modes(file, model);
    EXPECT_TRUE(assembly_modes) << file.name;
    start = assembly_modes->front();
    rerun(steps > 0 ? steps : file.steps);
  }

  static LinkageFile parsed(const std::string& name) {
    const auto read = read_linkage_file(KEMPE_SOURCE_DIR "/specs/examples/linkages/" + name + ".toml");
    EXPECT_TRUE(read) << read.error().message();
    return *read;
  }

  void rerun(int steps) {
    const auto done = run_motion(model.linkage, start, model.schedule, steps);
    ASSERT_TRUE(done) << file.name;
    run = *done;
  }

  Point at(const RunFrame& frame, const std::string& name) const {
    return place(frame.position, model.point(name)) / file.unit.in_mm;
  }
  Complex z(const RunFrame& frame, const std::string& name) const { return as_complex(at(frame, name)); }
  Complex velocity(const RunFrame& frame, const std::string& name) const {
    return as_complex(velocity_of(frame.position, frame.rate, model.point(name)) / file.unit.in_mm);
  }
  Complex acceleration(const RunFrame& frame, const std::string& name) const {
    return as_complex(acceleration_of(frame.position, frame.rate, frame.second, model.point(name)) /
                      file.unit.in_mm);
  }
  Mobility mobility() const { return mobility_of(model.linkage, start); }

  LinkageFile file;
  LinkageModel model;
  PlanarPosition start;
  PlanarRun run;
};

/// The point at distances `a` from A and `b` from B, on the left of AB for side +1.
inline Point meet(const Point& A, double a, const Point& B, double b, int side) {
  const Point e = B - A;
  const double d = e.norm(), along = (a * a - b * b + d * d) / (2 * d);
  return A + along * e / d + side * std::sqrt(a * a - along * along) * Point(-e.y(), e.x()) / d;
}

inline Point on_circle(double radius, double angle) {
  return radius * Point(std::cos(angle), std::sin(angle));
}

inline void expect_near(const Point& a, const Point& b, double tolerance, const std::string& what) {
  EXPECT_LT((a - b).norm(), tolerance) << what;
}

}  // namespace kempe
