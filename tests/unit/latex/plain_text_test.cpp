// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/plain_text.h"

#include "catch.h"
#include "latex/written_box.h"

namespace rigor {

TEST_CASE("vector algebra is one line of plain text") {
  CHECK(plain_of(R"(|\mathbf{A}\times\mathbf{B}|^2 = A^2B^2 - (\mathbf{A}\cdot\mathbf{B})^2)") ==
        "|A×B|² = A²B² − (A·B)²");
  CHECK(plain_of(R"(\varepsilon_{ijk}A_jB_k)") == "εᵢⱼₖAⱼBₖ");
  CHECK(plain_of(R"(T_{rot} = \tfrac12 I_{ij}\omega_i\omega_j)") == "Tᵣₒₜ = ½Iᵢⱼωᵢωⱼ");
}

TEST_CASE("what has no raised form is written behind a mark, in brackets if it is long") {
  CHECK(plain_of(R"(m_\alpha r_{\alpha i} e^{-\lambda t})") == "m_αr_(αi)e^(−λt)");
  CHECK(plain_of(R"(T_{\mathrm{rot}})") == "T_rot");
  CHECK(plain_of(R"(x'_1 + f''^2)") == "x₁′ + f′′²");
}

TEST_CASE("a fraction is a quotient with the brackets that it needs") {
  CHECK(plain_of(R"(\frac{a+b}{2c})") == "(a + b)/(2c)");
  CHECK(plain_of(R"(\frac{1}{12}m)") == "(1/12)m");
  CHECK(plain_of(R"(\sqrt{a^2+b^2} + \sqrt[3]{x})") == "√(a² + b²) + ³√x");
}

TEST_CASE("accents are combining marks on one letter") {
  CHECK(plain_of(R"(\dot{\mathbf{r}}_\alpha = \vec v)") == "r\u0307_α = v\u20D7");
  CHECK(plain_of(R"(\ddot\omega_2)") == "ω\u0308₂");
}

TEST_CASE("a minus sign of what follows stands close to it") {
  CHECK(plain_of(R"(a = -b + (-c))") == "a = −b + (−c)");
}

TEST_CASE("rows of one chain go on on the line, other rows are parted") {
  CHECK(to_plain_text(display_of(R"(a &= b \\ &= c \\ d &= e)", "align").box) == "a = b = c; d = e");
  CHECK(plain_of(R"(\begin{pmatrix} a & b \\ c & d \end{pmatrix})") == "(a, b; c, d)");
  CHECK(plain_of(R"(\begin{cases} 1 & \text{if } i = j \\ 0 & \text{else} \end{cases})") ==
        "{1, if i = j; 0, else");
}

TEST_CASE("sums, limits and functions keep their places") {
  CHECK(plain_of(R"(\sum_{i=1}^3 A_iB_i)") == "∑ᵢ₌₁³ AᵢBᵢ");
  CHECK(plain_of(R"(\lim_{x\to0} \sin x)") == "lim_(x → 0) sin x");
}

TEST_CASE("units read as they are spoken of") {
  CHECK(plain_of(R"(\SI{9.81}{\metre\per\second\squared})") == "9.81 m s⁻²");
  CHECK(plain_of(R"(\qty{3e-4}{kg.m/s})") == "3×10⁻⁴ kg m/s");
}

TEST_CASE("a control that nobody knows is shown by its name") { CHECK(plain_of(R"(a \foo b)") == "a\\foob"); }

}  // namespace rigor
