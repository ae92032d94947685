package simgsm.air;

import simgsm.octets.OctetWriter;

/** The values of telephone numbers in messages (TS 24.008, 10.5.4.7 and 10.5.4.9; TS 24.011, 8.2.5.1). */
final class NumberElements {
    /** ISDN numbering plan (E.164). */
    private static final int PLAN = 0x01;

    private static final int TYPE_MASK = 0x70;
    private static final int INTERNATIONAL = 0x10;
    /** Presentation allowed; network provided (10.5.4.9, screening indicator). */
    private static final int SHOWN_BY_NETWORK = 0x83;

    private static final int NO_EXTENSION = 0x80;

    private NumberElements() {}

    /** Writes a called number or an SMSC's address. */
    static void writeCalled(OctetWriter out, Msisdn number) {
        SemiOctets.write(out.octet(NO_EXTENSION | type(number)), number.digits(), 0);
    }

    /** Writes a calling or connected number. */
    static void writeShown(OctetWriter out, Msisdn number) {
        SemiOctets.write(out.octet(type(number)).octet(SHOWN_BY_NETWORK), number.digits(), 0);
    }

    private static int type(Msisdn number) {
        return number.international() ? PLAN | INTERNATIONAL : PLAN;
    }

    static Msisdn read(MessageReader value) throws ProtocolViolation {
        int typeAndPlan = value.octet("number");
        if ((typeAndPlan & NO_EXTENSION) == 0) {
            value.octet("number's presentation");
        }
        try {
            return new Msisdn(SemiOctets.read(value), (typeAndPlan & TYPE_MASK) == INTERNATIONAL);
        } catch (IllegalArgumentException wrong) {
            throw ProtocolViolation.invalid(wrong.getMessage());
        }
    }
}
