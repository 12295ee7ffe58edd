// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_offers.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/check.h"
#include "check/question/decision_cache.h"
#include "check/repair/repair.h"
#include "check/repair/sides_near.h"
#include "check/verdict/chain_reading.h"
#include "check/verdict/judge.h"
#include "check/walk/walk.h"
#include "further_slips.h"
#include "latex/parse/parse.h"
#include "source/read_file.h"

namespace rigor::twins {
namespace {

/// The expression as text, with the factors of numbers and the terms of sums in order.
std::string sorted_text(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  std::vector<std::string> parts;
  if (node.op == Op::add || node.op == Op::negate) {
    for (const ExprId child : tree.children(id))
      parts.push_back((node.op == Op::negate ? "-" : "+") + sorted_text(tree, child));
    if (node.op == Op::add) std::sort(parts.begin(), parts.end());
    return fmt::format("({})", fmt::join(parts, ""));
  }
  if (node.count == 0 || node.op == Op::table) return dump(tree, id);
  for (const ExprId child : tree.children(id)) parts.push_back(sorted_text(tree, child));
  if (node.op == Op::multiply || node.op == Op::dot) std::sort(parts.begin(), parts.end());
  std::string own =
      fmt::format("{}.{}.{}", static_cast<int>(node.op), node.exponent, static_cast<int>(node.function));
  if (node.op == Op::index_sum) own += tree.name(node.index);
  for (const Slot& slot : tree.slots(id))
    own += slot.axis != 0 ? std::to_string(slot.axis) : tree.name(slot.variable);
  return fmt::format("[{} {}]", own, fmt::join(parts, " "));
}

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char each) { return each == ' ' || each == '{' || each == '}'; });
  return text;
}

/// A text as tokens, which are views into it.
struct Written {
  explicit Written(std::string text) {
    const auto size = static_cast<std::uint32_t>(text.size());
    file = sources.add("side", std::move(text));
    tokens = lex(sources, {file, 0, size});
  }
  SourceMap sources;
  FileId file = 0;
  Tokens tokens;
};

class FileOfRows {
 public:
  explicit FileOfRows(const std::string& path) : path_(path) {
    auto text = read_file(path);
    RIGOR_CHECK(text.has_value(), path);
    report_.file = sources_.add(path, *std::move(text));
    std::filesystem::path beside(path);
    beside.replace_extension(".rigor");
    std::optional<FileId> sidecar;
    if (auto directives = read_file(beside.string()))
      sidecar = sources_.add(beside.string(), *std::move(directives));
    Diagnostics ignored;
    notes_ = read_notes(sources_, report_.file, sidecar ? &*sidecar : nullptr, ignored);
    ledger_ = walk_through(sources_, notes_, report_, {.repairs = Repairs::none, .cache = &cache_});
  }

  Offers all() {
    for (const LedgerEntry& entry : ledger_.entries) {
      const auto* statement = std::get_if<rigor::Statement>(&entry.what);
      if (statement == nullptr || !is_claimed(statement->role) || statement->chain->image > 0) continue;
      for (std::size_t which = 0; which < statement->step_count; ++which) {
        if (report_.steps[statement->first_step + which].verdict == Verdict::proved)
          spoil({*entry.scope, *statement, which});
      }
    }
    return std::move(result_);
  }

 private:
  struct Row {
    const Names& names;
    const rigor::Statement& statement;
    std::size_t which;
  };

  /// The chain of a row with one side as it is in `written`, and what is read of it.
  struct Reread {
    ExprTree tree;
    Names names;
    SyntaxTree syntax = {};
    ParsedChain chain;
    std::unique_ptr<ChainReading> reading = {};
    std::optional<Claim> claim = {};
  };

  std::unique_ptr<Reread> reread(const Row& row, std::size_t side, const Tokens& tokens) const {
    auto read = std::make_unique<Reread>(Reread{ledger_.tree, row.names, {}, *row.statement.chain});
    read->chain.written.sides[row.which + side].tokens = tokens;
    for (std::size_t k = 0; k < read->chain.sides.size(); ++k) {
      const WrittenSide& each = read->chain.written.sides[k];
      read->chain.sides[k] = parse_side(each.tokens, each.span, read->syntax);
    }
    read->reading = read_chain(read->syntax, read->tree, read->names, read->chain);
    const auto& sides = read->reading->sides;
    Diagnostics mismatches;
    if (sides[row.which].typed && sides[row.which + 1].typed)
      read->claim = read->reading->claim(read->chain, row.which, row.statement.first_order, mismatches);
    if (!mismatches.empty()) read->claim.reset();
    return read;
  }

