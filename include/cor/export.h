/* SPDX-License-Identifier: MIT */
/* COR_API marks what the library shows; everything else is hidden in the shared build. */
#ifndef COR_EXPORT_H
#define COR_EXPORT_H

#if defined(__GNUC__)
#define COR_API __attribute__((visibility("default")))
#else
#define COR_API
#endif

#endif
