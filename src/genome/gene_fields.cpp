#include "genome/gene_fields.h"

#include "math/elementary.h"

#include <array>

namespace cambrian {
namespace {

using namespace gene_range;

double log_uniform(double low, double high, RandomStream& stream) {
    return low * power(high / low, stream.uniform());
}

// Founders' distributions are those of genome/README.md 4.
double draw_length(const FounderSettings& settings, RandomStream& stream) {
    return log_uniform(settings.min_length, settings.max_length, stream);
}
double draw_width(const FounderSettings& settings, RandomStream& stream) {
    return log_uniform(settings.min_width, settings.max_width, stream);
}
double draw_limit_high(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.uniform(0.2, 1.8);
}
double draw_limit_low(const FounderSettings& settings, RandomStream& stream) {
    return -draw_limit_high(settings, stream);
}
double draw_position(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.uniform();
}
double draw_edge_angle(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.uniform(-1.2, 1.2);
}
double draw_scale(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.chance(0.5) ? 1.0 : stream.uniform(0.6, 1.2);
}
double draw_weight(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.uniform(-2.0, 2.0);
}
double draw_height(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.chance(0.4) ? 0.0 : stream.uniform(-1.0, 1.0);
}
double draw_roll(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.chance(0.5) ? 0.0 : stream.uniform(-kPi, kPi);
}
double draw_root_tilt(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.chance(0.5) ? 0.0 : stream.uniform(-0.5 * kPi, 0.5 * kPi);
}
double draw_root_angle(const FounderSettings& /*settings*/, RandomStream& stream) {
    return stream.chance(0.5) ? 0.0 : stream.uniform(-kPi, kPi);
}

// Of any degree of freedom.
constexpr FieldRule kLowLimit = {"low limit", "limits/0",  -kMaxLimit,     -kMinLimit, -1.0,
                                 false,       {0.25, 0.2}, draw_limit_low, "rad"};
constexpr FieldRule kHighLimit = {"high limit", "limits/1",  kMinLimit,       kMaxLimit, 1.0,
                                  false,        {0.25, 0.2}, draw_limit_high, "rad"};

constexpr std::size_t kPlanarNodeFields = 4;
constexpr std::array<GeneField<NodeGene>, 5> kNodeFields = {{
    {{"length", "length", kMinSize, kMaxLength, 0.5, false, {0.20, 0.1}, draw_length, "m"},
     &NodeGene::length},
    {{"width", "width", kMinSize, kMaxWidth, 0.2, false, {0.20, 0.1}, draw_width, "m"},
     &NodeGene::width},
    {kLowLimit, &NodeGene::limit_low},
    {kHighLimit, &NodeGene::limit_high},
    {{"depth", "depth", kMinSize, kMaxWidth, 0.2, false, {0.20, 0.1}, draw_width, "m"},
     &NodeGene::depth},
}};

constexpr std::array<GeneField<DegreeGene>, 2> kDegreeFields = {{
    {kLowLimit, &DegreeGene::limit_low},
    {kHighLimit, &DegreeGene::limit_high},
}};

// Steps of a position are absolute: 0.06 of the outline or, in one case of five, 0.25.
constexpr GeneStep kPositionStep = {0.06, 1.0, 0.25 / 0.06, 0.2};

// Those of a height: 0.12 or, in one case of five, 0.5.
constexpr GeneStep kHeightStep = {0.12, 1.0, 0.5 / 0.12, 0.2};

constexpr std::size_t kPlanarEdgeFields = 3;
constexpr std::array<GeneField<EdgeGene>, 6> kEdgeFields = {{
    {{"position", "pos", 0.0, 1.0, 0.0, true, kPositionStep, draw_position}, &EdgeGene::position},
    {{"angle",
      "angle",
      -kMaxEdgeAngle,
      kMaxEdgeAngle,
      0.0,
      false,
      {0.25, 0.3},
      draw_edge_angle,
      "rad"},
     &EdgeGene::angle},
    {{"scale", "scale", kMinScale, kMaxScale, 1.0, false, {0.15, 0.3}, draw_scale},
     &EdgeGene::scale},
    {{"height", "height", -1.0, 1.0, 0.0, false, kHeightStep, draw_height}, &EdgeGene::height},
    {{"tilt",
      "tilt",
      -kMaxEdgeAngle,
      kMaxEdgeAngle,
      0.0,
      false,
      {0.25, 0.3},
      draw_edge_angle,
      "rad"},
     &EdgeGene::tilt},
    {{"roll", "roll", -kPi, kPi, 0.0, true, {0.25, 0.5}, draw_roll, "rad"}, &EdgeGene::roll},
}};

constexpr std::array<GeneField<InputGene>, 1> kInputFields = {{
    {{"weight", "w", -kMaxWeight, kMaxWeight, 1.0, false, {0.3, 0.2}, draw_weight},
     &InputGene::weight},
}};

constexpr std::size_t kPlanarGenomeFields = 1;
constexpr std::array<GeneField<Genome>, 3> kGenomeFields = {{
    {{"root angle", "rootAngle", -kPi, kPi, 0.0, true, {0.3, 0.3}, draw_root_angle, "rad"},
     &Genome::root_angle},
    {{"root tilt",
      "rootTilt",
      -0.5 * kPi,
      0.5 * kPi,
      0.0,
      false,
      {0.3, 0.3},
      draw_root_tilt,
      "rad"},
     &Genome::root_tilt},
    {{"root roll", "rootRoll", -kPi, kPi, 0.0, true, {0.3, 0.3}, draw_roll, "rad"},
     &Genome::root_roll},
}};

template <class Gene, std::size_t kCount>
std::span<const GeneField<Gene>> fields_of(const std::array<GeneField<Gene>, kCount>& fields,
                                           std::size_t planar, int dimensions) {
    return std::span(fields).first(dimensions == 3 ? kCount : planar);
}

}  // namespace

std::span<const GeneField<NodeGene>> node_fields(int dimensions) {
    return fields_of(kNodeFields, kPlanarNodeFields, dimensions);
}
std::span<const GeneField<EdgeGene>> edge_fields(int dimensions) {
    return fields_of(kEdgeFields, kPlanarEdgeFields, dimensions);
}
std::span<const GeneField<InputGene>> input_fields() {
    return kInputFields;
}
std::span<const GeneField<Genome>> genome_fields(int dimensions) {
    return fields_of(kGenomeFields, kPlanarGenomeFields, dimensions);
}
std::span<const GeneField<DegreeGene>> degree_fields() {
    return kDegreeFields;
}

}  // namespace cambrian
