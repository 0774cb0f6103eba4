#include <gtest/gtest.h>

#include "contact/response.h"
#include "core/parallel.h"
#include "scene.h"

namespace drape {
namespace {

using test::one_triangle;
using test::Random;
using test::Scene;

constexpr double thickness = 0.01;

std::vector<Contact> active(const Scene& scene) {
  std::vector<Contact> contacts;
  Proximity proximity = scene.proximity();
  find_active_pairs(scene.phase(), proximity, contacts);
  return contacts;
}

// Two free triangles of random masses that would pass through each other, while they slide.
Scene colliding(unsigned seed, double friction, const Vec3& slide = Vec3::Zero()) {
  Random random(seed);
  Scene scene;
  scene.add_cloth(one_triangle({-1, 0, -1}, {0, 0, 1}, {1, 0, -1}), thickness, friction);
  scene.add_cloth(one_triangle({0, 0.1, 0}, {0.1, 0.9, 0}, {-0.1, 0.9, 0.1}), thickness, friction);
  for (double& inverse_mass : scene.geometry.inverse_masses) inverse_mass = random.between(0.2, 5);
  for (int v = 3; v < 6; ++v) scene.end[v] += Vec3(0, -0.15, 0) + slide;
  return scene;
}

Scene crumpling(unsigned seed, double friction) {
  Random random(seed);
  Scene scene;
  scene.add_cloth(make_grid({0.5, 0.5}, {7, 7}), thickness, friction);
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    scene.geometry.inverse_masses[v] = random.between(0.2, 5);
    scene.start[v] += random.vector(0.05);
    scene.end[v] = scene.start[v] + random.vector(0.05);
  }
  return scene;
}

Vec3 momentum(const Scene& scene, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < x.size(); ++v)
    if (scene.geometry.inverse_masses[v] > 0) sum += x[v] / scene.geometry.inverse_masses[v];
  return sum;
}

// Of a Contact or its Pull.
double gap(const auto& contact, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 4; ++i) sum += contact.weights[i] * x[contact.vertices[i]];
  return contact.normal.template head<3>().dot(sum);
}

Vec3 sliding(const Pull& pull, const Scene& scene) {
  Vec3 way = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    way += pull.weights[i] * (scene.end[pull.vertices[i]] - scene.start[pull.vertices[i]]);
  const Vec3 normal = pull.normal.head<3>();
  return way - normal.dot(way) * normal;
}

std::vector<Pull> resolve(Scene& scene) { return test::resolve(scene, active(scene)); }

Response push(Scene& scene, const std::vector<Contact>& contacts) {
  Response response = begin_response(scene.geometry, contacts, {}, 1, scene.start);
  push_apart(response, scene.end);
  return response;
}

TEST(Response, LinearMomentumIsKept) {
  for (const double friction : {0.0, 0.5}) {
    for (unsigned seed = 1; seed < 5; ++seed)
      for (Scene scene : {colliding(seed, friction, {0.03, 0, 0.01}), crumpling(seed, friction)}) {
        const Vec3 before = momentum(scene, scene.end);
        const std::vector<Vec3> unresolved = scene.end;
        resolve(scene);
        ASSERT_NE(scene.end, unresolved);
        EXPECT_LT((momentum(scene, scene.end) - before).norm(), 1e-12);
      }
  }
}

TEST(Response, SidesEndAtTheirTarget) {
  for (unsigned seed = 1; seed < 10; ++seed) {
    Scene scene = colliding(seed, 0);
    const std::vector<Pull> pulls = resolve(scene);
    ASSERT_FALSE(pulls.empty());
    for (const Pull& pull : pulls) EXPECT_GE(gap(pull, scene.end), pull.target - 0.01 * thickness);
    EXPECT_NEAR(gap(pulls[0], scene.end), thickness, 0.02 * thickness);
  }
}

TEST(Response, ContactsNeverPullSidesTogether) {
  for (unsigned seed = 1; seed < 10; ++seed) {
    Scene scene = crumpling(seed, 0.3);
    for (const Pull& pull : resolve(scene)) EXPECT_GE(pull.impulse, 0);
  }
}

