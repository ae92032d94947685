package simgsm.air;

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
    /** Longest payload that we send or take. The longest real one, a cell broadcast page, has 97 octets. */
    public static final int MAX_PAYLOAD = 1024;
}
