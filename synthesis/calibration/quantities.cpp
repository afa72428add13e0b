// A calibration in the names that a maker uses, with the uncertainty of each.
#include <algorithm>
#include <cmath>

#include "synthesis/calibration/job.hpp"
#include "synthesis/calibration/slack.hpp"

namespace kempe {

std::string spoken_name(Measure measure, bool variable_ratio) {
  if (!variable_ratio) return std::string(name(measure));
  switch (measure) {
    case Measure::AX: return "AC";
    case Measure::BC: return "CF";
    case Measure::VA: return "BE";
    case Measure::VB: return "DE";
    case Measure::CX: return "arm_AC";
    case Measure::CY: return "arm_CF";
    case Measure::offset_A: return "bearing_B";
    case Measure::offset_B: return "bearing_D";
    default: return std::string(name(measure));
  }
}

namespace {

using Row = Eigen::Matrix<double, 1, measure_count>;

class QuantityMaking {
 public:
  QuantityMaking(const Instrument& reference, const Calibration& calibration)
      : reference_(reference), calibration_(calibration) {}

  void add(std::string name, Quantity::Kind kind, double drawn, double error, const Row& by) {
    Quantity quantity{std::move(name), kind, drawn, error};
    quantity.uncertainty = std::sqrt(std::max(0.0, (by * calibration_.covariance * by.transpose()).value()));
    for (const Indistinct& one : calibration_.indistinct) {
      double moves = 0;
      for (const Indistinct::Part& part : one.parts) moves += by[index_of(part.measure)] * part.factor;
      if (std::abs(moves) > slack::hardly_moves) quantity.determined = false;
    }
    table_.quantities.push_back(std::move(quantity));
    rows_.push_back(by);
  }

  void add(std::string name, Quantity::Kind kind, Measure measure, double sign = 1) {
    Row by = Row::Zero();
    by[index_of(measure)] = sign;
    add(std::move(name), kind, reference_.drawn[index_of(measure)],
        sign * calibration_.deviations[index_of(measure)], by);
  }

  QuantityTable table() {
    table_.by.resize(static_cast<Eigen::Index>(rows_.size()), measure_count);
    for (std::size_t i = 0; i < rows_.size(); ++i) table_.by.row(static_cast<Eigen::Index>(i)) = rows_[i];
    return std::move(table_);
  }

 private:
  const Instrument& reference_;
  const Calibration& calibration_;
  QuantityTable table_;
  std::vector<Row> rows_;
};

}  // namespace

QuantityTable quantities_of(const Instrument& reference, bool variable_ratio,
                            const std::vector<Measure>& free, const Calibration& calibration) {
  QuantityMaking making(reference, calibration);
  const auto is_free = [&](Measure measure) {
    return std::find(free.begin(), free.end(), measure) != free.end();
  };
  const auto add_free = [&](Measure measure, Quantity::Kind kind) {
    if (is_free(measure)) making.add(spoken_name(measure, variable_ratio), kind, measure);
  };
  using Kind = Quantity::Kind;
  if (variable_ratio) {
    for (std::size_t i = 0; i < scales.size(); ++i)
      if (is_free(scales[i].measure))
        making.add(std::string(ScaleErrors::names[i]), Kind::scale, scales[i].measure, scales[i].sign);
    for (const Measure measure : {Measure::CX, Measure::CY}) add_free(measure, Kind::length);
  } else if (is_free(Measure::VA)) {
    const auto drawn = lengths_of(reference.drawn),
               made = lengths_of(reference.drawn + calibration.deviations);
    for (int i = 0; i < 8; ++i)
      making.add(std::string(LinkLengths::names[static_cast<std::size_t>(i)]), Kind::length, drawn.values[i],
                 made.values[i] - drawn.values[i], made.by.row(i));
  }
  if (variable_ratio || is_straight(reference))
    for (const Measure measure : {Measure::offset_A, Measure::offset_B}) add_free(measure, Kind::length);
  for (const Measure measure :
       {Measure::pole_x, Measure::pole_y, Measure::origin_x, Measure::origin_y, Measure::turn})
    add_free(measure, Kind::placement);
  return making.table();
}

}  // namespace kempe
