#include "evolution/setting_field.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <cmath>
#include <limits>
#include <set>

using namespace cambrian;
using test::kinds;

TEST_CASE("default settings are valid", "[evolution][settings]") {
    CHECK(check_settings(ExperimentSettings{}, kinds()).has_value());
}

TEST_CASE("every field has a unique name, a label and a sentence of help",
          "[evolution][settings]") {
    std::set<std::string> names;
    for (const SettingField& field : setting_fields(kinds())) {
        CHECK(names.insert(field.table + "." + field.key).second);
        CHECK_FALSE(field.label.empty());
        CHECK(field.help.size() > 10);
        CHECK(field.help.back() == '.');
    }
    CHECK(names.size() > 40);
}

TEST_CASE("a number outside its range is an error that names it", "[evolution][settings]") {
    for (const SettingField& field : setting_fields(kinds())) {
        ExperimentSettings settings;
        const SettingRef ref = field.at(settings);
        if (auto* const* real = std::get_if<double*>(&ref)) {
            for (const double bad :
                 {field.high * 2 + 1, field.low - 1.0, std::numeric_limits<double>::quiet_NaN(),
                  std::numeric_limits<double>::infinity()}) {
                **real = bad;
                const Status status = check_settings(settings, kinds());
                REQUIRE_FALSE(status);
                CHECK(status.error().message.find(field.key) != std::string::npos);
            }
        } else if (auto* const* whole = std::get_if<int*>(&ref)) {
            **whole = static_cast<int>(field.low) - 1;
            CHECK_FALSE(check_settings(settings, kinds()));
        } else if (auto* const* text = std::get_if<std::string*>(&ref)) {
            **text = "no-such-thing";
            const Status status = check_settings(settings, kinds());
            REQUIRE_FALSE(status);
            CHECK(status.error().message.find("no-such-thing") != std::string::npos);
        }
    }
}

TEST_CASE("crossed limits and shares that are all zero are errors", "[evolution][settings]") {
    ExperimentSettings crossed;
    crossed.founders.min_nodes = 6;
    CHECK(check_settings(crossed, kinds()).error().message.find("min-nodes") != std::string::npos);
    ExperimentSettings shareless;
    for (const BreedingKind& kind : kinds().breeding.all())
        shareless.breeding.shares[kind.id] = 0;
    CHECK(check_settings(shareless, kinds()).error().message.find("[breeding]") !=
          std::string::npos);
    ExperimentSettings weightless;
    for (const MutationKind& kind : kinds().mutations.all()) {
        weightless.mutation.weights[kind.id] = 0;
    }
    CHECK_FALSE(check_settings(weightless, kinds()));
}
