#pragma once

// A creature edited by hand: the original, every version since, undo and redo.

#include "studio/playback/exhibit.h"

#include <optional>
#include <string>
#include <vector>

namespace cambrian {

// One gene, in words as of a mutation.
struct GeneChange {
    std::string place;  // "part 2 length"
    std::string from;
    std::string to;
};

class GeneEditor {
public:
    // Another creature is shown; nothing to undo.
    void clear() { *this = {}; }
    // The genome replaces that of the creature shown. Edits of the same place without a finish()
    // between them, as a drag makes them, are one step to undo.
    void edit(const Exhibit& shown, GenomePtr genome, const GeneChange& change);
    void finish() { open_place_.clear(); }
    bool can_undo() const { return present_ > 0; }
    bool can_redo() const { return present_ + 1 < versions_.size(); }
    void undo();
    void redo();
    // The creature to display: the original if no gene differs from it, otherwise its child by the
    // method "edited". Only after edit().
    Exhibit exhibit() const;

private:
    struct Version {
        GenomePtr genome;
        std::vector<MutationRecord> changes;  // since the original, one a place
    };

    std::optional<Exhibit> original_;
    std::vector<Version> versions_;  // the original first
    std::size_t present_ = 0;
    std::string open_place_;  // being edited, or empty
};

}  // namespace cambrian
