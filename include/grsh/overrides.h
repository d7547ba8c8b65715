// What grsh --set says: options and words of gr_render that count for more than the script's.
#pragma once

#include "grsh/tcl_value.h"
#include "render/settings.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace grsh {

struct RenderJob;

class Overrides {
public:
    Overrides() = default;
    // assignments: option=value each, as the command line has them. Throws core::Error, whose topic is USAGE, for what
    // gr_render does not know or take.
    explicit Overrides(const std::vector<std::string>& assignments);

    // Puts them in the place of what the script says. Throws core::Error where the picture would replace one that an
    // earlier gr_render of this script has put into the file that --set names.
    void apply(RenderJob& job);
    // Once the picture is about to be written.
    void takeFile() { isFileTaken_ = file_.has_value(); }
    // Whether there are any, and no gr_render has asked for them.
    bool areUnused() const { return isAny_ && !areUsed_; }

    // What may be set: file, width, height, and the options of gr_render.
    static std::vector<std::string_view> names();

private:
    void set(const std::string& name, Tcl_Obj* value);

    std::optional<std::string> file_;
    std::optional<int> width_, height_;
    std::vector<std::pair<const core::OptionRow<render::RenderSettings>*, Value>> options_;
    bool isAny_ = false, areUsed_ = false, isFileTaken_ = false;
};

}  // namespace grsh
