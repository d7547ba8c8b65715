#include "scene_script.h"

#include "grsh/commands.h"
#include "grsh/render_job.h"

#include <optional>
#include <stdexcept>

namespace bench {
namespace {

// One run of a script, with commands that are grsh's own but for gr_render.
struct Run {
    grsh::Session session;
    std::optional<ScriptScene> scene;

    void render(grsh::Call& call) {
        const grsh::RenderJob job = grsh::readRenderJob(call);
        if (scene) return;
        scene.emplace(ScriptScene{gr::compile(session.database, job.node, job.lights),
                                  render::Camera(job.eye, job.view, job.up, job.fieldOfView, job.width, job.height),
                                  job.width, job.height});
    }
};

struct Binding {
    const grsh::Command* command;
    Run* run;
};

int call(ClientData data, Tcl_Interp* interp, int objc, Tcl_Obj* const objv[]) {
    const auto& [command, run] = *static_cast<const Binding*>(data);
    grsh::Call call{interp, run->session, grsh::Words(objc, objv)};
    try {
        if (call.words.size() < command->leastWords || call.words.size() > command->mostWords)
            throw std::runtime_error("wrong # args: " + std::string(command->name));
        if (command->name == "gr_render")
            run->render(call);
        else if (Tcl_Obj* result = command->function(call))
            Tcl_SetObjResult(interp, result);
        return TCL_OK;
    } catch (const std::exception& error) {
        Tcl_SetObjResult(interp, grsh::textObject(error.what()));
        return TCL_ERROR;
    }
}

}  // namespace

ScriptScene sceneOf(const std::string& script) {
    Tcl_FindExecutable(nullptr);
    Run run;
    std::vector<Binding> bindings;
    for (const grsh::Command* command : grsh::allCommands()) bindings.push_back({command, &run});
    Tcl_Interp* interp = Tcl_CreateInterp();
    bool isDone = Tcl_Init(interp) == TCL_OK;
    for (Binding& binding : bindings)
        Tcl_CreateObjCommand(interp, std::string(binding.command->name).c_str(), call, &binding, nullptr);
    isDone = isDone && Tcl_FSEvalFileEx(interp, grsh::textValue(script).get(), "utf-8") == TCL_OK;
    const std::string said = grsh::stringOf(Tcl_GetObjResult(interp));
    Tcl_DeleteInterp(interp);
    if (!isDone || !run.scene) throw std::runtime_error(script + ": " + (isDone ? "renders nothing" : said));
    return std::move(*run.scene);
}

}  // namespace bench
