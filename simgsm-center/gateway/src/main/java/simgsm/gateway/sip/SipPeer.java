package simgsm.gateway.sip;

/**
 * A UDP address.
 *
 * @param host a numeric address
 */
public record SipPeer(String host, int port) {
    /** The address in URIs and Via (RFC 3261, 25.1): an IPv6 address in brackets. */
    static String inUri(String host) {
        return host.indexOf(':') >= 0 ? "[" + host + "]" : host;
    }

    @Override
    public String toString() {
        return inUri(host) + ":" + port;
    }
}
