/* SPDX-License-Identifier: MIT */
/* COR_API marks the symbols that the shared library exports. All others are hidden. */
#ifndef COR_EXPORT_H
#define COR_EXPORT_H

#if defined(_WIN32)
/* COR_SHARED: the library is a DLL (CMake and pkg-config define it); COR_BUILDING: this is the library itself. */
#if !defined(COR_SHARED)
#define COR_API
#elif defined(COR_BUILDING)
#define COR_API __declspec(dllexport)
#else
#define COR_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define COR_API __attribute__((visibility("default")))
#else
#define COR_API
#endif

#endif
