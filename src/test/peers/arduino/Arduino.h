// Stand-in for Arduino's core on a host: what TinyGSM and Adafruit_FONA use of it. The serial line is a TCP connection.
#pragma once
#define ARDUINO 10800
#define __SAM3X8E__ // keeps libraries away from SoftwareSerial

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <time.h>

typedef uint8_t byte;
class __FlashStringHelper;
#define PROGMEM
#define PSTR(s) (s)
#define F(s) (reinterpret_cast<const __FlashStringHelper *>(s))
#define strcmp_P strcmp
#define strstr_P strstr
#define strlen_P strlen
#define strcpy_P strcpy
#define pgm_read_byte(address) (*(const uint8_t *)(address))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define constrain(value, least, most) ((value) < (least) ? (least) : (value) > (most) ? (most) : (value))
#define DEC 10
#define HEX 16
#define HIGH 1
#define LOW 0
#define OUTPUT 1
#define FALLING 2

inline uint32_t millis() {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<uint32_t>(now.tv_sec * 1000LL + now.tv_nsec / 1000000);
}
inline void delay(uint32_t ms) { usleep(ms == 0 ? 50 : ms * 1000); }
inline bool isDigit(int c) { return c >= '0' && c <= '9'; }
inline void pinMode(int, int) {}
inline void digitalWrite(int, int) {}
// The ring indicator's interrupt; the program runs it when it sees RING.
inline std::function<void()> ring_indicator;
inline void attachInterrupt(int, void (*routine)(), int) { ring_indicator = routine; }
inline void detachInterrupt(int) { ring_indicator = nullptr; }

class String {
    std::string s;

  public:
    String(const char *text = "") : s(text ? text : "") {}
    explicit String(char c) : s(1, c) {}
    explicit String(int number) : s(std::to_string(number)) {}
    const char *c_str() const { return s.c_str(); }
    unsigned length() const { return s.length(); }
    void reserve(unsigned size) { s.reserve(size); }
    String &operator+=(const String &other) { s += other.s; return *this; }
    String &operator+=(const char *other) { s += other; return *this; }
    String &operator+=(char c) { s += c; return *this; }
    String &operator+=(int number) { s += std::to_string(number); return *this; }
    friend String operator+(String left, const String &right) { return left += right; }
    bool operator==(const char *other) const { return s == other; }
    bool operator!=(const char *other) const { return s != other; }
    char operator[](unsigned at) const { return at < s.length() ? s[at] : 0; }
    char charAt(unsigned at) const { return (*this)[at]; }
    void remove(unsigned from) { s.erase(from); }
    bool startsWith(const char *begin) const { return s.rfind(begin, 0) == 0; }
    bool endsWith(const char *end) const {
        size_t length = strlen(end);
        return s.length() >= length && s.compare(s.length() - length, length, end) == 0;
    }
    int indexOf(const char *what, unsigned from = 0) const { return static_cast<int>(s.find(what, from)); }
    int indexOf(char what, unsigned from = 0) const { return static_cast<int>(s.find(what, from)); }
    int lastIndexOf(const char *what, unsigned from) const { return static_cast<int>(s.rfind(what, from)); }
    String substring(unsigned from, unsigned to = ~0u) const {
        return from < s.length() && from < to ? String(s.substr(from, to - from).c_str()) : String();
    }
    void replace(const char *what, const char *with) {
        for (size_t at = 0; (at = s.find(what, at)) != std::string::npos; at += strlen(with)) {
            s.replace(at, strlen(what), with);
        }
    }
    void trim() {
        size_t first = s.find_first_not_of(" \t\r\n"), last = s.find_last_not_of(" \t\r\n");
        s = first == std::string::npos ? "" : s.substr(first, last - first + 1);
    }
    long toInt() const { return atol(s.c_str()); }
};

class Print {
    size_t number(long long value, int base) {
        char digits[24];
        snprintf(digits, sizeof digits, base == HEX ? "%llX" : "%lld", value);
        return print(digits);
    }

  public:
    virtual ~Print() {}
    virtual size_t write(uint8_t octet) = 0;
    virtual size_t write(const uint8_t *octets, size_t count) {
        for (size_t i = 0; i < count; i++) write(octets[i]);
        return count;
    }
    size_t write(const char *octets, size_t count) { return write(reinterpret_cast<const uint8_t *>(octets), count); }
    size_t print(const char *text) { return write(reinterpret_cast<const uint8_t *>(text), strlen(text)); }
    size_t print(const __FlashStringHelper *text) { return print(reinterpret_cast<const char *>(text)); }
    size_t print(const String &text) { return print(text.c_str()); }
    size_t print(char c) { return write(static_cast<uint8_t>(c)); }
    size_t print(unsigned char value, int base = DEC) { return number(value, base); }
    size_t print(int value, int base = DEC) { return number(value, base); }
    size_t print(unsigned value, int base = DEC) { return number(value, base); }
    size_t print(long value, int base = DEC) { return number(value, base); }
    size_t print(unsigned long value, int base = DEC) { return number(value, base); }
    size_t print(double value, int = 2) { return print(std::to_string(value).c_str()); }
    size_t println() { return print("\r\n"); }
    template <typename... A> size_t println(A... values) { return print(values...) + println(); }
};

