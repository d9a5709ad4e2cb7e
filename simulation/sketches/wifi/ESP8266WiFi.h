// The name that it has on an ESP8266.
#pragma once

#include "WiFi.h"
