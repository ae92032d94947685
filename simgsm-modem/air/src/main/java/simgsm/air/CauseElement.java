package simgsm.air;

import java.util.Optional;
import simgsm.octets.OctetWriter;

/** The call control cause (TS 24.008, 10.5.4.11): coding and location, then the cause with its highest bit set. */
final class CauseElement {
    /** Standard defined for GSM, location: user. */
    private static final int GSM_USER = 0xe0;

    private static final int LAST_OCTET = 0x80;

    private CauseElement() {}

    /** Writes a cause as length and value. */
    static void write(OctetWriter out, Cause cause) {
        out.octet(2).octet(GSM_USER).octet(LAST_OCTET | cause.code());
    }

    static Cause read(MessageReader in) throws ProtocolViolation {
        return readValue(in.lengthAndValue("cause"));
    }

    private static Cause readValue(MessageReader value) throws ProtocolViolation {
        int coding = value.octet("cause");
        if ((coding & LAST_OCTET) == 0) {
            value.octet("cause's recommendation");
        }
        return Cause.ofCode(value.octet("cause value") & 0x7f);
    }

    /** The cause in an optional element; empty if it cannot be read (TS 24.008, 8.7.1). */
    static Optional<Cause> readOptional(MessageReader value) {
        try {
            return Optional.of(readValue(value));
        } catch (ProtocolViolation broken) {
            return Optional.empty();
        }
    }
}
