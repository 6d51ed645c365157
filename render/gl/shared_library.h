#pragma once
// A library opened at run time. It stays open: Mesa's leave threads and thread-local data behind.
#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace selvedge {

class SharedLibrary {
 public:
    explicit SharedLibrary(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
        if (handle_ == nullptr) throw std::runtime_error(dlerror());
    }

    template <class Function>
    Function function(const char* name) const {
        void* address = dlsym(handle_, name);
        if (address == nullptr) throw std::runtime_error(std::string("lacks ") + name);
        return reinterpret_cast<Function>(address);
    }

 private:
    void* handle_;
};

}  // namespace selvedge
