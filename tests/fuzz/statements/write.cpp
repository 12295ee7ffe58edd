// SPDX-License-Identifier: GPL-3.0-or-later
#include "write.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace fuzz {
namespace {

enum class Place {
  alone,   // nothing beside it
  term,    // of a sum, behind a plus
  factor,  // of a product
  last,    // the last factor of a product
  vector,  // an operand of · or ×
  atom,    // below a power, a dot
};

std::string particle_name(char particle) { return particle == 'a' ? "\\alpha" : "\\beta"; }

class Writer {
 public:
  Writer(const std::vector<Letter>& letters, const Style& style)
      : letters_(letters), style_(style), random_(style.seed) {}

  std::string at(const Term& term, Place place) {
    const std::string text = plain(*term, place);
    return needs_brackets(*term, place) ? bracketed(text) : text;
  }

 private:
  /// A sum that is written with its sign in front.
  static bool is_sum(const Node& node) {
    if (node.op == Op::contract) return is_sum(*node.parts[0]);
    return node.op == Op::sum || node.op == Op::negative || (node.op == Op::number && node.p < 0);
  }
  static bool is_product(const Node& node) {
    if (node.op == Op::contract) return is_product(*node.parts[0]);
    return node.op == Op::product || node.op == Op::dot || node.op == Op::act || node.op == Op::cross ||
           node.op == Op::particle_sum || node.op == Op::rate || node.op >= Op::partial;
  }

  bool needs_brackets(const Node& node, Place place) const {
    if (node.bare) return place == Place::atom || place == Place::factor;
    if (place == Place::alone) return false;
    if (is_sum(node)) return true;
    if (place == Place::term) return node.op == Op::particle_sum || node.op == Op::rate;
    if (place == Place::last || place == Place::factor) {
      const Op op = node.op == Op::contract ? node.parts[0]->op : node.op;
      return is_product(node) && op != Op::product && op != Op::rate && op != Op::cross;
    }
    if (place == Place::vector) return is_product(node) || node.op == Op::quotient;
    if (node.op == Op::number) return node.q != 1 && node.decimals == 0;
    if (node.op == Op::symbol) return node.dots > 0 && style_.dots_as_fractions;
    return node.op != Op::absolute && node.op != Op::length && node.op != Op::component;
  }

  std::string bracketed(const std::string& text) {
    const bool tall = text.find("frac") != std::string::npos;
    switch (random_.below(tall ? 3 : 6)) {
      case 0:
      case 1:
        return "\\left(" + text + "\\right)";
      case 2:
        return "\\bigl( " + text + " \\bigr)";
      default:
        return "(" + text + ")";
    }
  }
  std::string barred(const std::string& text) {
    if (style_.physics && random_.one_in(2)) return "\\abs{" + text + "}";
    if (text.find('|') != std::string::npos || random_.one_in(3)) return "\\left|" + text + "\\right|";
    return random_.one_in(3) ? "\\lvert " + text + "\\rvert " : "|" + text + "|";
  }
  std::string fraction(const std::string& above, const std::string& below) {
    return style_.fraction + "{" + above + "}{" + below + "}";
  }

  std::string faced(const Letter& letter) const {
    if (letter.rank == 0) return letter.plain;
    if (letter.rank == 1 && letter.nature != Nature::unit) return style_.face + "{" + letter.plain + "}";
    const std::string& face = letter.rank == 2 ? style_.tensor_face : style_.unit_face;
    return face + "{" + letter.plain + (face.find('{') != std::string::npos ? "}}" : "}");
  }

  std::string dotted(const std::string& text, int dots) const {
    if (dots == 0) return text;
    return (dots == 1 ? "\\dot{" : "\\ddot{") + text + "}";
  }

  std::string symbol(const Node& node) {
    const Letter& letter = letters_[node.letter];
    std::string name = node.slots.empty() ? faced(letter) : letter.plain;
    if (!node.slots.empty() && letter.nature == Nature::unit) name = "\\hat{" + letter.plain + "}";
    const bool in_time = node.dots > 0 && style_.dots_as_fractions && node.slots.empty();
    if (!in_time) name = dotted(name, node.dots);
    std::string below = letter.label;
    if (node.particle != 0) below += particle_name(node.particle) + (node.slots.empty() ? "" : " ");
    below += node.slots;
    if (below.size() == 1) name += "_" + below;
    if (below.size() > 1) name += "_{" + below + "}";
    return in_time ? as_derivative(name, node.dots) : name;
  }

