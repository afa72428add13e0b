#include "synthesis/calibration/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/chance.hpp"
#include "synthesis/calibration/slack.hpp"
#include "synthesis/calibration/task.hpp"

namespace kempe {
namespace {

struct Place {
  std::optional<double> arm_angle;
  Point input = Point::Zero();
};

/// A plate in its own frame after its three holes were displaced: along, across, outer length.
struct Displaced {
  double along_from_corner, across, outer;
};
Displaced displaced(Complex corner, Complex middle, Complex outer) {
  const Complex axis = (outer - corner) / std::abs(outer - corner);
  const Complex place = (middle - corner) / axis;
  return {place.real(), place.imag(), std::abs(outer - corner)};
}

class Simulation {
 public:
  Simulation(const Measurements& spec, const std::optional<DrawnDesign>& design, std::uint64_t seed)
      : spec_(spec), design_(design), wanted_(*spec.simulation), chance_(seed) {
    Measurements bare = spec;
    bare.readings.clear();
    bare.fit.arm_tolerance_percent = std::max(bare.fit.arm_tolerance_percent, wanted_.arm_error_percent);
    bare.fit.bearing_tolerance_percent =
        std::max(bare.fit.bearing_tolerance_percent, wanted_.bearing_error_percent);
    bare_ = bare;
    method_ = spec.fit.method.value_or(design ? CalibrationMethod::least_squares : CalibrationMethod::knight);
    const int usual = method_ == CalibrationMethod::knight ? 2 : 10;
    places_ = places(wanted_.readings > 0 ? wanted_.readings : design ? 16 : usual);
    fan_ = places(25);
    const TaskMaking making(bare_, design_);
    drawn_ = making.task().setups.front();
    free_ = making.task().free;
  }

  std::optional<SimulationRecord> run(const std::function<void(double)>& progress,
                                      const std::atomic<bool>& interrupted) {
    record_.method = method_;
    record_.readings = static_cast<int>(places_.size());
    record_.rounds.resize(static_cast<std::size_t>(wanted_.rounds));
    for (int i = 0; i < wanted_.instruments; ++i) {
      if (interrupted) return std::nullopt;
      if (play_one(i == 0)) {
        ++record_.instruments;
      } else {
        ++record_.failed;
      }
      progress((i + 1.0) / wanted_.instruments);
    }
    finish();
    return record_;
  }

 private:
  std::vector<Place> places(int count) const {
    std::vector<Place> all;
    const ArmAngles& angles = spec_.arm_angles;
    for (int i = 0; i < count; ++i) {
      const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.5;
      if (design_) {
        all.push_back({{}, design_->place(share, std::fmod(0.6180339887498949 * i, 1.0))});
      } else {
        const bool knights_own = method_ == CalibrationMethod::knight && count == 2;
        const double angle =
            knights_own ? radians(i == 0 ? 30 : 60) : angles.lower + share * (angles.upper - angles.lower);
        all.push_back({angle, Point(2 * spec_.instrument->arm * std::cos(angle), 0)});
      }
    }
    return all;
  }

  Measures hidden_errors() {
    Measures hidden = Measures::Zero();
    for (const Measure measure : free_)
      hidden[index_of(measure)] =
          chance_.symmetric(wanted_.largest_error) * (measure == Measure::turn ? 1 / size() : 1);
    if (!design_) {
      const double arm = spec_.instrument->arm / 100;
      for (const Measure measure : {Measure::CX, Measure::CY})
        hidden[index_of(measure)] += chance_.symmetric(wanted_.arm_error_percent * arm);
      for (const Measure measure : {Measure::offset_A, Measure::offset_B})
        hidden[index_of(measure)] += chance_.symmetric(wanted_.bearing_error_percent * arm);
    }
    for (int j = 0; j < measure_count; ++j) {
      const auto measure = static_cast<Measure>(j);
      const auto given = wanted_.errors.find(spoken_name(measure, !design_));
      if (given != wanted_.errors.end())
        hidden[j] = given->second * (!design_ && measure == Measure::VB ? -1 : 1);
    }
    return hidden;
  }

  double size() const { return drawn_.drawn.head<8>().cwiseAbs().maxCoeff(); }

  double rounded(double value) const {
    return wanted_.resolution > 0 ? wanted_.resolution * std::round(value / wanted_.resolution) : value;
  }

  std::optional<ReadingSpec> read(const Place& place, const Measures& present, int round) {
    const Measures loose =
        with_play(drawn_.drawn + present, wanted_.play, [this] { return chance_.share(); });
    const auto output = output_at(drawn_, loose, place.input);
    if (!output) return std::nullopt;
    const double noise_y = wanted_.noise * chance_.normal(), noise_x = wanted_.noise * chance_.normal();
    const Point origin = place.arm_angle ? wanted_output(drawn_, place.input) : Point(0, 0);
    const Point value = output->at - origin + Point(noise_x, noise_y);
    ReadingSpec reading;
    reading.round = round;
    reading.arm_angle = place.arm_angle;
    (place.arm_angle ? reading.error : reading.pen) = Point(rounded(value.x()), rounded(value.y()));
    reading.tracer = place.input;
    return reading;
  }

