#pragma once
// Every slack and threshold of the proof log, each with its unit and its reason. What is guessed here in doubles the checker
// decides in intervals: slack that is too small costs lines of the log, never its truth.

#include "geometry/slack.hpp"

namespace kempe::slack {

/// Share, and mm: what a guess in doubles keeps in hand, so that the checker's own rounding does not decide otherwise.
inline constexpr double in_hand = 1e-9;
/// Share of a variable's size, or of the distances, below which nothing is cut: what is not refuted there is the design that the
/// bound belongs to.
inline constexpr double narrowest_cut = 1e-9;
/// None: weight of a variable's width beside its share in what a sum lacks, so that one without a share is cut last.
inline constexpr double width_weight = 1e-9;
/// Factor: a variable wider than this many times the one to be cut is cut first. (2 to 8 take about as many lines; without, trees
/// with a free pole are ten times as long where contacts decide.)
inline constexpr double most_uneven = 2;
/// Factor: so many times narrower than the lengths poles become where they are cut first.
inline constexpr double most_uneven_of_poles = 256;
/// Share of the area's sides down to which poles alone are cut, where they bring tracer or pen into an obstruction.
inline constexpr double narrowest_poles = 1.0 / 64;
/// rad: of a cell as wide as its middle, the narrowest range of openings that a contact cuts. In narrower cells it falls with their width.
inline constexpr double narrowest_passed = 1e-2;
/// Share of a range within which its middle is rounded to fewer digits before it is cut there. (With a sixteenth instead, trees have a
/// tenth more lines.)
inline constexpr double short_cut = 0.01;
/// None: the weights of a sum, the largest being 1, are rounded to whole multiples of 1 / this.
inline constexpr double steps_of_weights = 1e4;
/// Shares by which the bound is given way, tried in this order until a proof comes out. At the last every tree has a few lines a root: no
/// design has the size 0, none a transmission angle of 90 degrees.
inline constexpr double given_way[] = {0.0,  1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.02,
                                       0.05, 0.1,  0.2,  0.3,  0.5,  1.0};
/// The least of these shares that is worth another try where a proof was too long.
inline constexpr double much_shorter = 1e-3;
/// Sine: the sides of a plate nearer to one line than this span no triangle.
inline constexpr double flat_plate = 1e-9;
/// mm: a point so near to a side lies on it.
inline constexpr double on_side = 1e-12;
/// None: the shares of a point of a plate add up to no more; their sum may not pass 1 by rounding.
inline constexpr double inside_plate = 1 - 1e-15;
/// Share of the region's diagonal and of the place's distance: a place deeper in the region is inside it.
inline constexpr double inside_region = 1e-9;
/// Factor: half of a cell's width, surely.
inline constexpr double whole_half = 1 + rounding;
/// mm: a place counts as no nearer to the pole where it is weighed or a cell's width is judged.
inline constexpr double nearest_weighed = 1e-3;
/// Share of the region's diagonal: places deeper in the region than this are looked at for obstacles.
inline constexpr double spread_inside = 1e-3;
/// Share of the openings passed: a cut leaves at least so much on either side, in narrow cells a tenth of their width.
inline constexpr double least_side_of_cut = 1e-3;
/// rad: how far beyond the openings that the copy error leaves a log cuts, so that the error there is surely above its limit.
inline constexpr double beyond_copy_error = 1e-8;

}  // namespace kempe::slack
