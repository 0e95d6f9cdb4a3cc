// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/plan_page.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <sstream>

#include "quoin/base/error.h"

namespace quoin {
namespace {

constexpr std::string_view bare_template = "<title>@@QUOIN_TITLE@@</title><!--@@QUOIN_SCENE@@--></html>";

PlanPicture two_parts() {
  PlanPicture plan;
  plan.title = "A </script> title";
  plan.facts = {{"Parts", "2"}};
  plan.parts = {{"a", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}}, {{0, 1}}}, {"</script>", {}, {}, {}}};
  plan.graphs = {{{{0, 1}}, {{1}}}};
  plan.states = {{{0, 1}, {{{1}, {0, 0, 1}, "(0, 0, 1)", 0}}}};
  plan.steps = {{0, 0}};
  return plan;
}

std::string page_of(const PlanPicture& plan) {
  std::ostringstream out;
  write_plan_page(out, plan, bare_template);
  return out.str();
}

TEST(PlanPage, HoldsThePlan) {
  const std::string page = page_of(two_parts());
  for (const char* part :
       {"\"format\":\"quoin-plan\"", "\"vertices\":[0,0,0,1,0,0,0,1,0.5]", "\"triangles\":[0,1,2]", "\"edges\":[0,1]",
        "\"moving\":[1]", "\"direction\":[0,0,1]", "\"exact\":\"(0, 0, 1)\"", "\"moved\":null", "\"steps\":[[0,0]]",
        "\"arcs\":[[0,1]]", "\"movable\":[[1]]", "\"sought\":true", "id=\"quoin-sphere\"", "id=\"quoin-map\""}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("</script> title"), std::string::npos);
  EXPECT_EQ(page, page_of(two_parts()));
  EXPECT_NE(page_of({}).find("\"parts\":[]"), std::string::npos);
}

TEST(PlanPage, RefusesWhatIsOutOfRange) {
  const std::vector<std::function<void(PlanPicture&)>> faults{
      [](PlanPicture& p) { p.parts[0].vertices[0].x = std::numeric_limits<double>::infinity(); },
      [](PlanPicture& p) { p.parts[0].triangles[0][2] = 3; },
      [](PlanPicture& p) {
        p.parts[1].edges.push_back({0, 0});
      },
      [](PlanPicture& p) { p.states[0].parts.push_back(2); },
      [](PlanPicture& p) { p.states[0].moves[0].moving[0] = 2; },
      [](PlanPicture& p) { p.states[0].moves[0].graph = 1; },
      [](PlanPicture& p) { p.states[0].moves[0].rest_state = 1; },
      [](PlanPicture& p) { p.steps[0][0] = 1; },
      [](PlanPicture& p) { p.steps[0][1] = 1; },
      [](PlanPicture& p) { p.interlocked = {1}; },
      [](PlanPicture& p) { p.graphs[0].arcs[0][0] = 2; },
      [](PlanPicture& p) { p.graphs[0].movable[0][0] = 2; },
      [](PlanPicture& p) { p.face_graphs = {0}; },
      [](PlanPicture& p) {
        p.sphere.points.push_back({{0, 0, 1}});
      },
      [](PlanPicture& p) {
        p.sphere.points.push_back({{0, 0, 1}});
        p.point_graphs = {1};
      }};
  for (std::size_t k = 0; k < faults.size(); ++k) {
    PlanPicture plan = two_parts();
    faults[k](plan);
    EXPECT_THROW(page_of(plan), InputError) << "fault " << k;
  }
}

}  // namespace
}  // namespace quoin
