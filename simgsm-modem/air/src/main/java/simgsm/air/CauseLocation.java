package simgsm.air;

/** The originator of a cause (TS 24.008, 10.5.4.11); the ordinal is the code. */
public enum CauseLocation {
    USER,
    PRIVATE_NETWORK_OF_LOCAL_USER,
    PUBLIC_NETWORK_OF_LOCAL_USER,
    TRANSIT_NETWORK,
    PUBLIC_NETWORK_OF_REMOTE_USER,
    PRIVATE_NETWORK_OF_REMOTE_USER,
    /** Code 10, network beyond interworking point, is read as this. */
    OTHER_NETWORK,
    INTERNATIONAL_NETWORK;

    /** The party that sends in this direction; the other one if it answers. */
    public static CauseLocation of(Direction direction, boolean answers) {
        return (direction == Direction.UPLINK) != answers ? USER : PUBLIC_NETWORK_OF_LOCAL_USER;
    }

    static CauseLocation ofCode(int code) {
        return code < values().length ? values()[code] : OTHER_NETWORK;
    }
}
