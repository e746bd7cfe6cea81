// SPDX-License-Identifier: MIT
// Python objects that hold one C++ value. Unlike an instance of a class of pybind11, such an object has its value from
// `__new__` on, so nothing that Python can do calls a method of one without. The types are final and immutable, and
// their instances have no attributes of their own.
#pragma once

#include <new>
#include <string>
#include <type_traits>
#include <utility>

#include <pybind11/pybind11.h>

namespace graze::python {

namespace py = pybind11;

/// Specialised for every C++ type that has a Python type: `static constexpr auto name =
/// py::detail::const_name("Scene")`.
template <class Value>
struct BoxedName;

template <class Value>
concept HasBox = requires {
  BoxedName<Value>::name;
};

/// The layout of an object.
template <class Value>
struct Box {
  PyObject ob_base;
  Value value;
};

/// The Python type of a value. Shapes have one for each type of shape, of which this is the base.
template <HasBox Value>
inline PyTypeObject* boxed_type = nullptr;

/// What to do with an object that is not of the type, for messages. Specialised for types with advice.
template <class Value>
struct WayOut {
  static std::string of(py::handle /*object*/) { return ""; }
};

/// A new object of a type, or of a type derived from `boxed_type<Value>`.
template <HasBox Value>
py::object boxed_as(PyTypeObject* type, Value value) {
  PyObject* const object = type->tp_alloc(type, 0);
  if (object == nullptr) throw py::error_already_set();
  new (&reinterpret_cast<Box<Value>*>(object)->value) Value(std::move(value));
  return py::reinterpret_steal<py::object>(object);
}

template <HasBox Value>
py::object boxed(Value value) {
  return boxed_as<Value>(boxed_type<Value>, std::move(value));
}

template <HasBox Value>
bool is_boxed(py::handle object) {
  return PyObject_TypeCheck(object.ptr(), boxed_type<Value>) != 0;
}

/// The value in an object for which `is_boxed` holds.
template <HasBox Value>
Value& unboxed(py::handle object) {
  return reinterpret_cast<Box<Value>*>(object.ptr())->value;
}

template <class Value>
void deallocate_box(PyObject* object) {
  PyTypeObject* const type = Py_TYPE(object);
  reinterpret_cast<Box<Value>*>(object)->value.~Value();
  type->tp_free(object);
  Py_DECREF(type);
}

/// Calls the function `_create` of the type, which returns the new object.
inline PyObject* create_box(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
  PyObject* const maker = PyObject_GetAttrString(reinterpret_cast<PyObject*>(type), "_create");
  if (maker == nullptr) return nullptr;
  PyObject* const object = PyObject_Call(maker, arguments, keywords);
  Py_DECREF(maker);
  return object;
}

/// A Python type under construction: methods and properties are added, then `finish` makes it immutable.
class TypeMaker {
 public:
  /// `qualified_name` lives as long as the program. Without a base the type is one of `Value`.
  template <HasBox Value>
  static TypeMaker of(py::module_& module, const char* qualified_name, const char* doc, PyTypeObject* base = nullptr) {
    PyType_Slot slots[] = {{Py_tp_dealloc, reinterpret_cast<void*>(&deallocate_box<Value>)},
                           {Py_tp_new, reinterpret_cast<void*>(&create_box)},
                           {Py_tp_doc, const_cast<char*>(doc)},
                           {0, nullptr}};
    PyType_Spec spec = {qualified_name, static_cast<int>(sizeof(Box<Value>)), 0,
                        Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE, slots};
    PyObject* const made =
        base == nullptr ? PyType_FromSpec(&spec) : PyType_FromSpecWithBases(&spec, reinterpret_cast<PyObject*>(base));
    if (made == nullptr) throw py::error_already_set();
    TypeMaker maker(made);
    if (base == nullptr) boxed_type<Value> = maker.type();
    module.attr(maker.type()->tp_name + std::string(qualified_name).rfind('.') + 1) = maker.type_;
    return maker;
  }

  PyTypeObject* type() const { return reinterpret_cast<PyTypeObject*>(type_.ptr()); }

  template <class Function, class... Extra>
  TypeMaker& method(const char* name, Function&& function, const Extra&... extra) {
    type_.attr(name) =
        py::cpp_function(std::forward<Function>(function), py::name(name), py::is_method(type_), extra...);
    return *this;
  }

  template <class Function>
  TypeMaker& property(const char* name, Function&& function, const char* doc) {
    const py::cpp_function getter(std::forward<Function>(function), py::is_method(type_));
    type_.attr(name) = property_type()(getter, py::none(), py::none(), doc);
    return *this;
  }

  template <class Function, class... Extra>
  TypeMaker& static_method(const char* name, Function&& function, const Extra&... extra) {
    type_.attr(name) = static_method_type()(
        py::cpp_function(std::forward<Function>(function), py::name(name), py::scope(type_), extra...));
    return *this;
  }

  TypeMaker& attribute(const char* name, const py::object& value) {
    type_.attr(name) = value;
    return *this;
  }

  /// The function behind the constructor, which returns a boxed value. Without one, Python cannot make an object.
  template <class Function, class... Extra>
  TypeMaker& constructor(Function&& function, const Extra&... extra) {
    return static_method("_create", std::forward<Function>(function), extra...);
  }
  TypeMaker& no_constructor(const char* reason) {
    return constructor([reason](const py::args&, const py::kwargs&) -> py::object { throw py::type_error(reason); });
  }

  /// Once types derived from it are made.
  void finish() {
    type()->tp_flags &= ~static_cast<unsigned long>(Py_TPFLAGS_BASETYPE);
    type()->tp_flags |= Py_TPFLAGS_IMMUTABLETYPE;
    PyType_Modified(type());
  }

 private:
  explicit TypeMaker(PyObject* type) : type_(py::reinterpret_steal<py::object>(type)) {}

  static py::handle property_type() { return reinterpret_cast<PyObject*>(&PyProperty_Type); }
  static py::handle static_method_type() { return reinterpret_cast<PyObject*>(&PyStaticMethod_Type); }

  py::object type_;
};

}  // namespace graze::python

namespace pybind11::detail {

/// Arguments of a boxed type are references to the value in the object.
template <class Value>
class type_caster<Value, std::enable_if_t<graze::python::HasBox<Value>>> {
 public:
  static constexpr auto name = graze::python::BoxedName<Value>::name;
  template <class>
  using cast_op_type = Value&;

  /// No function is overloaded, so another type is an error, and pybind11's message about it would have no advice.
  bool load(handle source, bool /*convert*/) {
    if (!source) return false;
    if (!graze::python::is_boxed<Value>(source)) {
      throw type_error("a graze." + std::string(name.text) + " is needed, not a " + Py_TYPE(source.ptr())->tp_name +
                       graze::python::WayOut<Value>::of(source));
    }
    value_ = &graze::python::unboxed<Value>(source);
    return true;
  }
  operator Value&() { return *value_; }

 private:
  Value* value_ = nullptr;
};

}  // namespace pybind11::detail
