// What the examples use of the WiFi library of an ESP32 or an ESP8266, to compile against. Nothing of it runs.
#pragma once

#include <Arduino.h>
#include <Udp.h>

enum WiFiMode { WIFI_STA, WIFI_AP };

class WiFiClass {
 public:
  bool mode(WiFiMode) { return true; }
  int begin(const char*, const char*) { return 0; }
  bool softAP(const char*, const char*) { return true; }
};

static WiFiClass WiFi;
