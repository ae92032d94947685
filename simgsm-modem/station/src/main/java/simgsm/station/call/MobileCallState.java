package simgsm.station.call;

/** The mobile's call states (TS 24.008, 5.1.2.1), with the codes that STATUS carries (10.5.4.6). */
public enum MobileCallState {
    NULL("U0", 0),
    MM_CONNECTION_PENDING("U0.1", 0),
    CALL_INITIATED("U1", 1),
    MO_CALL_PROCEEDING("U3", 3),
    CALL_DELIVERED("U4", 4),
    CALL_PRESENT("U6", 6),
    CALL_RECEIVED("U7", 7),
    CONNECT_REQUEST("U8", 8),
    MT_CALL_CONFIRMED("U9", 9),
    ACTIVE("U10", 10),
    DISCONNECT_REQUEST("U11", 11),
    DISCONNECT_INDICATION("U12", 12),
    RELEASE_REQUEST("U19", 19);

    private final String shortName;
    private final int code;

    MobileCallState(String shortName, int code) {
        this.shortName = shortName;
        this.code = code;
    }

    /** As the standard's tables write it, "U10". */
    public String shortName() {
        return shortName;
    }

    /** Call state value of STATUS, 0 to 63. */
    public int code() {
        return code;
    }
}
