#include "studio/panels/machines/machines_panel.h"

#include "machines/scripted_cluster.h"
#include "panel_press.h"
#include "studio/panels/bar/machines_line.h"

namespace cambrian {
namespace {

using test::PanelRun;

// Clicks a field and types text into it.
template <class Run>
void type_into(Run& run, const std::string& field, const std::string& text) {
    run.click(field);
    for (const char letter : text)
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
    run.frame();
    run.frame();
}

TEST_CASE("a person types a server and connects", "[studio][machines]") {
    PanelRun<MachinesPanel> run(860, 600);
    CHECK(run.click("Connect").all().empty());  // no server is named
    type_into(run, "Server", "nats://lab-server");
    type_into(run, "Credentials file", "my keys.creds");
    const auto login = test::asked<JoinCluster>(run.click("Connect")).login;
    CHECK(login == ClusterLogin{"nats://lab-server", "", "my keys.creds", ""});
    CHECK(run.click("Work alone").all().empty());  // it does already
}

TEST_CASE("the fields begin with the last login and keep what is typed into them",
          "[studio][machines]") {
    PanelRun<MachinesPanel> run(860, 600);
    run.studio.machines().login = {"nats://lab-server", "second", "", ""};
    run.frame();
    type_into(run, "Cluster name", "x");
    CHECK(test::asked<JoinCluster>(run.click("Connect")).login.name == "secondx");
    run.studio.machines().login.servers = "nats://other";  // chosen elsewhere meanwhile
    run.frame();
    CHECK(test::asked<JoinCluster>(run.click("Connect")).login ==
          ClusterLogin{"nats://other", "second", "", ""});
}

TEST_CASE("a joined cluster can be left, and only one attempt to join runs at a time",
          "[studio][machines]") {
    PanelRun<MachinesPanel> run(860, 600);
    run.studio.machines().login.servers = "nats://lab-server";
    run.studio.machines().joining = true;
    run.frame();
    CHECK(run.click("Connect").all().empty());
    CHECK(test::was_asked<LeaveCluster>(run.click("Work alone")));
    CHECK(test::was_asked<ToggleMachines>(run.click("Close machines")));
}

TEST_CASE("the table has a row for each machine, as far as they fit", "[studio][machines]") {
    PanelRun<MachinesPanel> run(860, 600);
    run.studio.machines().joined = true;
    run.studio.machines().status = test::connected(7);
    run.frame();
    run.frame();
    for (int i = 0; i < 7; ++i)
        CHECK(run.gui.has("machine lab-" + std::to_string(i)));
    run.studio.machines().status = test::connected(1000);
    run.frame();
    run.frame();
    CHECK_FALSE(run.gui.has("machine lab-999"));
}

TEST_CASE("a click on the line of machines opens their card", "[studio][machines]") {
    PanelRun<MachinesLine> run(1280, 28);
    run.studio.machines().joined = true;
    run.studio.machines().status = test::connected(2);
    run.frame();
    CHECK(test::was_asked<ToggleMachines>(run.click("machines line")));
}

}  // namespace
}  // namespace cambrian
