// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/typeset_signs.h"

#include "latex/token/words.h"

namespace rigor {
namespace {

/// What amsmath and amssymb can set.
const WordTable& commands() {
  static const WordTable table(R"(
      α \alpha  β \beta  γ \gamma  δ \delta  ϵ \epsilon  ε \varepsilon  ζ \zeta  η \eta  θ \theta
      ϑ \vartheta  ι \iota  κ \kappa  ϰ \varkappa  λ \lambda  μ \mu  µ \mu  ν \nu  ξ \xi  ο o  π \pi
      ϖ \varpi  ρ \rho  ϱ \varrho  σ \sigma  ς \varsigma  τ \tau  υ \upsilon  ϕ \phi  φ \varphi  χ \chi
      ψ \psi  ω \omega  ℓ \ell  ı \imath  ȷ \jmath  Γ \Gamma  Δ \Delta  Θ \Theta  Λ \Lambda  Ξ \Xi  Π \Pi
      Σ \Sigma  Υ \Upsilon  Φ \Phi  Ψ \Psi  Ω \Omega  ℏ \hbar  ∞ \infty  ∂ \partial  ∇ \nabla  ∇² \nabla^2
      ℜ \Re  ℑ \Im  ℵ \aleph  ∅ \varnothing  ∀ \forall  ∃ \exists  ∄ \nexists  † \dagger  ‡ \ddagger
      □ \square  ∠ \angle  ° {}^\circ  … \ldots  ⋯ \cdots  ⋮ \vdots  ⋱ \ddots  ⊤ \top  ⊥ \bot  ¬ \neg
      △ \triangle  ⋄ \diamond  % \%  $ \$  # \#  & \&  _ \_  ✓ \checkmark  ■ \blacksquare  × \times  · \cdot
      • \bullet  ± \pm  ∓ \mp  ÷ \div  ∧ \wedge  ∨ \vee  ⊗ \otimes  ⊕ \oplus  ⊖ \ominus  ⊙ \odot  ∘ \circ
      ⋆ \star  ∗ \ast  ∪ \cup  ∩ \cap  ∖ \setminus  ⋉ \ltimes  ⋊ \rtimes  ≡ \equiv  ≔ :=  ≕ =:  ≜ \triangleq
      ≝ \triangleq  ≐ \doteq  < <  > >  ≪ \ll  ≫ \gg  ≤ \leq  ⩽ \leqslant  ≥ \geq  ⩾ \geqslant  ≠ \neq
      ≈ \approx  ≃ \simeq  ≅ \cong  ≊ \approxeq  ∼ \sim  ∝ \propto  ∈ \in  ∉ \notin  ∋ \ni  ⊂ \subset
      ⊆ \subseteq  ⊃ \supset  ⊇ \supseteq  ⟂ \perp  ∥ \parallel  → \rightarrow  ↦ \mapsto  ⟶ \longrightarrow
      ↔ \leftrightarrow  ≲ \lesssim  ≳ \gtrsim  ≺ \prec  ≻ \succ  ≍ \asymp  ⟼ \longmapsto  ← \leftarrow
      ⟵ \longleftarrow  ↑ \uparrow  ↓ \downarrow  ⇒ \Rightarrow  ⟹ \Longrightarrow  ⟺ \Longleftrightarrow
      ⇔ \Leftrightarrow  ⟸ \Longleftarrow  ⇐ \Leftarrow  ∣ \mid  ∤ \nmid  ⊢ \vdash  ⊨ \models  ∴ \therefore
      ∵ \because  ↪ \hookrightarrow  ⇌ \rightleftharpoons  ⇝ \rightsquigarrow  { \{  } \}  [ [  ] ]  ( (
      ) )  ⟨ \langle  ⟩ \rangle  ⌊ \lfloor  ⌋ \rfloor  ⌈ \lceil  ⌉ \rceil  | \vert  ‖ \Vert  ∑ \sum  ∏ \prod
      ∐ \coprod  ⋃ \bigcup  ⋂ \bigcap  ⨁ \bigoplus  ⨂ \bigotimes  ⋁ \bigvee  ⋀ \bigwedge  ∫ \int  ∬ \iint
      ∭ \iiint  ∮ \oint  ∯ \oint  − -  + +  = =  , ,  ; ;  : :  / /  ! !  . .  ? ?  * \ast  @ @
      𝒪( \mathcal{O}()");
  return table;
}

}  // namespace

std::string typeset_sign(std::string_view text) {
  const std::string command(commands().find(text));
  return command.starts_with('\\') && command.size() > 2 ? command + " " : command;
}

}  // namespace rigor
