#pragma once
/// @file
/// The whole library: copying linkages designed, mapped, verified and written; any planar linkage moved; generators; calibration.
///
/// Lengths are millimetres and angles radians everywhere; places are in the table's frame. A function never throws for what
/// a spec, a file or a folder may be: the answer says it. There is no global state.

#include "kempe/calibrate.hpp"
#include "kempe/design.hpp"
#include "kempe/generators.hpp"
#include "kempe/linkage.hpp"
#include "kempe/point.hpp"
#include "kempe/sketch.hpp"
#include "kempe/spec.hpp"
#include "kempe/trace.hpp"
#include "kempe/validate.hpp"
#include "kempe/verify.hpp"
#include "kempe/write.hpp"

/// Design synthesis for copying linkages.
namespace kempe {

/// Units: lengths are millimetres and angles radians, always. Multiply a number by these, or by rad and degree (kempe/point.hpp), to say
/// what it is.
inline constexpr double mm = 1;
/// The same of an inch.
inline constexpr double inch = 25.4;

}  // namespace kempe
