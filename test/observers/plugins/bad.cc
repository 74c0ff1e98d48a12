// A plugin that is wrong in the way that DOB_BAD says, one library each.
#include <stdexcept>

#include "observers/plugin_api.h"

#define DOB_NO_ENTRY 1
#define DOB_NOTHING 2
#define DOB_OLD_INTERFACE 3
#define DOB_OTHER_LAYOUT 4
#define DOB_NAME_WITH_SPACE 5
#define DOB_BUILT_IN_NAME 6
#define DOB_NO_FACTORY 7
#define DOB_THROWS 8
#define DOB_THROWS_NUMBER 9
#define DOB_MAKES_NOTHING 10
#define DOB_UNRESOLVED 11

#if DOB_BAD == DOB_UNRESOLVED
void dob_not_there_at_all();
#endif

#if DOB_BAD == DOB_NO_ENTRY
extern "C" [[gnu::visibility("default")]] int dob_something_else();
int dob_something_else() {
  return 1;
}
#else

namespace {

std::unique_ptr<dob::DisturbanceObserver> make(const dob::ObserverOptions& /*options*/, double /*dt*/) {
#if DOB_BAD == DOB_THROWS
  throw std::runtime_error("out of ideas");
#elif DOB_BAD == DOB_THROWS_NUMBER
  throw 42;
#elif DOB_BAD == DOB_UNRESOLVED
  dob_not_there_at_all();
#endif
  return nullptr;
}

constexpr dob::PluginAbi abi() {
  dob::PluginAbi abi = dob::plugin_abi();
  if (DOB_BAD == DOB_OLD_INTERFACE) abi.interface_version = 0;
  if (DOB_BAD == DOB_OTHER_LAYOUT) abi.model_terms_size += 8;
  return abi;
}

constexpr const char* name() {
  if (DOB_BAD == DOB_NAME_WITH_SPACE) return "my observer";
  return DOB_BAD == DOB_BUILT_IN_NAME ? "momentum" : "bad";
}

}  // namespace

const dob::ObserverPlugin* dob_observer_plugin() {
  static constexpr dob::ObserverPlugin plugin{
      .abi = abi(), .name = name(), .estimates_legs = true, .make = DOB_BAD == DOB_NO_FACTORY ? nullptr : make};
  return DOB_BAD == DOB_NOTHING ? nullptr : &plugin;
}

#endif
