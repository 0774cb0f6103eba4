#pragma once

// The only file that includes Eigen: vectors and matrices of the simulation (double) and of what is drawn
// (float).

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace drape {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Quaternion = Eigen::Quaterniond;

// A fourth value, 0, makes up a vector register.
inline Vec4 padded(const Vec3& x) { return {x.x(), x.y(), x.z(), 0}; }

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Vec4f = Eigen::Vector4f;
using Mat4f = Eigen::Matrix4f;

}  // namespace drape
