#pragma once

// Edits of a creature's genes by hand: the original, all versions since, undo and redo.

#include "studio/playback/exhibit.h"

#include <optional>
#include <string>
#include <vector>

namespace cambrian {

// The change of one gene, in the words of a mutation record.
struct GeneChange {
    std::string place;  // "part 2 length"
    std::string from;
    std::string to;
};

class GeneEditor {
public:
    // Must be called when another creature is displayed; forgets all versions.
    void clear() { *this = {}; }
    // Replaces the displayed creature's genome. Edits of the same place without a finish() between
    // them, as during a drag, are one step to undo.
    void edit(const Exhibit& shown, GenomePtr genome, const GeneChange& change);
    void finish() { open_place_.clear(); }
    bool can_undo() const { return present_ > 0; }
    bool can_redo() const { return present_ + 1 < versions_.size(); }
    void undo();
    void redo();
    // Returns the creature to display: the original if no gene differs from it, otherwise a child
    // bred by the method "edited". Must be called after edit().
    Exhibit exhibit() const;

private:
    struct Version {
        GenomePtr genome;
        std::vector<MutationRecord> changes;  // since the original, one per place
    };

    std::optional<Exhibit> original_;
    std::vector<Version> versions_;  // the original first
    std::size_t present_ = 0;
    std::string open_place_;  // place being edited, or empty
};

}  // namespace cambrian
