#include "results/seeded_list.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "results/store.h"
#include "run_samples.h"

namespace dob::seeded_list_test {
namespace {

using test::key;

std::vector<CellKey> cells_of_two_rows() {
  return {key("s", "v", "a", "x", 7), key("s", "v", "a", "x", 8), key("s", "v", "b", "x", 7),
          key("s", "v", "a", "x", 9)};
}

TEST(SeededList, GivesBackWhatWasPutIn) {
  const std::vector<CellKey> cells = cells_of_two_rows();
  const CellKeys list(cells);
  ASSERT_EQ(list.size(), 4U);
  for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_EQ(list[i], cells[i]);
  EXPECT_EQ(list.front(), cells.front());
  EXPECT_EQ(list.back(), cells.back());
  std::vector<CellKey> visited;
  for (const CellKey& cell : list) visited.push_back(cell);
  EXPECT_EQ(visited, cells);
}

TEST(SeededList, HoldsARowOnceWhateverItsSeeds) {
  const CellKeys list(cells_of_two_rows());
  EXPECT_THAT(list.rows(), testing::ElementsAre(key("s", "v", "a", "x", 0), key("s", "v", "b", "x", 0)));
  EXPECT_EQ(&list.row(0), &list.row(3));
  EXPECT_EQ(list.row(2).observer, "b");
  EXPECT_EQ(list.seed(3), 9);
}

TEST(SeededList, DiffersByOrderRowAndSeed) {
  const CellKey a = key("s", "", "a", "x", 1), a2 = key("s", "", "a", "x", 2), b = key("s", "", "b", "x", 1);
  EXPECT_EQ((CellKeys{a, b}), (CellKeys{a, b}));
  EXPECT_NE((CellKeys{a, b}), (CellKeys{b, a}));
  EXPECT_NE((CellKeys{a}), (CellKeys{a2}));
  EXPECT_NE((CellKeys{a, b, a}), (CellKeys{a, b, b}));
  EXPECT_NE((CellKeys{a}), (CellKeys{a, a2}));
}

TEST(Interned, HoldsEqualElementsOnce) {
  Interned<std::string> words{"a", "a", "b", "a"};
  EXPECT_EQ(words.size(), 4U);
  EXPECT_EQ(words[3], "a");
  EXPECT_EQ(words[2], "b");
  EXPECT_THAT(words.values(), testing::ElementsAre("a", "b"));
  words.clear();
  EXPECT_TRUE(words.empty());
  words.push_back("b");
  EXPECT_THAT(words.values(), testing::ElementsAre("b"));
}

}  // namespace
}  // namespace dob::seeded_list_test