  std::string as_derivative(const std::string& of, int order) {
    if (style_.physics) return order == 1 ? "\\dv{" + of + "}{t}" : "\\dv[2]{" + of + "}{t}";
    return order == 1 ? fraction("d" + of, "dt") : fraction("d^2" + of, "dt^2");
  }

  std::string number(const Node& node) {
    if (node.decimals > 0) {
      std::string digits = std::to_string(std::abs(node.p));
      const auto behind = static_cast<std::size_t>(node.decimals);
      if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
      return (node.p < 0 ? "-" : "") + digits.insert(digits.size() - behind, ".");
    }
    if (node.q == 1) return std::to_string(node.p);
    const std::string sign = node.p < 0 ? "-" : "";
    return sign + fraction(std::to_string(std::abs(node.p)), std::to_string(node.q));
  }

  std::string sum(const Node& node) {
    std::string text;
    for (const Term& part : node.parts) {
      const Term* inner = &part;
      bool minus = false;
      if (part->op == Op::negative) {
        minus = true;
        inner = &part->parts[0];
      }
      const bool signed_number = (*inner)->op == Op::number && (*inner)->p < 0;
      std::string next = at(*inner, text.empty() && !minus && !signed_number ? Place::alone : Place::term);
      if (text.empty()) {
        text = minus ? "-" + next : next;
      } else {
        text += (style_.spaced ? (minus ? " - " : " + ") : (minus ? "-" : "+")) + next;
      }
    }
    return text;
  }

  std::string product(const Node& node) {
    std::string text;
    for (std::size_t k = 0; k < node.parts.size(); ++k) {
      const Term& part = node.parts[k];
      const bool scalars = part->rank == 0 && (k == 0 || node.parts[k - 1]->rank == 0);
      std::string next = at(part, k + 1 == node.parts.size() ? Place::last : Place::factor);
      if (text.empty()) {
        text = next;
        continue;
      }
      const bool digit = std::isdigit(static_cast<unsigned char>(next[0])) != 0 || part->op == Op::number;
      const bool bracket =
          next[0] == '(' || next.compare(0, 6, "\\left(") == 0 || next.compare(0, 5, "\\bigl") == 0;
      if (scalars && (digit || (bracket && node.parts[k - 1]->op == Op::symbol) || random_.one_in(8))) {
        text += "\\cdot " + next;
      } else {
        text += (digit ? "\\," : style_.between) + next;
      }
    }
    return text;
  }

  std::string quotient(const Node& node) {
    const Node& above = *node.parts[0];
    const Node& below = *node.parts[1];
    const bool short_ones = above.op == Op::symbol && below.op == Op::symbol && above.dots + below.dots == 0;
    if (short_ones && above.rank == 0 && random_.one_in(3))
      return bracketed(at(node.parts[0], Place::alone) + "/" + at(node.parts[1], Place::alone));
    return fraction(at(node.parts[0], Place::alone), at(node.parts[1], Place::alone));
  }

  std::string power(const Node& node, Place place) {
    const Node& base = *node.parts[0];
    const std::string exponent =
        node.p < 0 || node.p > 9 ? "^{" + std::to_string(node.p) + "}" : "^" + std::to_string(node.p);
    if (base.op == Op::function && node.p > 1 && base.function != Function::exp &&
        base.function != Function::ln)
      return function(base, place, exponent);
    if (base.op == Op::length && base.parts[0]->op == Op::symbol && base.parts[0]->dots == 0 &&
        style_.lengths_by_letter && letters_[base.parts[0]->letter].nature != Nature::unit) {
      Node plain = *base.parts[0];
      std::string name = letters_[plain.letter].plain;
      if (plain.particle != 0) name += "_" + particle_name(plain.particle);
      return name + exponent;
    }
    std::string text = at(node.parts[0], Place::atom);
    return text + exponent;
  }

  std::string function(const Node& node, Place place, const std::string& exponent = "") {
    static const std::array names{"\\sin", "\\cos", "\\tan", "\\exp", "\\sinh", "\\cosh", "\\tanh", "\\ln"};
    const Node& argument = *node.parts[0];
    if (node.function == Function::exp && !node.bare && random_.one_in(2))
      return "e^{" + at(node.parts[0], Place::alone) + "}";
    const std::string name = names[static_cast<std::size_t>(node.function)] + exponent;
    if (node.bare)
      return name + " " + at(argument.parts[0], Place::atom) + bracketed(at(argument.parts[1], Place::alone));
    const bool bare = argument.op == Op::symbol && argument.dots == 0 && place != Place::factor;
    if (bare && random_.one_in(2)) return name + " " + at(node.parts[0], Place::alone);
    return name + bracketed(at(node.parts[0], Place::alone));
  }

