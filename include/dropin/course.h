#pragma once

// The names of Berkeley's MeshEdit homework (CS184, 2016 to 2026), mapped onto meshedit, so
// that a homework file written for it compiles as it is. The grader includes this file before
// every file of such a submission; docs/dropin.md says what works.

#include "meshedit/meshedit.h"

// Homework defines members of the mesh's classes inside `namespace CGL { }`. That is allowed
// only in the namespace that the classes are declared in, so the name itself has to be
// replaced: an alias of the namespace cannot be opened.
#define CGL meshedit

// The course leaves the class MeshResampler to the student's header, where it may hold
// anything. It gets a name of its own beside meshedit's; adapter.cpp connects the two.
#define MeshResampler CourseMeshResampler

// Where the course's handles are the iterators of a list, so that some write
// `list<Vertex>::iterator`.
namespace std {  // NOLINT(cert-dcl58-cpp): for types of our own
template <>
class list<meshedit::Halfedge> : public meshedit::detail::Pool<meshedit::Halfedge> {};
template <>
class list<meshedit::Vertex> : public meshedit::detail::Pool<meshedit::Vertex> {};
template <>
class list<meshedit::Edge> : public meshedit::detail::Pool<meshedit::Edge> {};
template <>
class list<meshedit::Face> : public meshedit::detail::Pool<meshedit::Face> {};
}  // namespace std

// NOLINTBEGIN(google-global-names-in-headers): the course's headers do this, and homework
// depends on it.
using namespace std;
using namespace meshedit;
// NOLINTEND(google-global-names-in-headers)

#include "CGL/color.h"
#include "CGL/matrix3x3.h"
#include "CGL/matrix4x4.h"
#include "CGL/vector4D.h"
