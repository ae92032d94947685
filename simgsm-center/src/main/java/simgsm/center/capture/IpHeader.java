package simgsm.center.capture;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.util.Arrays;

/** Writes IP headers between two addresses: IPv4 (RFC 791), or IPv6 (RFC 8200) if either address is. */
final class IpHeader {
    static final int TCP = 6;
    static final int UDP = 17;

    /** Sent instead of a computed UDP checksum of 0 (RFC 768). */
    private static final short ZERO_AS_SENT = (short) 0xffff;

    private static final int VERSION_4_LENGTH_5 = 0x45;
    private static final short DO_NOT_FRAGMENT = 0x4000;
    private static final byte TIME_TO_LIVE = 64;
    private static final int VERSION_4_HEADER_LENGTH = 20;
    private static final int VERSION_6_HEADER_LENGTH = 40;
    private static final int VERSION_6 = 6 << 28;
    private static final int VERSION_6_ADDRESS_LENGTH = 16;
    /** ::ffff:0:0/96 (RFC 4291, 2.5.5.2). */
    private static final int MAPPED_PREFIX_LENGTH = 12;

    private final byte[] peer;
    private final byte[] center;
    private int identification;

    private IpHeader(byte[] peer, byte[] center) {
        this.peer = peer;
        this.center = center;
    }

    static IpHeader between(InetAddress peer, InetAddress center) {
        if (peer instanceof Inet4Address && center instanceof Inet4Address) {
            return new IpHeader(peer.getAddress(), center.getAddress());
        }
        return new IpHeader(version6(peer), version6(center));
    }

    private static byte[] version6(InetAddress address) {
        byte[] octets = address.getAddress();
        if (octets.length == VERSION_6_ADDRESS_LENGTH) {
            return octets;
        }
        byte[] mapped = new byte[VERSION_6_ADDRESS_LENGTH];
        Arrays.fill(mapped, MAPPED_PREFIX_LENGTH - 2, MAPPED_PREFIX_LENGTH, (byte) 0xff);
        System.arraycopy(octets, 0, mapped, MAPPED_PREFIX_LENGTH, octets.length);
        return mapped;
    }

    private boolean isVersion4() {
        return peer.length == VERSION_4_HEADER_LENGTH - 16;
    }

    int length() {
        return isVersion4() ? VERSION_4_HEADER_LENGTH : VERSION_6_HEADER_LENGTH;
    }

    /** Puts the header before a segment or datagram of this length. */
    void put(ByteBuffer packet, int protocol, boolean isFromPeer, int segmentLength) {
        byte[] source = isFromPeer ? peer : center;
        byte[] destination = isFromPeer ? center : peer;
        if (isVersion4()) {
            int start = packet.position();
            packet.put((byte) VERSION_4_LENGTH_5).put((byte) 0);
            packet.putShort((short) (VERSION_4_HEADER_LENGTH + segmentLength));
            packet.putShort((short) identification++).putShort(DO_NOT_FRAGMENT);
            packet.put(TIME_TO_LIVE).put((byte) protocol).putShort((short) 0);
            packet.put(source).put(destination);
            packet.putShort(start + 10, folded(sum(packet.array(), start, VERSION_4_HEADER_LENGTH)));
        } else {
            packet.putInt(VERSION_6).putShort((short) segmentLength);
            packet.put((byte) protocol).put(TIME_TO_LIVE);
            packet.put(source).put(destination);
        }
    }

    /**
     * The checksum of a segment or datagram with checksum field 0, and its pseudo header (RFC 9293, 3.1, and RFC 768).
     */
    short checksum(byte[] packet, int protocol, int from, int segmentLength) {
        long sum = sum(peer, 0, peer.length) + sum(center, 0, center.length) + protocol + segmentLength;
        short checksum = folded(sum + sum(packet, from, segmentLength));
        // 0 would mean no checksum
        return protocol == UDP && checksum == 0 ? ZERO_AS_SENT : checksum;
    }

    private static long sum(byte[] octets, int from, int length) {
        long sum = 0;
        for (int i = 0; i < length; i++) {
            sum += (octets[from + i] & 0xff) << (i % 2 == 0 ? 8 : 0);
        }
        return sum;
    }

    private static short folded(long sum) {
        long rest = sum;
        while (rest > 0xffff) {
            rest = (rest & 0xffff) + (rest >> 16);
        }
        return (short) ~rest;
    }
}
