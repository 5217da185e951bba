/* SPDX-License-Identifier: MIT
 *
 * The version, for the preprocessor; the build files read it from here. Until 1.0 the middle number
 * grows when something that programs use changes, the last one when nothing does. */
#ifndef ASTERISM_CORE_VERSION_H
#define ASTERISM_CORE_VERSION_H

/* The first number. */
#define ASTERISM_VERSION_MAJOR 0
/* The middle number. */
#define ASTERISM_VERSION_MINOR 1
/* The last number. */
#define ASTERISM_VERSION_PATCH 0
/* All three as text. */
#define ASTERISM_VERSION_TEXT "0.1.0"
/* One number that grows with the version: 10203 is 1.2.3. */
#define ASTERISM_VERSION \
  (ASTERISM_VERSION_MAJOR * 10000 + ASTERISM_VERSION_MINOR * 100 + ASTERISM_VERSION_PATCH)

#endif /* ASTERISM_CORE_VERSION_H */
