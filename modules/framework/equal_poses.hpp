// Names equal poses for people: the words are the same in every geometry.
#pragma once

#include <functional>
#include <string>

namespace burmester {

/// "poses 2 and 4 are equal: in effect 4 poses, in general met by a curve of dyads .." for up to five poses, counted
/// from 1. same(i, j): whether poses i < j, counted from 0, are equal. Precondition: two of them are.
std::string name_equal_poses(const std::function<bool(int, int)>& same, int count = 5);

}  // namespace burmester
