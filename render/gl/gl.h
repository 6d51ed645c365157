#pragma once
// GL's names and the type of its function table, by glad. Every use goes through a context's table (context.h), so that
// contexts of two makers can live in one program; no other room names the loader.
#include <glad/gl.h>
