// Arduino's interface of network clients, which TinyGSM's sockets implement; this stand-in opens none.
#pragma once
#include "Arduino.h"

class IPAddress {
    uint8_t octets[4];

  public:
    IPAddress(uint8_t a = 0, uint8_t b = 0, uint8_t c = 0, uint8_t d = 0) : octets{a, b, c, d} {}
    uint8_t operator[](int at) const { return octets[at]; }
    bool operator==(const IPAddress &other) const { return memcmp(octets, other.octets, 4) == 0; }
    bool operator!=(const IPAddress &other) const { return !(*this == other); }
};

class Client : public Stream {
  public:
    virtual int connect(IPAddress address, uint16_t port) = 0;
    virtual int connect(const char *host, uint16_t port) = 0;
    virtual int read(uint8_t *into, size_t count) = 0;
    virtual void stop() = 0;
    virtual uint8_t connected() = 0;
    virtual operator bool() = 0;
    using Stream::read;
};
