#include "breeding/mutations/tuning.h"

#include "core/assert.h"
#include "genome/gene_fields.h"
#include "genome/words.h"
#include "math/elementary.h"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

// Smallest and largest steps, relative to those of mutations. The logarithm is uniform between.
constexpr double kFinest = 0.03;
constexpr double kCoarsest = 1.0;
constexpr double kAllShare = 0.5;         // share of genomes in which all numbers change
constexpr double kOthersShare = 0.3;      // share of numbers that change in the others
constexpr double kRepeatShare = 0.3;      // share of genomes that repeat their mother's step
constexpr double kRepeatOnlyShare = 0.5;  // share of these without random steps
constexpr double kShortestRepeat = 0.3;   // of the mother's step
constexpr double kLongestRepeat = 2.0;

// A number of a genome and its rule.
struct Number {
    double* value;
    const FieldRule* rule;
};

template <class Gene>
void collect(Gene& gene, std::span<const GeneField<Gene>> fields, std::vector<Number>& numbers) {
    for (const GeneField<Gene>& field : fields)
        numbers.push_back({&(gene.*field.value), &field.rule});
}

void collect(std::vector<NeuronGene>& neurons, std::vector<Number>& numbers) {
    for (NeuronGene& neuron : neurons) {
        for (InputGene& input : neuron.inputs)
            collect(input, input_fields(), numbers);
    }
}

void collect(OrganGene& organ, const KindCatalog& catalog, std::vector<Number>& numbers) {
    CAMBRIAN_TICK_ASSERT(organ.kind < catalog.organs.size(), "an organ of the catalog");
    collect(organ.input, input_fields(), numbers);
    const std::vector<FieldRule>& rules = catalog.organs[organ.kind].parameters;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        if (!rules[i].whole) numbers.push_back({&organ.parameters[i], &rules[i]});
    }
}

std::vector<Number> numbers_of(Genome& genome, const KindCatalog& catalog) {
    std::vector<Number> numbers;
    collect(genome, genome_fields(catalog.dimensions), numbers);
    collect(genome.brain, numbers);
    for (NodeGene& node : genome.nodes) {
        collect(node, node_fields(catalog.dimensions), numbers);
        collect(node.effector, input_fields(), numbers);
        for (DegreeGene& degree : node.further) {
            collect(degree, degree_fields(), numbers);
            collect(degree.effector, input_fields(), numbers);
        }
        collect(node.neurons, numbers);
        for (EdgeGene& edge : node.edges)
            collect(edge, edge_fields(catalog.dimensions), numbers);
        for (OrganGene& organ : node.organs)
            collect(organ, catalog, numbers);
    }
    return numbers;
}

bool same_structure(Genome genome, Genome other, const KindCatalog& catalog) {
    const std::vector<Number> numbers = numbers_of(genome, catalog);
    const std::vector<Number> others = numbers_of(other, catalog);
    if (numbers.size() != others.size()) return false;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        *numbers[i].value = *others[i].value;
    return genome == other;
}

// Returns the step from one value to another, the short way round if the rule wraps.
double step_between(double from, double to, const FieldRule& rule) {
    if (!rule.wraps) return to - from;
    const double width = rule.high - rule.low;
    return to - from - width * std::floor((to - from) / width + 0.5);
}

MutationRecord repeat_step(Genome& genome, Genome before, const KindCatalog& catalog,
                           RandomStream& stream) {
    const double factor = stream.uniform(kShortestRepeat, kLongestRepeat);
    const std::vector<Number> numbers = numbers_of(genome, catalog);
    const std::vector<Number> old = numbers_of(before, catalog);
    CAMBRIAN_TICK_ASSERT(numbers.size() == old.size(), "both have one structure");
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const FieldRule& rule = *numbers[i].rule;
        double& x = *numbers[i].value;
        x = fit(x + factor * step_between(*old[i].value, x, rule), rule);
    }
    return {.operator_id = "tuning",
            .place = "all numbers",
            .from = "",
            .to = fmt::format("last step times {}", in_words(factor))};
}

MutationRecord take_random_steps(Genome& genome, const KindCatalog& catalog, RandomStream& stream) {
    const double scale = kFinest * power(kCoarsest / kFinest, stream.uniform());
    const bool all = stream.chance(kAllShare);
    // Equal numbers, such as the frequencies of a rhythm, have one new value.
    std::map<std::pair<const FieldRule*, double>, double> tuned;
    for (const Number& number : numbers_of(genome, catalog)) {
        const double x = *number.value;
        const auto [known, first] = tuned.try_emplace({number.rule, x}, x);
        if (first && stream.chance(all ? 1.0 : kOthersShare)) {
            const GeneStep& step = number.rule->step;
            const double size = scale * step.relative * std::fmax(std::fabs(x), step.floor);
            known->second = fit(x + stream.gauss() * size, *number.rule);
        }
        *number.value = known->second;
    }
    return {.operator_id = "tuning",
            .place = all ? "all numbers" : "some numbers",
            .from = "",
            .to = fmt::format("steps of {}", in_words(scale))};
}

}  // namespace

MutationRecord tune(Genome& genome, const Genome* before, const KindCatalog& catalog,
                    RandomStream& stream) {
    CAMBRIAN_ASSERT(!genome.nodes.empty(), "only valid genomes are tuned");
    const bool repeats = stream.chance(kRepeatShare) && before != nullptr && !(*before == genome) &&
                         same_structure(genome, *before, catalog);
    MutationRecord record;
    if (repeats) record = repeat_step(genome, *before, catalog, stream);
    if (!repeats || !stream.chance(kRepeatOnlyShare)) {
        const std::string repeated = record.to.empty() ? "" : record.to + ", ";
        record = take_random_steps(genome, catalog, stream);
        record.to = repeated + record.to;
    }
    repair(genome, catalog);
    return record;
}

}  // namespace cambrian
