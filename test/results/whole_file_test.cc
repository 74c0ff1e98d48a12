#include "results/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/run_samples.h"

namespace dob::whole_file_test {
namespace {

namespace fs = std::filesystem;
using test::read_text;
using test::store_error;
using ::testing::HasSubstr;

TEST(WholeFile, IsReplacedAsAWholeOrNotAtAll) {
  const test::TemporaryDirectory temporary;
  const fs::path page = temporary.path() / "page.html";
  write_whole_file(page, "first");
  write_whole_file(page, "second");
  EXPECT_EQ(read_text(page), "second");
  EXPECT_FALSE(fs::exists(page.string() + ".part"));
  EXPECT_THAT(store_error([&] { write_whole_file(temporary.path() / "nowhere" / "page.html", "x"); }),
              HasSubstr("page.html: cannot be written"));
  fs::create_directories(temporary.path() / "taken.html" / "by");
  EXPECT_THAT(store_error([&] { write_whole_file(temporary.path() / "taken.html", "x"); }),
              HasSubstr("taken.html: cannot be written"));
  EXPECT_FALSE(fs::exists(temporary.path() / "taken.html.part"));
}

TEST(WholeFile, WhatLinksOfItsNamesPointToIsLeftAlone) {
  const test::TemporaryDirectory temporary;
  const fs::path page = temporary.path() / "page.html", other = temporary.path() / "thesis.tex";
  test::append_text(other, "years of work");
  fs::create_symlink(other, page);
  fs::create_symlink(other, page.string() + ".part");
  write_whole_file(page, "first");
  EXPECT_EQ(read_text(page), "first");
  EXPECT_EQ(read_text(other), "years of work");
  EXPECT_FALSE(fs::is_symlink(page));
}

}  // namespace
}  // namespace dob::whole_file_test