class Stream : public Print {
    int timedRead() {
        for (uint32_t begin = millis(); millis() - begin < _timeout; delay(1)) {
            if (available() > 0) return read();
        }
        return -1;
    }

  protected:
    unsigned long _timeout = 1000;

  public:
    virtual int available() = 0;
    virtual int read() = 0;
    virtual int peek() = 0;
    virtual void flush() {}
    void setTimeout(unsigned long ms) { _timeout = ms; }
    size_t readBytes(char *into, size_t count) {
        size_t got = 0;
        for (int c; got < count && (c = timedRead()) >= 0;) into[got++] = static_cast<char>(c);
        return got;
    }
    size_t readBytesUntil(char end, char *into, size_t count) {
        size_t got = 0;
        for (int c; got < count && (c = timedRead()) >= 0 && c != end;) into[got++] = static_cast<char>(c);
        return got;
    }
    String readStringUntil(char end) {
        String text;
        for (int c; (c = timedRead()) >= 0 && c != end;) text += static_cast<char>(c);
        return text;
    }
    String readString() { return readStringUntil(0); }
    long parseInt() {
        int c = timedRead();
        while (c >= 0 && c != '-' && (c < '0' || c > '9')) c = timedRead();
        std::string digits;
        for (; c == '-' || (c >= '0' && c <= '9'); c = timedRead()) {
            digits += static_cast<char>(c);
            if (peek() < '0' || peek() > '9') break;
        }
        return atol(digits.c_str());
    }
};

// The serial line to the modem. With the environment variable TRACE all that passes is shown on standard error.
class ModemLine : public Stream {
    int line;
    std::string waiting;
    bool traced = getenv("TRACE") != nullptr;

    void fill() {
        pollfd ready = {line, POLLIN, 0};
        char octets[512];
        if (poll(&ready, 1, 0) > 0) {
            ssize_t count = recv(line, octets, sizeof octets, 0);
            if (count <= 0) {
                fprintf(stderr, "the modem has closed the line\n");
                exit(1);
            }
            waiting.append(octets, count);
            if (traced) fwrite(octets, 1, count, stderr);
        }
    }

  public:
    explicit ModemLine(int port) : line(socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (::connect(line, reinterpret_cast<sockaddr *>(&address), sizeof address) != 0) {
            perror("connect");
            exit(1);
        }
    }
    using Print::write;
    size_t write(uint8_t octet) override { return write(&octet, 1); }
    size_t write(const uint8_t *octets, size_t count) override {
        if (traced) fprintf(stderr, "\033[1m%.*s\033[0m", static_cast<int>(count), octets);
        return send(line, octets, count, 0) < 0 ? 0 : count;
    }
    int available() override {
        fill();
        return static_cast<int>(waiting.size());
    }
    int peek() override { return available() > 0 ? static_cast<uint8_t>(waiting[0]) : -1; }
    int read() override {
        int octet = peek();
        if (octet >= 0) waiting.erase(0, 1);
        return octet;
    }
    // Reads until a text has come. @return false if it does not come in time
    bool await(const char *text, uint32_t ms) {
        std::string all;
        for (uint32_t begin = millis(); millis() - begin < ms; delay(1)) {
            for (int c; (c = read()) >= 0;) all += static_cast<char>(c);
            if (all.find(text) != std::string::npos) return true;
        }
        return false;
    }
};

// Takes the debug output of libraries and drops it.
class Discarding : public Print {
  public:
    size_t write(uint8_t) override { return 1; }
};
inline Discarding Serial;

// A call of the library: its name, whether its result is right, and what it gave.
inline int asked, right;
inline void tell(const char *call, bool isRight, const char *result = "") {
    asked++;
    right += isRight;
    printf("%s %s %s\n", isRight ? "right" : "WRONG", call, result);
    fflush(stdout);
}
// Asks the script for something that a second phone does, and waits until it is under way.
inline void want(const char *what) {
    char line[16];
    printf("want %s\n", what);
    fflush(stdout);
    if (fgets(line, sizeof line, stdin) == nullptr) exit(1);
}
