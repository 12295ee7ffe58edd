// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/constant/physical_constants.h"

#include <array>

namespace rigor {
namespace {

constexpr std::string_view electron_words = "electron|positron|hydrogen|bohr|compton";
constexpr std::string_view acceleration_words = "free fall|gravity|gravitational|falls|weight";
constexpr std::string_view earth_words = "earth|earth's";
constexpr std::string_view sun_words = "sun|sun's|solar";

constexpr auto constants = std::to_array<PhysicalConstant>({
    // exact
    {"the speed of light", "299792458", 0, "m/s", 0, "c_0", "c", "", "light|electromagnetic|relativistic"},
    {"Planck's constant", "6.62607015", -34, "J s", 0, "", "h", "", "planck|planck's|quantum"},
    {"the reduced Planck constant", "1.0545718176461564", -34, "J s", 0, "\\hbar", "", "", ""},
    {"the elementary charge", "1.602176634", -19, "C", 0, "q_e", "e e_0", "",
     "elementary charge|electron|proton|positron|ion|charge of the"},
    {"the charge of the electron", "-1.602176634", -19, "C", 0, "", "", "q", "electron"},
    {"the charge of the proton", "1.602176634", -19, "C", 0, "", "", "q", "proton|positron|electron"},
    {"Boltzmann's constant", "1.380649", -23, "J/K", 0, "k_B", "k k_b", "", "boltzmann|boltzmann's"},
    {"Avogadro's constant", "6.02214076", 23, "1/mol", 0, "N_A", "N_L", "", "avogadro|avogadro's"},
    {"the gas constant", "8.31446261815324", 0, "J/(mol K)", 0, "R_{gas}", "R R_m", "", "gas constant"},
    {"the gas constant for one mole", "8.31446261815324", 0, "J/K", 0, "", "", "R", "one mole|a mole"},
    {"Faraday's constant", "96485.33212331002", 0, "C/mol", 0, "", "F", "", "faraday|faraday's"},
    {"the Stefan-Boltzmann constant", "5.670374419184429", -8, "W m^-2 K^-4", 0, "\\sigma_{SB}",
     "\\sigma \\sigma_B", "", "stefan|stefan-boltzmann|blackbody|black body"},
    {"Wien's constant", "2.897771955185172", -3, "m K", 0, "", "", "b", "wien|wien's"},
    {"the quantum of magnetic flux", "2.067833848461929", -15, "Wb", 0, "", "", "\\Phi_0",
     "flux quantum|quantum of"},
    // measured
    {"the electric constant", "8.8541878188", -12, "F/m", 1e-9, "\\epsilon_0 \\varepsilon_0", "", "", ""},
    {"the magnetic constant", "1.25663706127", -6, "N/A^2", 3e-10, "", "\\mu_0", "", "permeability|magnetic"},
    {"Coulomb's constant", "8.9875517862", 9, "N m^2/C^2", 1e-9, "k_e", "k K k_C", "", "coulomb|coulomb's"},
    {"the impedance of free space", "376.730313412", 0, "\\Omega", 3e-10, "", "Z_0", "\\eta_0", "impedance"},
    {"the gravitational constant", "6.6743", -11, "m^3/(kg s^2)", 2.3e-5, "G_N", "G", "",
     "gravitational|gravity|newton's constant|gravitation"},
    {"the mass of the electron", "9.1093837139", -31, "kg", 2e-9, "m_e m_{el}", "", "m m_0", electron_words},
    {"the mass of the proton", "1.67262192595", -27, "kg", 2e-9, "m_p", "", "m M m_0", "proton"},
    {"the mass of the neutron", "1.67492750056", -27, "kg", 2e-9, "m_n", "", "m M m_0", "neutron"},
    {"the mass of the muon", "1.883531627", -28, "kg", 3e-8, "m_{\\mu}", "", "m m_0", "muon"},
    {"the atomic mass constant", "1.66053906892", -27, "kg", 2e-9, "\\mathrm{u} m_u", "", "u",
     "atomic mass|mass unit"},
    {"Bohr's radius", "5.29177210544", -11, "m", 4e-10, "a_B", "a_0", "a", "bohr|bohr's"},
    {"the fine-structure constant", "7.2973525643", -3, "", 2e-10, "", "", "\\alpha",
     "fine-structure|fine structure"},
    {"Rydberg's constant", "10973731.568157", 0, "1/m", 4e-12, "R_{\\infty}", "", "R", "rydberg|rydberg's"},
    {"Rydberg's constant of hydrogen", "10967758.34", 0, "1/m", 1e-9, "", "", "R R_H", "rydberg|rydberg's"},
    {"the Rydberg energy", "2.179872361103", -18, "J", 2e-12, "Ry E_{Ry}", "", "E_R", "rydberg"},
    {"the Hartree energy", "4.3597447222060", -18, "J", 3e-12, "", "E_h", "E_H", "hartree"},
    {"Bohr's magneton", "9.2740100657", -24, "J/T", 3e-9, "\\mu_B", "", "", "magneton"},
    {"the nuclear magneton", "5.0507837393", -27, "J/T", 2e-9, "\\mu_N", "\\mu_K", "", "nuclear magneton"},
    {"the classical radius of the electron", "2.8179403205", -15, "m", 1e-9, "", "r_e", "r_0",
     "classical electron radius|classical radius"},
    {"the Compton wavelength of the electron", "2.42631023538", -12, "m", 1e-9, "", "\\lambda_C", "",
     "compton"},
    {"the cross section of Thomson", "6.6524587051", -29, "m^2", 3e-9, "", "\\sigma_T", "\\sigma_e",
     "thomson"},
    // of the earth and the sun
    {"the acceleration of free fall", "9.81", 0, "m/s^2", 0, "", "g", "", acceleration_words},
    {"the acceleration of free fall", "9.80665", 0, "m/s^2", 0, "g_n", "g g_0", "", acceleration_words},
    {"the acceleration of free fall", "9.8", 0, "m/s^2", 0, "", "g", "", acceleration_words},
    {"the mass of the earth", "5.972", 24, "kg", 2e-4, "M_{\\oplus}", "", "M m M_E", earth_words},
    {"the radius of the earth", "6.371", 6, "m", 2e-4, "R_{\\oplus}", "", "R R_E", earth_words},
    {"the radius of the earth", "6.3781", 6, "m", 2e-4, "R_{\\oplus}", "", "R R_E", earth_words},
    {"the mass of the sun", "1.9885", 30, "kg", 2e-4, "M_{\\odot} M_{\\sun}", "", "M M_S", sun_words},
    {"the radius of the sun", "6.957", 8, "m", 2e-4, "R_{\\odot} R_{\\sun}", "", "R", sun_words},
    {"the luminosity of the sun", "3.828", 26, "W", 2e-4, "L_{\\odot} L_{\\sun}", "", "L", sun_words},
});

}  // namespace

std::span<const PhysicalConstant> physical_constants() { return constants; }

}  // namespace rigor
