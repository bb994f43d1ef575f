// The one file that reads Eigen.
#include "tests/oracle/dense.h"

#include <Eigen/Dense>

namespace joints::testing {

namespace {

using Read = Eigen::Map<const Eigen::MatrixXd>;
using Write = Eigen::Map<Eigen::MatrixXd>;

Read read(const Dense& A) { return {A.data(), A.rows(), A.columns()}; }
Write write(Dense& A) { return {A.data(), A.rows(), A.columns()}; }

Dense dense(const Eigen::MatrixXd& A) {
  Dense out(A.rows(), A.cols());
  write(out) = A;
  return out;
}

}  // namespace

Dense::Dense(long rows, long columns)
    : rows_(rows), columns_(columns), numbers_(std::size_t(rows * columns)) {}

Dense::Dense(long rows, long columns, const std::vector<double>& row_by_row)
    : Dense(rows, columns) {
  eigen_assert(long(row_by_row.size()) == size());
  for (long i = 0; i < size(); ++i) (*this)(i / columns, i % columns) = row_by_row[std::size_t(i)];
}

Dense Dense::identity(long size) { return dense(Eigen::MatrixXd::Identity(size, size)); }

Dense Dense::block(long row, long column, long rows, long columns) const {
  return dense(read(*this).block(row, column, rows, columns));
}

Dense Dense::rows_at(const std::vector<int>& which) const {
  return dense(read(*this)(which, Eigen::all));
}

void Dense::add(long row, long column, const Dense& other) {
  write(*this).block(row, column, other.rows_, other.columns_) += read(other);
}

Dense Dense::transpose() const { return dense(read(*this).transpose()); }

double Dense::norm() const { return read(*this).norm(); }
double Dense::largest() const { return size() > 0 ? read(*this).cwiseAbs().maxCoeff() : 0; }
bool Dense::finite() const { return read(*this).allFinite(); }

Dense& Dense::operator+=(const Dense& other) {
  write(*this) += read(other);
  return *this;
}
Dense& Dense::operator*=(double factor) {
  write(*this) *= factor;
  return *this;
}

Dense operator*(const Dense& A, const Dense& B) { return dense(read(A) * read(B)); }
double dot(const Column& a, const Column& b) { return read(a).col(0).dot(read(b).col(0)); }

// One decomposition for all that is solved here: the slowest and the one that is never surprised.
Dense inverse_of(const Dense& A) { return dense(read(A).fullPivLu().inverse()); }
Column solved(const Dense& A, const Column& b) { return dense(read(A).fullPivLu().solve(read(b))); }
long rank_of(const Dense& A, double threshold) {
  auto lu = read(A).fullPivLu();
  return lu.setThreshold(threshold).rank();
}
double determinant_of(const Dense& A) { return read(A).fullPivLu().determinant(); }

Column symmetric_eigenvalues(const Dense& A) {
  return dense(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(read(A)).eigenvalues());
}
Dense symmetric_eigenvectors(const Dense& A) {
  return dense(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(read(A)).eigenvectors());
}

double spectral_radius(const Dense& A) {
  // Gelfand: the k-th root of the norm of A^k, here with k = 2^50, by squaring
  Dense power = A;
  double logarithm = 0, share = 1;
  for (int squared = 0; squared < 50; ++squared, share /= 2) {
    const double size = power.norm();
    if (size == 0) return 0;
    logarithm += share * std::log(size);
    power = power / size;
    power = power * power;
  }
  return std::exp(logarithm);
}

Dense rotation_of(double w, double x, double y, double z) {
  return dense(Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix());
}

double difference(const Column& yours, const Column& expected) {
  return (yours - expected).largest() / std::max(1.0, expected.largest());
}

}  // namespace joints::testing
