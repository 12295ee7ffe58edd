// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions as a straight-line program over doubles, with the slope of each value in all numbers of the
// point. The evaluator walks the tree once and writes the program; running it at a point takes about 10 ns
// for an instruction, where a walk takes a hundred times as long.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "algebra/point/scope.h"

namespace rigor {

/// How many particles there are at a rough point.
inline constexpr std::uint32_t rough_particles = 2;

/// Where the numbers of the free symbols are in the vector of all.
class RoughLayout {
 public:
  RoughLayout(const ExprTree& tree, const std::vector<SymbolId>& symbols);
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t place(SymbolId symbol, std::uint32_t particle, std::size_t component) const;

 private:
  const ExprTree& tree_;
  std::unordered_map<std::uint32_t, std::size_t> first_;
  std::size_t size_ = 0;
};

/// A value of the program; by default a 0 that stays 0.
struct RoughValue {
  std::uint32_t at = 0;
};

class RoughProgram {
 public:
  using Value = RoughValue;
  enum class Code : std::uint8_t {
    constant,
    input,
    add,
    negate,
    multiply,
    divide,
    power,
    root,
    not_negative,  // the value itself; rejected where it is negative
    sin,
    cos,
    exp,
    log,
    arcsin,
    arccos,
    arctan,
  };

  explicit RoughProgram(std::size_t inputs);

  // --- writing it: what is known without a point is calculated at once
  [[nodiscard]] Value constant(double value);
  [[nodiscard]] Value input(std::size_t place);
  [[nodiscard]] Value write(Code code, Value a, Value b = {}, int exponent = 0);
  [[nodiscard]] bool is_constant(Value value) const { return code_[value.at].code == Code::constant; }
  [[nodiscard]] std::size_t size() const { return code_.size(); }

  // --- running it
  void look_at(const Eigen::VectorXd& point);
  [[nodiscard]] std::size_t to_be_run(std::size_t end) const { return end > done_ ? end - done_ : 0; }
  /// Up to here, from where it was left; false where some value is no number.
  [[nodiscard]] bool run_to(std::size_t end);
  [[nodiscard]] double value(Value of) const { return values_[of.at]; }
  /// Adds the slope, times a number, to a row of as many numbers as the point has.
  template <class Row>
  void add_slope(Value of, double times, Row&& row) const {
    if (const std::uint32_t at = code_[of.at].row; at != no_row) row += times * slopes_.col(at).transpose();
  }

 private:
  static constexpr std::uint32_t no_row = 0xffffffffu;

  struct Instruction {
    Code code;
    int exponent = 0;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t row = no_row;  // of its slope; a constant has none
  };
  /// A value and its slopes in the operands.
  struct Step {
    double value;
    double in_a;
    double in_b;
  };
  [[nodiscard]] static Step calculated(const Instruction& instruction, double a, double b);
  [[nodiscard]] Value append(const Instruction& instruction);

  std::size_t inputs_;
  std::vector<Instruction> code_;
  std::vector<double> values_;
  std::vector<Value> input_;  // by place; the constant 0: not written yet
  std::uint32_t rows_ = 0;
  Eigen::MatrixXd slopes_;  // a column for each value that is no constant
  const Eigen::VectorXd* point_ = nullptr;
  std::size_t done_ = 0;
};

/// Writes the program, as a Domain of `Evaluator`.
class RoughDomain {
 public:
  using Number = RoughValue;

  RoughDomain(RoughProgram& program, const RoughLayout& layout, std::uint64_t most_steps)
      : program_(program), layout_(layout), most_steps_(most_steps) {}

  [[nodiscard]] Number number(const std::string& digits);
  [[nodiscard]] Number integer(int value) { return program_.constant(value); }
  [[nodiscard]] bool is_zero(Number x) const { return x.at == 0; }
  void add(Number& total, Number x) { total = program_.write(Code::add, total, x); }
  void negate(Number& x) { x = program_.write(Code::negate, x); }
  [[nodiscard]] Number multiply(Number a, Number b) { return program_.write(Code::multiply, a, b); }
  [[nodiscard]] Number divide(Number a, Number b) { return program_.write(Code::divide, a, b); }
  [[nodiscard]] Number power(Number x, int exponent) { return program_.write(Code::power, x, {}, exponent); }
  [[nodiscard]] Number real_power(Number base, Number exponent);
  [[nodiscard]] Number root(Number square) { return program_.write(Code::root, square); }
  [[nodiscard]] Number even_power_of_root(Number square, int exponent) {
    check_root(square);
    return power(square, exponent / 2);
  }
  void check_root(Number square) { static_cast<void>(program_.write(Code::not_negative, square)); }
  [[nodiscard]] Number function(Function function, Number x);
  [[nodiscard]] Number circle_number();
  [[nodiscard]] Number value(SymbolId symbol, std::uint32_t particle, std::size_t component) {
    return program_.input(layout_.place(symbol, particle, component));
  }
  template <class Body>
  [[nodiscard]] std::vector<Number> particle_sum(std::size_t count, const Body& body) {
    std::vector<Number> total(count);
    for (std::uint32_t particle = 1; particle <= rough_particles; ++particle) {
      const std::vector<Number> term = body(particle);
      for (std::size_t i = 0; i < count; ++i) add(total[i], term[i]);
    }
    return total;
  }
  void settle(Number) {}
  void step();
  [[nodiscard]] std::uint64_t steps() const { return steps_; }

 private:
  using Code = RoughProgram::Code;

  RoughProgram& program_;
  const RoughLayout& layout_;
  std::uint64_t most_steps_;
  std::uint64_t steps_ = 0;
};

}  // namespace rigor
