// SPDX-License-Identifier: MIT
// Off-screen contexts from OSMesa. All drawing goes to frame buffer objects; the buffer that OSMesa
// wants for its default frame buffer is one pixel.
#include "render/context.h"

#include <array>
#include <cstdint>

// After glcorearb.h: its old GL/gl.h would hide the types of OpenGL 1.1 functions.
#include <GL/osmesa.h>

#include "render/shared_library.h"

namespace render {

namespace {

/// The functions of libOSMesa in use.
struct Functions {
    decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
    decltype(&OSMesaDestroyContext) destroy_context = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaGetCurrentContext) current_context = nullptr;
    decltype(&OSMesaGetProcAddress) proc_address = nullptr;
};

base::Result<Functions> load_functions() {
    constexpr const char* package = "libosmesa6";
    const auto library = SharedLibrary::open({"libOSMesa.so.8", "libOSMesa.so"}, package);
    if (!library) return library.problems();
    Functions f;
    f.create_context = library->function<decltype(f.create_context)>("OSMesaCreateContextAttribs");
    f.destroy_context = library->function<decltype(f.destroy_context)>("OSMesaDestroyContext");
    f.make_current = library->function<decltype(f.make_current)>("OSMesaMakeCurrent");
    f.current_context = library->function<decltype(f.current_context)>("OSMesaGetCurrentContext");
    f.proc_address = library->function<decltype(f.proc_address)>("OSMesaGetProcAddress");
    if (!f.create_context || !f.destroy_context || !f.make_current || !f.current_context ||
        !f.proc_address)
        return base::error(
            "libOSMesa is too old: it cannot create a core context; install the package "
            "libosmesa6, version 11.2 or newer");
    return f;
}

class OsmesaContext final : public Context {
public:
    static base::Result<std::unique_ptr<Context>> open();

    ~OsmesaContext() override {
        if (functions_.current_context() == context_) release();
        functions_.destroy_context(context_);
    }

    void make_current() override { bind(); }
    void release() override { functions_.make_current(nullptr, nullptr, 0, 0, 0); }

private:
    OsmesaContext(const Functions& functions, OSMesaContext context)
        : functions_(functions), context_(context) {}

    bool bind() {
        return functions_.make_current(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
    }

    Functions functions_;
    OSMesaContext context_;
    alignas(16) std::array<std::uint8_t, 4> pixel_{};
};

base::Result<std::unique_ptr<Context>> OsmesaContext::open() {
    const auto functions = load_functions();
    if (!functions) return functions.problems();

    constexpr std::array<int, 9> attributes{OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            4,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            5,
                                            0};
    OSMesaContext handle = functions->create_context(attributes.data(), nullptr);
    if (!handle)
        return base::error(
            "OSMesa offers no OpenGL 4.5 core context; install a newer version of the package "
            "libosmesa6");
    std::unique_ptr<OsmesaContext> context(new OsmesaContext(*functions, handle));
    if (!context->bind())
        return base::error(
            "OSMesa cannot make its context current; is another driver's context "
            "current on this thread?");
    auto gl = Gl::load(functions->proc_address);
    if (!gl) return gl.problems();
    context->gl_ = *gl;
    return std::unique_ptr<Context>(std::move(context));
}

}  // namespace

base::Result<std::unique_ptr<Context>> open_osmesa() { return OsmesaContext::open(); }

}  // namespace render
