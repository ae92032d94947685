package simgsm.air;

/** Causes of refusals by mobility management (TS 24.008, 10.5.3.6 and annex G). */
public enum RejectCause implements Coded.Titled {
    IMSI_UNKNOWN_IN_HLR(2, "IMSI unknown in HLR"),
    ILLEGAL_MS(3, "illegal MS"),
    IMSI_UNKNOWN_IN_VLR(4, "IMSI unknown in VLR"),
    IMEI_NOT_ACCEPTED(5, "IMEI not accepted"),
    ILLEGAL_ME(6, "illegal ME"),
    PLMN_NOT_ALLOWED(11, "PLMN not allowed"),
    LOCATION_AREA_NOT_ALLOWED(12, "location area not allowed"),
    ROAMING_NOT_ALLOWED(13, "roaming not allowed in this location area"),
    NO_SUITABLE_CELLS(15, "no suitable cells in location area"),
    NETWORK_FAILURE(17, "network failure"),
    MAC_FAILURE(20, "MAC failure"),
    SYNCH_FAILURE(21, "synch failure"),
    CONGESTION(22, "congestion"),
    AUTHENTICATION_UNACCEPTABLE(23, "GSM authentication unacceptable"),
    NOT_AUTHORIZED_FOR_CSG(25, "not authorized for this CSG"),
    SERVICE_OPTION_NOT_SUPPORTED(32, "service option not supported"),
    SERVICE_OPTION_NOT_SUBSCRIBED(33, "requested service option not subscribed"),
    SERVICE_OPTION_OUT_OF_ORDER(34, "service option temporarily out of order"),
    CALL_CANNOT_BE_IDENTIFIED(38, "call cannot be identified"),
    RETRY_IN_NEW_CELL(48, "retry upon entry into a new cell"),
    SEMANTICALLY_INCORRECT_MESSAGE(95, "semantically incorrect message"),
    INVALID_MANDATORY_INFORMATION(96, "invalid mandatory information"),
    MESSAGE_TYPE_NON_EXISTENT(97, "message type non-existent or not implemented"),
    MESSAGE_NOT_COMPATIBLE_WITH_STATE(98, "message type not compatible with protocol state"),
    INFORMATION_ELEMENT_NON_EXISTENT(99, "information element non-existent or not implemented"),
    CONDITIONAL_ELEMENT_ERROR(100, "conditional IE error"),
    MESSAGE_NOT_COMPATIBLE(101, "message not compatible with protocol state"),
    PROTOCOL_ERROR(111, "protocol error, unspecified");

    private final Row row;

    RejectCause(int code, String title) {
        row = new Row(code, title);
    }

    @Override
    public Row row() {
        return row;
    }

    /** The cause with this code; an unlisted one is 34 for the mobile and 111 for the network (10.5.3.6). */
    public static RejectCause ofCode(int code, Direction direction) {
        return code >> 4 == 3
                ? RETRY_IN_NEW_CELL
                : Coded.find(values(), code)
                        .orElse(direction == Direction.DOWNLINK ? SERVICE_OPTION_OUT_OF_ORDER : PROTOCOL_ERROR);
    }
}
