package simgsm.abis;

import simgsm.octets.Bounds;

/**
 * One frame of the IP access multiplex: two octets of payload length, one of stream, the payload.
 *
 * @param stream 0 to 255, see {@link #RSL}, {@link #CCM}, {@link #MGCP} and {@link #SPEECH}
 * @param payload at most {@link #MAX_PAYLOAD} octets; not copied, so it must not change
 */
public record IpaFrame(int stream, byte[] payload) {
    /** Radio signalling link of the first transceiver: {@link RslMessage}. */
    public static final int RSL = 0x00;
    /** Connection control: identity and keep-alive, {@link CcmMessage}. */
    public static final int CCM = 0xfe;
    /** Media control, the addresses of speech as RTP over UDP: {@link MgcpMessage}. */
    public static final int MGCP = 0xfc;
    /** Speech, the suite's own stream: one RTP packet per frame. */
    public static final int SPEECH = 0xe1;

    public static final int HEADER_LENGTH = 3;
    /** Longest payload sent or accepted, octets. The longest in use, an RP-DATA of 248 octets in RSL, has 260. */
    public static final int MAX_PAYLOAD = 1024;

    public IpaFrame {
        Bounds.checkOctet("stream", stream);
        if (payload.length > MAX_PAYLOAD) {
            throw new IllegalArgumentException(
                    "a payload of " + payload.length + " octets is longer than " + MAX_PAYLOAD);
        }
    }
}