TEST(Response, SidesThatPartAnywayAreLeftAlone) {
  Scene scene = colliding(1, 0.5);
  const std::vector<Contact> contacts = active(scene);
  ASSERT_FALSE(contacts.empty());
  for (int v = 3; v < 6; ++v) scene.end[v] = scene.start[v] + Vec3(0.01, 1, 0);
  const std::vector<Vec3> before = scene.end;
  test::resolve(scene, contacts);
  EXPECT_EQ(scene.end, before);
}

TEST(Response, FrictionStaysInItsConeAndAcrossTheNormal) {
  int slipping = 0;
  for (unsigned seed = 1; seed < 10; ++seed) {
    Scene scene = crumpling(seed, 0.3);
    for (const Pull& pull : resolve(scene)) {
      const double length = pull.friction_impulse.norm();
      EXPECT_NEAR(pull.friction, 0.3, 1e-15);
      EXPECT_LE(length, 0.3 * pull.impulse + 1e-15);
      EXPECT_NEAR(pull.friction_impulse.dot(pull.normal), 0, 1e-14);
      slipping += length > 0.299 * pull.impulse && length > 0;
    }
  }
  EXPECT_GT(slipping, 10);
}

TEST(Response, SlidingStopsWhereFrictionIsLarge) {
  Scene scene = colliding(2, 100, {0.02, 0, 0});
  for (const Pull& pull : resolve(scene))
    if (pull.impulse > 0) {
      EXPECT_LT(sliding(pull, scene).norm(), 0.05 * 0.02);
    }
}

TEST(Response, FrictionBrakesAgainstTheSlidingAndNoMore) {
  for (const double friction : {0.0, 0.05, 0.1}) {
    Scene scene = colliding(3, friction, {0.05, 0, 0});
    std::vector<Contact> contacts = active(scene);
    ASSERT_FALSE(contacts.empty());
    contacts.erase(contacts.begin() + 1, contacts.end());
    const Pull pull = test::resolve(scene, test::exact(contacts)).at(0);
    double mobility = 0;
    for (int i = 0; i < 4; ++i)
      mobility += scene.geometry.inverse_masses[pull.vertices[i]] * pull.weights[i] * pull.weights[i];
    const double left = 0.05 - friction * pull.impulse * mobility;
    EXPECT_NEAR(sliding(pull, scene).x(), left, 1e-9);
    EXPECT_GT(left, 0.03);
  }
}

TEST(Response, PinnedVerticesAndCollidersStayAndTheOthersGiveWay) {
  Scene scene = colliding(4, 0.5, {0.02, 0, 0});
  for (int v = 0; v < 3; ++v) scene.geometry.inverse_masses[v] = 0;
  const std::vector<Pull> pulls = resolve(scene);
  ASSERT_FALSE(pulls.empty());
  for (int v = 0; v < 3; ++v) EXPECT_EQ(scene.end[v], scene.start[v]);
  EXPECT_NEAR(gap(pulls[0], scene.end), thickness, 0.02 * thickness);
}

TEST(Response, ThePushMovesOverlappingSidesAsFarAsTheirPushTarget) {
  Scene scene = colliding(5, 0);
  for (int v = 3; v < 6; ++v) scene.end[v] = scene.start[v] -= Vec3(0, 0.096, 0);  // 4 mm apart
  const std::vector<Contact> contacts = active(scene);
  ASSERT_FALSE(contacts.empty());
  const Vec3 before = momentum(scene, scene.end);
  test::resolve(scene, contacts);
  EXPECT_EQ(scene.end, scene.start);
  push(scene, contacts);
  EXPECT_NEAR(gap(contacts[0], scene.end), contacts[0].push_target, 1e-9);
  EXPECT_GT(contacts[0].push_target, 0.004);
  EXPECT_LT((momentum(scene, scene.end) - before).norm(), 1e-13);
}

Vec3 weighted_sum_of_masses(const Scene& scene, const std::vector<Vec3>& ways) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < ways.size(); ++v)
    if (scene.geometry.inverse_masses[v] > 0) sum += ways[v] / scene.geometry.inverse_masses[v];
  return sum;
}

// One contact, so that its push is all that parts the sides, which are 4 mm apart.
struct Overlap {
  Scene scene = colliding(5, 0);
  std::vector<Contact> contacts;

  Overlap() {
    for (int v = 3; v < 6; ++v) scene.end[v] = scene.start[v] -= Vec3(0, 0.096, 0);
    contacts = {active(scene).at(0)};
  }