  std::optional<Calibration> calibrated(const std::vector<ReadingSpec>& readings) const {
    Measurements file = bare_;
    file.readings = readings;
    TaskMaking making(file, design_);
    std::vector<std::size_t> all;
    for (const ReadingSpec& reading : readings) {
      making.add(reading);
      all.push_back(all.size());
    }
    CalibrationTask task = making.task();
    if (method_ == CalibrationMethod::knight && !task.reading_uncertainty)
      task.reading_uncertainty = std::max(slack::least_simulated_noise,
                                          std::hypot(wanted_.noise, wanted_.resolution / std::sqrt(12.0)));
    const auto found =
        method_ == CalibrationMethod::knight ? calibrate_by_knight(task, file, all) : calibrate(task);
    return found ? std::optional(*found) : std::nullopt;
  }

  /// Largest true departure over the reach; nothing where the linkage does not close.
  std::optional<double> departure(const Measures& present) const {
    double largest = 0;
    for (const Place& place : fan_) {
      const auto output = output_at(drawn_, drawn_.drawn + present, place.input);
      if (!output) return std::nullopt;
      largest = std::max(largest, (output->at - wanted_output(drawn_, place.input)).norm());
    }
    return largest;
  }

  bool play_one(bool first) {
    const Measures hidden = hidden_errors();
    Measures present = hidden;
    std::vector<double> residuals;
    const auto before = departure(present);
    if (!before) return false;
    for (int round = 1; round <= wanted_.rounds; ++round) {
      std::vector<ReadingSpec> readings;
      for (const Place& place : places_)
        if (const auto reading = read(place, present, round)) readings.push_back(*reading);
      const auto found = calibrated(readings);
      if (!found) return false;
      count_coverage(*found, present, record_.rounds[static_cast<std::size_t>(round - 1)]);
      if (first)
        record_.readings_of_first.insert(record_.readings_of_first.end(), readings.begin(), readings.end());
      present -= found->deviations;
      const auto after = departure(present);
      if (!after) return false;
      residuals.push_back(*after);
    }
    if (first) remember(hidden);
    record_.departure_mean += *before;
    record_.departure_largest = std::max(record_.departure_largest, *before);
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      SimulatedRound& round = record_.rounds[i];
      round.residual_mean += residuals[i];
      round.residual_largest = std::max(round.residual_largest, residuals[i]);
      round.reached += residuals[i] <= spec_.fit.target ? 1 : 0;
    }
    return true;
  }

  /// `coverage` counts until the end; then it is a share.
  void count_coverage(const Calibration& found, const Measures& present, SimulatedRound& round) const {
    for (const Measure measure : free_) {
      const int i = index_of(measure);
      if (!found.determined[i]) continue;
      ++round.intervals;
      const double off = std::abs(found.deviations[i] - present[i]);
      round.coverage += off <= found.coverage_factor * found.uncertainty(measure) ? 1 : 0;
    }
  }

  void remember(const Measures& hidden) {
    Calibration truth;
    truth.deviations = hidden;
    record_.hidden = quantities_of(drawn_, !design_, free_, truth).quantities;
  }

  void finish() {
    const double count = std::max(1, record_.instruments);
    record_.departure_mean /= count;
    for (SimulatedRound& round : record_.rounds) {
      round.residual_mean /= count;
      round.reached /= count;
      round.coverage /= std::max<double>(1, static_cast<double>(round.intervals));
    }
  }

  const Measurements& spec_;
  const std::optional<DrawnDesign>& design_;
  const SimulationSpec& wanted_;
  Chance chance_;
  Measurements bare_;
  CalibrationMethod method_;
  std::vector<Place> places_, fan_;
  Instrument drawn_;
  std::vector<Measure> free_;
  SimulationRecord record_;
};

}  // namespace

Measures with_play(const Measures& measures, double play, const std::function<double()>& draw) {
  if (play <= 0) return measures;
  const auto slip = [&] {
    const double far = 0.5 * play * std::sqrt(draw());
    return std::polar(far, 2 * pi * draw());
  };
  const auto at = [&](Measure measure) { return measures[index_of(measure)]; };
  const Complex C = slip(), X = at(Measure::CX), Y = at(Measure::CY);
  const Complex A = Complex(at(Measure::CX) - at(Measure::AX), at(Measure::offset_A)) + slip();
  const Complex B = Complex(at(Measure::BC), at(Measure::offset_B)) + slip();
  const Displaced one = displaced(C, A, X), two = displaced(0, B, Y);
  Measures loose = measures;
  loose[index_of(Measure::CX)] = one.outer;
  loose[index_of(Measure::AX)] = one.outer - one.along_from_corner;
  loose[index_of(Measure::offset_A)] = one.across;
  loose[index_of(Measure::CY)] = two.outer;
  loose[index_of(Measure::BC)] = two.along_from_corner;
  loose[index_of(Measure::offset_B)] = two.across;
  loose[index_of(Measure::VB)] += slip().real();
  const Complex pole = slip();
  loose[index_of(Measure::pole_x)] += pole.real();
  loose[index_of(Measure::pole_y)] += pole.imag();
  return loose;
}

std::optional<SimulationRecord> simulate_calibration(const Measurements& spec,
                                                     const std::optional<DrawnDesign>& design,
                                                     std::uint64_t seed,
                                                     const std::function<void(double)>& progress,
                                                     const std::atomic<bool>& interrupted) {
  return Simulation(spec, design, seed).run(progress, interrupted);
}

}  // namespace kempe
