/* For kernels without SCTP, as in many containers: preloaded into the Osmocom programs, it turns their SCTP sockets into TCP
   ones and hands each M3UA message over whole, as SCTP would. Both ends must have it.
     gcc -shared -fPIC -O2 -o sctp_over_tcp.so sctp_over_tcp.c -ldl */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <dlfcn.h>
#include <errno.h>
#include <netinet/in.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#define SCTP 132
#define M3UA_HEADER 8
#define M3UA_PAYLOAD_ID 3
#define MESSAGE_ENDS 0x80 /* MSG_EOR */

/* RFC 6458, 5.3.2: what comes with a received message. */
struct received_info {
    uint16_t stream, number, flags;
    uint32_t payload_id, context, time_to_live, tsn, cumulative_tsn;
    int32_t association;
};

static void *real(const char *name) {
    return dlsym(RTLD_NEXT, name);
}

int socket(int domain, int type, int protocol) {
    static int (*call)(int, int, int);
    if (!call) call = real("socket");
    if (protocol != SCTP) return call(domain, type, protocol);
    return call(domain, (type & (SOCK_NONBLOCK | SOCK_CLOEXEC)) | SOCK_STREAM, 0);
}

int setsockopt(int fd, int level, int option, const void *value, socklen_t length) {
    static int (*call)(int, int, int, const void *, socklen_t);
    if (!call) call = real("setsockopt");
    return level == SCTP ? 0 : call(fd, level, option, value, length);
}

int getsockopt(int fd, int level, int option, void *value, socklen_t *length) {
    static int (*call)(int, int, int, void *, socklen_t *);
    if (!call) call = real("getsockopt");
    if (level != SCTP) return call(fd, level, option, value, length);
    memset(value, 0, *length);
    return 0;
}

static socklen_t length_of(const struct sockaddr *address) {
    return address->sa_family == AF_INET6 ? sizeof(struct sockaddr_in6) : sizeof(struct sockaddr_in);
}

int sctp_bindx(int fd, struct sockaddr *addresses, int count, int flags) {
    return bind(fd, addresses, length_of(addresses));
}

int sctp_connectx(int fd, struct sockaddr *addresses, int count, void *association) {
    return connect(fd, addresses, length_of(addresses));
}

static int one_address(int (*ask)(int, struct sockaddr *, socklen_t *), int fd, struct sockaddr **addresses) {
    socklen_t length = sizeof(struct sockaddr_storage);
    *addresses = calloc(1, length);
    return *addresses && ask(fd, *addresses, &length) == 0 ? 1 : -1;
}

int sctp_getladdrs(int fd, int association, struct sockaddr **addresses) {
    return one_address(getsockname, fd, addresses);
}

int sctp_getpaddrs(int fd, int association, struct sockaddr **addresses) {
    return one_address(getpeername, fd, addresses);
}

void sctp_freeladdrs(struct sockaddr *addresses) {
    free(addresses);
}

void sctp_freepaddrs(struct sockaddr *addresses) {
    free(addresses);
}

int sctp_sendmsg(int fd, const void *message, size_t length, struct sockaddr *to, socklen_t to_length,
                 uint32_t payload_id, uint32_t flags, uint16_t stream, uint32_t lifetime, uint32_t context) {
    return send(fd, message, length, MSG_NOSIGNAL);
}

int sctp_send(int fd, const void *message, size_t length, const struct received_info *info, int flags) {
    return send(fd, message, length, flags | MSG_NOSIGNAL);
}

/* One message; its length stands in octets 4 to 7 of its header (RFC 4666, 3.1.4). */
int sctp_recvmsg(int fd, void *message, size_t room, struct sockaddr *from, socklen_t *from_length,
                 struct received_info *info, int *flags) {
    uint8_t header[M3UA_HEADER];
    ssize_t peeked = recv(fd, header, sizeof header, MSG_PEEK);
    if (peeked <= 0) return peeked;
    if (peeked < M3UA_HEADER) {
        errno = EAGAIN;
        return -1;
    }
    uint32_t length;
    memcpy(&length, header + 4, sizeof length);
    length = ntohl(length);
    if (length > room) length = room;
    for (uint32_t got = 0; got < length;) {
        ssize_t part = recv(fd, (char *)message + got, length - got, 0);
        if (part == 0) return 0;
        if (part > 0) {
            got += part;
        } else if (errno == EAGAIN || errno == EINTR) {
            usleep(200);
        } else {
            return -1;
        }
    }
    if (info) {
        memset(info, 0, sizeof *info);
        info->payload_id = htonl(M3UA_PAYLOAD_ID);
        info->stream = header[2] == 1;
    }
    if (flags) *flags = MESSAGE_ENDS;
    return length;
}

ssize_t sctp_recvv(int fd, const struct iovec *parts, int count, struct sockaddr *from, socklen_t *from_length,
                   void *info, socklen_t *info_length, unsigned *info_type, int *flags) {
    return sctp_recvmsg(fd, parts[0].iov_base, parts[0].iov_len, from, from_length, NULL, flags);
}
