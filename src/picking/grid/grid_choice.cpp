#include "picking/grid/grid_choice.h"

#include "math/distance.h"
#include "math/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLeastWeighed = 1e-6;  // kg; least mass, since its logarithm is taken
constexpr double kLeastStir = 0.01;     // body lengths; smaller motion is not visible
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

double in_body_lengths(double length, const EvaluationResult& result) {
    return result.body_length > 0.0 ? length / result.body_length : 0.0;
}

CandidateGrade grade_of(const EvaluationResult& result) {
    if (is_invalid(result.outcome) || result.outcome == Outcome::kInterrupted)
        return CandidateGrade::kInvalid;
    if (result.outcome == Outcome::kRejected) return CandidateGrade::kRejected;
    const bool still = result.behavior.stir < kLeastStir * result.body_length;
    return still ? CandidateGrade::kStatic : CandidateGrade::kAlive;
}

// Returns a rank for each candidate, from 1 for the best to 0 for the worst.
std::vector<double> merit_of(std::span<const IndividualPtr> candidates) {
    std::vector<std::size_t> order(candidates.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return better(*candidates[a], *candidates[b]);
    });
    std::vector<double> merit(candidates.size(), 1.0);
    for (std::size_t rank = 1; rank < order.size(); ++rank)
        merit[order[rank]] =
            1.0 - static_cast<double>(rank) / static_cast<double>(order.size() - 1);
    return merit;
}

// Chooses candidates one by one, and keeps their distances to the creatures shown so far.
class DiverseChoice {
public:
    DiverseChoice(std::span<const IndividualPtr> candidates, std::span<const IndividualPtr> shown,
                  double fitness_weight)
        : merit_(merit_of(candidates)),
          nearest_(candidates.size(), kUnlimited),
          open_(candidates.size(), true),
          fitness_weight_(fitness_weight) {
        std::vector<IndividualPtr> all(candidates.begin(), candidates.end());
        all.insert(all.end(), shown.begin(), shown.end());
        descriptors_ = scaled_descriptors(all);
        for (std::size_t i = candidates.size(); i < all.size(); ++i)
            show(i);
        if (shown.empty()) fitness_weight_for_first_ = 1.0;
    }

    std::size_t take() {
        const double weight = std::exchange(fitness_weight_for_first_, fitness_weight_);
        const double furthest = furthest_open();
        std::size_t best = 0;
        double most = -kUnlimited;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            if (!open_[i]) continue;
            const double spread = furthest > 0.0 ? nearest_[i] / furthest : 0.0;
            // Before any creature is shown all distances are infinite, so fitness alone decides.
            const double value =
                weight < 1.0 ? (1.0 - weight) * spread + weight * merit_[i] : merit_[i];
            if (value <= most) continue;
            most = value;
            best = i;
        }
        open_[best] = false;
        show(best);
        return best;
    }

private:
    double furthest_open() const {
        double furthest = 0.0;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            if (open_[i]) furthest = std::max(furthest, nearest_[i]);
        }
        return furthest;
    }
    void show(std::size_t one) {
        for (std::size_t i = 0; i < nearest_.size(); ++i)
            nearest_[i] = std::min(nearest_[i], distance(descriptors_[i], descriptors_[one]));
    }

    // Descriptors of the candidates, followed by those of the creatures shown.
    std::vector<GridDescriptor> descriptors_;
    std::vector<double> merit_;
    std::vector<double> nearest_;  // distance of each candidate to the nearest creature shown
    std::vector<bool> open_;       // whether each candidate is not chosen yet
    double fitness_weight_;
    double fitness_weight_for_first_ = fitness_weight_;
};

}  // namespace

GridDescriptor describe_for_grid(const EvaluationResult& result) {
    return {static_cast<double>(result.parts), logarithm(std::fmax(result.mass, kLeastWeighed)),
            in_body_lengths(result.behavior.settled_height, result),
            result.behavior.mean_joint_frequency, in_body_lengths(result.behavior.travel, result)};
}

std::vector<GridDescriptor> scaled_descriptors(std::span<const IndividualPtr> all) {
    std::vector<GridDescriptor> scaled;
    scaled.reserve(all.size());
    for (const IndividualPtr& each : all)
        scaled.push_back(describe_for_grid(each->result));
    for (std::size_t measure = 0; measure < GridDescriptor().size(); ++measure) {
        double low = kUnlimited;
        double high = -kUnlimited;
        for (const GridDescriptor& each : scaled) {
            low = std::min(low, each[measure]);
            high = std::max(high, each[measure]);
        }
        const double scale = high > low ? 1.0 / (high - low) : 0.0;
        for (GridDescriptor& each : scaled)
            each[measure] = (each[measure] - low) * scale;
    }
    return scaled;
}

std::vector<CandidateGrade> grade_candidates(std::span<const IndividualPtr> candidates,
                                             std::set<std::uint64_t> taken) {
    std::vector<CandidateGrade> grades;
    grades.reserve(candidates.size());
    for (const IndividualPtr& candidate : candidates) {
        const bool is_new = taken.insert(candidate->genome_hash).second;
        const CandidateGrade grade = grade_of(candidate->result);
        grades.push_back(is_new ? grade : std::max(grade, CandidateGrade::kTwin));
    }
    return grades;
}

std::vector<std::size_t> choose_diverse(std::span<const IndividualPtr> candidates,
                                        std::span<const IndividualPtr> shown, std::size_t count,
                                        double fitness_weight) {
    DiverseChoice choice(candidates, shown, fitness_weight);
    std::vector<std::size_t> chosen(std::min(count, candidates.size()));
    for (std::size_t& each : chosen)
        each = choice.take();
    return chosen;
}

}  // namespace cambrian
