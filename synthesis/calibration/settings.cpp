#include "synthesis/calibration/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "synthesis/calibration/plan.hpp"
#include "synthesis/calibration/slack.hpp"

namespace kempe {
namespace {

struct Arrangement {
  Mounting mounting;
  double setting;
};

Arrangement arrangement_for(double ratio, bool reversed) {
  const bool smaller = ratio <= 1;
  if (!reversed && smaller) return {{Joint::X, Joint::Y, Joint::V}, ratio};
  if (!reversed) return {{Joint::X, Joint::V, Joint::Y}, 1 / ratio};
  if (smaller) return {{Joint::V, Joint::Y, Joint::X}, ratio / (1 + ratio)};
  return {{Joint::V, Joint::X, Joint::Y}, 1 / (1 + ratio)};
}

/// The instrument at one setting, looked at over the arm angles.
class Fan {
 public:
  Fan(const SettingTask& task, const Arrangement& arrangement) : task_(task) {
    CalibrationTask places;
    places.setups = {variable_ratio_instrument(task.arm, arrangement.setting).mounted(arrangement.mounting)};
    instrument_ = places.setups.front();
    constexpr int count = 13;
    for (const Candidate& at :
         candidates_on_axis(places, 0, task.arm, task.arm_angles.lower, task.arm_angles.upper, count))
      inputs_.push_back(at.input);
  }

  /// Departures, x and y in turn, and their slopes by the four scales; false where the linkage does not
  /// close.
  bool departures(const Measures& corrections, Eigen::VectorXd& values, Eigen::MatrixXd& slopes) const {
    values.resize(static_cast<Eigen::Index>(2 * inputs_.size()));
    slopes.resize(values.size(), 4);
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      const auto output =
          output_at(instrument_, instrument_.drawn + task_.deviations + corrections, inputs_[i]);
      if (!output) return false;
      const auto row = static_cast<Eigen::Index>(2 * i);
      values.segment<2>(row) = output->at - wanted_output(instrument_, inputs_[i]);
      for (std::size_t j = 0; j < 4; ++j)
        slopes.block<2, 1>(row, static_cast<Eigen::Index>(j)) = output->by.col(index_of(scales[j].measure));
    }
    return true;
  }

  /// Largest standard uncertainty of a departure in any direction, from the calibration's covariance.
  double uncertainty() const {
    double largest = 0;
    for (const Point& input : inputs_)
      if (const auto output = output_at(instrument_, instrument_.drawn, input)) {
        const Eigen::Matrix2d spread = output->by * task_.covariance * output->by.transpose();
        const double half = 0.5 * spread.trace(),
                     apart = std::hypot(0.5 * (spread(0, 0) - spread(1, 1)), spread(0, 1));
        largest = std::max(largest, std::sqrt(std::max(0.0, half + apart)));
      }
    return largest;
  }

 private:
  const SettingTask& task_;
  Instrument instrument_;
  std::vector<Point> inputs_;
};

double largest_departure(const Eigen::VectorXd& values) {
  double largest = 0;
  for (Eigen::Index i = 0; i < values.size(); i += 2)
    largest = std::max(largest, values.segment<2>(i).norm());
  return largest;
}

/// Gauss-Newton: the departures are all but linear in settings that are off by a thousandth.
bool correct(const Fan& fan, Measures& corrections, Eigen::VectorXd& values) {
  Eigen::MatrixXd slopes;
  for (int step = 0; step < 6; ++step) {
    if (!fan.departures(corrections, values, slopes)) return false;
    const Eigen::Vector4d move = solution_of(slopes.colPivHouseholderQr(), -values);
    for (std::size_t j = 0; j < 4; ++j)
      corrections[index_of(scales[j].measure)] += move[static_cast<Eigen::Index>(j)];
    if (move.norm() < slack::corrections_at_rest) break;
  }
  return fan.departures(corrections, values, slopes);
}

}  // namespace

SettingRow setting_for(const SettingTask& task, const WantedRatio& wanted, bool reversed) {
  const Arrangement arrangement = arrangement_for(wanted.value, reversed);
  SettingRow row{.ratio = wanted.text,
                 .reversed = reversed,
                 .pole = arrangement.mounting.pole,
                 .tracer = arrangement.mounting.input,
                 .pen = arrangement.mounting.output,
                 .setting = arrangement.setting,
                 .corrections = {},
                 .scales = {},
                 .impossible = {}};
  if (!(row.setting >= smallest_setting && row.setting <= largest_setting)) {
    row.impossible = fmt::format("its setting {:.4g} is not within {} to {}", row.setting, smallest_setting,
                                 largest_setting);
    return row;
  }
  const Fan fan(task, arrangement);
  Measures corrections = Measures::Zero();
  Eigen::VectorXd values;
  Eigen::MatrixXd slopes;
  if (!fan.departures(corrections, values, slopes)) {
    row.impossible = "with these errors the instrument does not reach the arm angles";
    return row;
  }
  row.before = largest_departure(values);
  if (!correct(fan, corrections, values)) {
    row.impossible = "no correction brings it within reach of the arm angles";
    return row;
  }
  row.corrections = scale_errors_of(corrections);
  const double nominal = row.setting * task.arm;
  const auto c = row.corrections.values();
  row.scales = {nominal + c[0], nominal + c[1], nominal + c[2], nominal + c[3]};
  row.remaining = largest_departure(values);
  // The largest over all arm angles and directions at once, as the four scales' errors fall (Scheffe): the 95
  // % point of chi squared with four degrees of freedom over that of one.
  const double all_at_once = std::sqrt(9.487729 / 3.841459);
  row.predicted = row.remaining + all_at_once * task.coverage_factor * fan.uncertainty();
  return row;
}

std::vector<SettingRow> setting_table(const SettingTask& task, const std::vector<WantedRatio>& wanted) {
  std::vector<SettingRow> rows;
  for (const WantedRatio& one : wanted)
    for (const bool reversed : {false, true}) rows.push_back(setting_for(task, one, reversed));
  return rows;
}

}  // namespace kempe
