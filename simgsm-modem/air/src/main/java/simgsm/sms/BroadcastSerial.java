package simgsm.sms;

/**
 * The serial number of a broadcast message; a phone shows each code and update once (TS 23.041, 9.4.1.2.1).
 *
 * @param scope area in which the code is unique: 0 cell, displayed immediately, 1 network, 2 location area, 3 cell
 * @param code distinguishes messages with the same identifier, 0 to 1023
 * @param update counts changes of the same message, 0 to 15
 */
public record BroadcastSerial(int scope, int code, int update) {
    public static final int NETWORK_WIDE = 1;

    private static final int MAX_CODE = 1023;
    private static final int MAX_UPDATE = 15;

    public BroadcastSerial {
        if (scope < 0 || scope > 3 || code < 0 || code > MAX_CODE || update < 0 || update > MAX_UPDATE) {
            throw new IllegalArgumentException("broadcast serial of scope " + scope + ", code " + code + ", update "
                    + update + " are out of range");
        }
    }

    /** The two octets on the air. */
    public int value() {
        return scope << 14 | code << 4 | update;
    }

    /** The serial of the two octets. */
    public static BroadcastSerial ofValue(int value) {
        return new BroadcastSerial(value >> 14 & 0x03, value >> 4 & MAX_CODE, value & MAX_UPDATE);
    }
}
