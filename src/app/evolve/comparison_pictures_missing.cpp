#include "app/evolve/comparison_pictures.h"

namespace cambrian {

Status save_comparison_pictures(const std::filesystem::path& /*folder*/,
                                const std::vector<ComparedRun>& /*runs*/) {
    return Error{"this program was built without pictures; no curves are drawn"};
}

}  // namespace cambrian
