// How much memory there still is.
#pragma once

#include <cstdint>
#include <string>

namespace core {

// Bytes that this process can still use: without swapping, within its limit of address space (ulimit -v) and within
// those of its control groups. A very large number where the system tells none of them.
std::uint64_t availableMemory();

// Bytes that the control groups leave, by the list of a process's groups (/proc/self/cgroup) and the folder where they
// are mounted (/sys/fs/cgroup).
std::uint64_t cgroupMemory(const std::string& groups, const std::string& mount);

// 1536 bytes -> "1.5 KB"
std::string memoryText(double bytes);

}  // namespace core