  std::string field(const Node& node) {
    const std::string nabla = style_.face == "\\vec" && random_.one_in(2) ? "\\vec{\\nabla}" : "\\nabla";
    const auto operand = [&](std::size_t k) { return at(node.parts[k], Place::vector); };
    switch (node.op) {
      case Op::partial:
        return "\\partial_" + node.slots + " " + operand(0);
      case Op::gradient:
        return nabla + " " + operand(0);
      case Op::divergence:
        return nabla + "\\cdot " + operand(0);
      case Op::curl:
        return nabla + "\\times " + operand(0);
      case Op::laplacian:
        return "\\nabla^2 " + operand(0);
      default:
        return "(" + operand(0) + "\\cdot\\nabla)" + operand(1);
    }
  }

  std::string in_frame(const Node& node) {
    const std::string of = node.parts[0]->op == Op::symbol
                               ? fraction("d" + at(node.parts[0], Place::alone), "dt")
                               : fraction("d", "dt") + at(node.parts[0], Place::vector);
    return "\\left(" + of + "\\right)_{\\text{" + (node.op == Op::rate_in ? "in" : "rot") + "}}";
  }

  std::string plain(const Node& node, Place place) {
    switch (node.op) {
      case Op::number:
        return number(node);
      case Op::symbol:
        return symbol(node);
      case Op::delta:
        return "\\delta_{" + node.slots + "}";
      case Op::epsilon:
        return style_.epsilon + "_{" + node.slots + "}";
      case Op::sum:
        return sum(node);
      case Op::negative:
        return "-" + at(node.parts[0], Place::term);
      case Op::product:
        return product(node);
      case Op::quotient:
        return quotient(node);
      case Op::power:
        return power(node, place);
      case Op::root:
        return "\\sqrt{" + at(node.parts[0], Place::alone) + "}";
      case Op::absolute:
      case Op::length:
        return barred(at(node.parts[0], Place::alone));
      case Op::dot:
      case Op::act:
        return at(node.parts[0], Place::vector) + "\\cdot " + at(node.parts[1], Place::vector);
      case Op::cross:
        return at(node.parts[0], Place::vector) + "\\times " + at(node.parts[1], Place::vector);
      case Op::trace:
        return "\\operatorname{tr} " + at(node.parts[0], Place::vector);
      case Op::function:
        return function(node, place);
      case Op::component:
        return "(" + at(node.parts[0], Place::alone) + ")_" + node.slots;
      case Op::contract:
        return plain(*node.parts[0], place);
      case Op::particle_sum:
        return "\\sum_" + particle_name(node.particle) + " " + at(node.parts[0], Place::last);
      case Op::rate:
        if (style_.physics) return "\\dv{t}" + bracketed(at(node.parts[0], Place::alone));
        return fraction("d", "dt") + bracketed(at(node.parts[0], Place::alone));
      case Op::rate_in:
      case Op::rate_rot:
        return in_frame(node);
      default:
        return field(node);
    }
  }

