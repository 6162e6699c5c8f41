// P/R dyads by name, in any geometry that has them.
//
// A dyad carries the coupler by two joints, named from the fixed to the moving body: RR a crank or rocker, PR
// a slider on the ground that turns on the coupler, RP a slide through a block that turns on the ground, PP
// two slides. Exchanging the two bodies reads the name backwards (on the sphere a slider is its own inverse:
// see its module).
//
// Two dyads with a common coupler close a linkage, named round its loop from the ground: the first dyad as
// written, the second backwards, RR before PR before RP before PP.
//
// What each type is as a constraint stands with its geometry: <burmester/planar/dyads.hpp>,
// <burmester/spherical/dyads.hpp>.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace burmester {

enum class Joint : char { revolute = 'R', prismatic = 'P' };

/// All P/R dyad types, in the order in which results list them.
inline constexpr std::array<std::string_view, 4> dyad_names{"RR", "PR", "RP", "PP"};

/// Place of a type in that order, 0 to 3; 4 for any other name.
int type_rank(std::string_view type);

/// The joint at the fixed body and the one at the moving body. Precondition: a P/R dyad type.
Joint fixed_joint(std::string_view type);
Joint moving_joint(std::string_view type);

/// The type seen after exchange of the fixed and the moving body, in the plane: PR <-> RP, RR and PP stay.
std::string inverse_type(std::string_view type);

/// Whether two dyads of these types close a linkage. Two PP do not: their coupler translates freely.
bool pairs(std::string_view first, std::string_view second);

/// RRRR, RRRP, RRPR, RRPP, PRRP, PRPR, PRPP, RPPR or RPPP, whichever dyad is named first.
/// Precondition: pairs(first, second).
std::string linkage_type(std::string_view first, std::string_view second);

}  // namespace burmester
