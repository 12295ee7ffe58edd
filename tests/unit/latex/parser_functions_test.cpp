// SPDX-License-Identifier: GPL-3.0-or-later
// Functions and integrals over a body.
#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

std::string parsed(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  const Tokens side = stretch.side();
  return dump_syntax(tree, parse_side(side, span_of(side), tree));
}

std::string obstacle(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  const Tokens side = stretch.side();
  const SyntaxId root = parse_side(side, span_of(side), tree);
  return tree[root].kind == SyntaxKind::opaque ? tree.obstacle(root).message : "";
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

}  // namespace

TEST_CASE("a real or imaginary part takes a bracket, or the plain factors behind it") {
  for (const char* text : {"\\Re z", "\\operatorname{Re} z", "\\mathrm{Re}(z)"}) {
    INFO(text);
    CHECK(parsed(text) == "(Re z)");
  }
  CHECK(parsed("\\Im(z w)") == "(Im (term z w))");
  CHECK(parsed("\\Re\\mathbf{E}") == "(Re vector:E)");
  CHECK(parsed("\\Re\\{z + w\\}") == "(Re (sum +z +w))");
  CHECK(parsed("\\Re\\mathbf{E} z") == "(term <ambiguous-reading> z)");
}

TEST_CASE("a bracket behind a function is its argument") {
  for (const char* text :
       {"\\cos(x)", "\\cos[x]", "\\cos\\left(x\\right)", "\\cos{x}", "\\cos\\bigl(x\\bigr)", "\\cos x",
        "\\cos\\,x", "\\operatorname{cos}(x)", "\\mathrm{cos}\\,x"}) {
    INFO(text);
    CHECK(parsed(text) == "(cos x)");
  }
  CHECK(parsed("\\exp\\left(-\\frac{t}{\\tau}\\right)") == "(exp (sum -(fraction t \\tau)))");
  CHECK(parsed("\\cos(x_{i'}, x_j)") == "(cos (tuple x[i'] x[j]))");
  CHECK(parsed("\\ln|x|") == "(ln (bars x))");
  CHECK(parsed("\\sin(x)y") == "(term (sin x) y)");
}

TEST_CASE("without a bracket the plain letters and numbers that follow are the argument") {
  CHECK(parsed("\\cos\\Omega t") == "(cos (term \\Omega t))");
  CHECK(parsed("\\cos 2\\theta") == "(cos (term 2 \\theta))");
  CHECK(parsed("\\sin\\frac{\\theta}{2}") == "(sin (fraction \\theta 2))");
  CHECK(parsed("\\cos\\theta\\sin\\phi") == "(term (cos \\theta) (sin \\phi))");
  CHECK(parsed("A\\cos\\Omega_1 t + B\\sin\\Omega_1 t") ==
        "(sum +(term A (cos (term \\Omega[1] t))) +(term B (sin (term \\Omega[1] t))))");
  CHECK(parsed("\\cos\\dot\\theta t") == "(cos (term dot:\\theta t))");
  CHECK(parsed("\\tan\\theta^2") == "(tan (power \\theta 2))");
}

TEST_CASE("an argument without a bracket ends at space, products, brackets, bold letters and bars") {
  CHECK(parsed("\\sin\\theta (a+b)") == "(term (sin \\theta) (group (sum +a +b)))");
  CHECK(parsed("\\sin\\theta\\,a") == "(term (sin \\theta) a)");
  CHECK(parsed("\\sin\\theta\\quad a") == "(term (sin \\theta) a)");
  CHECK(parsed("\\sin\\theta\\cdot a") == "(term (sin \\theta) ·a)");
  CHECK(parsed("\\cos\\theta\\mathbf A\\times\\mathbf B") == "(term (cos \\theta) vector:A ×vector:B)");
  CHECK(parsed("\\cos\\theta\\dot{\\mathbf A}") == "(term (cos \\theta) vector:dot:A)");
  CHECK(parsed("\\cos\\theta|a|") == "(term (cos \\theta) (bars a))");
  CHECK(parsed("|\\mathbf A||\\mathbf B|\\sin\\theta") ==
        "(term (bars vector:A) (bars vector:B) (sin \\theta))");
  CHECK(parsed("\\sin\\theta/\\cos\\theta") == "(term (sin \\theta) /(cos \\theta))");
}

TEST_CASE("a letter over a slash may belong to the argument or not") {
  CHECK(parsed("\\sin\\theta/2") == "(term <ambiguous-reading> /2)");
  CHECK(parsed("\\sin(\\theta)/2") == "(term (sin \\theta) /2)");
}

TEST_CASE("a rate or a change behind an argument without a bracket may belong to it or not") {
  CHECK(parsed("\\cos\\theta\\dot\\theta^2") == "<ambiguous-reading>");
  CHECK(parsed("\\cos\\theta\\delta\\theta") == "<ambiguous-reading>");
  CHECK(parsed("\\cos\\theta\\frac{d\\theta}{dt}") == "<ambiguous-reading>");
  CHECK(parsed("\\cos\\theta\\,\\dot\\theta") == "(term (cos \\theta) dot:\\theta)");
}

