// A synthesis problem as a module receives it, and the two ways in which one cannot be answered.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace burmester {

struct Units {
  std::string length;   ///< a label only; no conversion
  bool degrees = true;  ///< angles in files: degrees, or radians
};

/// The exact data of one pose: the doubles that fast solver, certificate and oracle read as exact numbers
/// (planar x, y, X3, X4; spherical the quaternion w, x, y, z).
using PoseData = std::vector<double>;

struct Problem {
  std::string geometry, name, source;
  Units units;
  std::vector<PoseData> poses;
  std::vector<std::string> types;                   ///< dyad types to list; empty: all
  std::vector<std::vector<double>> fixed, moving;   ///< dyads are asked for with these pivots
  std::vector<std::optional<double>> weights;       ///< more than five poses; no value: the pose is met exactly
  std::vector<std::vector<double>> near;            ///< four poses: places near which a dyad is wanted
  bool certify = true;                              ///< prove the answer where that is known how
  std::vector<std::string> warnings;                ///< what the reader noticed
};

/// Bad input. what() is one line: file, place, what was expected.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A request that is understood but that this version cannot answer. what() says which; callers put
/// "not available yet: " in front.
class NotAvailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace burmester
