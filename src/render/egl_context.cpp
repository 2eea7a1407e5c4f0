// SPDX-License-Identifier: MIT
// Off-screen contexts from EGL without any surface: on the first real graphics card that works,
// else on Mesa's surfaceless platform.
#include "render/context.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "render/shared_library.h"

namespace render {

namespace {

/// The functions of libEGL in use; the last three may be missing.
struct Functions {
    decltype(&eglBindAPI) bind_api = nullptr;
    decltype(&eglCreateContext) create_context = nullptr;
    decltype(&eglDestroyContext) destroy_context = nullptr;
    decltype(&eglGetCurrentContext) current_context = nullptr;
    decltype(&eglGetError) error = nullptr;
    decltype(&eglGetProcAddress) proc_address = nullptr;
    decltype(&eglInitialize) initialise = nullptr;
    decltype(&eglMakeCurrent) make_current = nullptr;
    decltype(&eglQueryString) query_string = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display = nullptr;
    PFNEGLQUERYDEVICESEXTPROC devices = nullptr;
    PFNEGLQUERYDEVICESTRINGEXTPROC device_string = nullptr;
};

base::Result<Functions> load_functions() {
    const auto library = SharedLibrary::open({"libEGL.so.1", "libEGL.so"}, "libegl1");
    if (!library) return library.problems();
    Functions f;
    bool complete = true;
    const auto load = [&]<class Function>(Function& function, const char* name) {
        function = library->function<Function>(name);
        complete = complete && function;
    };
    load(f.bind_api, "eglBindAPI");
    load(f.create_context, "eglCreateContext");
    load(f.destroy_context, "eglDestroyContext");
    load(f.current_context, "eglGetCurrentContext");
    load(f.error, "eglGetError");
    load(f.proc_address, "eglGetProcAddress");
    load(f.initialise, "eglInitialize");
    load(f.make_current, "eglMakeCurrent");
    load(f.query_string, "eglQueryString");
    if (!complete)
        return base::error("libEGL is too old; install a newer version of the package libegl1");

    const auto extension = [&]<class Function>(Function& function, const char* name) {
        function = reinterpret_cast<Function>(f.proc_address(name));
    };
    extension(f.platform_display, "eglGetPlatformDisplayEXT");
    extension(f.devices, "eglQueryDevicesEXT");
    extension(f.device_string, "eglQueryDeviceStringEXT");
    return f;
}

// A list of extensions is words separated by spaces.
bool lists(const char* extensions, std::string_view name) {
    if (!extensions) return false;
    const std::string padded = fmt::format(" {} ", extensions);
    return padded.find(fmt::format(" {} ", name)) != std::string::npos;
}

/// A way to a display, and its name for messages.
struct Candidate {
    EGLenum platform;
    void* native;
    std::string name;
};

// Graphics cards first, then whatever Mesa offers without a device, software last.
std::vector<Candidate> candidates(const Functions& f) {
    const char* client = f.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<Candidate> hardware;
    std::vector<Candidate> software;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    const bool has_devices =
        lists(client, "EGL_EXT_platform_device") && f.devices && f.device_string;
    if (has_devices && !f.devices(devices.size(), devices.data(), &count)) count = 0;
    for (EGLint i = 0; i < count; ++i) {
        const bool is_software =
            lists(f.device_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
        (is_software ? software : hardware)
            .push_back({EGL_PLATFORM_DEVICE_EXT, devices[i], fmt::format("EGL device {}", i)});
    }
    if (lists(client, "EGL_MESA_platform_surfaceless"))
        hardware.push_back(
            {EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "the surfaceless platform"});
    hardware.insert(hardware.end(), software.begin(), software.end());
    return hardware;
}

class EglContext final : public Context {
public:
    static base::Result<std::unique_ptr<Context>> open(const Functions& f,
                                                       const Candidate& candidate);

    // The display stays: other contexts of the process share it, and EGL does not count them.
    ~EglContext() override {
        if (functions_.current_context() == context_) release();
        functions_.destroy_context(display_, context_);
    }

    void make_current() override { bind(); }
    void release() override {
        functions_.bind_api(EGL_OPENGL_API);
        functions_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

private:
    EglContext(const Functions& functions, EGLDisplay display, EGLContext context)
        : functions_(functions), display_(display), context_(context) {}

    // The bound API belongs to the thread, so it is set again each time.
    bool bind() {
        functions_.bind_api(EGL_OPENGL_API);
        return functions_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) ==
               EGL_TRUE;
    }

    Functions functions_;
    EGLDisplay display_;
    EGLContext context_;
};

base::Result<std::unique_ptr<Context>> EglContext::open(const Functions& f,
                                                        const Candidate& candidate) {
    const auto failed = [&](std::string_view what) {
        return base::error(fmt::format("{} {} (EGL error {:#06x})", candidate.name, what,
                                       static_cast<unsigned>(f.error())));
    };
    EGLDisplay display = f.platform_display(candidate.platform, candidate.native, nullptr);
    if (display == EGL_NO_DISPLAY) return failed("has no display");
    if (!f.initialise(display, nullptr, nullptr)) return failed("cannot be initialised");
    const char* extensions = f.query_string(display, EGL_EXTENSIONS);
    for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"})
        if (!lists(extensions, needed)) return failed(fmt::format("lacks {}", needed));
    if (!f.bind_api(EGL_OPENGL_API)) return failed("has no desktop OpenGL");

    constexpr std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               4,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               5,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE};
    EGLContext handle =
        f.create_context(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (handle == EGL_NO_CONTEXT) return failed("has no OpenGL 4.5 core");
    std::unique_ptr<EglContext> context(new EglContext(f, display, handle));
    if (!context->bind()) return failed("cannot make its context current");
    auto gl = Gl::load(f.proc_address);
    if (!gl) return gl.problems();
    context->gl_ = *gl;
    return std::unique_ptr<Context>(std::move(context));
}

}  // namespace

base::Result<std::unique_ptr<Context>> open_egl() {
    const auto functions = load_functions();
    if (!functions) return functions.problems();

    std::string reasons;
    if (functions->platform_display) {
        for (const Candidate& candidate : candidates(*functions)) {
            auto context = EglContext::open(*functions, candidate);
            if (context) return context;
            for (const base::Diagnostic& problem : context.problems())
                reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", problem.message);
        }
    }
    if (reasons.empty()) reasons = "EGL knows no device and no surfaceless platform";
    return base::error(fmt::format(
        "no EGL display offers OpenGL 4.5 without a window ({}); install the graphics card's "
        "driver or the packages libegl-mesa0 and libgl1-mesa-dri, or use the backend osmesa",
        reasons));
}

}  // namespace render
