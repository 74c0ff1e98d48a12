// A list whose equal elements are held once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <vector>

namespace dob {

// Of an ordered type; an element takes four bytes where its value is there already. Elements cannot be changed.
template <typename T>
class Interned {
 public:
  Interned() = default;
  Interned(std::initializer_list<T> elements) {
    for (const T& element : elements) push_back(element);
  }

  void push_back(const T& value) {
    if (places_.empty() || values_[places_.back()] != value) {
      const auto [it, added] = known_.emplace(value, static_cast<std::uint32_t>(values_.size()));
      if (added) values_.push_back(value);
      places_.push_back(it->second);
    } else {
      places_.push_back(places_.back());  // as most are: no search
    }
  }

  const T& operator[](std::size_t i) const { return values_[places_[i]]; }
  const T& front() const { return (*this)[0]; }
  std::size_t size() const noexcept { return places_.size(); }
  bool empty() const noexcept { return places_.empty(); }
  void clear() { *this = {}; }

  // Each once, in the order in which they came first.
  const std::vector<T>& values() const noexcept { return values_; }

  friend bool operator==(const Interned& a, const Interned& b) {
    return a.places_ == b.places_ && a.values_ == b.values_;
  }

 private:
  std::vector<T> values_;
  std::vector<std::uint32_t> places_;  // of each element: index into values_
  std::map<T, std::uint32_t> known_;
};

}  // namespace dob
