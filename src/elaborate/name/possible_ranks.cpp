// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of ranks instead of ranks, from the leaves up. A letter has the ranks that the evidence leaves,
// whatever is not read has all, and an operation keeps each result that some choice of its operands gives.
#include "elaborate/name/possible_ranks.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>

#include "base/among.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

constexpr RankSet scalar = 0b0001;
constexpr RankSet vector = 0b0010;
constexpr RankSet tensor = 0b0100;
constexpr std::size_t most_combinations = 256;

bool has(RankSet set, int rank) { return rank >= 0 && rank <= 3 && (set >> rank & 1) != 0; }
RankSet only(int rank) { return rank >= 0 && rank <= 3 ? static_cast<RankSet>(1 << rank) : any_rank; }

struct Factor {
  RankSet ranks = no_rank;
  Joint joint = Joint::none;
  bool product = false;  // a dot product, in brackets or not
  bool number = false;
};

/// One choice of ranks for the factors of a product: the rank of the whole, or several, or none.
RankSet rank_of_product(const std::vector<Factor>& factors, const std::vector<int>& ranks) {
  std::vector<std::pair<int, Joint>> axes;  // what is no scalar
  Joint carried = Joint::none;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const Joint joint = factors[k].joint;
    const bool after_scalar = k > 0 && ranks[k - 1] == 0;
    const bool by_number = factors[k].number || (after_scalar && factors[k - 1].number);
    if (ranks[k] == 0) {
      if (joint == Joint::cross && k > 0 && !by_number && !axes.empty()) return no_rank;
      if (joint == Joint::dot && factors[k].product && !axes.empty()) return no_rank;
      if (joint == Joint::dot || joint == Joint::cross) carried = joint;
      continue;
    }
    if (joint == Joint::slash) return no_rank;
    const bool by_scalar = axes.empty() && after_scalar && !by_number;
    if (by_scalar && joint == Joint::cross) return no_rank;
    if (by_scalar && joint == Joint::dot && factors[k - 1].product) return no_rank;
    const bool joined = joint == Joint::dot || joint == Joint::cross;
    axes.emplace_back(ranks[k], axes.empty() ? Joint::none : joined ? joint : carried);
    carried = Joint::none;
  }
  for (const Joint kind : {Joint::cross, Joint::dot}) {
    for (std::size_t k = 1; k < axes.size();) {
      if (axes[k].second != kind) {
        ++k;
        continue;
      }
      const int left = axes[k - 1].first;
      const int right = axes[k].first;
      if (left == 0 || right == 0) return no_rank;
      axes[k - 1].first = kind == Joint::dot ? left + right - 2 : std::max(left, right);
      axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
  RankSet whole = scalar;  // side by side: an outer product, or a matrix on what follows
  for (const auto& [rank, joint] : axes) {
    RankSet next = no_rank;
    for (int before = 0; before <= 3; ++before) {
      if (!has(whole, before)) continue;
      next |= only(before + rank);
      if (before > 0 && rank > 0 && std::max(before, rank) > 1) next |= only(before + rank - 2);
    }
    whole = next;
  }
  return whole;
}

class RankReader {
 public:
  RankReader(const SyntaxTree& syntax, const Letters& letters, const Names& names,
             std::vector<OpenPart>& open)
      : syntax_(syntax), letters_(letters), names_(names), open_(open) {}

  RankSet read(SyntaxId id) {
    const RankSet ranks = read_node(id);
    failed_ = failed_ || ranks == no_rank;
    return failed_ ? no_rank : ranks;
  }

 private:
  RankSet read_node(SyntaxId id) {
    const SyntaxNode& node = syntax_[id];
    switch (node.kind) {
      case SyntaxKind::number:
        return syntax_.text(id) == "0" ? any_rank : scalar;
      case SyntaxKind::unit:
        return scalar;
      case SyntaxKind::symbol:
        return symbol(syntax_.symbol(id), node.span);
      case SyntaxKind::sum:
        return sum(id);
      case SyntaxKind::term:
        return term(syntax_.children(id));
      case SyntaxKind::fraction: {
        const RankSet above = read(syntax_.child(id, 0));
        return has(read(syntax_.child(id, 1)), 0) ? above : no_rank;
      }
      case SyntaxKind::root:
        return static_cast<RankSet>(read(syntax_.child(id, 0)) & (scalar | tensor));
      case SyntaxKind::power:
        return power(id);
      case SyntaxKind::component:
        return component(id);
      case SyntaxKind::group:
      case SyntaxKind::big_sum:
      case SyntaxKind::line_integral:
      case SyntaxKind::between:
        return read(syntax_.child(id, 0));
      case SyntaxKind::bars:
      case SyntaxKind::norm:
        static_cast<void>(read(syntax_.child(id, 0)));
        return scalar;
      case SyntaxKind::function:
        return function(id);
      case SyntaxKind::derivative:
        return derivative(id);
      case SyntaxKind::tuple:
        return tuple(id);
      case SyntaxKind::matrix:
        return any_rank;
      case SyntaxKind::determinant:
        return static_cast<RankSet>(scalar | vector);
      case SyntaxKind::integral:
        return syntax_.text(id) == "m" || syntax_.text(id) == "V" ? read(syntax_.child(id, 0)) : any_rank;
      case SyntaxKind::text:
      case SyntaxKind::cases:
        return any_rank;
      case SyntaxKind::opaque:
        return unread(node.span, syntax_.obstacle(id).message);
    }
    return any_rank;
  }

  RankSet unread(Span span, std::string why) {
    open_.push_back({span, std::move(why)});
    return any_rank;
  }

  RankSet sum(SyntaxId id) {
    RankSet common = any_rank;
    for (const SyntaxChild& child : syntax_.children(id)) {
      // A number among tensors is that multiple of the unit tensor.
      const bool number = syntax_[child.id].kind == SyntaxKind::number && syntax_.text(child.id) != "0";
      common &= number ? static_cast<RankSet>(scalar | tensor) : read(child.id);
    }
    return common;
  }

  RankSet term(std::span<const SyntaxChild> children) {
    if (starts_order(children))
      return unread(syntax_[children[0].id].span, "a Landau symbol can have any rank");
    std::vector<Factor> factors;
    for (std::size_t k = 0; k < children.size();) {
      const Joint joint = children[k].joint;
      std::size_t next = k + 1;
      const bool acts = acts_as_operator(syntax_, children[k].id);
      const RankSet ranks = acts ? operated(children, k, next) : read(children[k].id);
      const bool number = syntax_[children[k].id].kind == SyntaxKind::number;
      factors.push_back({ranks, joint, !acts && is_dot_product(children[k].id), number});
      k = next;
    }
    return product(factors);
  }

  /// `O(\omega^2)`, also after a coefficient.
  bool starts_order(std::span<const SyntaxChild> children) const {
    for (std::size_t k = 0; k + 1 < children.size(); ++k) {
      if (syntax_[children[k].id].kind != SyntaxKind::symbol) continue;
      const std::string& letter = syntax_.symbol(children[k].id).letter;
      const bool bracket = syntax_[children[k + 1].id].kind == SyntaxKind::group;
      if (bracket && (letter == "O" || letter == "o" || letter.ends_with("{O}"))) return true;
    }
    return false;
  }

  bool is_dot_product(SyntaxId id) const {
    while (syntax_[id].kind == SyntaxKind::group) id = syntax_.child(id, 0);
    if (syntax_[id].kind != SyntaxKind::term) return false;
    const auto factors = syntax_.children(id);
    return factors.size() == 2 && factors[1].joint == Joint::dot;
  }

  static RankSet product(const std::vector<Factor>& factors) {
    std::size_t combinations = 1;
    for (const Factor& factor : factors) {
      std::size_t count = 0;
      for (int rank = 0; rank <= 3; ++rank) count += has(factor.ranks, rank) ? 1 : 0;
      combinations *= count;
      if (combinations > most_combinations) return any_rank;
    }
    RankSet whole = no_rank;
    std::vector<int> ranks(factors.size(), 0);
    const std::function<void(std::size_t)> choose = [&](std::size_t k) {
      if (k == factors.size()) {
        whole |= rank_of_product(factors, ranks);
        return;
      }
      for (int rank = 0; rank <= 3; ++rank) {
        if (!has(factors[k].ranks, rank)) continue;
        ranks[k] = rank;
        choose(k + 1);
      }
    };
    choose(0);
    return whole;
  }

  /// ∇ with what it acts on, as `apply_operator` reads it.
  RankSet operated(std::span<const SyntaxChild> children, std::size_t at, std::size_t& next) {
    const SyntaxId id = children[at].id;
    if (at + 1 >= children.size()) return unread(syntax_[id].span, "an operator has no operand");
    const Joint joint = children[at + 1].joint;
    next = at + 2;
    const SyntaxId behind = children[at + 1].id;
    const RankSet operand =
        acts_as_operator(syntax_, behind) ? operated(children, at + 1, next) : read(behind);
    if (!is_nabla(syntax_, id) || !syntax_.symbol(id).lower.empty()) return operand;
    RankSet result = no_rank;
    for (int rank = 0; rank <= 3; ++rank) {
      if (!has(operand, rank)) continue;
      if (joint == Joint::dot) {
        if (rank > 0) result |= only(rank - 1);
      } else if (joint == Joint::cross) {
        if (rank > 0) result |= only(rank);
      } else {
        result |= only(rank + 1);
      }
    }
    return result;
  }

  RankSet power(SyntaxId id) {
    const RankSet base = read(syntax_.child(id, 0));
    const RankSet exponent = read(syntax_.child(id, 1));
    const bool whole = syntax_[syntax_.child(id, 1)].kind == SyntaxKind::number;
    RankSet ranks = static_cast<RankSet>(base & (scalar | tensor));
    if (has(exponent, 2) && !has(exponent, 0)) ranks = tensor;  // e^A
    if (!has(base, 1)) return ranks;
    const std::string text = whole ? syntax_.text(syntax_.child(id, 1)) : "";
    const bool even = !text.empty() && (text.back() - '0') % 2 == 0;
    return even ? static_cast<RankSet>(ranks | scalar) : any_rank;
  }

  RankSet component(SyntaxId id) {
    const RankSet inside = read(syntax_.child(id, 0));
    const auto& axes = syntax_.indices(id);
    const bool sure = std::ranges::all_of(axes, [&](const WrittenIndex& axis) {
      return axis.form == IndexForm::letter && letters_.is_sure(axis.text);
    });
    const auto count = static_cast<int>(axes.size());
    const RankSet taken = has(inside, count) ? scalar : no_rank;
    if (sure) return taken;
    open_.push_back({syntax_[id].span, "the subscript can be a label"});
    return static_cast<RankSet>(taken | inside);
  }

  RankSet function(SyntaxId id) {
    const std::string& name = syntax_.text(id);
    if (name == "O") return unread(syntax_[id].span, "`O(…)` has the rank of what is next to it");
    if (name == "ket" || name == "bra") return scalar;
    const RankSet inside = read(syntax_.child(id, 0));
    if (is_one_of(name, {"D/Dt", "conjugate", "bar", "Re", "Im", "average"})) return inside;
    if (name == "transpose" || name == "adjoint" || name == "diag") return any_rank;
    if (name == "det" || name == "tr") return scalar;
    if (const auto of_field = field_operator(name)) {
      if (*of_field == FieldOperator::gradient) return static_cast<RankSet>(inside << 1 & any_rank);
      if (*of_field == FieldOperator::divergence) return static_cast<RankSet>(inside >> 1);
      return *of_field == FieldOperator::curl ? static_cast<RankSet>(inside & ~scalar) : inside;
    }
    return static_cast<RankSet>(inside & (scalar | tensor));
  }

  RankSet derivative(SyntaxId id) {
    const RankSet inside = read(syntax_.child(id, 0));
    const bool plain = std::ranges::all_of(syntax_.derivative(id).by, [](const WrittenVariable& variable) {
      return variable.symbol.face == Face::plain && variable.symbol.accent == Accent::none;
    });
    return plain ? inside : any_rank;
  }

  RankSet tuple(SyntaxId id) {
    RankSet common = any_rank;
    for (const SyntaxChild& child : syntax_.children(id)) common &= read(child.id);
    if (is_pair_in_brackets(syntax_[id])) return unread(syntax_[id].span, "this can be a commutator");
    return has(common, 0) && syntax_[id].count == 3 ? vector : any_rank;
  }

  // -- letters --

  bool is_declared(const std::string& base, int rank) const {
    return rigor::is_declared(names_.symbols, {base, rank, false}) ||
           rigor::is_declared(names_.symbols, {base, rank, true});
  }

  RankSet symbol(const WrittenSymbol& written, Span span) {
    if (is_kronecker(written) || is_levi_civita(written)) return scalar;
    if (is_basis_family(written)) return vector;
    const bool axes =
        !written.lower.empty() && std::ranges::all_of(written.lower, [&](const WrittenIndex& index) {
          return index.form == IndexForm::letter && letters_.is_sure(index.text);
        });
    if (axes) return scalar;
    const std::string base = letter_with_marks(written);
    const RankSet ranks = declared(base, written);
    if (ranks != no_rank) return ranks;
    if (written.face == Face::tensor) return any_rank;
    return written.face == Face::vector ? bold(base, written, span) : plain(base, written, span);
  }

  /// What directives say of it.
  RankSet declared(const std::string& base, const WrittenSymbol& written) const {
    RankSet ranks = no_rank;
    const std::string labelled = with_labels(base, written.lower);
    for (int rank = 0; rank <= 2; ++rank) {
      if (!is_declared(base, rank) && !is_declared(labelled, rank)) continue;
      const bool whole = written.face != Face::plain || written.accent == Accent::hat || rank == 0 ||
                         is_plain(names_.symbols, {base, rank, false}) ||
                         is_plain(names_.symbols, {base, rank, true});
      ranks |= whole ? only(rank) : scalar;
    }
    // `scalar A` leaves `\mathbf A` a vector.
    return written.face == Face::vector && ranks == scalar ? no_rank : ranks;
  }

  RankSet bold(const std::string& base, const WrittenSymbol& written, Span span) {
    const char first = written.letter.empty() ? ' ' : written.letter[0];
    const bool small = first >= 'a' && first <= 'z';
    if (!written.lower.empty() && written.lower[0].form == IndexForm::letter)
      return static_cast<RankSet>(scalar | vector);
    if (small || written.accent == Accent::hat || names_.symbols.evidence->crossed.contains(base))
      return vector;
    open_.push_back({span, fmt::format("`\\mathbf{{{}}}` can be a vector or a matrix", written.letter)});
    return static_cast<RankSet>(vector | tensor);
  }

  RankSet plain(const std::string& base, const WrittenSymbol& written, Span span) {
    static const std::set<std::string> numbers{"x", "y", "z", "t", "\\pi"};
    const bool hat = written.accent == Accent::hat;
    if (hat) {
      static const std::set<std::string> directions{
          "x", "y", "z", "i", "j", "k", "\\imath", "\\jmath", "n", "r", "\\theta", "\\phi", "\\varphi"};
      if (!names_.symbols.evidence->operators && directions.contains(written.letter)) return vector;
      open_.push_back({span, fmt::format("`{}` can be a vector, an operator or a number", base)});
      return any_rank;
    }
    const bool coordinate = written.lower.empty() && written.accent == Accent::none && numbers.contains(base);
    if (coordinate || names_.symbols.evidence->vectors.contains(base) ||
        names_.symbols.evidence->numbers.contains(base))
      return scalar;
    open_.push_back(
        {span, fmt::format("nothing says that `{}` is a number", with_labels(base, written.lower))});
    return static_cast<RankSet>(scalar | vector | tensor);
  }

  const SyntaxTree& syntax_;
  const Letters& letters_;
  const Names& names_;
  std::vector<OpenPart>& open_;
  bool failed_ = false;
};

}  // namespace

RankSet possible_ranks(const SyntaxTree& syntax, SyntaxId id, const Letters& letters, const Names& names,
                       std::vector<OpenPart>& open) {
  return RankReader(syntax, letters, names, open).read(id);
}

}  // namespace rigor
