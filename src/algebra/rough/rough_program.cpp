// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/rough/rough_program.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "algebra/engine/undecidable.h"

namespace rigor {

RoughLayout::RoughLayout(const ExprTree& tree, const std::vector<SymbolId>& symbols) : tree_(tree) {
  for (const SymbolId symbol : symbols) {
    const Symbol& named = tree.symbols[symbol];
    first_.emplace(static_cast<std::uint32_t>(symbol), size_);
    size_ += component_count(named) * (named.per_particle ? rough_particles : 1);
  }
}

std::size_t RoughLayout::place(SymbolId symbol, std::uint32_t particle, std::size_t component) const {
  const Symbol& named = tree_.symbols[symbol];
  const std::size_t copy = particle == 0 ? 0 : particle - 1;
  return first_.at(static_cast<std::uint32_t>(symbol)) + copy * component_count(named) +
         canonical_component(named, component);
}

RoughProgram::RoughProgram(std::size_t inputs) : inputs_(inputs), input_(inputs) {
  static_cast<void>(append({.code = Code::constant}));  // 0
}

RoughProgram::Value RoughProgram::append(const Instruction& instruction) {
  code_.push_back(instruction);
  values_.push_back(0);
  if (instruction.code != Code::constant) code_.back().row = rows_++;
  return {static_cast<std::uint32_t>(code_.size() - 1)};
}

RoughProgram::Value RoughProgram::constant(double value) {
  if (value == 0) return {};
  const Value made = append({.code = Code::constant});
  values_.back() = value;
  return made;
}

RoughProgram::Value RoughProgram::input(std::size_t place) {
  if (input_[place].at == 0)
    input_[place] = append({.code = Code::input, .a = static_cast<std::uint32_t>(place)});
  return input_[place];
}

RoughProgram::Value RoughProgram::write(Code code, Value a, Value b, int exponent) {
  if (code == Code::add && a.at == 0) return b;
  if (code == Code::add && b.at == 0) return a;
  if (code == Code::multiply && (a.at == 0 || b.at == 0)) return {};
  if (code == Code::multiply && is_constant(a) && values_[a.at] == 1) return b;
  if (code == Code::multiply && is_constant(b) && values_[b.at] == 1) return a;
  const Instruction made{.code = code, .exponent = exponent, .a = a.at, .b = b.at};
  if (is_constant(a) && is_constant(b)) {
    const double value = calculated(made, values_[a.at], values_[b.at]).value;
    if (std::isfinite(value)) return constant(value);
  }
  return append(made);
}

RoughProgram::Step RoughProgram::calculated(const Instruction& instruction, double a, double b) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  switch (instruction.code) {
    case Code::constant:
    case Code::input:
      return {a, 1, 0};
    case Code::add:
      return {a + b, 1, 1};
    case Code::negate:
      return {-a, -1, 0};
    case Code::multiply:
      return {a * b, b, a};
    case Code::divide: {
      const double quotient = a / b;
      return {quotient, 1 / b, -quotient / b};
    }
    case Code::power: {
      const double lower = std::pow(a, instruction.exponent - 1);
      return {lower * a, instruction.exponent * lower, 0};
    }
    case Code::root: {
      const double root = std::sqrt(a);
      return {root, 0.5 / root, 0};
    }
    case Code::not_negative:
      return {a < 0 ? none : a, 1, 0};
    case Code::sin:
      return {std::sin(a), std::cos(a), 0};
    case Code::cos:
      return {std::cos(a), -std::sin(a), 0};
    case Code::exp:
      return {std::exp(a), std::exp(a), 0};
    case Code::log:
      return {std::log(a), 1 / a, 0};
    case Code::arcsin:
      return {std::asin(a), 1 / std::sqrt(1 - a * a), 0};
    case Code::arccos:
      return {std::acos(a), -1 / std::sqrt(1 - a * a), 0};
    case Code::arctan:
      return {std::atan(a), 1 / (1 + a * a), 0};
  }
  return {none, none, none};
}

void RoughProgram::look_at(const Eigen::VectorXd& point) {
  point_ = &point;
  done_ = 0;
  const auto inputs = static_cast<Eigen::Index>(inputs_);
  if (slopes_.cols() < static_cast<Eigen::Index>(rows_))
    slopes_.resize(inputs, static_cast<Eigen::Index>(rows_));
}

bool RoughProgram::run_to(std::size_t end) {
  for (; done_ < end; ++done_) {
    const Instruction& now = code_[done_];
    if (now.code == Code::constant) continue;
    auto slope = slopes_.col(now.row);
    if (now.code == Code::input) {
      values_[done_] = (*point_)[now.a];
      slope.setZero();
      slope[now.a] = 1;
      continue;
    }
    const Step step = calculated(now, values_[now.a], values_[now.b]);
    if (!std::isfinite(step.value) || !std::isfinite(step.in_a) || !std::isfinite(step.in_b)) return false;
    values_[done_] = step.value;
    const std::uint32_t a = code_[now.a].row;
    const std::uint32_t b = code_[now.b].row;
    if (a != no_row && b != no_row) {
      slope = step.in_a * slopes_.col(a) + step.in_b * slopes_.col(b);
    } else if (a != no_row) {
      slope = step.in_a * slopes_.col(a);
    } else if (b != no_row) {
      slope = step.in_b * slopes_.col(b);
    } else {
      slope.setZero();  // what is no number for constants was rejected above
    }
  }
  return true;
}

RoughDomain::Number RoughDomain::number(const std::string& digits) {
  return program_.constant(std::strtod(digits.c_str(), nullptr));
}

RoughDomain::Number RoughDomain::real_power(Number base, Number exponent) {
  return function(Function::exp, multiply(exponent, function(Function::log, base)));
}

RoughDomain::Number RoughDomain::function(Function function, Number x) {
  switch (function) {
    case Function::sin:
      return program_.write(Code::sin, x);
    case Function::cos:
      return program_.write(Code::cos, x);
    case Function::exp:
      return program_.write(Code::exp, x);
    case Function::log:
      return program_.write(Code::log, x);
    case Function::arcsin:
      return program_.write(Code::arcsin, x);
    case Function::arccos:
      return program_.write(Code::arccos, x);
    case Function::arctan:
      return program_.write(Code::arctan, x);
  }
  throw Undecidable("this function has no rough values");
}

RoughDomain::Number RoughDomain::circle_number() { return program_.constant(std::numbers::pi); }

void RoughDomain::step() {
  if (++steps_ > most_steps_) throw Undecidable("no rough point was found in time");
}

}  // namespace rigor
