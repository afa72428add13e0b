#pragma once
// The load error as waves over the opening, for the proven bound's backends.
//
// At one opening d the pen gives way in one direction by a sum of squares (synthesis/loads/load_error.hpp): of the components of forces, each
// times a power of VA or VB, all over sin^2 d. Times the sine each component is a wave a + b cos d + c sin d + e cos 2d + f sin 2d, finite
// at a change point too. So a linkage keeps its limit only where the root of the sum of the waves' squares, in units of the limit, is at most |sin d|.
//
// Over a wide range of openings the floor of load_floor.hpp, in which most components stand without the sine, is the higher one.

#include <array>
#include <vector>

#include "geometry/interval.hpp"
#include "specs/spec.hpp"
#include "synthesis/bound/box.hpp"

namespace kempe::bounding {

/// Cosine and sine of d, and of twice d, over a range.
struct Phase {
  Interval cosine, sine, cosine_2, sine_2;
};
/// Over a range of psi (rad).
Phase phase_at(const ModeFacts& mode, const Interval& psi);

/// a + b cos d + c sin d + e cos 2d + f sin 2d.
struct Wave {
  Interval a{0}, b{0}, c{0}, e{0}, f{0};

  Interval at(const Phase& d) const { return a + b * d.cosine + c * d.sine + e * d.cosine_2 + f * d.sine_2; }
  Wave derivative() const { return {Interval(0), c, -b, 2.0 * f, -2.0 * e}; }
};
Wave operator*(const Interval& factor, const Wave& wave);
Wave operator+(const Wave& one, const Wave& other);

/// One of the squares is that of `wave`, at the lengths that were asked for. It grows with VA^power, or with VB^power.
struct LoadWave {
  Wave wave;
  bool is_of_VA;
  int power;  ///< 3 or 1
};

/// A force, for 1 N at Y (synthesis/loads/link_forces.hpp), times the sine of d: the sum of by[n] e^{i (n - 1) d}.
struct TurningForce {
  std::array<IntervalComplex, 4> by{exactly(0.0), exactly(0.0), exactly(0.0), exactly(0.0)};
};

/// Of all linkages of one grounding and assembly mode.
class LoadWaves {
 public:
  /// Of a spec with load, material and a limit on the load error.
  LoadWaves(const Spec& spec, const ModeFacts& mode);

  /// The waves of a linkage with VA and VB (mm), in units of the limit, in the direction in which it gives way most at `d`, about.
  std::vector<LoadWave> of(const Interval& VA, const Interval& VB, const Phase& d) const;
  /// 1 or -1, as the sine of d is over all openings of the assembly mode.
  double sign_of_sine() const { return sign_; }

 private:
  /// coefficient * length^power * (force . direction)^2 / sin^2 d is a term of the load error over its limit.
  struct Term {
    Interval coefficient;
    TurningForce force;
    bool is_of_VA;
    int power;
  };
  std::vector<Term> terms_;
  double sign_;
};

/// A wave that is nowhere above the root of the sum of the squares, and touches it at about `d`: by the inequality of Cauchy and Schwarz the
/// waves, each weighted by its share there.
Wave touching_from_below(const std::vector<LoadWave>& waves, const Phase& d);

/// Slopes of that root along the logarithms of t and w, over the range `all` of d; `about` (rad): that range less the place `d`.
struct SlopesOfRoot {
  Interval by_log_t, by_log_w;
};
SlopesOfRoot slopes_of_root(const std::vector<LoadWave>& waves, const Phase& d, const Phase& all,
                            const Interval& about);

}  // namespace kempe::bounding
