package simgsm.trace;

import simgsm.air.Direction;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;

/** The capabilities of a terminal in words. The suite does not use them, so the messages' records omit them. */
final class CapabilityTexts {
    private static final int EXTENSION = 0x80;

    private CapabilityTexts() {}

    /** Information transfer capability (TS 24.008, 10.5.4.5); uplink also the radio channel requirement and speech versions. */
    static String bearer(MessageReader in, Direction direction, FieldTexts texts) throws ProtocolViolation {
        int octet = in.octet("bearer capability");
        StringBuilder words = new StringBuilder(texts.of("bearer." + (octet & 0x07)));
        if (direction == Direction.UPLINK) {
            words.append(", ").append(texts.of("rate." + (octet >> 5 & 0x03)));
        }
        StringBuilder versions = new StringBuilder();
        while ((octet & EXTENSION) == 0 && in.hasMore()) {
            octet = in.octet("speech version");
            versions.append(' ').append(speechVersion(octet & 0x0f));
        }
        return versions.length() == 0 ? words.toString() : words + ", " + texts.of("speechVersions") + versions;
    }

    /** FR3 is full rate speech version 3: odd codes are half rate, versions count from 1. */
    private static String speechVersion(int code) {
        return (code % 2 == 0 ? "FR" : "HR") + (code / 2 + 1);
    }

    /** Revision level and RF power capability (TS 24.008, 10.5.1.5). */
    static String classmark(MessageReader in, FieldTexts texts) throws ProtocolViolation {
        int classmark = in.octet("classmark");
        return texts.of("revision." + (classmark >> 5 & 0x03)) + ", " + texts.of("powerClass") + " "
                + ((classmark & 0x07) + 1);
    }
}