  // From the start, with the push's sides parted by a share of its way.
  std::vector<Vec3> reached(double share) const {
    std::vector<Vec3> x = scene.start;
    for (std::size_t v = 0; v < x.size(); ++v) x[v] += share * (scene.end[v] - scene.start[v]);
    return x;
  }
};

TEST(Response, OfThePushThatMuchIsNoVelocityAsTheSidesHaveParted) {
  Overlap overlap;
  Scene& scene = overlap.scene;
  Response response = push(scene, overlap.contacts);
  ASSERT_GT(response.pulls.at(0).push_impulse, 0);
  const auto ways = [&](double share) { return take_pushes(7, response, overlap.reached(share)); };
  const std::vector<Vec3> all = ways(1), more = ways(2), half = ways(0.5), none = ways(0), back = ways(-1);
  for (std::size_t v = 0; v < all.size(); ++v) {
    EXPECT_LT((all[v] - (scene.end[v] - scene.start[v])).norm(), 1e-15);
    EXPECT_LT((more[v] - all[v]).norm(), 1e-15);
    EXPECT_LT((half[v] - 0.5 * all[v]).norm(), 1e-15);
    EXPECT_EQ(none[v], Vec3(Vec3::Zero()));
    EXPECT_EQ(back[v], Vec3(Vec3::Zero()));
  }
  EXPECT_LT(weighted_sum_of_masses(scene, half).norm(), 1e-15);
}

TEST(Response, APushInVainIsPaused) {
  Overlap overlap;
  const Response pushed = push(overlap.scene, overlap.contacts);
  const auto pause = [&](double share) {
    Response response = pushed;
    take_pushes(7, response, overlap.reached(share));
    return memories_of(response).at(0).paused_steps;
  };
  EXPECT_EQ(pause(1), 0);
  EXPECT_EQ(pause(0.5), 7);
  EXPECT_EQ(pause(-1), 7);
}

TEST(Response, WhatIsPausedIsPushedOnlyToATwentiethOfItsThickness) {
  Overlap overlap;
  const Contact& contact = overlap.contacts[0];
  const auto target = [&](std::int64_t paused_steps) {
    const std::vector<ContactMemory> memories = {{0, Vec3::Zero(), paused_steps}};
    return begin_response(overlap.scene.geometry, overlap.contacts, memories, 1, overlap.scene.start)
        .pulls[0]
        .push_target;
  };
  EXPECT_EQ(target(0), contact.push_target);
  EXPECT_EQ(target(1), contact.paused_push_target);
  ASSERT_LT(contact.paused_push_target, contact.push_target);
}

// Two triangles near each other, of which the lower one is near a plane; moved since they were resolved.
TEST(Response, OnlyWhatIsTooNearACollidersSurfaceIsKeptOff) {
  Scene scene;
  scene.add_cloth(one_triangle({-1, 0.009, -1}, {0, 0.009, 1}, {1, 0.009, -1}), thickness);
  scene.add_cloth(one_triangle({-1, 0.017, -1}, {0, 0.017, 1}, {1, 0.017, -1}), thickness);
  scene.add_plane();
  std::vector<Contact> contacts = active(scene);
  find_plane_contacts(scene.phase(), contacts);
  Response response = begin_response(scene.geometry, contacts, {}, 1, scene.start);
  resolve_contacts(response, scene.end);
  for (int v = 0; v < 3; ++v) scene.end[v].y() = 0.004;
  for (int v = 3; v < 6; ++v) scene.end[v].y() = 0.006;
  const std::vector<Vec3> before = scene.end;
  EXPECT_EQ(keep_firm_contacts(response, scene.end), (std::vector<char>{1, 1, 1, 0, 0, 0}));
  for (int v = 0; v < 3; ++v) EXPECT_NEAR(scene.end[v].y(), 0.009, 1e-9);
  for (int v = 3; v < 6; ++v) EXPECT_EQ(scene.end[v], before[v]);
}

// Two triangles over each other, pressed into each other since they were resolved; returns which vertices
// that moves.
std::vector<char> press(Scene& scene, double start_gap) {
  scene.add_cloth(one_triangle({-1, 0, -1}, {0, 0, 1}, {1, 0, -1}), thickness);
  scene.add_cloth(one_triangle({-1, start_gap, -1}, {0, start_gap, 1}, {1, start_gap, -1}), thickness);
  Response response = begin_response(scene.geometry, active(scene), {}, 1, scene.start);
  resolve_contacts(response, scene.end);
  for (int v = 3; v < 6; ++v) scene.end[v].y() = -0.002;
  return keep_firm_contacts(response, scene.end);
}

