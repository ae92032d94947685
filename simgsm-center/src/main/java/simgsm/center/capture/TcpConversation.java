package simgsm.center.capture;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.octets.Octets;

/**
 * One peer's signalling as TCP segments, and its speech as datagrams: handshake, one segment per message, an acknowledgement when half of the window is
 * unacknowledged, and the end. Sequence numbers begin at 0 on each side.
 */
final class TcpConversation implements WireTap {
    /** The port at which Wireshark decodes IPA. */
    static final int CENTER_PORT = 3003;

    /** The octet of a frame that names its stream. */
    private static final int STREAM = 2;

    private static final int FIN = 0x01;
    private static final int SYN = 0x02;
    private static final int PUSH = 0x08;
    private static final int ACK = 0x10;

    private static final int TCP_HEADER_LENGTH = 20;
    private static final byte TCP_HEADER_WORDS = 5;
    private static final short WINDOW = (short) 0xffff;
    /** Half of the window, so that neither side appears to wait. */
    private static final int MOST_UNACKNOWLEDGED = 0x7fff;

    private final Capture capture;
    private final IpHeader ip;
    private final Side peer;
    private final Side center;
    private final SpeechConversation speech;
    /** True if MGCP negotiates the terminal's media on this connection. */
    private boolean hasMgcp;

    private boolean isOver;

    private static final class Side {
        final boolean isPeer;
        final int port;
        int nextSequence;
        int acknowledgedByOther;

        Side(boolean isPeer, int port) {
            this.isPeer = isPeer;
            this.port = port;
        }
    }

    TcpConversation(Capture capture, InetSocketAddress peerAddress, InetSocketAddress centerAddress) {
        this.capture = capture;
        this.ip = IpHeader.between(peerAddress.getAddress(), centerAddress.getAddress());
        this.peer = new Side(true, peerAddress.getPort());
        this.speech = new SpeechConversation(capture, this, ip, peerAddress, centerAddress);
        this.center = new Side(false, CENTER_PORT);
        segment(peer, center, SYN, new byte[0]);
        segment(center, peer, SYN | ACK, new byte[0]);
        segment(peer, center, ACK, new byte[0]);
    }

    @Override
    public void received(IpaFrame frame) {
        if (frame.stream() == IpaFrame.SPEECH) {
            speech.speech(true, frame.payload(), System.nanoTime());
        } else {
            message(true, IpaFramer.encode(frame));
        }
    }

    @Override
    public void sent(byte[] wire) {
        boolean isSpeech = wire.length > IpaFrame.HEADER_LENGTH && (wire[STREAM] & 0xff) == IpaFrame.SPEECH;
        if (isSpeech) {
            speech.speech(false, Octets.range(wire, IpaFrame.HEADER_LENGTH, wire.length), System.nanoTime());
        } else {
            hasMgcp |= wire.length > IpaFrame.HEADER_LENGTH && (wire[STREAM] & 0xff) == IpaFrame.MGCP;
            message(false, wire);
        }
    }

    @Override
    public void datagram(boolean isFromPeer, int peerPort, int centerPort, byte[] rtp) {
        speech.datagram(isFromPeer, peerPort, centerPort, rtp, hasMgcp);
    }

    /**
     * Adds one message of signalling.
     *
     * @param wire a whole IPA frame
     */
    void message(boolean isFromPeer, byte[] wire) {
        Side from = isFromPeer ? peer : center;
        Side to = isFromPeer ? center : peer;
        if (from.nextSequence - from.acknowledgedByOther + wire.length > MOST_UNACKNOWLEDGED) {
            segment(to, from, ACK, new byte[0]);
        }
        segment(from, to, PUSH | ACK, wire);
    }

    @Override
    public void closed(boolean isByPeer) {
        if (isOver) {
            return;
        }
        speech.end();
        Side first = isByPeer ? peer : center;
        Side second = isByPeer ? center : peer;
        segment(first, second, FIN | ACK, new byte[0]);
        segment(second, first, FIN | ACK, new byte[0]);
        segment(first, second, ACK, new byte[0]);
        isOver = true;
    }

    private void segment(Side from, Side to, int flags, byte[] data) {
        if (isOver) {
            return;
        }
        boolean acknowledges = (flags & ACK) != 0;
        int length = TCP_HEADER_LENGTH + data.length;
        byte[] packet = new byte[ip.length() + length];
        ByteBuffer out = ByteBuffer.wrap(packet);
        ip.put(out, IpHeader.TCP, from.isPeer, length);
        int start = out.position();
        out.putShort((short) from.port).putShort((short) to.port);
        out.putInt(from.nextSequence).putInt(acknowledges ? to.nextSequence : 0);
        out.put((byte) (TCP_HEADER_WORDS << 4)).put((byte) flags);
        out.putShort(WINDOW).putShort((short) 0).putShort((short) 0).put(data);
        out.putShort(start + 16, ip.checksum(packet, IpHeader.TCP, start, length));
        from.nextSequence += data.length + ((flags & (SYN | FIN)) != 0 ? 1 : 0);
        if (acknowledges) {
            to.acknowledgedByOther = to.nextSequence;
        }
        capture.packet(packet);
    }
}
