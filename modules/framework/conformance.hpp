// Every law of pose spaces and dyad types as GoogleTests; one line per space, one per list of dyads:
//   BURMESTER_SPACE_CONFORMANCE(mine::Space);
//   BURMESTER_DYAD_CONFORMANCE(mine::Dyads);   // a DyadList; lifted laws for types with a lifted form
// Tests are called <space>_space.<law> and <space>_<dyad>.<law>.
// The laws themselves, without GoogleTest: space_laws.hpp, dyad_laws.hpp.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "burmester/modules/framework/dyad_laws.hpp"
#include "burmester/modules/framework/space_laws.hpp"

namespace burmester::laws {

class LawTest : public testing::Test {
 public:
  LawTest(Law law, std::string subject) : law_(std::move(law)), subject_(std::move(subject)) {}
  void TestBody() override {
    for (const std::string& violation : violations(law_, subject_)) ADD_FAILURE() << violation;
  }

 private:
  Law law_;
  std::string subject_;
};

inline void register_tests(const std::vector<Law>& all, const std::string& suite, const std::string& subject,
                           const char* file, int line) {
  for (const Law& law : all)
    testing::RegisterTest(suite.c_str(), law.name.c_str(), nullptr, nullptr, file, line,
                          [law, subject]() -> LawTest* { return new LawTest(law, subject); });
}

template <PoseSpace S>
bool register_space(const char* file, int line) {
  const std::string name(S::name);
  register_tests(space_laws<S>(), name + "_space", name, file, line);
  return true;
}

template <class List>
bool register_dyads(const char* file, int line) {
  List::for_each([&]<DyadType D>() {
    register_tests(dyad_laws<D>(), std::string(D::Space::name) + "_" + std::string(D::name), subject_of<D>(),
                   file, line);
  });
  return true;
}

}  // namespace burmester::laws

#define BURMESTER_CONFORMANCE_JOIN_(a, b) a##b
#define BURMESTER_CONFORMANCE_NAME_(line) BURMESTER_CONFORMANCE_JOIN_(burmester_conformance_, line)
#define BURMESTER_SPACE_CONFORMANCE(...)                                     \
  [[maybe_unused]] static const bool BURMESTER_CONFORMANCE_NAME_(__LINE__) = \
      ::burmester::laws::register_space<__VA_ARGS__>(__FILE__, __LINE__)
#define BURMESTER_DYAD_CONFORMANCE(...)                                      \
  [[maybe_unused]] static const bool BURMESTER_CONFORMANCE_NAME_(__LINE__) = \
      ::burmester::laws::register_dyads<__VA_ARGS__>(__FILE__, __LINE__)
