package simgsm.speech;

/** GSM 06.10 full rate at 13 kbit/s; has a state, so each direction of a call needs its own. */
final class GsmFullRate implements SpeechCodec {
    private final GsmEncoder encoder = new GsmEncoder();
    private final GsmDecoder decoder = new GsmDecoder();

    @Override
    public Kind kind() {
        return Kind.GSM_FULL_RATE;
    }

    @Override
    public byte[] encode(short[] frame) {
        if (frame.length != SAMPLES_PER_FRAME) {
            throw new IllegalArgumentException("Frame of " + frame.length + " samples (expected 160)");
        }
        return encoder.encode(frame);
    }

    @Override
    public short[] decode(byte[] octets) {
        return decoder.decode(octets);
    }
}
