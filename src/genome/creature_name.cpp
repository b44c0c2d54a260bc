#include "genome/creature_name.h"

#include "core/text/code_points.h"

#include <array>
#include <string_view>

namespace cambrian {
namespace {

// Left out are, for example, "Ku" and "Tu" to begin with, "na" in the middle and "ro" at the end:
// each makes a bad word with one of the others.
constexpr std::array<std::string_view, 59> kFirstSyllables = {
    "Ba",  "Be", "Bi", "Bre", "Bri", "Bro", "Da", "De",  "Di",  "Do",  "Dra", "Dre",
    "Dro", "Ga", "Ge", "Ja",  "Jo",  "Ka",  "Ke", "Kra", "Kre", "Kri", "La",  "Le",
    "Li",  "Lu", "Ma", "Me",  "Mi",  "Mo",  "Mu", "Na",  "Ne",  "Ni",  "No",  "Ra",
    "Re",  "Ri", "Ru", "Sa",  "Si",  "Su",  "Ta", "Te",  "To",  "Tre", "Tri", "Va",
    "Ve",  "Vi", "Vo", "Wa",  "We",  "Ya",  "Yo", "Za",  "Ze",  "Zi",  "Zo"};
constexpr std::array<std::string_view, 25> kMiddleSyllables = {
    "la", "le", "li",  "lo",  "ma",  "mo",  "ne",  "no",  "ra",  "re",  "ri",  "va", "ve",
    "vi", "vo", "lma", "lme", "lmi", "lmo", "lve", "lvi", "lvo", "rne", "rni", "rno"};
constexpr std::array<std::string_view, 19> kLastSyllables = {
    "la", "le", "lo", "lu", "ma", "mi", "mo", "na", "ne", "no",
    "ra", "re", "ri", "sa", "so", "va", "ve", "vi", "vo"};
constexpr std::array<std::string_view, 6> kNameEndings = {"", "n", "r", "s", "th", "x"};

// Returns the element that the number names, and takes it out of the number.
template <std::size_t kCount>
std::string_view take_from(const std::array<std::string_view, kCount>& all, std::uint64_t& number) {
    const std::string_view taken = all[number % kCount];
    number /= kCount;
    return taken;
}

}  // namespace

std::string coined_name(std::uint64_t genome_hash) {
    std::string name(take_from(kFirstSyllables, genome_hash));
    name += take_from(kMiddleSyllables, genome_hash);
    name += take_from(kLastSyllables, genome_hash);
    name += take_from(kNameEndings, genome_hash);
    return name;
}

std::string creature_name(const Genome& genome) {
    return genome.name.empty() ? coined_name(genome_hash(genome)) : on_one_line(genome.name);
}

}  // namespace cambrian
