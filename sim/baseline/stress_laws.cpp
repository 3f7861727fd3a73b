// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/stress_laws.h"

#include <cmath>

#include <Eigen/Dense>

namespace torsio {

namespace {

Eigen::Map<const Eigen::Matrix3d> matrix(const Matrix3& values) {
  return Eigen::Map<const Eigen::Matrix3d>(values.data());
}

Matrix3 numbers(const Eigen::Matrix3d& m) {
  Matrix3 values;
  Eigen::Map<Eigen::Matrix3d>(values.data()) = m;
  return values;
}

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// A polar decomposition that is in doubt: the element is flat or turned inside out.
Eigen::Matrix3d rotationBySingularValues(const Eigen::Matrix3d& f) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) {
    u.col(2) *= -1.0;
  }
  return u * svd.matrixV().transpose();
}

/// Newton's iteration R <- (g R + R^-T / g) / 2 (Higham 1986), quadratic; scaled in its first steps only.
Eigen::Matrix3d polarRotation(const Eigen::Matrix3d& f) {
  constexpr int kMaxSteps = 24;
  constexpr double kDone = 1e-28;
  constexpr double kFlat = 1e-3;
  const double scale = f.norm();
  if (!(f.determinant() > kFlat * scale * scale * scale)) {
    return rotationBySingularValues(f);
  }
  Eigen::Matrix3d r = f;
  for (int i = 0; i < kMaxSteps; ++i) {
    Eigen::Matrix3d cofactor;
    cofactor.col(0) = r.col(1).cross(r.col(2));
    cofactor.col(1) = r.col(2).cross(r.col(0));
    cofactor.col(2) = r.col(0).cross(r.col(1));
    const Eigen::Matrix3d next = 0.5 * (r + cofactor / r.col(0).dot(cofactor.col(0)));
    const double change = (next - r).squaredNorm();
    r = next;
    if (change < kDone) {
      break;
    }
  }
  return r;
}

/// The tangent whose column k is `change(dF, k)`, the change of P by number k of F.
template <typename Change>
Matrix9 tangentOf(const Change& change) {
  Matrix9 tangent;
  Eigen::Map<Eigen::Matrix<double, 9, 9>> a(tangent.data());
  for (int k = 0; k < 9; ++k) {
    Eigen::Matrix3d df = Eigen::Matrix3d::Zero();
    df(k % 3, k / 3) = 1.0;
    const Eigen::Matrix3d dp = change(df, k);
    a.col(k) = dp.reshaped();
  }
  return tangent;
}

}  // namespace

StressState neoHookeanStress(const Matrix3& gradient, const ElasticConstants& constants) {
  const Eigen::Matrix3d f = matrix(gradient);
  const double g = constants.shearModulus_Pa;
  const double logJ = std::log(f.determinant());
  const Eigen::Matrix3d stress = g * f + (constants.lame_Pa() * logJ - g) * f.inverse().transpose();
  return {0.5 * g * (f.squaredNorm() - 3.0) - g * logJ + 0.5 * constants.lame_Pa() * logJ * logJ,
          numbers(stress)};
}

Matrix9 neoHookeanTangent(const Matrix3& gradient, const ElasticConstants& constants) {
  const Eigen::Matrix3d f = matrix(gradient);
  const double g = constants.shearModulus_Pa;
  const double lambda = constants.lame_Pa();
  const Eigen::Matrix3d h = f.inverse().transpose();
  const double turned = g - lambda * std::log(f.determinant());
  // dP = G dF + (G - lambda ln J) F^-T dF^T F^-T + lambda (F^-T : dF) F^-T
  return tangentOf([&](const Eigen::Matrix3d& df, int k) -> Eigen::Matrix3d {
    return g * df + turned * h * df.transpose() * h + lambda * h(k % 3, k / 3) * h;
  });
}

Matrix3 rotationOf(const Matrix3& gradient) {
  return numbers(polarRotation(matrix(gradient)));
}

StressState corotationalStress(const Matrix3& gradient, const ElasticConstants& constants) {
  const Eigen::Matrix3d f = matrix(gradient);
  const Eigen::Matrix3d r = polarRotation(f);
  const double g = constants.shearModulus_Pa;
  const double trace = r.cwiseProduct(f).sum() - 3.0;
  const Eigen::Matrix3d shape = f - r;
  return {g * shape.squaredNorm() + 0.5 * constants.lame_Pa() * trace * trace,
          numbers(2.0 * g * shape + constants.lame_Pa() * trace * r)};
}

Matrix9 corotationalTangent(const Matrix3& gradient, const ElasticConstants& constants) {
  const Eigen::Matrix3d f = matrix(gradient);
  const Eigen::Matrix3d r = polarRotation(f);
  const Eigen::Matrix3d s = r.transpose() * f;
  const double g = constants.shearModulus_Pa;
  const double lambda = constants.lame_Pa();
  const Eigen::Matrix3d spin = (s.trace() * Eigen::Matrix3d::Identity() - s).inverse();
  const double turning = lambda * (s.trace() - 3.0) - 2.0 * g;
  // dR = R [w], (tr S I - S) w = axial(R^T dF - dF^T R)
  return tangentOf([&](const Eigen::Matrix3d& df, int /*k*/) -> Eigen::Matrix3d {
    const Eigen::Matrix3d w = r.transpose() * df;
    const Eigen::Vector3d axial(w(2, 1) - w(1, 2), w(0, 2) - w(2, 0), w(1, 0) - w(0, 1));
    const Eigen::Matrix3d dr = r * crossMatrix(spin * axial);
    return 2.0 * g * df + turning * dr + lambda * w.trace() * r;
  });
}

}  // namespace torsio
