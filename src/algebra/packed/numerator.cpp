// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/packed/numerator.h"

#include <ginac/ginac.h>

#include <utility>
#include <vector>

#include "base/splitmix.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr std::uint64_t image_prime = (std::uint64_t{1} << 61) - 1;
constexpr std::uint64_t unknown_image = ~std::uint64_t{0};

[[nodiscard]] std::uint64_t times_modulo(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;  // 2^61 is 1
  const auto sum =
      static_cast<std::uint64_t>(product & image_prime) + static_cast<std::uint64_t>(product >> 61U);
  return sum < image_prime ? sum : sum - image_prime;
}

[[nodiscard]] std::uint64_t power_modulo(std::uint64_t base, std::uint64_t exponent) {
  std::uint64_t result = 1;
  for (; exponent != 0; exponent /= 2) {
    if (exponent % 2 != 0) result = times_modulo(result, base);
    base = times_modulo(base, base);
  }
  return result;
}

[[nodiscard]] std::uint64_t residue_of(const cln::cl_I& integer) {
  return cln::cl_I_to_ulong(cln::mod(integer, cln::cl_I(static_cast<unsigned long>(image_prime))));
}

[[nodiscard]] std::uint64_t residue_of(const PackedNumber& number) {
  if (number.is_small()) {
    const auto prime = static_cast<std::int64_t>(image_prime);
    const std::int64_t rest = number.small() % prime;
    return static_cast<std::uint64_t>(rest < 0 ? rest + prime : rest);
  }
  const std::uint64_t above = residue_of(cln::numerator(number.exact()));
  const std::uint64_t below = residue_of(cln::denominator(number.exact()));
  return below == 0 ? unknown_image : times_modulo(above, power_modulo(below, image_prime - 2));
}

/// The value at one point that is the same in every run.
[[nodiscard]] std::uint64_t image_of(const PackedPolynomial& value) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    std::uint64_t term = residue_of(value.coefficient(i));
    if (term == unknown_image) return unknown_image;
    value.for_each_power(i, [&](std::size_t variable, int exponent) {
      const std::uint64_t letter = SplitMix(variable).next() % image_prime;
      for (int k = 0; k < exponent; ++k) term = times_modulo(term, letter);
    });
    sum = (sum + term) % image_prime;
  }
  return sum;
}

}  // namespace

struct Numerator::Node {
  enum class Kind : std::uint8_t { leaf, sum, product, power, opposite };

  Kind kind = Kind::leaf;
  int exponent = 1;
  std::vector<Shared> parts = {};
  const PackedLetters* letters = nullptr;  // of a leaf that is packed

  // Found when they are asked for.
  mutable bool is_read = false;  // packed, or that cannot be
  mutable bool is_flat = false;
  mutable std::optional<PackedPolynomial> packed = {};
  mutable std::optional<ex> written = {};
  mutable std::optional<std::uint64_t> image = {};
};

Numerator::Numerator() {
  static const Shared zero = Numerator(0).node_;
  node_ = zero;
}

Numerator::Numerator(ex value) {
  auto node = std::make_shared<Node>();
  node->written = std::move(value);
  node_ = std::move(node);
}

Numerator::Numerator(const PackedNumber& value) {
  static const PackedLetters none;
  *this = Numerator(PackedPolynomial(value), none);
}

Numerator::Numerator(PackedPolynomial expanded, const PackedLetters& letters) {
  auto node = std::make_shared<Node>();
  node->letters = &letters;
  node->is_read = node->is_flat = true;
  node->packed = std::move(expanded);
  node_ = std::move(node);
}

const ex& Numerator::written() const { return written(*node_); }

/// Recursion: as deep as what is written.
const ex& Numerator::written(const Node& node) {
  if (node.written) return *node.written;
  GiNaC::exvector parts;
  for (const Shared& each : node.parts) parts.push_back(written(*each));
  switch (node.kind) {
    case Node::Kind::leaf:
      node.written = to_ex(*node.packed, *node.letters);
      break;
    case Node::Kind::sum:
      node.written = GiNaC::add(parts);
      break;
    case Node::Kind::product:
      node.written = parts[0] * parts[1];
      break;
    case Node::Kind::power:
      node.written = GiNaC::pow(parts[0], node.exponent);
      break;
    case Node::Kind::opposite:
      node.written = -parts[0];
      break;
  }
  return *node.written;
}

