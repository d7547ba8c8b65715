// Whole numbers mixed until they look like chance.
#pragma once

namespace core {

// Every bit of the result depends on every bit of x. UInt: a number of 32 bits, or one in each lane. (Wellons,
// "lowbias32".)
template<class UInt>
UInt mixed(UInt x) {
    x = x ^ (x >> 16);
    x = x * UInt(0x7feb352d);
    x = x ^ (x >> 15);
    x = x * UInt(0x846ca68b);
    return x ^ (x >> 16);
}

}  // namespace core
