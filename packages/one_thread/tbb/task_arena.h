// SPDX-License-Identifier: MIT
#pragma once

#include "serial.h"
