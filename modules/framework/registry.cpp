#include "burmester/modules/framework/registry.hpp"

namespace burmester {

bool Registry::add(std::unique_ptr<Module> module) {
  if (find(module->info().name)) return false;
  modules_.push_back(std::move(module));
  return true;
}

const Module* Registry::find(std::string_view name) const {
  for (const auto& module : modules_)
    if (module->info().name == name) return module.get();
  return nullptr;
}

std::vector<const Module*> Registry::modules() const {
  std::vector<const Module*> out;
  for (const auto& module : modules_) out.push_back(module.get());
  return out;
}

}  // namespace burmester