TEST_CASE("an exponent on a function is a power of its value, but for the inverse") {
  CHECK(parsed("\\cos^2\\theta + \\sin^{2}\\theta") ==
        "(sum +(power (cos \\theta) 2) +(power (sin \\theta) 2))");
  CHECK(parsed("\\cos^2(x)") == "(power (cos x) 2)");
  CHECK(parsed("\\sin^{-1}x") == "<unsupported>");
  CHECK(obstacle("\\max") == "`\\max`: functions such as this one are not decided yet");
  CHECK(parsed("\\log_2 x") == "(lb x)");
  CHECK(parsed("\\log_a x") == "<unsupported>");
}

TEST_CASE("determinant and trace take a bracket or one tensor") {
  CHECK(parsed("\\operatorname{tr}\\mathbf A") == "(tr vector:A)");
  CHECK(parsed("\\Tr(\\mathbf A\\mathbf B)") == "(tr (term vector:A vector:B))");
  CHECK(parsed("\\tr\\overleftrightarrow I+1") == "(sum +(tr tensor:I) +1)");
  CHECK(parsed("\\mathrm{Tr}\\,A") == "(tr A)");
  CHECK(parsed("\\operatorname*{det}A") == "(det A)");
  CHECK(parsed("\\det\\begin{pmatrix}a&b\\\\c&d\\end{pmatrix}") == "(det (matrix a b c d))");
  CHECK(parsed("\\tr\\mathbf A\\mathbf B") == "(term <ambiguous-reading> vector:B)");
}

TEST_CASE("a function without an argument is not read: it may be meant as a whole") {
  CHECK(parsed("\\sin") == "<unsupported>");
  CHECK(parsed("\\sin + 1") == "(sum +<unsupported> +1)");
}

TEST_CASE("Euler's number is a letter") {
  CHECK(parsed("e^{x}\\mathrm e^{y}") == "(term (power e x) (power \\mathrm{e} y))");
}

TEST_CASE("derivatives of fields by name are functions") {
  CHECK(parsed("\\grad f") == "(grad f)");
  CHECK(parsed("\\gradient{f}") == "(gradient f)");
  CHECK(parsed("\\grad(f+g)h") == "(term (grad (sum +f +g)) h)");
  CHECK(parsed("\\div\\mathbf A") == "(div vector:A)");
  CHECK(parsed("\\divergence(\\mathbf A)") == "(divergence vector:A)");
  CHECK(parsed("\\curl{\\mathbf A} + a") == "(sum +(curl vector:A) +a)");
  CHECK(parsed("\\laplacian f^2") == "(laplacian (power f 2))");
  CHECK(parsed("a\\div b") == "(term a <unsupported> b)");
}

TEST_CASE("an integral over the body has its measure and its integrand") {
  CHECK(parsed("\\int f\\,dm") == "(integral dm f)");
  CHECK(parsed("\\int\\rho f\\,dV") == "(integral dV (term \\rho f))");
  CHECK(parsed("\\int dm") == "(integral dm 1)");
  CHECK(parsed("\\int dm\\,\\mathbf r\\times\\mathbf v") == "(integral dm (term vector:r ×vector:v))");
  CHECK(parsed("\\int_B dV\\,\\rho\\left(r^2\\delta_{ij}-r_ir_j\\right)") ==
        "(integral dV (term \\rho (group (sum +(term (power r 2) \\delta[i,j]) -(term r[i] r[j])))) \"B\")");
  CHECK(parsed("\\int\\!\\mathbf r\\,\\mathrm dm+a") == "(sum +(integral dm vector:r) +a)");
  CHECK(parsed("\\iiint_V\\rho\\,d^3r") == "(integral dV \\rho \"V\")");
  CHECK(parsed("\\int\\rho\\,d^3\\mathbf{r}\\,\\mathbf r") == "(integral dV (term \\rho vector:r))");
  CHECK(parsed("\\int\\dd{m}+\\int\\dd[3]{x}\\rho+\\int\\dd m") ==
        "(sum +(integral dm 1) +(integral dV \\rho) +(integral dm 1))");
  CHECK(parsed("2\\int\\cos\\theta dm") == "(term 2 (integral dm (cos \\theta)))");
  CHECK(parsed("\\int\\sum_i a_i\\,dm") == "(integral dm (sum over [i] a[i]))");
  CHECK(parsed("\\int\\frac{d\\mathbf r}{dt}dm") == "(integral dm (d/dt vector:r))");
}

