#include "certificate/box_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "contact/scene.h"

namespace drape {
namespace {

using test::Random;

std::vector<BoundingBox> random_boxes(int count) {
  Random random(7);
  std::vector<BoundingBox> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 centre = random.vector(), a = random.vector(0.1), b = random.vector(0.1);
    boxes.push_back(box_of({centre, centre + a, centre + b}));
  }
  return boxes;
}

TEST(BoxTree, FindsTheOverlappingBoxesEachOnce) {
  for (const int count : {0, 1, 4, 5, 9, 300}) {
    const std::vector<BoundingBox> boxes = random_boxes(count);
    const BoxTree tree(boxes);
    for (const BoundingBox& wanted : random_boxes(20)) {
      std::multiset<int> expected, found;
      for (int i = 0; i < count; ++i)
        if (boxes_overlap(boxes[i], wanted)) expected.insert(i);
      tree.find_overlapping(wanted, [&](std::size_t place) { found.insert(tree.item(place)); });
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(BoxTree, FindsFromAPlaceOnOnlyWhatComesAfterIt) {
  const BoxTree tree(random_boxes(100));
  std::size_t found = 0;
  const BoundingBox all{Vec3::Constant(-9), Vec3::Constant(9)};
  tree.find_near(
      all, 37, [] { return 0.0; },
      [&](std::size_t place) {
        EXPECT_GE(place, 37u);
        ++found;
      });
  EXPECT_EQ(found, 63u);
}

TEST(BoxTree, FindsTheNearestBoxUnderAShrinkingBound) {
  const std::vector<BoundingBox> boxes = random_boxes(300);
  const BoxTree tree(boxes);
  for (BoundingBox wanted : random_boxes(20)) {
    wanted.lower.x() += 3, wanted.upper.x() += 3;
    double nearest = 1e300, bound = 1e300;
    for (const BoundingBox& box : boxes) nearest = std::min(nearest, squared_box_distance(box, wanted));
    tree.find_near(
        wanted, 0, [&] { return bound; },
        [&](std::size_t place) {
          bound = std::min(bound, squared_box_distance(tree.box(tree.item(place)), wanted));
        });
    EXPECT_EQ(bound, nearest);
  }
}

}  // namespace
}  // namespace drape
