package simgsm.speech;

/** Encodes and decodes frames of 20 ms. A codec may have a state, so each direction of each call needs its own. */
public interface SpeechCodec {
    int SAMPLES_PER_SECOND = 8000;
    int FRAME_MILLIS = 20;
    int SAMPLES_PER_FRAME = 160;

    /** The codecs. */
    enum Kind {
        /** G.711 mu-law. */
        MU_LAW(0, 160),
        /** GSM 06.10 full rate. */
        GSM_FULL_RATE(3, 33),
        /** G.711 A-law. */
        A_LAW(8, 160);

        private final int payloadType;
        private final int octetsPerFrame;

        Kind(int payloadType, int octetsPerFrame) {
            this.payloadType = payloadType;
            this.octetsPerFrame = octetsPerFrame;
        }

        /** The codec with this name in options. @throws IllegalArgumentException for an unknown name */
        public static Kind named(String name) {
            return switch (name) {
                case "alaw" -> A_LAW;
                case "gsm" -> GSM_FULL_RATE;
                default -> throw new IllegalArgumentException("expected alaw or gsm, found " + name);
            };
        }

        /** RTP payload type (RFC 3551, table 4). */
        public int payloadType() {
            return payloadType;
        }

        public int octetsPerFrame() {
            return octetsPerFrame;
        }

        /** A new codec for one direction of one call. */
        public SpeechCodec open() {
            return switch (this) {
                case MU_LAW -> G711.MU_LAW;
                case A_LAW -> G711.A_LAW;
                case GSM_FULL_RATE -> new GsmFullRate();
            };
        }
    }

    Kind kind();

    /** True if no sample is louder than {@code most}. */
    static boolean isSilent(short[] frame, int most) {
        for (short sample : frame) {
            if (Math.abs(sample) > most) {
                return false;
            }
        }
        return true;
    }

    /**
     * One of the two frames in a block of 65 octets of a WAV file with GSM 06.10 (tag 49), as its 33 octets.
     *
     * @param index 0 or 1
     */
    static byte[] gsmFrameOfWav(byte[] block, int index) {
        return GsmFrame.ofWav(block, index);
    }

    /** @param frame 160 samples */
    byte[] encode(short[] frame);

    /** @param octets one frame; IllegalArgumentException if its length is not {@link Kind#octetsPerFrame} */
    short[] decode(byte[] octets);
}
