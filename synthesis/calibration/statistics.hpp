#pragma once
// The few distributions that calibration needs, in closed form for whole degrees of freedom.

namespace kempe {

/// P(|t| <= value) of Student's t with `freedom` >= 1 degrees of freedom (Abramowitz and
/// Stegun 26.7.3, 26.7.4).
double student_central_probability(double value, int freedom);

/// The value that |t| stays below with `probability` (0 < . < 1).
double student_central_quantile(double probability, int freedom);

/// Half width of the interval that holds `probability` of a normal variable with unit deviation.
double normal_central_quantile(double probability);

/// P(F > value) for 2 `pairs` and `freedom` degrees of freedom, pairs >= 1; freedom 0 stands for infinitely
/// many (then value is chi squared over 2 `pairs`).
double fisher_upper_probability(double value, int pairs, int freedom);

/// P(chi squared > value) for `freedom` >= 1 degrees of freedom (Abramowitz and Stegun 26.4.4, 26.4.5).
double chi_squared_upper_probability(double value, int freedom);

}  // namespace kempe
