package simgsm.air;

/** Why mobility management refused (TS 24.008, 10.5.3.6 and annex G). */
public enum RejectCause implements Coded.Titled {
    IMSI_UNKNOWN_IN_HLR(2, "IMSI unknown in HLR"),
    ILLEGAL_MS(3, "illegal MS"),
    IMSI_UNKNOWN_IN_VLR(4, "IMSI unknown in VLR"),
    IMEI_NOT_ACCEPTED(5, "IMEI not accepted"),
    ILLEGAL_ME(6, "illegal ME"),
    PLMN_NOT_ALLOWED(11, "PLMN not allowed"),
    LOCATION_AREA_NOT_ALLOWED(12, "location area not allowed"),
    NETWORK_FAILURE(17, "network failure"),
    MAC_FAILURE(20, "MAC failure"),
    SYNCH_FAILURE(21, "synch failure"),
    CONGESTION(22, "congestion"),
    SERVICE_OPTION_NOT_SUPPORTED(32, "service option not supported"),
    CALL_CANNOT_BE_IDENTIFIED(38, "call cannot be identified"),
    SEMANTICALLY_INCORRECT_MESSAGE(95, "semantically incorrect message"),
    INVALID_MANDATORY_INFORMATION(96, "invalid mandatory information"),
    MESSAGE_TYPE_NON_EXISTENT(97, "message type non-existent or not implemented"),
    MESSAGE_NOT_COMPATIBLE_WITH_STATE(98, "message not compatible with protocol state"),
    PROTOCOL_ERROR(111, "protocol error, unspecified");

    private final int code;
    private final String title;

    RejectCause(int code, String title) {
        this.code = code;
        this.title = title;
    }

    @Override
    public int code() {
        return code;
    }

    @Override
    public String title() {
        return title;
    }

    /** The cause with this code; a code that the standard does not list is taken as PROTOCOL_ERROR. */
    public static RejectCause ofCode(int code) {
        return Coded.find(values(), code).orElse(PROTOCOL_ERROR);
    }
}
