package simgsm.air;

/** Why a call ended or a call-control message was refused (TS 24.008, 10.5.4.11 and annex H). */
public enum Cause {
    UNASSIGNED_NUMBER(1, "unassigned number"),
    NO_ROUTE_TO_DESTINATION(3, "no route to destination"),
    NORMAL_CALL_CLEARING(16, "normal call clearing"),
    USER_BUSY(17, "user busy"),
    NO_USER_RESPONDING(18, "no user responding"),
    USER_ALERTING_NO_ANSWER(19, "user alerting, no answer"),
    CALL_REJECTED(21, "call rejected"),
    NUMBER_CHANGED(22, "number changed"),
    DESTINATION_OUT_OF_ORDER(27, "destination out of order"),
    INVALID_NUMBER_FORMAT(28, "invalid number format"),
    NORMAL_UNSPECIFIED(31, "normal, unspecified"),
    NO_CIRCUIT_AVAILABLE(34, "no circuit/channel available"),
    NETWORK_OUT_OF_ORDER(38, "network out of order"),
    TEMPORARY_FAILURE(41, "temporary failure"),
    SWITCHING_EQUIPMENT_CONGESTION(42, "switching equipment congestion"),
    RESOURCES_UNAVAILABLE(47, "resources unavailable, unspecified"),
    SERVICE_NOT_AVAILABLE(63, "service or option not available, unspecified"),
    INVALID_TRANSACTION_IDENTIFIER(81, "invalid transaction identifier value"),
    INCOMPATIBLE_DESTINATION(88, "incompatible destination"),
    SEMANTICALLY_INCORRECT_MESSAGE(95, "semantically incorrect message"),
    INVALID_MANDATORY_INFORMATION(96, "invalid mandatory information"),
    MESSAGE_TYPE_NON_EXISTENT(97, "message type non-existent or not implemented"),
    MESSAGE_NOT_COMPATIBLE_WITH_STATE(98, "message not compatible with protocol state"),
    RECOVERY_ON_TIMER_EXPIRY(102, "recovery on timer expiry"),
    PROTOCOL_ERROR(111, "protocol error, unspecified"),
    INTERWORKING(127, "interworking, unspecified");

    private final int code;
    private final String title;

    Cause(int code, String title) {
        this.code = code;
        this.title = title;
    }

    /** The value on the wire. */
    public int code() {
        return code;
    }

    /** The cause's name in the standard, in lower case. */
    public String title() {
        return title;
    }

    /** The cause with this code; a code that the standard does not list is taken as NORMAL_UNSPECIFIED. */
    public static Cause ofCode(int code) {
        for (Cause cause : values()) {
            if (cause.code == code) {
                return cause;
            }
        }
        return NORMAL_UNSPECIFIED;
    }
}
