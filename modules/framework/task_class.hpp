// Tasks by name, made at random: what tests, benchmarks and studies draw from. Each geometry lists its own.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "burmester/geometry/random.hpp"

namespace burmester {

template <class Task>
struct TaskClassOf {
  std::string_view name;
  std::string_view what;  ///< one line for people
  Task (*make)(Random&);
};

/// A class of one of the lists by name; nullptr if there is none.
template <class Task>
const TaskClassOf<Task>* find_class(std::string_view name,
                                    std::initializer_list<const std::vector<TaskClassOf<Task>>*> lists) {
  for (const auto* list : lists)
    for (const TaskClassOf<Task>& c : *list)
      if (c.name == name) return &c;
  return nullptr;
}

}  // namespace burmester