  Answer answer_to(Reread& row) {
    if (!row.claim) return Answer::unread;
    cache_.begin(default_effort);
    const Judgement judgement = judge(row.tree, row.names, *row.claim, limits_of_candidates, &cache_);
    switch (judgement.verdict) {
      case Verdict::proved:
        return Answer::proved;
      case Verdict::refuted:
        return Answer::refuted;
      case Verdict::law:
        return Answer::law;
      default:
        return Answer::open;
    }
  }

  std::string sorted_side(const Row& row, std::size_t side, const Tokens& tokens) const {
    const auto read = reread(row, side, tokens);
    const auto& typed = read->reading->sides[row.which + side].typed;
    return typed ? sorted_text(read->tree, typed->id) : "not read";
  }

  void spoil(const Row& row) {
    ++result_.rows;
    const std::vector<WrittenSide>& sides = row.statement.chain->written.sides;
    const Written left(text_of(without_layout(sides[row.which].tokens)));
    const Written right(text_of(without_layout(sides[row.which + 1].tokens)));
    const auto same = reread(row, 0, left.tokens);
    if (answer_to(*same) != Answer::proved) {
      ++result_.not_alone;
      return;
    }
    const std::vector<TokenView> statement{left.tokens, right.tokens};
    for (const std::size_t side : {0u, 1u}) {
      const Written& own = side == 0 ? left : right;
      std::vector<Edit> edits = slips_of(own.sources, own.tokens, statement);
      for (Edit& edit : further_slips_of(own.sources, own.tokens, statement))
        edits.push_back(std::move(edit));
      const std::string original(own.sources.text(span_of(own.tokens)));
      const std::string sorted = sorted_side(row, side, own.tokens);
      for (const Edit& edit : edits)
        spoil(row, side, original, sorted, edit.slip,
              with_edit(own.sources.text(
                            {own.file, 0, static_cast<std::uint32_t>(own.sources.text(own.file).size())}),
                        0, edit));
    }
  }

  void spoil(const Row& row, std::size_t side, const std::string& original, const std::string& sorted,
             Slip slip, std::string text) {
    const Written spoilt(std::move(text));
    const auto read = reread(row, side, spoilt.tokens);
    Offer offer{.slip = slip, .answer = answer_to(*read)};
    if (offer.answer == Answer::proved) return;
    const Span relation = row.statement.chain->written.relations[row.which].span;
    offer.place = fmt::format("{}:{}", std::filesystem::path(path_).filename().string(),
                              sources_.line_column(relation.file, relation.begin).line);
    const std::string other = text_of(row.statement.chain->written.sides[row.which + 1 - side].tokens);
    offer.original = fmt::format("{}  [other side] {}", original, other);
    offer.twin = text_of(spoilt.tokens);
    ParsedChain chain = *row.statement.chain;
    chain.written.sides[row.which + side].tokens = spoilt.tokens;
    const WrongStep wrong{.parsed = chain,
                          .which = row.which,
                          .first_order = row.statement.first_order,
                          .near = sides_near(notes_, *row.statement.chain)};
    cache_.begin(default_effort);
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Repair> repairs = nearest_true_statements(ledger_.tree, row.names, wrong, &cache_);
    offer.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    for (std::size_t k = 0; k < repairs.size(); ++k) {
      offer.offered.push_back(repairs[k].statement);
      if (repairs[k].on_left != (side == 0)) continue;
      if (offer.equal == 0) offer.equal = k + 1;
      const Written repaired(repairs[k].replacement);
      const bool is_same = without_blanks(repairs[k].replacement) == without_blanks(original) ||
                           sorted_side(row, side, repaired.tokens) == sorted;
      if (is_same && offer.same == 0) offer.same = k + 1;
    }
    result_.offers.push_back(std::move(offer));
  }

  std::string path_;
  SourceMap sources_;
  DecisionCache cache_;
  FileReport report_;
  Notes notes_;
  Ledger ledger_;
  Offers result_;
};

}  // namespace

Offers offers_of(const std::string& path) { return FileOfRows(path).all(); }

}  // namespace rigor::twins
