#include "app/viewer/reloaded_look.h"

namespace glimt {
namespace {

template <typename T>
T reloaded(const T& value, const T& before, const T& now) {
  return value == before ? now : value;
}

}  // namespace

Look reloadedLook(const Look& look, const Look& before, const Look& now) {
  Look result = now;
  const bool as_many = look.materials.size() == now.materials.size() &&
                       before.materials.size() == now.materials.size();
  for (std::size_t i = 0; as_many && i < now.materials.size(); ++i)
    result.materials[i] = reloaded(look.materials[i], before.materials[i], now.materials[i]);
  result.environment_strength =
      reloaded(look.environment_strength, before.environment_strength, now.environment_strength);
  result.environment_rotation =
      reloaded(look.environment_rotation, before.environment_rotation, now.environment_rotation);
  result.bounces = reloaded(look.bounces, before.bounces, now.bounces);
  result.exposure = reloaded(look.exposure, before.exposure, now.exposure);
  result.tone = reloaded(look.tone, before.tone, now.tone);
  return result;
}

}  // namespace glimt