bool Numerator::is_zero() const {
  // A sum that is zero became a leaf when it was made, and nothing else is zero unless a part is.
  if (node_->kind != Node::Kind::leaf) return false;
  return node_->packed && node_->is_flat ? node_->packed->is_zero() : node_->written->is_zero();
}

bool Numerator::is_equal(const Numerator& other, const PackedLetters& letters) const {
  if (node_ == other.node_) return true;
  const PackedPolynomial* const a = flat(*node_, letters);
  const PackedPolynomial* const b = flat(*other.node_, letters);
  if (a != nullptr && b != nullptr) return *a == *b;
  const std::uint64_t here = image(*node_, letters);
  const std::uint64_t there = image(*other.node_, letters);
  const bool differ = here != there && here != unknown_image && there != unknown_image;
  return !differ && written().is_equal(other.written());
}

const PackedPolynomial* Numerator::known_expanded() const {
  return node_->kind == Node::Kind::leaf && node_->is_flat ? &*node_->packed : nullptr;
}

const PackedPolynomial* Numerator::packed(const PackedLetters& letters) const {
  pack(*node_, letters);
  return node_->packed ? &*node_->packed : nullptr;
}

const PackedPolynomial* Numerator::flat(const Node& node, const PackedLetters& letters) {
  if (node.kind != Node::Kind::leaf) return nullptr;
  pack(node, letters);
  return node.is_flat ? &*node.packed : nullptr;
}

void Numerator::pack(const Node& node, const PackedLetters& letters) {
  if (node.is_read) return;
  node.is_read = true;
  if (node.kind == Node::Kind::leaf) {
    auto read = read_polynomial(*node.written, letters);
    if (!read) return;
    node.packed = std::move(read->value);
    node.is_flat = read->is_expanded;
  } else {
    node.packed = multiplied_out(node, letters);
  }
}

/// Recursion: as deep as what is written.
std::optional<PackedPolynomial> Numerator::multiplied_out(const Node& node, const PackedLetters& letters) {
  std::vector<const PackedPolynomial*> parts;
  parts.reserve(node.parts.size());
  int degree = 0;
  for (const Shared& each : node.parts) {
    pack(*each, letters);
    if (!each->packed) return std::nullopt;
    parts.push_back(&*each->packed);
    degree += parts.back()->degree_bound();
  }
  switch (node.kind) {
    case Node::Kind::sum:
      return PackedPolynomial::sum(parts);
    case Node::Kind::product:
      if (degree > PackedPolynomial::largest_degree) return std::nullopt;
      return *parts[0] * *parts[1];
    case Node::Kind::power:
      if (degree * node.exponent > PackedPolynomial::largest_degree) return std::nullopt;
      return power(*parts[0], node.exponent);
    case Node::Kind::opposite:
      return -*parts[0];
    case Node::Kind::leaf:
      break;
  }
  return std::nullopt;
}

/// The value at one point modulo a prime: where it is not 0, neither is the polynomial. Recursion: as deep as
/// what is written.
std::uint64_t Numerator::image(const Node& node, const PackedLetters& letters) {
  if (node.image) return *node.image;
  std::vector<std::uint64_t> parts;
  for (const Shared& each : node.parts) {
    parts.push_back(image(*each, letters));
    if (parts.back() == unknown_image) return *(node.image = unknown_image);
  }
  std::uint64_t value = 0;
  switch (node.kind) {
    case Node::Kind::leaf:
      pack(node, letters);
      value = node.packed ? image_of(*node.packed) : unknown_image;
      break;
    case Node::Kind::sum:
      for (const std::uint64_t part : parts) value = (value + part) % image_prime;
      break;
    case Node::Kind::product:
      value = times_modulo(parts[0], parts[1]);
      break;
    case Node::Kind::power:
      value = power_modulo(parts[0], static_cast<std::uint64_t>(node.exponent));
      break;
    case Node::Kind::opposite:
      value = (image_prime - parts[0]) % image_prime;
      break;
  }
  return *(node.image = value);
}

