#include "studio/viewer/gene_editor.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

std::vector<MutationRecord> with_change(std::vector<MutationRecord> changes,
                                        const GeneChange& change) {
    const auto same = std::find_if(changes.begin(), changes.end(), [&](const MutationRecord& each) {
        return each.place == change.place;
    });
    if (same == changes.end()) {
        changes.push_back({"edited", change.place, change.from, change.to});
    } else if (same->from == change.to) {
        changes.erase(same);
    } else {
        same->to = change.to;
    }
    return changes;
}

}  // namespace

void GeneEditor::edit(const Exhibit& shown, GenomePtr genome, const GeneChange& change) {
    if (!original_) {
        original_ = shown;
        versions_.push_back({shown.genome(), {}});
    }
    Version next{std::move(genome), with_change(versions_[present_].changes, change)};
    if (open_place_ == change.place) {
        versions_[present_] = std::move(next);
        return;
    }
    versions_.resize(present_ + 1);
    versions_.push_back(std::move(next));
    ++present_;
    open_place_ = change.place;
}

void GeneEditor::undo() {
    finish();
    if (can_undo()) --present_;
}

void GeneEditor::redo() {
    finish();
    if (can_redo()) ++present_;
}

Exhibit GeneEditor::exhibit() const {
    const Version& version = versions_[present_];
    if (*version.genome == *versions_.front().genome) return *original_;
    Individual child;
    child.uid = genome_hash(*version.genome);
    child.born = original_->individual().born;
    child.line = original_->individual().line;
    child.genome = version.genome;
    child.genome_hash = child.uid;
    child.parents[0] = original_->individual().uid;
    child.mother = ParentLink(original_->creature.individual);
    child.method = "edited";
    child.mutations = version.changes;
    Exhibit edited = *original_;
    edited.creature.individual = std::make_shared<const Individual>(std::move(child));
    edited.title += ", edited";
    edited.ancestry.reset();
    edited.ticks.clear();
    return edited;
}

}  // namespace cambrian
