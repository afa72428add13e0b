#pragma once
// Instruments with hidden deviations and what they draw, for the tests of calibration.

#include <cmath>
#include <random>
#include <vector>

#include "synthesis/calibration/calibration.hpp"
#include "tests/random.hpp"

namespace kempe::calibration_specimens {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : generator_(seed) {}
  double uniform(double lower, double upper) { return test::uniform(generator_, lower, upper); }
  double normal() {
    const double u = uniform(0x1p-53, 1), v = uniform(0, 2 * pi);
    return std::sqrt(-2 * std::log(u)) * std::cos(v);
  }

 private:
  std::mt19937_64 generator_;
};

inline const std::vector<Measure> links{Measure::VA,       Measure::VB, Measure::AX, Measure::CX,
                                        Measure::offset_A, Measure::BC, Measure::CY, Measure::offset_B};
inline const std::vector<Measure> knights_scales{Measure::AX, Measure::BC, Measure::VA, Measure::VB};

/// Deviations of the free measures up to `size`, uniformly; the turn in rad per 100 mm.
inline Measures hidden_deviations(const std::vector<Measure>& free, double size, Chance& chance) {
  Measures deviations = Measures::Zero();
  for (const Measure measure : free)
    deviations[index_of(measure)] = chance.uniform(-size, size) / (measure == Measure::turn ? 100 : 1);
  return deviations;
}

/// What the instrument with these deviations draws when its input is set on each place, read with noise.
inline std::vector<CalibrationReading> drawn_readings(const Instrument& setup, const Measures& deviations,
                                                      const std::vector<Point>& inputs, double noise,
                                                      Chance& chance) {
  std::vector<CalibrationReading> readings;
  for (const Point& input : inputs) {
    const auto output = output_at(setup, setup.drawn + deviations, input);
    if (!output) continue;
    Point read = output->at;
    if (noise > 0) read += noise * Point(chance.normal(), chance.normal());
    readings.push_back({0, input, read});
  }
  return readings;
}

/// Stylus places on Knight's axis, arm angles evenly from 15 to 75 degrees.
inline std::vector<Point> on_the_axis(double arm, int count) {
  std::vector<Point> inputs;
  for (int i = 0; i < count; ++i) {
    const double angle = radians(15 + 60.0 * i / (count - 1));
    inputs.emplace_back(2 * arm * std::cos(angle), 0);
  }
  return inputs;
}

/// Places all over the reach of a linkage.
inline std::vector<Point> over_the_reach(const CopyingLinkage& linkage, int count, Chance& chance) {
  const OpeningInterval openings = shrink(linkage.assembly_mode().openings, 0.3);
  std::vector<Point> inputs;
  for (int i = 0; i < count; ++i)
    inputs.push_back(
        linkage.tracer_at(chance.uniform(openings.lower, openings.upper), chance.uniform(-0.9, 0.9)));
  return inputs;
}

/// One of each grounding, straight and turned.
inline std::vector<CopyingLinkage> linkages() {
  const auto made = [](Complex k, Grounding grounding, double VA, double VB, int assembly_mode) {
    return *CopyingLinkage::make(k, grounding, VA, VB, assembly_mode, Point(10, -20));
  };
  return {made(1.5, Grounding::tracer, 240, 180, 1), made({0, 1.4}, Grounding::pole, 200, 140, 3),
          made({0, 1.4}, Grounding::tracer, 200, 160, 2), made(0.5, Grounding::pen, 250, 250, 0),
          made(copy_ratio(0.6, radians(40)), Grounding::pen, 180, 220, 0)};
}

}  // namespace kempe::calibration_specimens
