/* SPDX-License-Identifier: MIT */
/* COR_API marks the symbols that the shared library exports. All others are hidden. */
#ifndef COR_EXPORT_H
#define COR_EXPORT_H

#if defined(__GNUC__)
#define COR_API __attribute__((visibility("default")))
#else
#define COR_API
#endif

#endif
