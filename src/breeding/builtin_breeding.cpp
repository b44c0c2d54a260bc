#include "breeding/methods.h"

namespace cambrian {

BreedingRegistry builtin_breeding() {
    BreedingRegistry methods;
    add_asexual(methods);
    add_crossover(methods);
    add_grafting(methods);
    add_homologous_crossover(methods);
    return methods;
}

}  // namespace cambrian
