// OSMesa: software rendering with no display, device or server. Declared by hand, as its header clashes with glad's.
#include <array>

#include "render/gl/makers.h"
#include "render/gl/shared_library.h"

namespace selvedge {
namespace {

using OSMesaHandle = struct osmesa_context*;

constexpr int kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kMajor = 0x36, kMinor = 0x37, kRgba = 0x1908;
constexpr unsigned kUnsignedByte = 0x1401;

struct OSMesa {
    SharedLibrary library{"libOSMesa.so.8"};
    OSMesaHandle (*create)(const int*, OSMesaHandle) =
        library.function<OSMesaHandle (*)(const int*, OSMesaHandle)>("OSMesaCreateContextAttribs");
    void (*destroy)(OSMesaHandle) = library.function<void (*)(OSMesaHandle)>("OSMesaDestroyContext");
    unsigned char (*make_current)(OSMesaHandle, void*, unsigned, int, int) =
        library.function<unsigned char (*)(OSMesaHandle, void*, unsigned, int, int)>("OSMesaMakeCurrent");
    void (*(*get_proc)(const char*))() = library.function<void (*(*)(const char*))()>("OSMesaGetProcAddress");
};

class OSMesaContext final : public GlContext {
 public:
    OSMesaContext() {
        const std::array<int, 11> attributes{kFormat, kRgba, kDepthBits, 0, kProfile, kCoreProfile,
                                             kMajor,  3,     kMinor,     3, 0};
        context_ = mesa_.create(attributes.data(), nullptr);
        if (context_ == nullptr) throw std::runtime_error("makes no core profile context");
        make_current();
        load_functions(mesa_.get_proc);
    }

    ~OSMesaContext() override {
        mesa_.make_current(nullptr, nullptr, kUnsignedByte, 0, 0);
        mesa_.destroy(context_);
    }

    void make_current() override {
        const int side = kSide;
        if (!mesa_.make_current(context_, default_framebuffer_.data(), kUnsignedByte, side, side)) {
            throw std::runtime_error("does not make its context current");
        }
    }

    ContextMaker maker() const override { return ContextMaker::OSMesa; }

 private:
    static constexpr int kSide = 4;  // px; nothing is drawn here

    OSMesa mesa_;
    OSMesaHandle context_ = nullptr;
    std::array<unsigned char, kSide * kSide * 4> default_framebuffer_{};
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context() {
    return std::make_unique<OSMesaContext>();
}

}  // namespace selvedge