TEST_CASE("an integral over a variable has its integrand, the variable and the limits") {
  CHECK(parsed("\\int x^2\\,dx") == "(integral (power x 2) x)");
  CHECK(parsed("\\int_0^L x^2\\,\\mathrm dx + c") == "(sum +(integral (power x 2) x 0 L) +c)");
  CHECK(parsed("\\int_{-\\infty}^\\infty dx\\,f") == "(integral f x (sum -\\infty) \\infty)");
  CHECK(parsed("\\int_0^t v\\,dt'") == "(integral v t' 0 t)");
  CHECK(parsed("\\int\\frac{dx}{x+a}") == "(integral (fraction 1 (sum +x +a)) x)");
  CHECK(parsed("\\int_1^2 dx/x") == "(integral (term 1 /x) x 1 2)");
  CHECK(parsed("\\int_0^1\\int_0^2 f\\,dx\\,dy") == "(integral (integral f x 0 2) y 0 1)");
  CHECK(parsed("\\int_0^1 dx\\int_0^2 dy\\,f") == "(integral (integral f y 0 2) x 0 1)");
  CHECK(parsed("\\int y\\,dx/x") == "<ambiguous-reading>");
  CHECK(parsed("\\int x\\,dx\\,x") == "<ambiguous-reading>");
  CHECK(parsed("\\int_0^1 x\\,dx\\,a") == "(integral (term x a) x 0 1)");
}

TEST_CASE("a bracket or a bar with two limits is a difference") {
  CHECK(parsed("\\left[x^2\\right]_a^b") == "(between (group (power x 2)) a b)");
  CHECK(parsed("[x^2]^b_a") == "(between (group (power x 2)) a b)");
  CHECK(parsed("\\frac12x^2\\Big|_{x=0}^{x=1}") == "(between (term (fraction 1 2) (power x 2)) 0 1 x)");
  CHECK(parsed("x + x^2\\Big|_0^1") == "(sum +x +<ambiguous-reading>)");
}

TEST_CASE("the integrals of a rigid body are read as they are written") {
  CHECK(parsed("\\int_V \\rho\\left(r^2\\delta_{ij} - r_i r_j\\right) d V") ==
        "(integral dV (term \\rho (group (sum +(term (power r 2) \\delta[i,j]) -(term r[i] r[j])))) \"V\")");
  CHECK(parsed("\\int_{\\text{body}}\\mathbf r\\times(\\boldsymbol\\omega\\times\\mathbf r)\\, dm") ==
        "(integral dm (term vector:r ×(group (term vector:\\omega ×vector:r))) \"\\text{body}\")");
  CHECK(parsed("\\frac12\\int \\mathbf v^2\\, dm") ==
        "(term (fraction 1 2) (integral dm (power vector:v 2)))");
  CHECK(parsed("\\frac{d}{dt}\\int\\rho\\,d^3 r") == "(d/dt (integral dV \\rho))");
}

TEST_CASE("an integral ends before a product sign behind its differential") {
  CHECK(parsed("\\mathbf a\\times\\int\\mathbf r\\,dm\\cdot\\mathbf b") ==
        "(term vector:a ×(integral dm vector:r) ·vector:b)");
}

TEST_CASE("other integrals are not read, and it is said which") {
  CHECK(obstacle("\\int\\mathbf F\\cdot d\\boldsymbol\\ell") ==
        "an integral over `d\\boldsymbol\\ell` is not read");
  CHECK(parsed("\\int d\\mathbf S\\cdot\\mathbf F") == "(term <unsupported> ·vector:F)");
  CHECK(obstacle("\\int_0^a f\\,dm") == "an integral over masses between limits is not read");
  CHECK(obstacle("\\int_{V_1} f\\,dm") == "an integral over a part, a surface or a curve is not read");
  CHECK(parsed("\\int f\\,dm\\,dV") == "<unsupported>");
  CHECK(parsed("\\int f\\,dm_\\alpha") == "<unsupported>");
  CHECK(parsed("\\int f") == "<unsupported>");
  CHECK(parsed("\\oint f\\,dm").find("<unsupported>") != std::string::npos);
  CHECK(parsed("\\int") == "<bad-syntax>");
}

TEST_CASE("differentials outside integrals stay letters") {
  CHECK(parsed("d\\mathbf A") == "(term d vector:A)");
  CHECK(parsed("(\\int dm)+dm") == "(sum +(group (integral dm 1)) +(term d m))");
}

TEST_CASE("functions nested without end are refused without a crash") {
  for (const char* text : {"\\sin", "\\sin(", "\\int", "\\int dm", "\\grad", "\\sin^2", "\\tr"}) {
    INFO(text);
    CHECK_FALSE(parsed(repeated(text, 20000) + " x").empty());
  }
}

TEST_CASE("primed indices are read wherever they stand") {
  CHECK(parsed("A_{i'}B_{i^\\prime}C_{i^{\\prime}}") == "(term A[i'] B[i'] C[i'])");
  CHECK(parsed("\\lambda_{i'j}B_{i'j'}e_{1'}x_{i'}") == "(term \\lambda[i',j] B[i',j'] e[1'] x[i'])");
  CHECK(parsed("\\mathbf{e}_{i'}\\mathbf{e}'_i") == "(term vector:e[i'] vector:e'[i])");
}

TEST_CASE("lengths leave nothing in an expression") {
  for (const char* text : {"a\\hskip 2pt b", "a\\hskip-.5em b", "a\\vspace*{2pt}b", "a\\hspace*{1em}b",
                           "a\\kern3mu b", "a\\hspace{2pt}b", "a\\mskip 3mu b"}) {
    INFO(text);
    CHECK(parsed(text) == "(term a b)");
  }
}
