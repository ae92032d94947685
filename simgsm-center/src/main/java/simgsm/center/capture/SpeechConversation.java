package simgsm.center.capture;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.MgcpMessage;
import simgsm.abis.MgcpMessage.MediaAddress;

/**
 * The speech of one connection as RTP over UDP, which Wireshark reads and plays without settings. Each session of
 * speech has separate ports, announced by MGCP within the TCP conversation; 400 ms of silence end it.
 */
final class SpeechConversation {
    /** The first port of RTP sessions, as media gateways use them. */
    static final int FIRST_PORT = 16_384;

    private static final int SESSIONS = 4_096;
    private static final int PORTS_PER_SESSION = 4;
    private static final int UDP_HEADER_LENGTH = 8;
    private static final long SILENCE_NANOS = TimeUnit.MILLISECONDS.toNanos(400);

    private final Capture capture;
    private final TcpConversation signalling;
    private final IpHeader ip;
    private final String peerHost;
    private final String centerHost;
    /** The session's port; 0 before the first. */
    private int centerPort;

    private int session;
    private long latestNanos;
    /** Announced ports of datagrams: the peer's in the high half, the centre's in the low one. */
    private final Set<Integer> announced = new HashSet<>();

    SpeechConversation(
            Capture capture,
            TcpConversation signalling,
            IpHeader ip,
            InetSocketAddress peer,
            InetSocketAddress center) {
        this.capture = capture;
        this.signalling = signalling;
        this.ip = ip;
        peerHost = peer.getAddress().getHostAddress();
        centerHost = center.getAddress().getHostAddress();
    }

    /**
     * Adds a speech frame.
     *
     * @param nowNanos of any monotonic clock
     */
    void speech(boolean isFromPeer, byte[] rtp, long nowNanos) {
        if (centerPort == 0 || nowNanos - latestNanos > SILENCE_NANOS) {
            end();
            begin();
        }
        latestNanos = nowNanos;
        datagram(isFromPeer, peerPort(), centerPort, rtp);
    }

    /**
     * Adds a datagram with its real ports.
     *
     * @param isAnnounced true if MGCP was on the wire; a tower's ports are in RSL, which Wireshark does not follow
     */
    void datagram(boolean isFromPeer, int toPeer, int toCenter, byte[] rtp, boolean isAnnounced) {
        if (!isAnnounced && announced.add(toPeer << 16 | toCenter)) {
            announce(capture.nextSession(), toPeer, toCenter);
        }
        datagram(isFromPeer, toPeer, toCenter, rtp);
    }

    private void datagram(boolean isFromPeer, int toPeer, int toCenter, byte[] rtp) {
        int from = isFromPeer ? toPeer : toCenter;
        int to = isFromPeer ? toCenter : toPeer;
        int length = UDP_HEADER_LENGTH + rtp.length;
        byte[] packet = new byte[ip.length() + length];
        ByteBuffer out = ByteBuffer.wrap(packet);
        ip.put(out, IpHeader.UDP, isFromPeer, length);
        int start = out.position();
        out.putShort((short) from).putShort((short) to);
        out.putShort((short) length).putShort((short) 0).put(rtp);
        out.putShort(start + 6, ip.checksum(packet, IpHeader.UDP, start, length));
        capture.packet(packet);
    }

    private int peerPort() {
        return centerPort + 2;
    }

    private void begin() {
        session = capture.nextSession();
        centerPort = FIRST_PORT + PORTS_PER_SESSION * (session % SESSIONS);
        announce(session, peerPort(), centerPort);
    }

    private void announce(int id, int toPeer, int toCenter) {
        MgcpMessage create = MgcpMessage.create(2 * id + 1, String.valueOf(id), new MediaAddress(centerHost, toCenter));
        announce(false, create);
        announce(true, create.created(String.valueOf(id), new MediaAddress(peerHost, toPeer)));
    }

    /** Ends the session, if there is one. */
    void end() {
        if (centerPort != 0) {
            String id = String.valueOf(session);
            MgcpMessage delete = MgcpMessage.delete(2 * session + 2, id, id);
            announce(false, delete);
            announce(true, delete.answered(MgcpMessage.Head.DELETED));
            centerPort = 0;
        }
    }

    private void announce(boolean isFromPeer, MgcpMessage message) {
        signalling.message(isFromPeer, IpaFramer.encode(new IpaFrame(IpaFrame.MGCP, message.encode())));
    }
}
