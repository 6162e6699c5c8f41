// A synthesis problem as a module receives it, and the two ways in which one cannot be answered.
#pragma once

#include <cstddef>
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

/// Which linkages from pairs of points of a curve of dyads are listed. What is not asked for is the module's choice.
struct LinkageRequest {
  struct Box {
    std::vector<double> low, high;  ///< corners, both belong to it
  };
  std::optional<Box> fixed_in, moving_in;  ///< where the pivots may be, in S and in E
  std::vector<std::string> classes;        ///< empty: all
  std::optional<double> largest_ratio;     ///< of the longest to the shortest link
  std::optional<std::size_t> most;         ///< length of the list
};

struct Problem {
  std::string geometry, name, source;
  Units units;
  std::vector<PoseData> poses;
  std::vector<std::string> types;                   ///< dyad types to list; empty: all
  std::vector<std::vector<double>> fixed, moving;   ///< dyads are asked for with these pivots
  std::vector<std::optional<double>> weights;       ///< more than five poses; no value: the pose is met exactly
  std::vector<std::vector<double>> near;            ///< four poses: places near which a dyad is wanted
  std::optional<LinkageRequest> linkages;           ///< four poses
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
