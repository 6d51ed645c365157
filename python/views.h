#pragma once
// Views of C++ memory as NumPy arrays: read-only, without a copy. Each keeps its owner, a Python object, alive.
#include <array>
#include <cstddef>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "sim/core/math.h"

namespace selvedge::python {

namespace py = pybind11;

// The number type of an element, and its shape in the array.
template <class T>
struct Element {
    using Number = T;
    static std::vector<py::ssize_t> shape() { return {}; }
};
template <class T, int N>
struct Element<Eigen::Matrix<T, N, 1>> {
    using Number = T;
    static std::vector<py::ssize_t> shape() { return {N}; }
};
template <class T, std::size_t N>
struct Element<std::array<T, N>> {
    using Number = typename Element<T>::Number;
    static std::vector<py::ssize_t> shape() {
        std::vector<py::ssize_t> inner = Element<T>::shape();
        inner.insert(inner.begin(), static_cast<py::ssize_t>(N));
        return inner;
    }
};

inline void make_read_only(py::array& array) {
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
}

// An array of that many elements, each `stride` bytes after the one before it.
// Pre: `owner` keeps the memory, which does not change.
template <class T>
py::array strided_view(const T* first, std::size_t count, std::size_t stride, py::handle owner) {
    using Number = typename Element<T>::Number;
    std::vector<py::ssize_t> shape = Element<T>::shape();
    std::vector<py::ssize_t> strides(shape.size());
    py::ssize_t bytes = sizeof(Number);
    for (std::size_t i = shape.size(); i-- > 0; bytes *= shape[i]) strides[i] = bytes;
    shape.insert(shape.begin(), static_cast<py::ssize_t>(count));
    strides.insert(strides.begin(), static_cast<py::ssize_t>(stride));
    py::array array(py::dtype::of<Number>(), shape, strides, static_cast<const void*>(first), owner);
    make_read_only(array);
    return array;
}

template <class T>
py::array view_of(const std::vector<T>& elements, py::handle owner) {
    static_assert(sizeof(T) % sizeof(typename Element<T>::Number) == 0);
    return strided_view(elements.data(), elements.size(), sizeof(T), owner);
}

}  // namespace selvedge::python
