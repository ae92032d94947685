package simgsm.air;

import java.util.Optional;
import simgsm.octets.OctetWriter;

/** The call control cause (TS 24.008, 10.5.4.11): coding and location, then the cause with its highest bit set. */
record CauseElement(Cause cause, CauseLocation location) {
    /** Last octet of this part, standard defined for GSM. */
    private static final int GSM_CODING = 0xe0;

    private static final int LOCATION_MASK = 0x0f;
    private static final int LAST_OCTET = 0x80;

    /** Writes a cause as length and value. */
    static void write(OctetWriter out, Cause cause, CauseLocation location) {
        out.octet(2).octet(GSM_CODING | location.ordinal()).octet(LAST_OCTET | cause.code());
    }

    static CauseElement read(MessageReader in) throws ProtocolViolation {
        return readValue(in.lengthAndValue("cause"));
    }

    private static CauseElement readValue(MessageReader value) throws ProtocolViolation {
        int coding = value.octet("cause");
        if ((coding & LAST_OCTET) == 0) {
            value.octet("cause's recommendation");
        }
        return new CauseElement(
                Cause.ofCode(value.octet("cause value") & 0x7f), CauseLocation.ofCode(coding & LOCATION_MASK));
    }

    /** The cause in an optional element; empty if it cannot be read (TS 24.008, 8.7.1). */
    static Optional<CauseElement> readOptional(MessageReader value) {
        try {
            return Optional.of(readValue(value));
        } catch (ProtocolViolation broken) {
            return Optional.empty();
        }
    }
}
