package simgsm.abis;

/**
 * One frame of the IP access multiplex: two octets of payload length, one of stream, the payload.
 *
 * @param stream which conversation the payload belongs to, 0 to 255
 * @param payload at most {@link #MAX_PAYLOAD} octets; not copied, so nobody may change it
 */
public record IpaFrame(int stream, byte[] payload) {
    /** Radio signalling link of the first transceiver: {@link RslMessage}. */
    public static final int RSL = 0x00;
    /** Connection control: identity and keep-alive, {@link CcmMessage}. */
    public static final int CCM = 0xfe;
    /** Speech, ours: one RTP packet a frame. */
    public static final int SPEECH = 0xe1;

    public static final int HEADER_LENGTH = 3;
    /** Longest payload that we send or take. The longest real one, an RP-DATA of 248 octets in RSL, has 260. */
    public static final int MAX_PAYLOAD = 1024;

    public IpaFrame {
        if (stream < 0 || stream > 0xff) {
            throw new IllegalArgumentException("stream " + stream + " is not 0 to 255");
        }
        if (payload.length > MAX_PAYLOAD) {
            throw new IllegalArgumentException(
                    "a payload of " + payload.length + " octets is longer than " + MAX_PAYLOAD);
        }
    }
}
