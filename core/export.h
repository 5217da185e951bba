/* SPDX-License-Identifier: MIT
 *
 * Marks what the shared libraries show: functions and classes of the public headers. Everything
 * else is compiled hidden, and the symbol lists below cmake/symbols name what is left to see. Plain
 * C, as c_api.h includes it.
 */
#ifndef ASTERISM_CORE_EXPORT_H
#define ASTERISM_CORE_EXPORT_H

#if defined(__GNUC__)
#define ASTERISM_EXPORT __attribute__((visibility("default")))
#else
#define ASTERISM_EXPORT
#endif

#endif /* ASTERISM_CORE_EXPORT_H */
