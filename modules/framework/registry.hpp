// Modules by name. Filled by explicit calls: a self-registering object in a static library is dropped by the linker.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "burmester/modules/framework/module.hpp"

namespace burmester {

class Registry {
 public:
  /// False (and nothing is changed) if a module of that name is there already.
  bool add(std::unique_ptr<Module> module);
  /// nullptr if there is none.
  const Module* find(std::string_view name) const;
  /// In the order in which they were added.
  std::vector<const Module*> modules() const;

 private:
  std::vector<std::unique_ptr<Module>> modules_;
};

}  // namespace burmester
