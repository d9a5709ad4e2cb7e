// An exact angle. On AVR `double` is a 32-bit float: a longitude beyond 128 degrees moves in steps of 1.7 m there. So a
// coordinate is never a float here, not even on its way from the source text: the literal is read digit by digit when
// the sketch is compiled.
#pragma once

#include <stdint.h>

namespace mavmission {

class WideHeading;

namespace literal {
template <typename T>
struct IsWide {
  static constexpr bool value = false;
};
template <>
struct IsWide<WideHeading> {
  static constexpr bool value = true;
};
}  // namespace literal

// An angle in steps of 1e-7 degree (about 1 cm on the ground), as MISSION_ITEM_INT.x and .y carry it. Written with a
// literal: -35.3632621_deg. From numbers that are computed: Degrees::fromE7().
class Degrees {
 public:
  constexpr Degrees() : e7_(0) {}
  // Any other type is refused when the sketch is compiled.
  template <typename Other>
  constexpr Degrees(Other) : e7_(0) {
    static_assert(!literal::IsWide<Other>::value,
                  "write a coordinate from -180 to 180 degrees: west and south have a minus sign");
    static_assert(literal::IsWide<Other>::value,
                  "write an angle with its unit: -35.3632621_deg, or Degrees::fromE7(e7) for a computed one");
  }

  // From whole steps of 1e-7 degree, -1800000000 to 1800000000. Beyond that a plan is refused, naming the item.
  static constexpr Degrees fromE7(int32_t e7) { return Degrees(e7, Exact()); }

  // Whole steps of 1e-7 degree.
  constexpr int32_t e7() const { return e7_; }

  // Exact. The sketch must see to it that the result stays in the range of fromE7().
  constexpr Degrees operator-() const { return fromE7(-e7_); }
  constexpr Degrees operator+(Degrees other) const { return fromE7(e7_ + other.e7_); }
  constexpr Degrees operator-(Degrees other) const { return fromE7(e7_ - other.e7_); }
  constexpr Degrees operator*(int32_t times) const { return fromE7(e7_ * times); }
  constexpr bool operator==(Degrees other) const { return e7_ == other.e7_; }
  constexpr bool operator!=(Degrees other) const { return e7_ != other.e7_; }

 private:
  struct Exact {};
  constexpr Degrees(int32_t e7, Exact) : e7_(e7) {}
  int32_t e7_;
};

// A heading beyond 180 degrees, such as the literal 270_deg. It cannot be used as a coordinate.
class WideHeading {
 public:
  // From an angle in units of 1e-7 degrees, from 0 to 360 degrees.
  constexpr explicit WideHeading(uint32_t e7) : e7_(e7) {}
  // Steps of 1e-7 degree.
  constexpr uint32_t e7() const { return e7_; }

 private:
  uint32_t e7_;
};

namespace literal {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }

// The number of decimals without trailing zeros (35.36320000_deg is exact too).
template <char... Rest>
struct Decimals;
template <>
struct Decimals<> {
  static constexpr int count(bool, int, int significant) { return significant; }
};
template <char First, char... Rest>
struct Decimals<First, Rest...> {
  static constexpr int count(bool afterPoint, int seen, int significant) {
    return First == '.'    ? Decimals<Rest...>::count(true, 0, 0)
           : First == '\'' ? Decimals<Rest...>::count(afterPoint, seen, significant)
           : afterPoint    ? Decimals<Rest...>::count(true, seen + 1, First == '0' ? significant : seen + 1)
                           : Decimals<Rest...>::count(false, 0, 0);
  }
};

// True for digits, at most one point, and the digit separators of C++14.
template <char... All>
struct Plain;
template <>
struct Plain<> {
  static constexpr bool check(bool) { return true; }
};
template <char First, char... Rest>
struct Plain<First, Rest...> {
  static constexpr bool check(bool pointSeen) {
    return First == '.' ? (!pointSeen && Plain<Rest...>::check(true))
                        : ((isDigit(First) || First == '\'') && Plain<Rest...>::check(pointSeen));
  }
};

// True for 0x10_deg and 010_deg, which the compiler or the reader would not take for decimal.
template <char... All>
struct LeadingZero {
  static constexpr bool value = false;
};
template <char Second, char... Rest>
struct LeadingZero<'0', Second, Rest...> {
  static constexpr bool value = isDigit(Second);
};

// The value in 1e-7 degree; digits beyond the seventh decimal are zeros here. Stops growing beyond 1e10, so that
// nothing overflows before the range is checked.
template <char... Rest>
struct Value;
template <>
struct Value<> {
  static constexpr int64_t scale(int64_t value, int decimals) {
    return decimals >= 7 ? value : scale(value * 10, decimals + 1);
  }
  static constexpr int64_t e7(int64_t value, bool, int decimals) { return scale(value, decimals); }
};
template <char First, char... Rest>
struct Value<First, Rest...> {
  static constexpr int64_t e7(int64_t value, bool afterPoint, int decimals) {
    return First == '.'                  ? Value<Rest...>::e7(value, true, 0)
           : !isDigit(First)             ? Value<Rest...>::e7(value, afterPoint, decimals)
           : afterPoint && decimals >= 7 ? Value<Rest...>::e7(value, true, decimals)
           : value > 9999999999
               ? Value<Rest...>::e7(value, afterPoint, decimals)
               : Value<Rest...>::e7(value * 10 + (First - '0'), afterPoint, decimals + (afterPoint ? 1 : 0));
  }
};

// The result of a literal, as a constant also inside a function: avr-gcc would otherwise compute it there each time.
template <int64_t E7, bool IsWide = (E7 > 1800000000)>
struct Constant {
  typedef Degrees Type;
  static constexpr int32_t value = static_cast<int32_t>(E7);
  static constexpr Degrees make() { return Degrees::fromE7(value); }
};
template <int64_t E7>
struct Constant<E7, true> {
  static_assert(E7 <= 3600000000,
                "write a coordinate from -180 to 180 degrees, a heading up to 360: west and south have a minus sign");
  typedef WideHeading Type;
  static constexpr uint32_t value = static_cast<uint32_t>(E7);
  static constexpr WideHeading make() { return WideHeading(value); }
};

}  // namespace literal

// -35.3632621_deg: exact to 1e-7 degree, computed by the compiler, no cost in flash. Up to seven decimals, and 180
// degrees; a heading may have up to 360. A latitude beyond 90 is found when the plan is checked (Status::BadLatitude).
template <char... Text>
constexpr typename literal::Constant<literal::Value<Text...>::e7(0, false, 0)>::Type operator"" _deg() {
  static_assert(literal::Plain<Text...>::check(false) && !literal::LeadingZero<Text...>::value,
                "write an angle as plain decimal digits, for example -35.3632621_deg: no exponent, no hexadecimal");
  static_assert(literal::Decimals<Text...>::count(false, 0, 0) <= 7,
                "write an angle with at most 7 decimals: autopilots keep steps of 1e-7 degrees, about 1 cm");
  return literal::Constant<literal::Value<Text...>::e7(0, false, 0)>::make();
}

}  // namespace mavmission
