// Dense matrices in double, for the tests' own calculations. All of the arithmetic is
// Eigen's. It stands in dense.cpp alone: reading Eigen takes a compiler seconds.
#pragma once

#include <vector>

namespace joints::testing {

/// A matrix; a column of numbers is one of a single column. Fresh entries are zero.
class Dense {
 public:
  Dense() = default;
  explicit Dense(long rows, long columns = 1);
  Dense(long rows, long columns, const std::vector<double>& row_by_row);
  static Dense identity(long size);

  long rows() const { return rows_; }
  long columns() const { return columns_; }
  long size() const { return rows_ * columns_; }
  double& operator()(long row, long column) { return numbers_[place(row, column)]; }
  double operator()(long row, long column) const { return numbers_[place(row, column)]; }
  double& operator[](long row) { return numbers_[place(row, 0)]; }
  double operator[](long row) const { return numbers_[place(row, 0)]; }
  double* data() { return numbers_.data(); }  ///< column by column
  const double* data() const { return numbers_.data(); }
  const double* begin() const { return data(); }
  const double* end() const { return data() + size(); }
  bool operator==(const Dense&) const = default;

  Dense block(long row, long column, long rows, long columns) const;
  Dense rows_from(long row, long count) const { return block(row, 0, count, columns_); }
  Dense columns_from(long column, long count) const { return block(0, column, rows_, count); }
  /// These rows, in this order.
  Dense rows_at(const std::vector<int>& which) const;
  /// Adds a matrix to the entries from there on.
  void add(long row, long column, const Dense& other);
  Dense transpose() const;

  double norm() const;     ///< root of the sum of all squares
  double largest() const;  ///< absolute value of any entry
  bool finite() const;

  Dense& operator+=(const Dense& other);
  Dense& operator*=(double factor);

 private:
  std::size_t place(long row, long column) const { return std::size_t(column * rows_ + row); }
  long rows_ = 0, columns_ = 0;
  std::vector<double> numbers_;
};
using Column = Dense;

Dense operator*(const Dense& A, const Dense& B);
double dot(const Column& a, const Column& b);
inline Dense operator+(Dense A, const Dense& B) { return A += B; }
inline Dense operator*(double factor, Dense A) { return A *= factor; }
inline Dense operator/(Dense A, double divisor) { return A *= 1 / divisor; }
inline Dense operator-(Dense A) { return A *= -1; }
inline Dense operator-(Dense A, const Dense& B) { return A += -B; }

Dense inverse_of(const Dense& A);                ///< of a matrix that has one
Column solved(const Dense& A, const Column& b);  ///< x in A x = b; one of them where there are many
long rank_of(const Dense& A, double threshold);  ///< pivots below it count as zero [1]
double determinant_of(const Dense& A);

Column symmetric_eigenvalues(const Dense& A);  ///< in increasing order
Dense symmetric_eigenvectors(const Dense& A);  ///< of length 1, at right angles, a column each
/// The largest absolute value of an eigenvalue of any square matrix.
double spectral_radius(const Dense& A);

/// The matrix of the rotation that a quaternion of any length stands for.
Dense rotation_of(double w, double x, double y, double z);

/// The largest difference of two columns over the largest number of the second (at least 1).
double difference(const Column& yours, const Column& expected);

}  // namespace joints::testing
