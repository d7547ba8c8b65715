// How much memory the machine still has.
#pragma once

#include <cstdint>
#include <string>

namespace core {

// Bytes that can be used without swapping; a very large number where the system does not tell.
std::uint64_t availableMemory();

// 1536 bytes -> "1.5 KB"
std::string memoryText(double bytes);

}  // namespace core
