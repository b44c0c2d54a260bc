// cambrian_bench_robustness: simulates many random creatures with violent motors or at a fixed
// pose. It reports how many simulations fail, their cost and the verdicts of their energy audits.

#include "bench/write_table.h"
#include "core/assert.h"
#include "core/threads/thread_pool.h"
#include "math/elementary.h"
#include "planar/integrators/builtin_integrators.h"
#include "planar/planar_scene.h"
#include "simulator/audit.h"
#include "spatial/bodies.h"
#include "support/body_plans.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <vector>

namespace cambrian::bench {
namespace {

constexpr int kLeastBodies = 3;
constexpr int kMostBodies = 32;
constexpr int kMostDeforming = 16;
constexpr double kLinearShare = 0.2;
constexpr double kGentlest = 20.0;           // N, least motor strength
constexpr double kMostViolent = 100.0;       // N, greatest motor strength
constexpr double kSlowest = 2.0;             // Hz, least frequency of the targets
constexpr double kFastest = 6.0;             // Hz, greatest frequency of the targets
constexpr double kPoseStrength = 20.0;       // N, motor strength while holding a pose
constexpr double kAtRest = 1e-3;             // m/s, speed below which a body is at rest
constexpr std::uint64_t kSwimEvery = 4;      // every so many creatures, one is in water
constexpr std::uint64_t kFloatEvery = 4;     // and in space another one floats
constexpr double kGentlestFlesh = 25e3;      // N/m^2, least strength of muscles in space
constexpr double kStrongestFlesh = 100e3;    // N/m^2, greatest
constexpr std::size_t kStragglersShown = 8;  // creatures listed per size that did not come to rest

struct Options {
    std::size_t creatures = 0;
    std::uint64_t first_seed = 0;
    double seconds = 10.0;
    std::size_t threads = ThreadPool::default_workers();
    std::string csv_path;
    bool pose = false;
    bool space = false;
    double deformable = 0.0;                   // share of the parts that deform
    std::vector<int> bodies = {3, 6, 12, 24};  // numbers of bodies for holding a pose
    double pose_seconds = 20.0;
    SceneSettings settings;
};

std::string row_text(const char* format, auto... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

// --- violent motion -------------------------------------------------------------------------

struct Challenge {
    BodyPlan plan;
    Environment environment;
    double strength = 0.0;   // N, in space N/m^2
    double frequency = 0.0;  // Hz
    std::string world;       // "walk", "swim" or "float"

    SceneKind scene_kind() const {
        return environment.dimensions == 3 ? spatial_scene_kind() : planar_scene_kind();
    }
};

void draw_surface(Environment& environment, RandomStream& random) {
    constexpr std::array kFrictions = {0.0, 0.4, 0.8, 1.2};
    constexpr std::array kElasticities = {0.0, 0.3, 0.6};
    environment.friction = kFrictions[random.below(kFrictions.size())];
    environment.elasticity = kElasticities[random.below(kElasticities.size())];
}

// Makes each part deformable with this probability while there is room: each takes the place of
// another body.
void deform_parts(BodyPlan& plan, double share, RandomStream& random) {
    int room = std::min(kMostDeforming, kMostBodies - static_cast<int>(plan.parts.size()));
    for (PlannedPart& part : plan.parts) {
        if (!(random.uniform() < share) || room == 0) continue;
        make_deformable(part, -0.5, 0.5);
        --room;
    }
}

Challenge challenge_of(std::uint64_t seed, double deformable) {
    RandomStream random(stream_seed({seed, 91}));
    Challenge challenge;
    const int bodies = random.between(kLeastBodies, kMostBodies);
    challenge.strength = random.uniform(kGentlest, kMostViolent);
    challenge.frequency = random.uniform(kSlowest, kFastest);
    challenge.plan = random_tree(random, bodies, kLinearShare, challenge.strength, 0.0);
    const bool swims = seed % kSwimEvery == 0;
    challenge.world = swims ? "swim" : "walk";
    if (swims) challenge.environment = open_water();
    draw_surface(challenge.environment, random);
    if (deformable > 0.0) deform_parts(challenge.plan, deformable, random);
    return challenge;
}

// Has joints of all kinds that space has, and parts that touch one another.
Challenge challenge_in_space(std::uint64_t seed) {
    RandomStream random(stream_seed({seed, 93}));
    Challenge challenge;
    const int bodies = random.between(kLeastBodies, kMostBodies);
    challenge.strength = random.uniform(kGentlestFlesh, kStrongestFlesh);
    challenge.frequency = random.uniform(kSlowest, kFastest);
    challenge.plan = random_solid(random, bodies, challenge.strength);
    const bool swims = seed % kSwimEvery == 0;
    const bool floats = seed % kFloatEvery == 1;
    challenge.world = swims ? "swim" : floats ? "float" : "walk";
    challenge.environment = swims    ? spatial_water()
                            : floats ? weightless()
                                     : spatial_ground(0.0, 0.0);
    draw_surface(challenge.environment, random);
    challenge.environment.self_contact = true;
    return challenge;
}

struct Outcome {
    SceneStatus status = SceneStatus::kRunning;
    double time = 0.0;  // s, time reached
    SceneAudit audit;
    bool finite = true;

    bool completed() const { return status == SceneStatus::kRunning; }
    AuditVerdict verdict() const {
        return completed() && finite ? judge(audit) : AuditVerdict::kInvalid;
    }
    double evaluation_rate() const {
        return static_cast<double>(audit.evaluations) / std::fmax(time, kTestTick);
    }
};

bool is_finite(const PhysicsScene& scene) {
    bool finite = std::isfinite(scene.audit().energy_residual) && std::isfinite(scene.energy());
    for (std::size_t part = 0; part < scene.part_count(); ++part)
        finite = finite && scene.part_pose(part).position.allFinite();
    return finite;
}

// Sets the targets of deforming parts: sines over all of their range, each with another phase.
void stretch_and_shorten(PhysicsScene& scene, const BodyPlan& plan, double frequency) {
    for (std::size_t i = 0; i < plan.parts.size(); ++i) {
        if (!plan.parts[i].stretch) continue;
        const double phase = 2.0 * kPi * frequency * scene.time() + static_cast<double>(i);
        scene.set_stretch_target(i, plan.parts[i].stretch->high * sine(phase));
    }
}

Outcome run_violently(const Challenge& challenge, const SceneSettings& settings, double seconds) {
    const auto scene = challenge.scene_kind().make(challenge.plan, challenge.environment, settings);
    CAMBRIAN_ASSERT(scene.has_value(), "random trees are valid");
    PhysicsScene& body = **scene;
    if (challenge.environment.has_ground) stand_on_ground(body);
    while (body.status() == SceneStatus::kRunning && body.time() < seconds) {
        if (challenge.environment.dimensions == 3) {
            swing(body, challenge.plan, challenge.frequency);
        } else {
            flail(body, challenge.plan, challenge.frequency);
        }
        stretch_and_shorten(body, challenge.plan, challenge.frequency);
        body.advance(kTestTick);
    }
    return {body.status(), body.time(), body.audit(), is_finite(body)};
}

struct Trial {
    Challenge challenge;
    Outcome outcome;
    std::optional<Outcome> finer;  // outcome with finer steps, for suspect trials

    AuditVerdict final_verdict() const { return (finer ? *finer : outcome).verdict(); }
};

Trial run_trial(std::uint64_t seed, const Options& options) {
    Trial trial{
        options.space ? challenge_in_space(seed) : challenge_of(seed, options.deformable), {}, {}};
    const auto run = [&](const SceneSettings& settings) {
        return run_violently(trial.challenge, settings, options.seconds);
    };
    trial.outcome = run(options.settings);
    if (trial.outcome.verdict() == AuditVerdict::kSuspect)
        trial.finer = run(finer_settings(options.settings, trial.challenge.scene_kind()));
    return trial;
}

std::string csv_row(std::uint64_t seed, const Trial& trial) {
    const Challenge& challenge = trial.challenge;
    const SceneAudit& audit = trial.outcome.audit;
    const std::string finer =
        trial.finer ? std::string(verdict_name(trial.finer->verdict())) : std::string();
    return row_text("%llu,%s,%zu,%g,%g,%.4g,%.4g,%d,%.4g,%.5g,%llu,%llu,%llu,%llu,",
                    static_cast<unsigned long long>(seed), challenge.world.c_str(),
                    challenge.plan.parts.size(), challenge.environment.friction,
                    challenge.environment.elasticity, challenge.strength, challenge.frequency,
                    static_cast<int>(trial.outcome.status), trial.outcome.time,
                    trial.outcome.evaluation_rate(), static_cast<unsigned long long>(audit.steps),
                    static_cast<unsigned long long>(audit.rejections),
                    static_cast<unsigned long long>(audit.events),
                    static_cast<unsigned long long>(audit.fallbacks)) +
           row_text("%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%s,%s\n", audit.max_penetration,
                    audit.max_limit_overrun, audit.max_part_speed,
                    audit.energy_residual / audit.energy_scale,
                    audit.positive_work / audit.energy_scale, audit.energy_scale,
                    std::string(verdict_name(trial.outcome.verdict())).c_str(), finer.c_str());
}

constexpr const char* kCsvHeader =
    "seed,world,bodies,friction,elasticity,strength,frequency,status,seconds,evaluations_per_s,"
    "steps,rejections,events,fallbacks,penetration_m,limit_overrun,part_speed,residual_share,"
    "positive_share,energy_scale_J,verdict,finer_verdict\n";

double worst_of(const std::vector<const Trial*>& trials, auto value_of) {
    double worst = 0.0;
    for (const Trial* trial : trials)
        worst = std::fmax(worst, value_of(*trial));
    return worst;
}

double median_of(const std::vector<const Trial*>& trials, auto value_of) {
    std::vector<double> values;
    for (const Trial* trial : trials)
        values.push_back(value_of(*trial));
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double mean_of(const std::vector<const Trial*>& trials, auto value_of) {
    double sum = 0.0;
    for (const Trial* trial : trials)
        sum += value_of(*trial);
    return sum / static_cast<double>(trials.size());
}

double percent_of(const std::vector<const Trial*>& trials, auto is_so) {
    return 100.0 * mean_of(trials, [&](const Trial& trial) { return is_so(trial) ? 1.0 : 0.0; });
}

void print_summary(const char* name, const std::vector<const Trial*>& trials) {
    if (trials.empty()) return;
    const auto count = [&](auto is_so) {
        return static_cast<int>(std::count_if(trials.begin(), trials.end(),
                                              [&](const Trial* trial) { return is_so(*trial); }));
    };
    const auto rate = [](const Trial& trial) { return trial.outcome.evaluation_rate(); };
    const auto audited = [](auto member) {
        return [member](const Trial& trial) {
            return static_cast<double>(trial.outcome.audit.*member);
        };
    };
    const auto overrun = audited(&SceneAudit::max_limit_overrun);
    std::printf(
        "%-11s %5zu | %3d %3d %3d | %5.0f %6.0f | %5.1f %4.0f | %5.2f %5.2f | %6.2f | "
        "%6.4f %6.4f | %6.1f | %5.2f %5.2f\n",
        name, trials.size(),
        count([](const Trial& t) { return t.outcome.status == SceneStatus::kInvalid; }),
        count([](const Trial& t) { return t.outcome.status == SceneStatus::kOverBudget; }),
        count([](const Trial& t) { return !t.outcome.finite; }), mean_of(trials, rate),
        worst_of(trials, rate), mean_of(trials, audited(&SceneAudit::events)),
        worst_of(trials, audited(&SceneAudit::events)),
        mean_of(trials, audited(&SceneAudit::fallbacks)) /
            std::fmax(1.0, mean_of(trials, audited(&SceneAudit::steps))) * 100.0,
        worst_of(trials, audited(&SceneAudit::fallbacks)) * 1e-3,
        100.0 * worst_of(trials, audited(&SceneAudit::max_penetration)), worst_of(trials, overrun),
        median_of(trials, overrun), worst_of(trials, audited(&SceneAudit::max_part_speed)),
        percent_of(trials,
                   [](const Trial& t) { return t.outcome.verdict() == AuditVerdict::kSuspect; }),
        percent_of(trials,
                   [](const Trial& t) { return t.final_verdict() != AuditVerdict::kClean; }));
}

void print_worst(const std::vector<Trial>& trials, std::uint64_t first_seed, const char* what,
                 auto value_of) {
    std::vector<std::size_t> order(trials.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    const std::size_t shown = std::min<std::size_t>(5, order.size());
    std::partial_sort(
        order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
        [&](std::size_t a, std::size_t b) { return value_of(trials[a]) > value_of(trials[b]); });
    std::printf("worst %s:", what);
    for (std::size_t i = 0; i < shown; ++i)
        std::printf("  %.4g (seed %llu)", value_of(trials[order[i]]),
                    static_cast<unsigned long long>(first_seed + order[i]));
    std::printf("\n");
}

void print_table(const std::vector<Trial>& trials, std::uint64_t first_seed) {
    std::printf(
        "                  |  ended early | evaluations/s |  impacts   |  fallbacks  |"
        " depth  | limit overrun |  speed | suspect %%\n"
        "set         runs | inv bud nan |  mean    max  |  mean  max | %%step  1e3  |"
        "   cm   |  worst median |   m/s  | first finer\n");
    const std::array kSizes = {3, 7, 13, 25, 33};
    std::vector<const Trial*> all;
    for (const Trial& trial : trials)
        all.push_back(&trial);
    for (const std::string world : {"walk", "swim", "float"}) {
        for (std::size_t i = 0; i + 1 < kSizes.size(); ++i) {
            std::vector<const Trial*> chosen;
            for (const Trial& trial : trials) {
                const int bodies = static_cast<int>(trial.challenge.plan.parts.size());
                if (trial.challenge.world == world && bodies >= kSizes[i] && bodies < kSizes[i + 1])
                    chosen.push_back(&trial);
            }
            const std::string name =
                row_text("%s %d-%d", world.c_str(), kSizes[i], kSizes[i + 1] - 1);
            print_summary(name.c_str(), chosen);
        }
    }
    print_summary("all", all);
    print_worst(trials, first_seed, "evaluations/s",
                [](const Trial& t) { return t.outcome.evaluation_rate(); });
    print_worst(trials, first_seed, "penetration, m",
                [](const Trial& t) { return t.outcome.audit.max_penetration; });
    print_worst(trials, first_seed, "limit overrun, rad or m",
                [](const Trial& t) { return t.outcome.audit.max_limit_overrun; });
    print_worst(trials, first_seed, "part speed, m/s",
                [](const Trial& t) { return t.outcome.audit.max_part_speed; });
}

std::string survey_violence(const Options& options) {
    const std::size_t creatures = options.creatures > 0 ? options.creatures : 10000;
    std::vector<Trial> trials(creatures);
    ThreadPool(options.threads).parallel_for(creatures, [&](std::size_t i, std::size_t) {
        trials[i] = run_trial(options.first_seed + i, options);
    });
    std::string csv = kCsvHeader;
    for (std::size_t i = 0; i < creatures; ++i)
        csv += csv_row(options.first_seed + i, trials[i]);
    print_table(trials, options.first_seed);
    return csv;
}

// --- holding a pose ---------------------------------------------------------------------------

// The greatest motion in a window of time.
struct Stir {
    double speed = 0.0;  // m/s, of the fastest part
    std::size_t part = 0;
    double spin = 0.0;           // rad/s, of that part
    double center_speed = 0.0;   // m/s, of the creature
    double fastest_joint = 0.0;  // rad/s or m/s
    std::size_t joint_part = 0;  // the part with that joint
    std::uint64_t impacts = 0;   // in the window
    std::size_t contact_count = 0;
};

struct Rest {
    bool completed = true;
    Stir early, late;  // second 10, and the last 5 s
};

void note_stir(const PhysicsScene& scene, Stir& stir) {
    for (std::size_t part = 0; part < scene.part_count(); ++part) {
        const Twist twist = scene.part_twist(part);
        if (twist.linear.norm() <= stir.speed) continue;
        stir.speed = twist.linear.norm();
        stir.part = part;
        stir.spin = twist.angular.z();
        stir.center_speed = scene.center_of_mass_velocity().norm();
        stir.fastest_joint = 0.0;
        for (std::size_t joint = 1; joint < scene.part_count(); ++joint) {
            const double rate = std::fabs(scene.joint_rate(joint));
            if (rate <= stir.fastest_joint) continue;
            stir.fastest_joint = rate;
            stir.joint_part = joint;
        }
        std::vector<SceneContact> contacts;
        scene.list_contacts(contacts);
        stir.contact_count = contacts.size();
    }
}

Stir watch(PhysicsScene& scene, double from, double to) {
    run(scene, from - scene.time());
    Stir stir;
    const std::uint64_t impacts = scene.audit().events;
    while (scene.time() < to - 0.5 * kTestTick && run(scene, kTestTick))
        note_stir(scene, stir);
    stir.impacts = scene.audit().events - impacts;
    return stir;
}

// Drops a body from 2 cm and holds a pose within the middle half of every joint's range.
Rest hold_pose(std::uint64_t seed, int bodies, const Options& options) {
    RandomStream random(stream_seed({seed, static_cast<std::uint64_t>(bodies), 92}));
    const BodyPlan plan = random_tree(random, bodies, 0.0, kPoseStrength, 0.0);
    const auto scene = planar_scene_kind().make(plan, {}, options.settings);
    CAMBRIAN_ASSERT(scene.has_value(), "random trees are valid");
    Rest rest;
    PhysicsScene& body = **scene;
    stand_on_ground(body);
    for (std::size_t part = 1; part < plan.parts.size(); ++part)
        body.set_target(part, random.uniform(-0.5, 0.5) * plan.parts[part].limit_high);
    rest.early = watch(body, 9.0, 10.0);
    rest.late = watch(body, options.pose_seconds - 5.0, options.pose_seconds);
    rest.completed = body.status() == SceneStatus::kRunning;
    return rest;
}

std::string stir_cells(const Stir& stir) {
    return row_text(",%.4g,%zu,%.4g,%.4g,%.4g,%zu,%llu,%zu", stir.speed, stir.part, stir.spin,
                    stir.center_speed, stir.fastest_joint, stir.joint_part,
                    static_cast<unsigned long long>(stir.impacts), stir.contact_count);
}

void print_stir(const char* window, const Stir& stir) {
    std::printf(
        "    %s: part %zu at %.3g m/s, turning %.3g rad/s; centre of mass %.3g m/s; joint of "
        "part %zu %.3g rad/s; %llu impacts; %zu contacts\n",
        window, stir.part, stir.speed, stir.spin, stir.center_speed, stir.joint_part,
        stir.fastest_joint, static_cast<unsigned long long>(stir.impacts), stir.contact_count);
}

void print_rests(int bodies, const std::vector<Rest>& rests, std::uint64_t first_seed) {
    const auto share_at_rest = [&](Stir Rest::*window) {
        const auto at_rest = std::count_if(rests.begin(), rests.end(), [&](const Rest& rest) {
            return rest.completed && (rest.*window).speed <= kAtRest;
        });
        return 100.0 * static_cast<double>(at_rest) / static_cast<double>(rests.size());
    };
    std::printf("%d bodies: below 1 mm/s in 9-10 s %.1f %%, in the last 5 s %.1f %%\n", bodies,
                share_at_rest(&Rest::early), share_at_rest(&Rest::late));
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < rests.size(); ++i) {
        const bool rested =
            rests[i].completed && rests[i].early.speed <= kAtRest && rests[i].late.speed <= kAtRest;
        if (!rested) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rests[a].late.speed > rests[b].late.speed;
    });
    for (std::size_t i = 0; i < std::min(order.size(), kStragglersShown); ++i) {
        std::printf("  seed %llu%s\n", static_cast<unsigned long long>(first_seed + order[i]),
                    rests[order[i]].completed ? "" : " ended early");
        print_stir("  9-10 s", rests[order[i]].early);
        print_stir("last 5 s", rests[order[i]].late);
    }
    if (order.size() > kStragglersShown)
        std::printf("  and %zu more\n", order.size() - kStragglersShown);
}

std::string survey_poses(const Options& options) {
    const std::size_t creatures = options.creatures > 0 ? options.creatures : 100;
    std::string csv = "seed,bodies,completed";
    for (const char* window : {"early", "late"}) {
        for (const char* column : {"speed", "part", "spin", "center_speed", "joint_rate",
                                   "joint_part", "impacts", "contacts"})
            csv += row_text(",%s_%s", window, column);
    }
    csv += '\n';
    ThreadPool pool(options.threads);
    for (const int bodies : options.bodies) {
        std::vector<Rest> rests(creatures);
        pool.parallel_for(creatures, [&](std::size_t i, std::size_t) {
            rests[i] = hold_pose(options.first_seed + i, bodies, options);
        });
        print_rests(bodies, rests, options.first_seed);
        for (std::size_t i = 0; i < creatures; ++i)
            csv += row_text("%llu,%d,%d", static_cast<unsigned long long>(options.first_seed + i),
                            bodies, rests[i].completed ? 1 : 0) +
                   stir_cells(rests[i].early) + stir_cells(rests[i].late) + "\n";
    }
    return csv;
}

int run_survey(const Options& options) {
    const std::string csv = options.pose ? survey_poses(options) : survey_violence(options);
    return write_table(options.csv_path, csv);
}

}  // namespace
}  // namespace cambrian::bench

int main(int argc, char** argv) try {
    cambrian::bench::Options options;
    CLI::App app(
        "Random creatures under violent motors, or holding a pose: failures, cost, honesty");
    app.add_flag("--pose", options.pose, "drop them and let them hold a pose for 20 s instead");
    app.add_flag("--space", options.space, "in three dimensions, without poses and deformation");
    app.add_option("--deformable", options.deformable, "share of the parts that deform")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("-n,--creatures", options.creatures,
                   "how many; 10000 by default, 100 of each size with --pose")
        ->check(CLI::PositiveNumber);
    app.add_option("--first-seed", options.first_seed, "seed of the first; the others follow");
    app.add_option("--seconds", options.seconds, "simulated time of each, s")
        ->check(CLI::PositiveNumber);
    app.add_option("--bodies", options.bodies, "sizes of creatures that hold a pose")
        ->check(CLI::Range(1, 32));
    app.add_option("--pose-seconds", options.pose_seconds, "how long they hold it, s")
        ->check(CLI::Range(15.0, 1e4));
    app.add_option("--integrator", options.settings.integrator)
        ->check(CLI::IsMember(cambrian::integrator_ids()));
    app.add_option("--tolerance", options.settings.tolerance)->check(CLI::PositiveNumber);
    app.add_option("--contact-step", options.settings.contact_step, "s")
        ->check(CLI::PositiveNumber);
    app.add_option("--threads", options.threads)->check(CLI::PositiveNumber);
    app.add_option("--csv", options.csv_path, "file to write a row a creature to");
    CLI11_PARSE(app, argc, argv);
    return cambrian::bench::run_survey(options);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
}
