package simgsm.abis;

import java.util.Locale;

/** Elements of RSL messages (TS 48.058, 9.3), and those of ip.access for speech: tag and form. */
public enum RslElement {
    CHANNEL_NUMBER(0x01, 1),
    LINK_IDENTIFIER(0x02, 1),
    ACTIVATION_TYPE(0x03, 1),
    BS_POWER(0x04, 1),
    CHANNEL_IDENTIFICATION(0x05),
    CHANNEL_MODE(0x06),
    ENCRYPTION_INFORMATION(0x07),
    FRAME_NUMBER(0x08, 2),
    HANDOVER_REFERENCE(0x09, 1),
    L1_INFORMATION(0x0a, 2),
    /** Its length has two octets. */
    L3_INFORMATION(0x0b, RslElement.LONG),
    MOBILE_IDENTITY(0x0c),
    MS_POWER(0x0d, 1),
    PAGING_GROUP(0x0e, 1),
    PAGING_LOAD(0x0f, 2),
    PHYSICAL_CONTEXT(0x10),
    ACCESS_DELAY(0x11, 1),
    RACH_LOAD(0x12),
    REQUEST_REFERENCE(0x13, 3),
    RELEASE_MODE(0x14, 1),
    RESOURCE_INFORMATION(0x15),
    LINK_CAUSE(0x16),
    STARTING_TIME(0x17, 2),
    TIMING_ADVANCE(0x18, 1),
    UPLINK_MEASUREMENTS(0x19),
    CAUSE(0x1a),
    MEASUREMENT_RESULT_NUMBER(0x1b, 1),
    MESSAGE_IDENTIFIER(0x1c, 1),
    SYSTEM_INFORMATION_TYPE(0x1e, 1),
    MS_POWER_PARAMETERS(0x1f),
    BS_POWER_PARAMETERS(0x20),
    PREPROCESSING_PARAMETERS(0x21),
    PREPROCESSED_MEASUREMENTS(0x22),
    MS_TIMING_OFFSET(0x25, 1),
    ERRONEOUS_MESSAGE(0x26),
    /** The whole BCCH block. */
    FULL_BCCH_INFORMATION(0x27),
    CHANNEL_NEEDED(0x28, 1),
    BROADCAST_COMMAND_TYPE(0x29, 1),
    BROADCAST_MESSAGE(0x2a),
    /** The whole AGCH block of 23 octets. */
    FULL_IMMEDIATE_ASSIGN(0x2b),
    SACCH_INFORMATION(0x2c),
    CBCH_LOAD(0x2d, 1),
    SMSCB_CHANNEL_INDICATOR(0x2e, 1),

    REMOTE_IP(0xf0, 4),
    REMOTE_PORT(0xf1, 2),
    RTP_PAYLOAD(0xf2, 1),
    LOCAL_PORT(0xf3, 2),
    SPEECH_MODE(0xf4, 1),
    LOCAL_IP(0xf5, 4),
    CONNECTION_STATISTICS(0xf6),
    CONNECTION_IDENTIFIER(0xf8, 2),
    RTP_PAYLOAD_2(0xfc, 1);

    /** Form TLV, with a length octet. */
    static final int VARIABLE = -1;
    /** Form TL16V, with two length octets. */
    static final int LONG = -2;

    private static final RslElement[] BY_TAG = new RslElement[256];

    static {
        for (RslElement element : values()) {
            BY_TAG[element.tag] = element;
        }
    }

    private final int tag;
    private final int length;
    /** Made once: each element read names itself for a possible error. */
    private final String words;

    RslElement(int tag) {
        this(tag, VARIABLE);
    }

    RslElement(int tag, int length) {
        this.tag = tag;
        this.length = length;
        this.words = name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    int tag() {
        return tag;
    }

    /** The octets of the value, for elements of a fixed length; else {@link #VARIABLE} or {@link #LONG}. */
    int length() {
        return length;
    }

    /** Octets before the value: tag and length. */
    public int overhead() {
        return length == LONG ? 3 : length == VARIABLE ? 2 : 1;
    }

    /** The element with this tag; null for an unknown one. */
    static RslElement ofTag(int tag) {
        return BY_TAG[tag];
    }

    /** The name in words, for error texts. */
    @Override
    public String toString() {
        return words;
    }
}
