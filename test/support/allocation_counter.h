// Counts heap allocations of this process, however they are made: operator new, malloc, calloc, realloc, aligned_alloc,
// posix_memalign. Linking dob_allocation_counter replaces glibc's entry points. For tests and benchmarks.
#pragma once

namespace dob::test {

// Allocations of the calling thread since this object was made.
class AllocationCounter {
 public:
  AllocationCounter() noexcept;
  long count() const noexcept;

 private:
  long start_;
};

}  // namespace dob::test
