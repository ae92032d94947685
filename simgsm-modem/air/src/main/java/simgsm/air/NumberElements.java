package simgsm.air;

import java.util.Optional;
import simgsm.octets.OctetWriter;

/** Telephone numbers as they stand in messages (TS 24.008, 10.5.4.7 and 10.5.4.9; TS 24.011, 8.2.5.1). */
final class NumberElements {
    /** No extension octet, international number, ISDN numbering plan (E.164). */
    private static final int INTERNATIONAL = 0x91;
    /** The same, followed by an octet with presentation and screening. */
    private static final int INTERNATIONAL_EXTENDED = 0x11;
    /** Presentation allowed; user provided, verified and passed. */
    private static final int PRESENTATION = 0x81;

    private static final int NO_EXTENSION = 0x80;

    private NumberElements() {}

    /** Writes a called number, or an SMSC's address, as length and value. */
    static void writeCalled(OctetWriter out, Msisdn number) {
        int start = out.openLength();
        out.octet(INTERNATIONAL);
        SemiOctets.write(out, number.digits(), 0);
        out.closeLength(start);
    }

    /** Writes a calling number as length and value. */
    static void writeCalling(OctetWriter out, Msisdn number) {
        int start = out.openLength();
        out.octet(INTERNATIONAL_EXTENDED).octet(PRESENTATION);
        SemiOctets.write(out, number.digits(), 0);
        out.closeLength(start);
    }

    static Msisdn read(MessageReader value) throws ProtocolViolation {
        int typeAndPlan = value.octet("number");
        if ((typeAndPlan & NO_EXTENSION) == 0) {
            value.octet("number's presentation");
        }
        try {
            return new Msisdn(SemiOctets.read(value));
        } catch (IllegalArgumentException wrong) {
            throw ProtocolViolation.invalid(wrong.getMessage());
        }
    }

    /** The number in an optional element; empty if it cannot be read (TS 24.008, 8.7.1). */
    static Optional<Msisdn> readOptional(MessageReader value) {
        try {
            return Optional.of(read(value));
        } catch (ProtocolViolation broken) {
            return Optional.empty();
        }
    }
}
