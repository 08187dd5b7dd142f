#include "assets/generate/demos.h"

#include "assets/generate/christmas/christmas.h"
#include "assets/generate/motorcycle/motorcycle.h"
#include "assets/generate/watch/watch.h"

namespace glimt::assets {

const std::map<std::string, std::function<Demo()>>& demos() {
  static const std::map<std::string, std::function<Demo()>> all = {
      {"christmas", makeChristmas},
      {"motorcycle", makeMotorcycle},
      {"shop-motorcycle", makeShopMotorcycle},
      {"watch", makeWatch}};
  return all;
}

}  // namespace glimt::assets
