#pragma once

// The only table of the genes' fields, in the order of hashes and files. Hashes, comparisons, files
// and panels visit all fields of a gene; random genomes, mutation, repair and validation take those
// that are real numbers. No other place lists fields.

#include "genome/field_rule.h"
#include "genome/genome.h"
#include "math/elementary.h"

#include <cstdint>
#include <span>
#include <tuple>

namespace cambrian {

inline MirrorAxis last_mirror_axis(int dimensions) {
    return dimensions == 3 ? MirrorAxis::kDepth : MirrorAxis::kAcross;
}

enum class FieldUse : std::uint8_t { kBody, kBodyInSpace, kControl };

template <class Gene, class Value = double>
struct GeneField {
    FieldRule rule;  // with a range if it is a number
    Value Gene::*value;
    FieldUse use = FieldUse::kBody;
    bool later = false;  // it came later, so files and hashes leave it out where it is 0

    bool is_of(int dimensions) const { return dimensions == 3 || use != FieldUse::kBodyInSpace; }
};

template <class Gene, class Value>
constexpr GeneField<Gene, Value> gene_field(const FieldRule& rule, Value Gene::*value,
                                            FieldUse use = FieldUse::kBody, bool later = false) {
    return {rule, value, use, later};
}

namespace gene_tables {

using namespace gene_range;

constexpr FieldRule plain(const char* name, const char* key, const char* help) {
    return {.name = name, .key = key, .help = help};
}
// A row of the table has a word or a number for each column.
// NOLINTBEGIN(readability-function-size)
constexpr FieldRule number(const char* name, const char* key, double low, double high,
                           double fallback, GeneStep step, FounderDraw founders, const char* unit,
                           const char* help) {
    return {name, key, low, high, fallback, false, step, founders, unit, false, help};
}
// A number that is reduced modulo the width of its range.
constexpr FieldRule circle(const char* name, const char* key, double low, double high,
                           GeneStep step, FounderDraw founders, const char* unit,
                           const char* help) {
    return {name, key, low, high, 0.0, true, step, founders, unit, false, help};
}
// NOLINTEND(readability-function-size)

inline constexpr FounderDraw kWidthDraw = {.least = &FounderSettings::min_width,
                                           .most = &FounderSettings::max_width};
inline constexpr FounderDraw kAngleDraw = {.low = -1.2, .high = 1.2};
inline constexpr FounderDraw kTurnDraw = {.low = -kPi, .high = kPi, .fallback_share = 0.5};
inline constexpr GeneStep kSizeStep = {0.20, 0.1};
// Steps of a position are absolute: 0.06 of the outline or, in one case of five, 0.25.
inline constexpr GeneStep kPositionStep = {0.06, 1.0, 0.25 / 0.06, 0.2};
// Those of a height: 0.12 or, in one case of five, 0.5.
inline constexpr GeneStep kHeightStep = {0.12, 1.0, 0.5 / 0.12, 0.2};

// Of any degree of freedom.
inline constexpr FieldRule kLowLimit = number(
    "low limit", "limits/0", -kMaxLimit, -kMinLimit, -1.0, {0.25, 0.2},
    {.low = 0.2, .high = 1.8, .negated = true}, "rad", "The limits of the joint on either side.");
inline constexpr FieldRule kHighLimit =
    number("high limit", "limits/1", kMinLimit, kMaxLimit, 1.0, {0.25, 0.2},
           {.low = 0.2, .high = 1.8}, "rad", "The limits of the joint on either side.");
inline constexpr FieldRule kEffector =
    plain("effector", "effector", "The effector that drives the joint.");

template <class Gene>
inline constexpr std::tuple<> kFields;

template <>
inline constexpr std::tuple kFields<InputGene>{
    gene_field(plain("source", "source", "The source of the value."), &InputGene::source),
    gene_field(
        number("weight", "w", -kMaxWeight, kMaxWeight, 1.0, {0.3, 0.2}, {.low = -2.0, .high = 2.0},
               "", "The factor of the value; for a constant, the value itself."),
        &InputGene::weight)};

template <>
inline constexpr std::tuple kFields<DegreeGene>{
    gene_field(kLowLimit, &DegreeGene::limit_low), gene_field(kHighLimit, &DegreeGene::limit_high),
    gene_field(kEffector, &DegreeGene::effector, FieldUse::kControl)};

template <>
inline constexpr std::tuple kFields<EdgeGene>{
    gene_field(plain("target", "target",
                     "The index of the node that grows there; it must be below the number of "
                     "nodes."),
               &EdgeGene::target),
    gene_field(circle("position", "pos", 0.0, 1.0, kPositionStep, {}, "",
                      "The position on the parent's outline, as a share of its length."),
               &EdgeGene::position),
    gene_field(number("angle", "angle", -kMaxEdgeAngle, kMaxEdgeAngle, 0.0, {0.25, 0.3}, kAngleDraw,
                      "rad", "The direction of growth, from the outward normal."),
               &EdgeGene::angle),
    gene_field(number("scale", "scale", kMinScale, kMaxScale, 1.0, {0.15, 0.3},
                      {.low = 0.6, .high = 1.2, .fallback_share = 0.5}, "",
                      "The factor of the size of all that grows there."),
               &EdgeGene::scale),
    gene_field(plain("reflect", "reflect",
                     "The handedness of all that grows there is flipped if this is true."),
               &EdgeGene::reflect),
    gene_field(plain("terminal only", "terminalOnly",
                     "The connection is followed only at the end of a repetition if this is true."),
               &EdgeGene::terminal_only),
    gene_field(number("height", "height", -1.0, 1.0, 0.0, kHeightStep,
                      {.low = -1.0, .high = 1.0, .fallback_share = 0.4}, "",
                      "The place between the parent's back, -1, and its front, 1."),
               &EdgeGene::height, FieldUse::kBodyInSpace),
    gene_field(number("tilt", "tilt", -kMaxEdgeAngle, kMaxEdgeAngle, 0.0, {0.25, 0.3}, kAngleDraw,
                      "rad", "The direction of growth out of the parent's plane."),
               &EdgeGene::tilt, FieldUse::kBodyInSpace),
    gene_field(circle("roll", "roll", -kPi, kPi, {0.25, 0.5}, kTurnDraw, "rad",
                      "The turn of the part that grows there about its long axis."),
               &EdgeGene::roll, FieldUse::kBodyInSpace),
    gene_field(plain("reflect depth", "reflectDepth",
                     "Front and back of all that grows there are exchanged if this is true."),
               &EdgeGene::reflect_depth, FieldUse::kBodyInSpace)};

template <>
inline constexpr std::tuple kFields<NodeGene>{
    gene_field(number("length", "length", kMinSize, kMaxLength, 0.5, kSizeStep,
                      {.least = &FounderSettings::min_length, .most = &FounderSettings::max_length},
                      "m", "The length of the part."),
               &NodeGene::length),
    gene_field(number("width", "width", kMinSize, kMaxWidth, 0.2, kSizeStep, kWidthDraw, "m",
                      "The width of the part."),
               &NodeGene::width),
    gene_field(number("depth", "depth", kMinSize, kMaxWidth, 0.2, kSizeStep, kWidthDraw, "m",
                      "The depth of the part, from back to front."),
               &NodeGene::depth, FieldUse::kBodyInSpace),
    gene_field(plain("joint", "joint", "The joint to the parent; of no effect on the root."),
               &NodeGene::joint),
    gene_field(kLowLimit, &NodeGene::limit_low),
    gene_field(kHighLimit, &NodeGene::limit_high),
    gene_field(number("recursion limit", "recursionLimit", 1, kMaxRecursion, 1, {}, {}, "",
                      "The number of times that the part may repeat along a limb."),
               &NodeGene::recursion_limit),
    gene_field(plain("symmetric", "symmetric",
                     "Two connections from one parent become a mirror pair if this is true."),
               &NodeGene::symmetric),
    gene_field(plain("mirror axis", "mirrorAxis",
                     "The axis of the parent about which the pair is mirrored."),
               &NodeGene::mirror_axis),
    gene_field(plain("effector kind", "kind", "The kind of the effector."),
               &NodeGene::effector_kind, FieldUse::kControl, true),
    gene_field(kEffector, &NodeGene::effector, FieldUse::kControl),
    gene_field(plain("degree", "further",
                     "The joint's further degrees of freedom, which only joints in space have."),
               &NodeGene::further, FieldUse::kBodyInSpace),
    gene_field(plain("organ", "organs", "The organs of the part; they exist since version 3."),
               &NodeGene::organs, FieldUse::kControl),
    gene_field(plain("neuron", "neurons", "The neurons of the part."), &NodeGene::neurons,
               FieldUse::kControl),
    gene_field(plain("edge", "edges", "The connections to parts that grow from this one."),
               &NodeGene::edges)};

template <>
inline constexpr std::tuple kFields<Genome>{
    gene_field(plain("nodes", "nodes", "The part genes; the first is the root."), &Genome::nodes),
    gene_field(plain("brain", "brain", "The central neurons."), &Genome::brain, FieldUse::kControl),
    gene_field(circle("root angle", "rootAngle", -kPi, kPi, {0.3, 0.3}, kTurnDraw, "rad",
                      "The angle of the first part at birth."),
               &Genome::root_angle),
    gene_field(plain("reproduction", "reproduction",
                     "The breeding method of its offspring, if the experiment leaves this to "
                     "creatures."),
               &Genome::reproduction, FieldUse::kControl),
    gene_field(number("root tilt", "rootTilt", -0.5 * kPi, 0.5 * kPi, 0.0, {0.3, 0.3},
                      {.low = -0.5 * kPi, .high = 0.5 * kPi, .fallback_share = 0.5}, "rad",
                      "The tilt of the first part at birth."),
               &Genome::root_tilt, FieldUse::kBodyInSpace),
    gene_field(circle("root roll", "rootRoll", -kPi, kPi, {0.3, 0.3}, kTurnDraw, "rad",
                      "The turn of the first part about its long axis at birth."),
               &Genome::root_roll, FieldUse::kBodyInSpace)};

}  // namespace gene_tables

// Calls `visit` with each GeneField of a gene.
template <class Gene, class Visit>
void visit_fields(Visit visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, gene_tables::kFields<Gene>);
}

// Returns those of a gene's fields that are real numbers, those of the plane first.
std::span<const GeneField<NodeGene>> node_fields(int dimensions);
std::span<const GeneField<EdgeGene>> edge_fields(int dimensions);
std::span<const GeneField<InputGene>> input_fields();              // the weight
std::span<const GeneField<Genome>> genome_fields(int dimensions);  // the root's angles
std::span<const GeneField<DegreeGene>> degree_fields();            // of space only

}  // namespace cambrian
