// What to say about five poses, by case: status, counts and one sentence with the reason.
#pragma once

#include <string>

#include "burmester/modules/framework/record.hpp"
#include "burmester/planar/five_pose_roots.hpp"

namespace burmester::planar {

struct Verdict {
  Status status = Status::exact;
  SolutionCounts counts;
  std::string message;
};

/// `real`: isolated real dyads listed; `family_type`: dyad type of a member of the family (common_line only).
Verdict verdict(FivePoseCase what, FivePoses poses, int real, const std::string& family_type);

}  // namespace burmester::planar