  const std::vector<Letter>& letters_;
  const Style& style_;
  Random random_;
};

std::string sign_of(Relation relation) {
  static const std::array signs{"=", "<", "\\le ", ">", "\\geq ", "\\ne ", "\\approx "};
  return signs[static_cast<std::size_t>(relation)];
}

std::string name_of(const Letter& letter, const Style& style) {
  Term term = symbol({letter}, 0, "", letter.of_particles ? 'a' : '\0');
  return latex(term, {letter}, style);
}

/// What says of what kind the letters are, and that they are meant for all values: the one place of it.
std::vector<std::string> declarations(const Statement& statement, const Style& style) {
  std::vector<std::string> lines;
  std::vector<bool> used(statement.letters.size());
  bool by_time = false;
  const auto look = [&](const Node& node) {
    if (node.op == Op::symbol) used[node.letter] = true;
    by_time = by_time || node.dots > 0 || node.op == Op::rate || node.op >= Op::partial;
  };
  for (const Term& side : statement.sides) visit(side, look);
  for (const Claim& given : statement.given) {
    visit(given.left, look);
    visit(given.right, look);
  }
  for (std::size_t k = 0; k < statement.letters.size(); ++k) {
    const Letter& letter = statement.letters[k];
    const std::string name = name_of(letter, style);
    if (letter.nature == Nature::spin)
      lines.insert(lines.begin(), "frame rot rotates with " + name + " in in");
    if (!used[k] || letter.nature == Nature::spin || letter.nature == Nature::position) continue;
    if (letter.rank == 2) {
      lines.push_back((letter.symmetric ? "symmetric tensor " : "tensor ") + letter.plain + "_{ij}");
    } else if (letter.nature == Nature::unit) {
      lines.push_back("unit vector " + name);
    } else {
      lines.push_back((letter.rank == 1 ? "vector " : "scalar ") + name);
    }
    const std::string said = letter.rank == 2 ? letter.plain + "_{ij}" : name;
    if (letter.nature == Nature::small) lines.push_back("small " + name);
    if (by_time && letter.nature == Nature::constant) lines.push_back("constant " + said);
    if (by_time && (letter.nature == Nature::free || letter.nature == Nature::field))
      lines.push_back("variable " + said);
    lines.push_back("for all " + said);
  }
  for (const Claim& given : statement.given)
    lines.push_back("given " + latex(given.left, statement.letters, style) + sign_of(given.relation) +
                    latex(given.right, statement.letters, style));
  return lines;
}

/// What may stand at the end of a display and changes nothing.
std::string ending(Random& random) {
  static const std::vector<std::string> endings{".",    ",",           " \\tag{7}", " \\label{eq:it}",
                                                "\\,.", " \\nonumber", "\\;,"};
  return random.one_in(3) ? random.of(endings) : "";
}

std::string display(const Statement& statement, const Style& style) {
  Random random(style.seed + 1);
  std::vector<std::string> sides;
  for (const Term& side : statement.sides) sides.push_back(latex(side, statement.letters, style));
  std::string body = sides[0];
  const bool rows = sides.size() > 2 || random.one_in(5);
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (rows && k > 1) body += " \\\\\n  ";
    body += (rows ? " &" : " ") + sign_of(statement.relations[k - 1]) + (style.spaced ? " " : "") + sides[k];
  }
  const bool starred = random.one_in(2);
  body += ending(random);
  if (rows && style.latex_notes && !starred) return "\\begin{align}\n  " + body + "\n\\end{align}\n";
  if (rows && style.latex_notes) return "\\begin{align*}\n  " + body + "\n\\end{align*}\n";
  if (rows) return "$$\\begin{aligned}\n  " + body + "\n\\end{aligned}$$\n";
  if (style.latex_notes && random.one_in(2)) return "\\begin{equation}\n  " + body + "\n\\end{equation}\n";
  return random.one_in(2) ? "\\[ " + body + " \\]\n" : "$$" + body + "$$\n";
}

}  // namespace

Style::Style(Random random)
    : face(random.of(std::vector<std::string>{"\\mathbf", "\\mathbf", "\\vec", "\\boldsymbol", "\\bm"})),
      unit_face(random.of(std::vector<std::string>{"\\hat", "\\hat{\\mathbf"})),
      tensor_face(random.of(std::vector<std::string>{"\\mathsf", "\\overleftrightarrow{\\mathbf"})),
      epsilon(random.one_in(2) ? "\\varepsilon" : "\\epsilon"),
      fraction(random.one_in(5) ? "\\dfrac" : "\\frac"),
      between(random.of(std::vector<std::string>{" ", "\\,", " ", "\\;"})),
      dots_as_fractions(random.one_in(3)),
      lengths_by_letter(random.one_in(2)),
      latex_notes(random.one_in(2)),
      physics(random.one_in(5)),
      spaced(!random.one_in(3)),
      seed(random.next()) {}

std::string latex(const Term& term, const std::vector<Letter>& letters, const Style& style) {
  return Writer(letters, style).at(term, Place::alone);
}

std::string section(const Statement& statement, const Style& style, const std::string& title) {
  std::string text = style.latex_notes ? "\\section{" + title + "}\n" : "# " + title + "\n\n";
  for (const std::string& line : declarations(statement, style))
    text += style.latex_notes ? "% rigor: " + line + "\n" : "<!-- rigor: " + line + " -->\n";
  return text + "\n" + display(statement, style);
}

std::string notes(const Statement& statement, const Style& style) {
  return section(statement, style, statement.kind);
}

std::string file_name(const Style& style) { return style.latex_notes ? "statement.tex" : "statement.md"; }

}  // namespace fuzz