Numerator Numerator::expanded(const PackedLetters& letters) const {
  if (flat(*node_, letters) != nullptr) return *this;
  const PackedPolynomial* const polynomial = packed(letters);
  return polynomial == nullptr ? Numerator(written().expand()) : Numerator(*polynomial, letters);
}

void Numerator::add(const Numerator& summand, const PackedLetters& letters) {
  if (summand.is_zero()) return;
  if (is_zero()) {
    *this = summand;
    return;
  }
  const PackedPolynomial* const a = flat(*node_, letters);
  const PackedPolynomial* const b = flat(*summand.node_, letters);
  if (a != nullptr && b != nullptr) {
    *this = Numerator(*a + *b, letters);
    return;
  }
  const std::uint64_t here = image(*node_, letters);
  const std::uint64_t there = image(*summand.node_, letters);
  const bool known = here != unknown_image && there != unknown_image;
  const std::uint64_t value = known ? (here + there) % image_prime : unknown_image;
  const bool extended = node_->kind == Node::Kind::sum && node_.use_count() == 1 && &summand != this;
  auto sum = extended ? node_ : std::make_shared<Node>();
  if (!extended) {
    sum->kind = Node::Kind::sum;
    sum->parts = node_->kind == Node::Kind::sum ? node_->parts : std::vector{node_};
  }
  sum->is_read = sum->is_flat = false;
  sum->packed.reset();
  sum->written.reset();
  sum->image = value;
  const std::vector<Shared> own{summand.node_};
  const std::vector<Shared>& more = summand.node_->kind == Node::Kind::sum ? summand.node_->parts : own;
  sum->parts.insert(sum->parts.end(), more.begin(), more.end());
  node_ = std::move(sum);
  // Only what has no value at the point may be one that GiNaC cancels.
  if ((value == 0 || !known) && written().is_zero()) *this = Numerator();
}

Numerator Numerator::times(const Numerator& factor, const PackedLetters& letters) const {
  if (is_zero() || factor.is_zero()) return {};
  const PackedPolynomial* const a = flat(*node_, letters);
  const PackedPolynomial* const b = flat(*factor.node_, letters);
  if (a != nullptr && a->is_number() && a->coefficient(0).is_one()) return factor;
  if (b != nullptr && b->is_number() && b->coefficient(0).is_one()) return *this;
  // GiNaC multiplies monomials, and a number into a sum.
  const bool at_once = a != nullptr && b != nullptr &&
                       ((a->size() == 1 && b->size() == 1) || a->is_number() || b->is_number()) &&
                       a->degree_bound() + b->degree_bound() <= PackedPolynomial::largest_degree;
  if (at_once) return {*a * *b, letters};
  auto product = std::make_shared<Node>();
  product->kind = Node::Kind::product;
  product->parts = {node_, factor.node_};
  return Numerator(std::move(product));
}

Numerator Numerator::to_power(int exponent, const PackedLetters& letters) const {
  if (exponent == 1 || is_zero()) return *this;
  const PackedPolynomial* const base = flat(*node_, letters);
  const bool at_once = base != nullptr && base->size() == 1 &&
                       base->degree_bound() * exponent <= PackedPolynomial::largest_degree;
  if (at_once) return {power(*base, exponent), letters};
  auto raised = std::make_shared<Node>();
  raised->kind = Node::Kind::power;
  raised->exponent = exponent;
  raised->parts = {node_};
  return Numerator(std::move(raised));
}

Numerator Numerator::negated(const PackedLetters& letters) const {
  if (const PackedPolynomial* const polynomial = flat(*node_, letters)) return {-*polynomial, letters};
  auto opposite = std::make_shared<Node>();
  opposite->kind = Node::Kind::opposite;
  opposite->parts = {node_};
  return Numerator(std::move(opposite));
}

}  // namespace rigor
