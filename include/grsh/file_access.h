// Which files a script may use. Without --safe: all, by their names as they are. With it: what lies below a few
// folders, opened from these folders step by step, so that neither a name nor a link nor a change meanwhile leads out
// of them. Every file that a command opens for a script goes through here; see docs/safe-mode.md.
#pragma once

#include "core/open_below.h"

#include <string>
#include <vector>

namespace image {
struct FileName;
}

namespace grsh {

class FileAccess {
public:
    // Any file.
    FileAccess() = default;
    // Only below these folders; they must exist. Throws core::Error.
    FileAccess(const std::vector<std::string>& reads, const std::vector<std::string>& writes);

    bool isSafe() const { return isSafe_; }

    // Each throws core::Error "cannot read ..." or "cannot write ...", which calls the file name, for what may not be
    // used. In safe mode the path that comes back leads to what was checked for as long as it is held.
    image::FileName toRead(const std::string& name) const;
    // The file at a path that its name does not tell by itself.
    image::FileName toRead(const std::string& path, const std::string& name) const;
    image::FileName toWrite(const std::string& name) const;
    // A file that grsh has written beside a picture: it lies where writing is allowed.
    image::FileName toReadBack(const std::string& name) const;
    // The folder to read below that an absolute path lies in; null without --safe. name: for messages.
    const core::Folder* folderToRead(const std::string& path, const std::string& name) const;

    // Tcl's own use of files: what a script may read, and what only Tcl may, like its library. errno is EXDEV for
    // anything else.
    core::Descriptor openForTcl(const std::string& name, int flags) const;
    void letTclRead(const std::string& path);

private:
    // A folder by its name as it was given and by its path.
    struct Root {
        core::Folder folder;
        std::string given;
    };
    using Roots = std::vector<Root>;

    static Roots openRoots(const char* verb, const std::vector<std::string>& folders);
    image::FileName openFile(const std::string& path, const std::string& name, const Roots& roots) const;

    bool isSafe_ = false;
    Roots reads_, writes_;
    std::vector<std::string> tclFiles_;
};

// A file's path from the root folder, without "." and "..", each of which takes the name before it away.
std::string plainPath(const std::string& name);

}  // namespace grsh
