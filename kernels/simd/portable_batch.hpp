// Batches in plain C++: 16 bytes of lanes in an array, with the names and meaning of those parts of
// xsimd that kernels use. For libraries built without SIMD, on any architecture and byte order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace thinbench::detail::portable {

struct Registers {
  static constexpr std::size_t kBytes = 16;
};

template <class T, class A>
class batch_bool {
 public:
  using register_type = std::array<bool, A::kBytes / sizeof(T)>;

  batch_bool() = default;
  explicit batch_bool(const register_type& lanes) : lanes_(lanes) {}
  operator register_type() const { return lanes_; }

  [[gnu::always_inline]] friend batch_bool operator|(const batch_bool& a, const batch_bool& b) {
    register_type lanes;
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = a.lanes_[i] || b.lanes_[i];
    return batch_bool(lanes);
  }

 private:
  register_type lanes_;
};

/// GCC 12 does not inline most of these functions by itself, and thinning is then 18 times as slow.
template <class T, class A>
class batch {
 public:
  using value_type = T;
  using register_type = std::array<T, A::kBytes / sizeof(T)>;
  using batch_bool_type = batch_bool<T, A>;
  static constexpr std::size_t size = A::kBytes / sizeof(T);

  batch() = default;
  batch(T value) { lanes_.fill(value); }
  batch(const register_type& lanes) : lanes_(lanes) {}
  operator register_type() const { return lanes_; }

  [[gnu::always_inline]] static batch load_unaligned(const T* from) {
    return lanes([from](std::size_t i) { return from[i]; });
  }
  [[gnu::always_inline]] static batch load_aligned(const T* from) { return load_unaligned(from); }
  [[gnu::always_inline]] void store_unaligned(T* to) const {
    for (std::size_t i = 0; i < size; ++i) to[i] = lanes_[i];
  }
  void store_aligned(T* to) const { store_unaligned(to); }

  /// Lane i is value(i), converted.
  template <class Value>
  [[gnu::always_inline]] static batch lanes(const Value& value) {
    register_type result;
    for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<T>(value(i));
    return result;
  }
  T operator[](std::size_t i) const { return lanes_[i]; }

  [[gnu::always_inline]] friend batch operator+(const batch& a, const batch& b) {
    return lanes([&](std::size_t i) { return arithmetic(a[i]) + arithmetic(b[i]); });
  }
  [[gnu::always_inline]] friend batch operator-(const batch& a, const batch& b) {
    return lanes([&](std::size_t i) { return arithmetic(a[i]) - arithmetic(b[i]); });
  }
  [[gnu::always_inline]] friend batch operator*(const batch& a, const batch& b) {
    return lanes([&](std::size_t i) { return arithmetic(a[i]) * arithmetic(b[i]); });
  }
  [[gnu::always_inline]] friend batch operator/(const batch& a, const batch& b) {
    return lanes([&](std::size_t i) { return a[i] / b[i]; });
  }
  [[gnu::always_inline]] friend batch operator&(const batch& a, const batch& b) {
    return lanes([&](std::size_t i) { return a[i] & b[i]; });
  }
  [[gnu::always_inline]] friend batch operator|(const batch& a, const batch& b) {
    return lanes([&](std::size_t i) { return a[i] | b[i]; });
  }
  [[gnu::always_inline]] friend batch operator^(const batch& a, const batch& b) {
    return lanes([&](std::size_t i) { return a[i] ^ b[i]; });
  }
  [[gnu::always_inline]] friend batch operator~(const batch& a) {
    return lanes([&](std::size_t i) { return ~a[i]; });
  }
  [[gnu::always_inline]] friend batch operator<<(const batch& a, int count) {
    return lanes([&](std::size_t i) { return arithmetic(a[i]) << count; });
  }
  [[gnu::always_inline]] friend batch operator>>(const batch& a, int count) {
    return lanes([&](std::size_t i) { return a[i] >> count; });
  }

  [[gnu::always_inline]] friend batch_bool_type operator!=(const batch& a, const batch& b) {
    return compared([&](std::size_t i) { return a[i] != b[i]; });
  }
  [[gnu::always_inline]] friend batch_bool_type operator<(const batch& a, const batch& b) {
    return compared([&](std::size_t i) { return a[i] < b[i]; });
  }
  [[gnu::always_inline]] friend batch_bool_type operator>=(const batch& a, const batch& b) {
    return compared([&](std::size_t i) { return a[i] >= b[i]; });
  }
  [[gnu::always_inline]] friend batch_bool_type operator>(const batch& a, const batch& b) {
    return b < a;
  }

 private:
  /// Integers wrap around: as unsigned, and at least as wide as int, to which narrow ones would
  /// grow.
  static auto arithmetic(T value) {
    if constexpr (std::is_floating_point_v<T>) {
      return value;
    } else if constexpr (sizeof(T) < sizeof(unsigned)) {
      return static_cast<unsigned>(value);
    } else {
      return static_cast<std::make_unsigned_t<T>>(value);
    }
  }
  template <class Holds>
  [[gnu::always_inline]] static batch_bool_type compared(const Holds& holds) {
    typename batch_bool_type::register_type result;
    for (std::size_t i = 0; i < size; ++i) result[i] = holds(i);
    return batch_bool_type(result);
  }

  register_type lanes_;
};

template <class T, class A>
bool any(const batch_bool<T, A>& lanes) {
  bool found = false;
  for (const bool lane : typename batch_bool<T, A>::register_type(lanes)) found = found || lane;
  return found;
}

template <class T, class A>
batch<T, A> select(const batch_bool<T, A>& chosen, const batch<T, A>& a, const batch<T, A>& b) {
  const typename batch_bool<T, A>::register_type lanes = chosen;
  return batch<T, A>::lanes([&](std::size_t i) { return lanes[i] ? a[i] : b[i]; });
}

template <class T, class A>
batch<T, A> min(const batch<T, A>& a, const batch<T, A>& b) {
  return select(b < a, b, a);
}

template <class T, class A>
batch<T, A> max(const batch<T, A>& a, const batch<T, A>& b) {
  return select(a < b, b, a);
}

template <class T, class A>
batch<T, A> abs(const batch<T, A>& a) {
  return max(a, batch<T, A>(T{0}) - a);
}

/// Saturating. T is narrower than int.
template <class T, class A>
batch<T, A> ssub(const batch<T, A>& a, const batch<T, A>& b) {
  static_assert(sizeof(T) < sizeof(int));
  constexpr int lowest = std::numeric_limits<T>::min();
  constexpr int highest = std::numeric_limits<T>::max();
  return batch<T, A>::lanes([&](std::size_t i) {
    const int difference = a[i] - b[i];
    return difference < lowest ? lowest : difference > highest ? highest : difference;
  });
}

template <class A>
batch<std::int32_t, A> to_int(const batch<float, A>& a) {
  return batch<std::int32_t, A>::lanes([&](std::size_t i) { return a[i]; });
}

}  // namespace thinbench::detail::portable
