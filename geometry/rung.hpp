// Which arithmetic decided: the ladder of every proof here.
#pragma once

namespace burmester {

/// none: nothing proved. doubles: plain doubles with a derived error bound. intervals: intervals of doubles.
/// exact: integers or rationals of any size.
enum class Rung { none, doubles, intervals, exact };

}  // namespace burmester
