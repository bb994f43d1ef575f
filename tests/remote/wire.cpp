// Messages through pipes, of both sides.
#include "tests/remote/wire.h"

#include <unistd.h>

namespace joints::testing::remote {

namespace {

bool whole(int from, void* to, std::size_t size) {
  for (auto* at = static_cast<char*>(to); size > 0;) {
    const ssize_t now = ::read(from, at, size);
    if (now <= 0) return false;
    at += now;
    size -= std::size_t(now);
  }
  return true;
}

}  // namespace

void send(int to, Kind kind, const std::string& data) {
  const std::size_t size = data.size();
  std::string all(1, char(kind));
  all.append(reinterpret_cast<const char*>(&size), sizeof size).append(data);
  for (std::size_t at = 0; at < all.size();) {
    const ssize_t now = ::write(to, all.data() + at, all.size() - at);
    if (now <= 0) return;  // the other side has ended, which it will be asked for
    at += std::size_t(now);
  }
}

bool receive(int from, Kind& kind, Bytes& bytes) {
  std::size_t size = 0;
  constexpr std::size_t most = std::size_t{1} << 24;
  bytes.at = 0;
  if (!whole(from, &kind, 1) || !whole(from, &size, sizeof size) || size > most) return false;
  bytes.data.resize(size);
  return whole(from, bytes.data.data(), size);
}

}  // namespace joints::testing::remote