TEST(Response, ClothWithNoThicknessLeftIsKeptApartAndWithSomeMayGiveIt) {
  constexpr double start_gap = 0.04 * thickness;
  Scene firm, soft;
  EXPECT_EQ(press(firm, start_gap), std::vector<char>(6, 1));
  for (int v = 0; v < 3; ++v) {
    EXPECT_GT(firm.end[v + 3].y() - firm.end[v].y(), start_gap - 0.0011 * thickness);
    EXPECT_NEAR(firm.end[v + 3].y() + firm.end[v].y(), -0.002, 1e-12);
  }
  EXPECT_EQ(press(soft, 0.06 * thickness), std::vector<char>(6, 0));
}

// A stack on a plane that would sink by `way`, beside a thick cloth that has no say in it; returns by how
// much the worst contact misses its target.
double left_over(double way) {
  Scene scene;
  scene.add_cloth(one_triangle({-1, 100, -1}, {0, 100, 1}, {1, 100, -1}), 50 * thickness);
  for (int layer = 1; layer <= 3; ++layer)
    scene.add_cloth(
        one_triangle({-1, layer * thickness, -1}, {0, layer * thickness, 1}, {1, layer * thickness, -1}),
        thickness);
  scene.add_plane();
  for (Vec3& x : scene.end) x.y() -= way;
  std::vector<Contact> contacts = active(scene);
  find_plane_contacts(scene.phase(), contacts);
  double worst = 0;
  for (const Pull& pull : test::resolve(scene, contacts))
    worst = std::max(worst, pull.target - gap(pull, scene.end));
  return worst;
}

// A remainder that nobody sees where cloth moves would be most of what moves where it rests.
TEST(Response, WhereThingsRestLessIsLeftOver) {
  EXPECT_LT(left_over(0.003 * thickness), 0.0005 * thickness);
  EXPECT_LT(left_over(0.3 * thickness), 0.01 * thickness);
}

// Sweeps pass over what has not moved: nothing may be missed by that.
TEST(Response, AnotherRoundOverAllContactsFindsLittleToDo) {
  for (unsigned seed = 1; seed < 10; ++seed) {
    Scene scene = crumpling(seed, 0);
    const std::vector<Contact> contacts = active(scene);
    Response response = begin_response(scene.geometry, contacts, {}, 1, scene.start);
    const std::vector<Vec3> wanted = scene.end;
    resolve_contacts(response, scene.end);
    const std::vector<Vec3> once = scene.end;
    resolve_contacts(response, scene.end);
    double first = 0, second = 0;
    for (std::size_t v = 0; v < once.size(); ++v) {
      first = std::max(first, (once[v] - wanted[v]).norm());
      second = std::max(second, (scene.end[v] - once[v]).norm());
    }
    EXPECT_GT(first, thickness);
    EXPECT_LT(second, 0.01 * thickness);
  }
}

// One above the other on the y axis, the middle one is moved by what it has with the upper one.
TEST(Response, AContactIsVisitedAgainWhicheverOfItsVerticesWasMoved) {
  for (int place = 0; place < 4; ++place) {
    Scene scene;
    scene.add_cloth(one_triangle({0, 0, 0}, {0, thickness, 0}, {0, 2 * thickness, 0}), thickness);
    scene.end[2].y() -= 0.3 * thickness;
    const double side = place < 2 ? 1 : -1;
    Contact lower{}, upper{};
    lower.vertices = {0, 0, 0, 0};
    lower.vertices[place] = 1;
    lower.weights[place] = side;
    lower.weights[3 - place] = -side;
    lower.normal = {0, side, 0};
    lower.thickness = lower.target = thickness;
    upper = lower;
    upper.vertices = {2, 1, 1, 1};
    upper.weights = {1, -1, 0, 0};
    upper.normal = {0, 1, 0};
    test::resolve(scene, test::exact({lower, upper}));
    EXPECT_NEAR(scene.end[1].y() - scene.end[0].y(), thickness, 1e-9) << place;
    EXPECT_NEAR(scene.end[2].y() - scene.end[1].y(), thickness, 1e-9) << place;
  }
}

