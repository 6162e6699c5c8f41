// How often tests repeat what is random.
#pragma once

namespace burmester {

/// n; a tenth of it with AddressSanitizer, where every step takes several times as long and what is looked for is a
/// fault of the code on a path, not a rare task: those are searched for without.
constexpr int repetitions(int n) {
#ifdef __SANITIZE_ADDRESS__
  return n / 10;
#else
  return n;
#endif
}

}  // namespace burmester
