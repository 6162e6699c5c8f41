// Small fixed-size vectors and matrices.
//
// Eigen types without over-alignment: a consumer compiled with -march=native (where Eigen would align
// a double[4] to 32 bytes) and the portable library agree on the layout of every public type.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace burmester {

template <class T, int N>
using Vector = Eigen::Matrix<T, N, 1, Eigen::DontAlign>;

template <class T, int Rows, int Cols>
using Matrix = Eigen::Matrix<T, Rows, Cols, Eigen::DontAlign>;

}  // namespace burmester
