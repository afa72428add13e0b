#pragma once
// Instruments with hidden errors that are read, calibrated, corrected and read again: for teaching, and to
// see what a procedure is worth before anybody saws.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "synthesis/calibration/job.hpp"

namespace kempe {

/// How the instruments stand after a round of corrections.
struct SimulatedRound {
  /// Over instruments: largest true departure over the reach, mm
  double residual_mean = 0, residual_largest = 0;
  double reached = 0;   ///< share of instruments within the target
  double coverage = 0;  ///< share of true errors inside this round's 95 % intervals
  std::size_t intervals = 0;
};

struct SimulationRecord {
  int instruments = 0;
  CalibrationMethod method = CalibrationMethod::knight;
  int readings = 0;                                  ///< of each round
  double departure_mean = 0, departure_largest = 0;  ///< before the first correction, mm
  std::vector<SimulatedRound> rounds;
  int failed = 0;  ///< instruments that could not be calibrated
  // The first instrument, to be solved by hand:
  std::vector<Quantity> hidden;                ///< its true errors
  std::vector<ReadingSpec> readings_of_first;  ///< of all its rounds
};

/// Plays `spec.simulation` (it must be there). The same seed gives the same record. Nothing comes back when
/// `interrupted` is set; `progress` gets the share done.
std::optional<SimulationRecord> simulate_calibration(const Measurements& spec,
                                                     const std::optional<DrawnDesign>& design,
                                                     std::uint64_t seed,
                                                     const std::function<void(double)>& progress,
                                                     const std::atomic<bool>& interrupted);

/// What the pins' play does to one reading: at A, B, C and the pole one link stands off the other by up to
/// play / 2 in any direction, at V along the bar VB. `draw` gives numbers evenly spread over 0 .. 1.
Measures with_play(const Measures& measures, double play, const std::function<double()>& draw);

}  // namespace kempe