// What held a contact holds it again: nothing is left to do.
TEST(Response, AStepLikeTheOneBeforeNeedsNothingButItsImpulses) {
  for (const double friction : {0.0, 0.5}) {
    Scene scene = colliding(5, friction, {0.03, 0, 0.01});
    const std::vector<Contact> contacts = test::exact(active(scene));
    const std::vector<Vec3> wanted = scene.end;
    Response first = begin_response(scene.geometry, contacts, {}, 1, scene.start);
    resolve_contacts(first, scene.end);
    const std::vector<Vec3> resolved = scene.end;
    ASSERT_NE(resolved, wanted);
    Response again = begin_response(scene.geometry, contacts, memories_of(first), 1, scene.start);
    scene.end = wanted;
    hold_again(again, scene.end);
    resolve_contacts(again, scene.end);
    for (std::size_t i = 0; i < contacts.size(); ++i)
      EXPECT_NEAR(again.pulls[i].impulse, first.pulls[i].impulse, 1e-12);
    for (std::size_t v = 0; v < resolved.size(); ++v) EXPECT_LT((scene.end[v] - resolved[v]).norm(), 1e-12);
  }
}

TEST(Response, WhatCanNoLongerMoveForgetsWhatHeldIt) {
  Scene scene = colliding(5, 0.5, {0.03, 0, 0.01});
  const std::vector<Contact> contacts = test::exact(active(scene));
  Response held = begin_response(scene.geometry, contacts, {}, 1, scene.start);
  resolve_contacts(held, scene.end);
  ASSERT_GT(held.pulls[0].impulse, 0);
  for (double& inverse_mass : scene.geometry.inverse_masses) inverse_mass = 0;
  Response pinned = begin_response(scene.geometry, contacts, memories_of(held), 1, scene.start);
  hold_again(pinned, scene.end);
  resolve_contacts(pinned, scene.end);
  for (const ContactMemory& memory : memories_of(pinned)) EXPECT_EQ(memory.impulse, 0);
}

TEST(Response, ABlowIsNotAskedForAgain) {
  Scene scene = colliding(5, 0.5, {0.03, 0, 0.01});
  const std::vector<Contact> contacts = test::exact(active(scene));
  Response blow = begin_response(scene.geometry, contacts, {}, 1, scene.start);
  resolve_contacts(blow, scene.end);
  constexpr double farthest = 1e-5;
  const Response after = begin_response(scene.geometry, contacts, memories_of(blow), farthest, scene.start);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Pull &before = blow.pulls[i], &now = after.pulls[i];
    EXPECT_NEAR(now.impulse * now.mobility, std::min(farthest, before.impulse * before.mobility), 1e-15);
    EXPECT_LE(now.friction_impulse.norm(), now.friction * now.impulse * (1 + 1e-12));
  }
}

// Cloth that was pressed on and no longer is: what held it gives way, and draws nothing near.
TEST(Response, ImpulsesOfBeforeThatNothingNeedsAnyMoreAreTakenBack) {
  Scene scene = colliding(5, 0.5, {0.03, 0, 0.01});
  const std::vector<Contact> contacts = test::exact(active(scene));
  Response pressed = begin_response(scene.geometry, contacts, {}, 1, scene.start);
  resolve_contacts(pressed, scene.end);
  for (std::size_t v = 0; v < scene.end.size(); ++v) scene.end[v] = scene.start[v];
  Response free = begin_response(scene.geometry, contacts, memories_of(pressed), 1, scene.start);
  ASSERT_GT(free.pulls[0].impulse, 0);
  hold_again(free, scene.end);
  resolve_contacts(free, scene.end);
  for (std::size_t v = 0; v < scene.end.size(); ++v)
    EXPECT_LT((scene.end[v] - scene.start[v]).norm(), 1e-9) << v;
}

