// Lists of cells: most differ from the one before in nothing but their seed.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "results/cell.h"
#include "results/interned.h"

namespace dob {

inline int& seed_of(CellKey& key) noexcept {
  return key.seed;
}

// A cell takes eight bytes and its row once, however many seeds the row has. Elements are made when they are asked for,
// and cannot be changed. T is an ordered type for which there is seed_of().
template <typename T>
class SeededList {
 public:
  SeededList() = default;
  SeededList(std::initializer_list<T> cells) {
    for (const T& cell : cells) push_back(cell);
  }
  explicit SeededList(const std::vector<T>& cells) {
    for (const T& cell : cells) push_back(cell);
  }

  void push_back(T cell) {
    seeds_.push_back(seed_of(cell));
    seed_of(cell) = 0;
    rows_.push_back(cell);
  }

  T operator[](std::size_t i) const {
    T cell = rows_[i];
    seed_of(cell) = seeds_[i];
    return cell;
  }
  T front() const { return (*this)[0]; }
  T back() const { return (*this)[size() - 1]; }
  std::size_t size() const noexcept { return seeds_.size(); }
  bool empty() const noexcept { return seeds_.empty(); }
  void clear() { *this = {}; }

  int seed(std::size_t i) const { return seeds_[i]; }
  // Of cell i, and all of them, each once, in the order of their first cells; their seeds are 0.
  const T& row(std::size_t i) const { return rows_[i]; }
  const std::vector<T>& rows() const noexcept { return rows_.values(); }

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = T;

    Iterator(const SeededList& list, std::size_t i) : list_(&list), i_(i) {}
    T operator*() const { return (*list_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++i_;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.i_ == b.i_; }

   private:
    const SeededList* list_;
    std::size_t i_;
  };

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

  friend bool operator==(const SeededList& a, const SeededList& b) {
    return a.seeds_ == b.seeds_ && a.rows_ == b.rows_;
  }

 private:
  Interned<T> rows_;
  std::vector<int> seeds_;
};

using CellKeys = SeededList<CellKey>;

}  // namespace dob
