#include "burmester/modules/framework/record.hpp"

namespace burmester {

std::string_view name_of(Status status) {
  switch (status) {
    case Status::exact: return "exact";
    case Status::approximate: return "approximate";
    case Status::family: return "family";
    case Status::none: return "none";
    case Status::degenerate: return "degenerate";
  }
  return "none";
}

}  // namespace burmester