TEST(Response, TheSameBitsWithAnyNumberOfThreads) {
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Scene scene = crumpling(6, 0.3);
    resolve(scene);
    results.push_back(scene.end);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

// One sheet that falls on another: thousands of contacts that hang together.
Scene two_layers() {
  Random random(7);
  Scene scene;
  const TriangleMesh layer = make_grid({1, 1}, {50, 50});
  scene.add_cloth(layer, thickness, 0.3);
  scene.add_cloth(test::shifted(layer, {0.003, 1.1 * thickness, 0.002}), thickness, 0.3);
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    scene.geometry.inverse_masses[v] = random.between(0.2, 5);
    scene.end[v] += random.vector(0.1 * thickness);
    if (v >= scene.start.size() / 2) scene.end[v].y() -= 0.5 * thickness;
  }
  return scene;
}

TEST(Response, PartsOfALargeGroupGiveTheSameBitsWithAnyNumberOfThreads) {
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Scene scene = two_layers();
    const std::vector<Contact> contacts = active(scene);
    const Response response = begin_response(scene.geometry, contacts, {}, 1, scene.start);
    ASSERT_GT(response.groups.part_count(), response.groups.group_count());
    test::resolve(scene, contacts);
    results.push_back(scene.end);
  }
  EXPECT_NE(results[0], two_layers().end);
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

// A sheet that lies on a plane, bent and pressed into it after all else was done; another lies on it.
// Thousands of contacts in one group, of which the plane's are firm.
struct Pressed {
  std::vector<Vec3> x, pushes;
  std::vector<char> moved;
};

Pressed press_layers() {
  Random random(8);
  Scene scene = two_layers();
  for (std::size_t v = 0; v < scene.start.size(); ++v) scene.start[v].y() += 0.9 * thickness;
  for (std::size_t v = 0; v < scene.end.size(); ++v) scene.end[v].y() += 0.8 * thickness;
  scene.add_plane();
  std::vector<Contact> contacts = active(scene);
  find_plane_contacts(scene.phase(), contacts);
  Response response = begin_response(scene.geometry, contacts, {}, 1, scene.start);
  resolve_contacts(response, scene.end);
  push_apart(response, scene.end);
  for (Vec3& x : scene.end) x.y() -= random.between(-0.2, 0.2) * thickness;
  Pressed pressed;
  pressed.moved = keep_firm_contacts(response, scene.end);
  pressed.x = scene.end;
  pressed.pushes = take_pushes(5, response, scene.end);
  return pressed;
}

TEST(Response, FirmContactsOfALargeGroupGiveTheSameBitsWithAnyNumberOfThreads) {
  std::vector<Pressed> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    results.push_back(press_layers());
  }
  const auto moved = std::count(results[0].moved.begin(), results[0].moved.end(), 1);
  EXPECT_GT(moved, 100);
  EXPECT_LT(moved, static_cast<std::ptrdiff_t>(results[0].moved.size()) / 2);
  for (const Pressed& other : results) {
    EXPECT_EQ(other.x, results[0].x);
    EXPECT_EQ(other.moved, results[0].moved);
    EXPECT_EQ(other.pushes, results[0].pushes);
  }
}

// Each part has its own range of them, and all of these together are all.
TEST(Response, FirmContactsAreThoseOfTheirParts) {
  Scene scene = two_layers();
  for (std::size_t v = 0; v < scene.start.size(); ++v) scene.start[v].y() += 0.9 * thickness;
  scene.end = scene.start;
  scene.add_plane();
  std::vector<Contact> contacts = active(scene);
  find_plane_contacts(scene.phase(), contacts);
  const Response response = begin_response(scene.geometry, contacts, {}, 1, scene.start);
  const CollisionGroups& groups = response.groups;
  ASSERT_GT(groups.part_count(), 10u);
  ASSERT_EQ(response.firm_begin.size(), groups.part_begin.size());
  std::size_t found = 0;
  for (std::size_t part = 0; part < groups.part_count(); ++part)
    for (std::size_t i = response.firm_begin[part]; i < response.firm_begin[part + 1]; ++i, ++found) {
      EXPECT_GE(response.firm[i], groups.part_begin[part]);
      EXPECT_LT(response.firm[i], groups.part_begin[part + 1]);
      EXPECT_TRUE(contacts[groups.order[response.firm[i]]].is_firm);
    }
  const auto firm =
      std::count_if(contacts.begin(), contacts.end(), [](const Contact& c) { return c.is_firm; });
  EXPECT_EQ(found, static_cast<std::size_t>(firm));
  EXPECT_GT(found, 1000u);
}

}  // namespace
}  // namespace drape
